//! Long edges cut in two.

use super::{LONGEST, Remesh, sorted};
use crate::solid::fit::Hold;
use crate::solid::vector::lerp;

/// Rounds of cutting, each of which halves the longest.
const ROUNDS: usize = 24;

impl Remesh<'_> {
    /// Cuts edges until none is too long.
    pub(super) fn split(&mut self) {
        for _ in 0..ROUNDS {
            let mut long: Vec<([u32; 2], f64)> = self
                .edges()
                .into_iter()
                .map(|edge| (edge, self.length_m(edge)))
                .filter(|(_, length_m)| *length_m > LONGEST * self.edge_m)
                .collect();
            if long.is_empty() {
                break;
            }
            // The longest first: none of its triangles is cut along a shorter side.
            long.sort_by(|(_, p), (_, q)| q.total_cmp(p));
            for (edge, length_m) in long {
                let longest = |face: &u32| {
                    let [a, b, c] = self.corners(*face);
                    let sides = [[a, b], [b, c], [c, a]];
                    sides
                        .into_iter()
                        .all(|side| self.length_m(side) <= length_m)
                };
                if self.beside(edge).iter().all(longest) {
                    self.cut(edge);
                }
            }
        }
    }

    fn cut(&mut self, edge: [u32; 2]) {
        let beside = self.beside(edge);
        let Some(&first) = beside.first() else { return };
        let [a, b] = edge;
        let straight = lerp(self.points[a as usize], self.points[b as usize], 0.5);
        let line = self.lines.remove(&edge);
        let hold = match line {
            Some(pair) => Hold::Edge(pair),
            None => Hold::Face(self.parts[first as usize]),
        };
        let middle = self.points.len() as u32;
        self.points
            .push(self.held(straight, hold).unwrap_or(straight));
        self.holds.push(hold);
        self.stars.push(Vec::new());
        if let Some(pair) = line {
            self.lines.insert(sorted([a, middle]), pair);
            self.lines.insert(sorted([middle, b]), pair);
        }
        for face in beside {
            let corners = self.corners(face);
            let put = |out: u32| corners.map(|corner| if corner == out { middle } else { corner });
            let added = self.faces.len() as u32;
            self.faces[face as usize] = Some(put(b));
            self.faces.push(Some(put(a)));
            self.parts.push(self.parts[face as usize]);
            self.stars[b as usize].retain(|&other| other != face);
            self.stars[b as usize].push(added);
            self.stars[middle as usize].extend([face, added]);
            let third = corners.into_iter().find(|corner| ![a, b].contains(corner));
            if let Some(third) = third {
                self.stars[third as usize].push(added);
            }
        }
    }
}
