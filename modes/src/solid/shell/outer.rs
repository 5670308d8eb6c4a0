//! The outer side of a wall as triangles that fit its surface.

use crate::solid::body::Body;
use crate::solid::features::Features;
use crate::solid::fit::{Fit, Hold};
use std::collections::HashMap;

/// Triangles with their corners on a surface, and what these hold to.
pub(in crate::solid) struct Outer<'a> {
    pub(in crate::solid) body: &'a Body,
    pub(in crate::solid) features: &'a Features,
    pub(in crate::solid) points: Vec<[f64; 3]>,
    pub(in crate::solid) holds: Vec<Hold>,
    /// Corners, counter-clockwise from outside.
    pub(in crate::solid) faces: Vec<[u32; 3]>,
    /// The smooth part that each lies on.
    pub(in crate::solid) parts: Vec<Option<u32>>,
    /// How far the surface may be from the triangles, in m.
    pub(in crate::solid) reach_m: f64,
}

impl<'a> Outer<'a> {
    /// The boundary of a filled body.
    pub(in crate::solid) fn of(fit: &Fit<'a>) -> Self {
        let mut outer = Self {
            body: fit.body,
            features: fit.features,
            points: Vec::new(),
            holds: Vec::new(),
            faces: Vec::with_capacity(fit.boundary.len()),
            parts: Vec::with_capacity(fit.boundary.len()),
            reach_m: fit.cell_m,
        };
        let mut numbers = HashMap::new();
        for &(face, _) in &fit.boundary {
            outer.parts.push(fit.part(face));
            outer.faces.push(face.map(|corner| {
                *numbers.entry(corner).or_insert_with(|| {
                    outer.points.push(fit.mesh.points[corner as usize]);
                    outer.holds.push(fit.holds[corner as usize]);
                    outer.points.len() as u32 - 1
                })
            }));
        }
        outer
    }

    /// Whether one can go from each triangle to each other.
    pub(in crate::solid) fn hangs_together(&self) -> bool {
        let mut stars: Vec<Vec<usize>> = vec![Vec::new(); self.points.len()];
        for (t, face) in self.faces.iter().enumerate() {
            for &corner in face {
                stars[corner as usize].push(t);
            }
        }
        let mut seen = vec![false; self.faces.len()];
        let mut stack = vec![0];
        let mut reached = 0;
        while let Some(t) = stack.pop() {
            if t >= seen.len() || std::mem::replace(&mut seen[t], true) {
                continue;
            }
            reached += 1;
            let corners = self.faces[t].iter();
            stack.extend(corners.flat_map(|&corner| stars[corner as usize].iter().copied()));
        }
        reached == self.faces.len()
    }
}
