//! Short edges drawn together.

use super::{LONGEST, Remesh, SHORTEST, sorted};
use crate::solid::fit::Hold;

/// Rounds of drawing together, at most.
const ROUNDS: usize = 12;

impl Remesh<'_> {
    /// Draws edges together until none is too short that can be.
    pub(super) fn collapse(&mut self) {
        for _ in 0..ROUNDS {
            let mut short: Vec<([u32; 2], f64)> = self
                .edges()
                .into_iter()
                .map(|edge| (edge, self.length_m(edge)))
                .filter(|(_, length_m)| *length_m < SHORTEST * self.edge_m)
                .collect();
            short.sort_by(|(_, p), (_, q)| p.total_cmp(q));
            let mut any = false;
            for ([a, b], _) in short {
                if self.may(a, b) {
                    self.draw(a, b);
                    any = true;
                } else if self.may(b, a) {
                    self.draw(b, a);
                    any = true;
                }
            }
            if !any {
                break;
            }
        }
    }

    /// Whether the point `a` may go to its neighbour `b`.
    fn may(&self, a: u32, b: u32) -> bool {
        let edge = sorted([a, b]);
        let beside = self.beside(edge);
        let along = self.lines.contains_key(&edge);
        let free = match self.holds[a as usize] {
            Hold::Face(_) => true,
            Hold::Edge(_) => along,
            _ => false,
        };
        if !free || beside.is_empty() || self.length_m(edge) >= SHORTEST * self.edge_m {
            return false;
        }
        // Nothing but the edge's own triangles may lie between.
        let (around, others) = (self.around(a), self.around(b));
        let common: Vec<u32> = around
            .iter()
            .copied()
            .filter(|p| others.contains(p))
            .collect();
        if common.len() != beside.len() {
            return false;
        }
        let line = |p: u32, q: u32| self.lines.contains_key(&sorted([p, q]));
        if common.iter().any(|&c| line(a, c) && line(b, c)) {
            return false;
        }
        // As long as they may be, or as they are: a file's triangles may be needles.
        let longest_m = |point: u32| {
            let others = around.iter().filter(|&&other| other != b);
            let lengths = others.map(|&other| self.length_m([point, other]));
            lengths.fold(0.0, f64::max)
        };
        if longest_m(b) > longest_m(a).max(LONGEST * self.edge_m) {
            return false;
        }
        let kept = self.stars[a as usize]
            .iter()
            .filter(|face| !beside.contains(face));
        kept.copied().all(|face| {
            let corners = self.corners(face);
            let moved = corners.map(|corner| if corner == a { b } else { corner });
            Self::bears(self.places(corners), self.places(moved))
        })
    }

    fn draw(&mut self, a: u32, b: u32) {
        for face in self.beside([a, b]) {
            for corner in self.corners(face) {
                self.stars[corner as usize].retain(|&other| other != face);
            }
            self.faces[face as usize] = None;
        }
        for other in self.around(a) {
            if let Some(pair) = self.lines.remove(&sorted([a, other])) {
                self.lines.insert(sorted([b, other]), pair);
            }
        }
        self.lines.remove(&sorted([a, b]));
        for face in std::mem::take(&mut self.stars[a as usize]) {
            let corners = self.corners(face);
            self.faces[face as usize] =
                Some(corners.map(|corner| if corner == a { b } else { corner }));
            self.stars[b as usize].push(face);
        }
    }
}
