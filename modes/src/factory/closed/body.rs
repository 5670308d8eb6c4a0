//! A flat body of closed form as one that can be struck and heard.

use super::grid::Grid;
use super::outline::{Cells, Outline};
use crate::analytic::ClosedMode;
use crate::bank::{Surface as Picture, SurfaceMotion};
use crate::radiation::{Surface, baffled_decay_per_s, cylinder_decay_per_s};
use crate::{SolvedBody, SolvedMode};
use rayon::prelude::*;
use std::f64::consts::PI;

/// How a flat body moves the air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Air {
    /// One face, in a rigid wall: a drum over a deep shell, a plate in a frame.
    Wall,
    /// Both faces of a strip of this width and thickness, in m, in the open.
    Open { width_m: f64, thickness_m: f64 },
}

/// What a closed form says of a body, beside its modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Flat {
    pub(super) outline: Outline,
    pub(super) mass_kg: f64,
    pub(super) grid: Grid,
    pub(super) air: Air,
    /// Where the felt lies, in m in the frame of the closed form.
    pub(super) felt_m: [f64; 2],
    /// Patches of the surface.
    pub(super) cells: Cells,
    /// Cells of its picture.
    pub(super) drawn: Cells,
}

/// Steps along a strip by which its radiation is summed.
const STEPS: usize = 200;

impl Flat {
    /// The body with `modes`, mass-normalised shapes for its patches and strike points.
    pub(super) fn solved<M: ClosedMode + Sync>(&self, modes: &[M]) -> SolvedBody {
        let points = self.grid.points_m(self.outline);
        let patches = self.outline.patches(self.cells);
        let surface = self.surface(&patches);
        let modes = modes
            .par_iter()
            .map(|mode| {
                let at = |point: &[f64; 2]| mode.displacement(*point);
                let faces: Vec<f64> = patches.iter().map(|(point, _)| at(point)).collect();
                let motion = self.motion(&faces);
                SolvedMode {
                    hz: mode.hz(),
                    residual: 0.0,
                    label: mode.label(),
                    // Adding 0 turns −0 to 0.
                    shape: points
                        .iter()
                        .map(|p| [0.0, 0.0, at(p) as f32 + 0.0])
                        .collect(),
                    rectified_area: surface.rectified_area(&motion),
                    radiation_per_s: self.radiation_per_s(mode, &patches, &faces),
                    motion,
                    held: 0.0,
                    felt: at(&self.felt_m).powi(2),
                }
            })
            .collect();
        SolvedBody {
            length_m: self.outline.length_m(),
            mass_kg: self.mass_kg,
            line: self.grid.line(self.outline),
            surface,
            modes,
            orthonormality: 0.0,
        }
    }

    /// What it looks like from above and from below, and how it moves.
    pub(super) fn picture<M: ClosedMode>(&self, modes: &[M]) -> Picture {
        let (points, _) = self.outline.triangles(self.drawn);
        let motions = modes.iter().take(Picture::MOST_MODES).map(|mode| {
            let motion = points
                .iter()
                .map(|p| [0.0, 0.0, mode.displacement(*p) as f32]);
            SurfaceMotion::of(&motion.collect::<Vec<_>>())
        });
        self.outline.picture(self.drawn, motions.collect())
    }

    /// The upper face, and of a strip in the open the lower one too.
    fn surface(&self, patches: &[([f64; 2], f64)]) -> Surface {
        let [x, y] = self.outline.middle_m();
        let mut surface = Surface::default();
        let faces: &[f64] = match self.air {
            Air::Wall => &[1.0],
            Air::Open { .. } => &[1.0, -1.0],
        };
        for up in faces {
            for (point, area_m2) in patches {
                surface.points_m.push([point[0] - x, point[1] - y, 0.0]);
                surface.normals.push([0.0, 0.0, *up]);
                surface.areas_m2.push(*area_m2);
            }
        }
        surface
    }

    fn motion(&self, faces: &[f64]) -> Vec<f32> {
        let upper = faces.iter().map(|u| *u as f32);
        match self.air {
            Air::Wall => upper.collect(),
            Air::Open { .. } => upper.clone().chain(upper.map(|u| -u)).collect(),
        }
    }

    fn radiation_per_s<M: ClosedMode>(
        &self,
        mode: &M,
        patches: &[([f64; 2], f64)],
        faces: &[f64],
    ) -> f64 {
        match self.air {
            Air::Wall => {
                let moved = patches.iter().zip(faces);
                baffled_decay_per_s(mode.hz(), moved.map(|((p, area), u)| (*p, area * u)))
            }
            Air::Open {
                width_m,
                thickness_m,
            } => {
                // A strip that moves across its plane stirs the far air as a cylinder does (Lamb 1932,
                // §71).
                let square = width_m * width_m / 8.0 + width_m * thickness_m / (2.0 * PI);
                let step_m = self.outline.length_m() / STEPS as f64;
                let motion: Vec<f64> = (0..STEPS)
                    .map(|i| mode.displacement([step_m * (i as f64 + 0.5), 0.0]))
                    .collect();
                cylinder_decay_per_s(mode.hz(), 1, square.sqrt(), step_m, &motion)
            }
        }
    }
}
