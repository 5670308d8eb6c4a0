//! The outline of a body of any shape, as the row shows it, and where on it a click strikes.

use super::flat::{boundary, is_flat, pieces};
use super::kind::Kind;
use super::solid::{Vector, cross, dot, unit};
use super::view::first_axes;
use egui::{Pos2, Rect, pos2, vec2};
use modes::{Body, Surface};
use std::sync::Arc;

/// A body's outline in a square from 0 to 1, its longer side filling it.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    /// Corners, clockwise as seen on the screen; around a body that is not flat, of its convex hull.
    corners: Vec<Pos2>,
    /// Convex pieces of it, as numbers of corners.
    pieces: Vec<Vec<usize>>,
    /// Width over height.
    aspect: f32,
    /// Places of the strike grid that face the eye: where they are seen, along and across.
    spots: Vec<(Pos2, [f32; 2])>,
}

/// Greatest width over height of what is called slender.
const SLENDER: f32 = 0.25;

/// To the right, upwards and to the eye, for one who looks at a flat body from above, its longer side upright.
fn from_above(surface: &Surface) -> [Vector; 3] {
    let span = |axis: usize| {
        let along = surface.points_m.iter().map(|point| point[axis]);
        along.clone().fold(f32::MIN, f32::max) - along.fold(f32::MAX, f32::min)
    };
    if span(0) * SLENDER > span(1) {
        [[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    } else {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    }
}

impl Outline {
    fn of(surface: &Surface, body: &Body) -> Self {
        let flat = is_flat(body);
        let [right, up, near] = if flat {
            from_above(surface)
        } else {
            first_axes(Kind::Other)
        };
        let seen = |point: Vector| pos2(dot(point, right), -dot(point, up));
        let points: Vec<Pos2> = surface.points_m.iter().map(|point| seen(*point)).collect();
        let area = Rect::from_points(&points);
        let size = area.size().max(vec2(1e-9, 1e-9));
        let even = |at: Pos2| pos2((at.x - area.left()) / size.x, (at.y - area.top()) / size.y);
        let scale = 1.0 / body.surface_scale();
        let grid = body.line.grid();
        let faces = |normal: &[f64; 3]| dot(unit(normal.map(|x| x as f32)), near) > 0.05;
        let spots = (body.line.points_m.iter().zip(&body.line.normals))
            .enumerate()
            .filter(|(_, (_, normal))| faces(normal))
            .map(|(i, (point, _))| {
                let at = seen(point.map(|x| (scale * x) as f32));
                (even(at), grid.place(i).map(|x| x as f32))
            });
        let even_points: Vec<Pos2> = points.into_iter().map(even).collect();
        let around = flat
            .then(|| boundary(surface, &even_points))
            .flatten()
            .unwrap_or_else(|| hull(even_points));
        Self {
            spots: spots.collect(),
            pieces: pieces(&around),
            corners: around,
            aspect: size.x / size.y,
        }
    }

    /// Whether it is several times as high as wide.
    pub(super) fn is_slender(&self) -> bool {
        self.aspect < SLENDER
    }

    /// Width over height.
    pub(super) fn aspect(&self) -> f32 {
        self.aspect
    }

    /// Width and height of a body whose longer side is 1.
    pub(super) fn size(&self) -> egui::Vec2 {
        vec2(self.aspect.min(1.0), (1.0 / self.aspect).min(1.0))
    }

    /// Its corners in `rect`.
    pub(super) fn corners(&self, rect: Rect) -> Vec<Pos2> {
        self.corners.iter().map(|at| within(rect, *at)).collect()
    }

    /// Corners in `rect` of convex pieces that cover it.
    pub(super) fn pieces(&self, rect: Rect) -> impl Iterator<Item = Vec<Pos2>> {
        let corner = move |number: &usize| within(rect, self.corners[*number]);
        self.pieces
            .iter()
            .map(move |piece| piece.iter().map(corner).collect())
    }

    /// Whether a point is inside, or within `slack` points of it.
    pub(super) fn holds(&self, rect: Rect, at: Pos2, slack: f32) -> bool {
        self.pieces(rect).any(|corners| {
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).all(|(a, b)| {
                let along = (*b - *a).normalized();
                along.x * (at.y - a.y) - along.y * (at.x - a.x) >= -slack
            })
        })
    }

    /// The place along and across that is seen nearest to a point.
    pub(super) fn place(&self, rect: Rect, at: Pos2) -> [f32; 2] {
        let away = |spot: &&(Pos2, [f32; 2])| within(rect, spot.0).distance_sq(at);
        let nearest = self.spots.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        nearest.map_or([0.0; 2], |(_, place)| *place)
    }

    /// Where a place is seen; the nearest that faces the eye.
    pub(super) fn point(&self, rect: Rect, [along, across]: [f32; 2]) -> Pos2 {
        let away = |(_, place): &&(Pos2, [f32; 2])| {
            let around = (place[1] - across).abs();
            (place[0] - along).powi(2) + around.min(1.0 - around).powi(2)
        };
        let nearest = self.spots.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
        nearest.map_or(rect.center(), |(at, _)| within(rect, *at))
    }
}

fn within(rect: Rect, at: Pos2) -> Pos2 {
    rect.min + rect.size() * at.to_vec2()
}

/// The convex hull of points (Andrew 1979), clockwise as seen on a screen.
fn hull(mut points: Vec<Pos2>) -> Vec<Pos2> {
    points.retain(|p| p.x.is_finite() && p.y.is_finite());
    points.sort_unstable_by(|a, b| {
        (a.x, a.y)
            .partial_cmp(&(b.x, b.y))
            .unwrap_or(std::cmp::Ordering::Equal)
    });
    points.dedup();
    let chain = |points: &mut dyn Iterator<Item = Pos2>| {
        let mut chain: Vec<Pos2> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..]
                && turn(a, b, point) <= 0.0
            {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = chain(&mut points.iter().copied());
    hull.extend(chain(&mut points.iter().rev().copied()));
    hull
}

/// Above 0 if the way over `b` turns to the right on a screen.
pub(super) fn turn(a: Pos2, b: Pos2, c: Pos2) -> f32 {
    let flat = |from: Pos2, to: Pos2| [to.x - from.x, to.y - from.y, 0.0];
    cross(flat(a, b), flat(a, c))[2]
}

/// The outlines of an instrument, worked out once.
#[derive(Default)]
pub struct Outlines {
    known: Vec<(Arc<Surface>, Arc<Outline>)>,
}

impl Outlines {
    /// Forgets what no body of these looks like.
    pub(super) fn keep(&mut self, bodies: &[Body]) {
        let shown = |surface: &Arc<Surface>| {
            let same = |body: &Body| {
                body.surface
                    .as_ref()
                    .is_some_and(|own| Arc::ptr_eq(own, surface))
            };
            bodies.iter().any(same)
        };
        self.known.retain(|(surface, _)| shown(surface));
    }

    /// That of a body, if the bank says what it looks like.
    pub(super) fn of(&mut self, body: &Body) -> Option<Arc<Outline>> {
        let surface = body.surface.as_ref()?;
        let same = |(known, _): &&(Arc<Surface>, _)| Arc::ptr_eq(known, surface);
        if let Some((_, outline)) = self.known.iter().find(same) {
            return Some(Arc::clone(outline));
        }
        let outline = Arc::new(Outline::of(surface, body));
        self.known.push((Arc::clone(surface), Arc::clone(&outline)));
        Some(outline)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hull_goes_around_all_points_once() {
        let points: Vec<Pos2> = (0..25u8)
            .map(|i| pos2(f32::from(i % 5), f32::from(i / 5)))
            .collect();
        let hull = hull(points);
        assert_eq!(hull.len(), 4, "{hull:?}");
        let area: f32 = (1..3).map(|i| turn(hull[0], hull[i], hull[i + 1])).sum();
        assert_eq!(area, 32.0, "twice four by four");
    }
}
