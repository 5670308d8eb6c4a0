//! What is inside, what is outside, and where the boundary between them runs.

use super::ClosedSurface;
use super::tree::{Near, Tree};
use super::vector::{add, distance, lerp, scale, sub};

/// Halvings that find where a way leaves a body that it enters again.
const HALVINGS: usize = 40;

/// Secants that find where a way leaves a wall, at most.
const SECANTS: usize = 30;

/// How exactly, over the wall, the inner surface is found.
const EXACT: f64 = 1e-7;

/// A body, solid or hollow.
pub(super) struct Body {
    tree: Tree,
    /// Thickness of a hollow body's wall, in m: the body is what lies between the surface and its
    /// interior offset (O'Brien et al. 2002, §4).
    wall_m: Option<f64>,
}

/// The two sides of a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// The surface itself.
    Outer,
    /// The offset surface.
    Inner,
}

impl Body {
    pub(super) fn new(surface: &ClosedSurface, wall_m: Option<f64>) -> Self {
        Self {
            tree: Tree::new(&surface.points_m, &surface.triangles),
            wall_m,
        }
    }

    /// Thickness of a hollow body's wall, in m.
    pub(super) fn wall_m(&self) -> Option<f64> {
        self.wall_m
    }

    pub(super) fn tree(&self) -> &Tree {
        &self.tree
    }

    /// Whether `p` is enclosed; the winding number there is kept too, for who asks about overlaps.
    pub(super) fn enclosed(&self, p: [f64; 3]) -> (bool, f64) {
        let winding = self.tree.winding(p);
        // A part that is inside out is inside all the same.
        (winding.abs() > 0.5, winding)
    }

    /// Whether the body is all around `p`, seen from `by_m` away into each eighth of space: a face
    /// there is one of a part inside another.
    pub(super) fn surrounds(&self, p: [f64; 3], by_m: f64) -> bool {
        (0..8).all(|eighth| {
            let side = |bit: i32| if eighth >> bit & 1 == 1 { by_m } else { -by_m };
            // Not quite along the diagonals, where edges may be.
            self.enclosed(add(p, [0.9 * side(0), side(1), 1.1 * side(2)]))
                .0
        })
    }

    /// Whether `p`, which is enclosed, is within the wall.
    pub(super) fn in_wall(&self, p: [f64; 3]) -> bool {
        self.wall_m
            .is_none_or(|wall_m| self.tree.nearest(p, wall_m, |_| true).is_some())
    }

    /// How far within the body `p` is, up to `most_m`; `None` outside.
    pub(super) fn depth_m(&self, p: [f64; 3], most_m: f64) -> Option<f64> {
        let enclosed = self.enclosed(p).0;
        let bound_m = most_m + self.wall_m.unwrap_or(0.0);
        let near = self.tree.nearest(p, bound_m, |_| true);
        let outer_m = near.map_or(f64::INFINITY, |near| near.distance_m);
        let inner_m = self.wall_m.map_or(f64::INFINITY, |wall_m| wall_m - outer_m);
        let depth_m = outer_m.min(inner_m).min(most_m);
        (enclosed && depth_m > 0.0).then_some(depth_m)
    }

    /// The share of the way from `inside` to `outside` at which the body ends.
    pub(super) fn end(&self, inside: [f64; 3], outside: [f64; 3]) -> f64 {
        match self.wall_m {
            Some(wall_m) if self.enclosed(outside).0 => self.end_of_wall(inside, outside, wall_m),
            // All but always the way goes through one triangle.
            _ => match self.tree.hits(inside, outside)[..] {
                [hit] => hit,
                _ => halved(|share| self.enclosed(lerp(inside, outside, share)).0),
            },
        }
    }

    /// Where the way from `inside` the wall to the hollow leaves it.
    fn end_of_wall(&self, inside: [f64; 3], hollow: [f64; 3], wall_m: f64) -> f64 {
        let bound_m = wall_m + distance(inside, hollow);
        let beyond_m = |share: f64| {
            let near = self
                .tree
                .nearest(lerp(inside, hollow, share), bound_m, |_| true);
            near.map_or(bound_m, |near| near.distance_m) - wall_m
        };
        // The secant where it gains, else the half (Dowell & Jarratt 1971).
        let (mut low, mut high) = ((0.0, beyond_m(0.0)), (1.0, beyond_m(1.0)));
        for _ in 0..SECANTS {
            let share = low.0 - low.1 * (high.0 - low.0) / (high.1 - low.1);
            if !(low.0..=high.0).contains(&share) {
                break;
            }
            let beyond = beyond_m(share);
            if beyond > 0.0 {
                high = (share, beyond);
                low.1 *= 0.5;
            } else {
                low = (share, beyond);
                high.1 *= 0.5;
            }
            if beyond.abs() < EXACT * wall_m {
                return share;
            }
        }
        0.5 * (low.0 + high.0)
    }

    /// Which side of the wall a point of the boundary is on.
    pub(super) fn side(&self, p: [f64; 3]) -> Side {
        let outer = self
            .wall_m
            .is_none_or(|wall_m| self.tree.nearest(p, 0.5 * wall_m, |_| true).is_some());
        if outer { Side::Outer } else { Side::Inner }
    }

    /// The point of one side of the boundary nearest to `p`, by triangles for which `wanted` holds;
    /// that side is known to be within `bound_m`.
    pub(super) fn project(
        &self,
        p: [f64; 3],
        bound_m: f64,
        side: Side,
        wanted: impl Fn(u32) -> bool,
    ) -> Option<Near> {
        let deeper_m = match side {
            Side::Outer => 0.0,
            Side::Inner => self.wall_m?,
        };
        // A hair more, or rounding may miss what lies just there.
        let near = self.tree.nearest(p, 1.001 * (bound_m + deeper_m), wanted)?;
        let offset = match side {
            Side::Outer => return Some(near),
            Side::Inner => self.wall_m? / near.distance_m,
        };
        offset.is_finite().then(|| Near {
            point: add(near.point, scale(sub(p, near.point), offset)),
            ..near
        })
    }
}

/// The share of the way up to which `inside` holds, by halving.
fn halved(inside: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if inside(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
