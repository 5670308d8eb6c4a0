//! What is inside, what is outside, and where the boundary between them runs.

use super::ClosedSurface;
use super::tree::{Near, Tree};
use super::vector::{add, lerp, scale, sub};

/// Halvings that find where a way leaves the body.
const HALVINGS: usize = 40;

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

    pub(super) fn tree(&self) -> &Tree {
        &self.tree
    }

    /// Whether `p` is enclosed; the winding number there is kept too, for who asks about overlaps.
    pub(super) fn enclosed(&self, p: [f64; 3]) -> (bool, f64) {
        let winding = self.tree.winding(p);
        // A part that is inside out is inside all the same.
        (winding.abs() > 0.5, winding)
    }

    /// Whether `p`, which is enclosed, is within the wall.
    pub(super) fn in_wall(&self, p: [f64; 3]) -> bool {
        self.wall_m
            .is_none_or(|wall_m| self.tree.nearest(p, wall_m, |_| true).is_some())
    }

    fn contains(&self, p: [f64; 3]) -> bool {
        self.enclosed(p).0 && self.in_wall(p)
    }

    /// The share of the way from `inside` to `outside` at which the body ends.
    pub(super) fn end(&self, inside: [f64; 3], outside: [f64; 3]) -> f64 {
        if self.wall_m.is_none() {
            // All but always the way goes through one triangle.
            if let [hit] = self.tree.hits(inside, outside)[..] {
                return hit;
            }
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.contains(lerp(inside, outside, middle)) {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// Which side of the wall a point of the boundary is on.
    pub(super) fn side(&self, p: [f64; 3]) -> Side {
        let outer = self
            .wall_m
            .is_none_or(|wall_m| self.tree.nearest(p, 0.5 * wall_m, |_| true).is_some());
        if outer { Side::Outer } else { Side::Inner }
    }

    /// The point of one side of the boundary nearest to `p`, by triangles for which `wanted` holds.
    pub(super) fn project(
        &self,
        p: [f64; 3],
        side: Side,
        wanted: impl Fn(u32) -> bool,
    ) -> Option<Near> {
        let near = self.tree.nearest(p, f64::INFINITY, wanted)?;
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
