//! The surface of a body and how its modes move it, from what a bank says of the body.

mod bar;
mod beam;
mod drawn;
mod edges;
mod finer;
mod nearest;
mod revolve;
mod space;
mod struck;
mod turned;

pub use drawn::Drawing;
pub use space::Vector;
pub(crate) use space::{add, between, cross, dot, unit};
pub use struck::Place;

use super::kind::Kind;
use crate::engine::Partial;
use beam::Beam;
use drawn::Given;
use edges::edges;
use finer::Halved;
use modes::{Material, ModeLabel};
use std::collections::HashMap;
use std::ops::Range;
use struck::Lines;
use turned::Turned;

/// The surface of a body, in the coordinates of its strike line.
#[derive(Clone, Debug)]
pub struct Solid {
    /// What it is.
    pub kind: Kind,
    /// Points on the surface, in m.
    pub points_m: Vec<Vector>,
    /// Outward unit normals at the points.
    pub normals: Vec<Vector>,
    /// Triangles of points, counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The place on the strike line, 0…1, that each point is struck as; none where a drawing is struck
    /// as what of its strike grid is nearest.
    pub places: Vec<f32>,
    /// Two points and the triangles on both sides, for every edge between two triangles.
    pub(crate) edges: Vec<[u32; 4]>,
    /// How much thicker than it is a slender body is drawn.
    pub thicker: f32,
    lines: Lines,
    motions: Motions,
}

/// How the modes move the points, in the order of [`Partial::all`].
#[derive(Clone, Debug)]
enum Motions {
    Turned(Turned),
    Beam(Beam),
    Given(Given),
    Halved(Box<Halved>),
}

impl Motions {
    fn motion(&self, mode: usize) -> Vec<Vector> {
        match self {
            Self::Turned(turned) => turned.motion(mode),
            Self::Beam(beam) => beam.motion(mode),
            Self::Given(given) => given.motion(mode),
            Self::Halved(halved) => halved.motion(mode),
        }
    }
}

/// A surface without motion.
#[derive(Default)]
struct Skin {
    points_m: Vec<Vector>,
    normals: Vec<Vector>,
    triangles: Vec<[u32; 3]>,
}

impl Skin {
    /// Joins two rows of points, the second to the left of the first as seen from outside.
    fn join(&mut self, first: Range<u32>, second: Range<u32>) {
        let first: Vec<u32> = first.collect();
        let second: Vec<u32> = second.collect();
        for (a, b) in first.windows(2).zip(second.windows(2)) {
            self.triangles.push([a[0], a[1], b[1]]);
            self.triangles.push([a[0], b[1], b[0]]);
        }
    }
}

impl Solid {
    /// That of a bank's body of this material.
    #[must_use]
    pub fn of(body: &modes::Body, material: &Material) -> Self {
        if let Some(surface) = &body.surface {
            return Self::drawn(Kind::Other, Drawing::of(body, surface));
        }
        let kind = Kind::of(body);
        let (skin, places, motions, thicker) = match kind {
            Kind::Bar => {
                let shape = bar::Bar::of(body, material);
                let (skin, places) = shape.skin();
                let beam = Beam::of(body, &shape, &skin.points_m);
                (skin, places, Motions::Beam(beam), 1.0)
            }
            Kind::Tube | Kind::Bowl | Kind::Other => {
                let profile = revolve::Profile::of(body, material, kind);
                let (skin, places) = profile.skin();
                let thicker = profile.thicker;
                (
                    skin,
                    places,
                    Motions::Turned(Turned::of(body, &profile)),
                    thicker,
                )
            }
        };
        let mut lines = Lines::of(&body.line);
        for point in &mut lines.points_m {
            if kind == Kind::Tube {
                point[0] *= thicker;
            }
        }
        Self {
            kind,
            edges: edges(&skin.triangles, &skin.points_m),
            points_m: skin.points_m,
            normals: skin.normals,
            triangles: skin.triangles,
            places,
            thicker,
            lines,
            motions,
        }
    }

    /// What a mode, by its number among the [`Partial`]s, moves each point by: φ in kg^(−1/2). Nothing if
    /// there is no such mode.
    #[must_use]
    pub fn motion(&self, mode: usize) -> Vec<Vector> {
        self.motions.motion(mode)
    }
}

/// The modes of a body by their names.
fn by_name(body: &modes::Body) -> HashMap<ModeLabel, &modes::Mode> {
    body.modes.iter().map(|mode| (mode.label, mode)).collect()
}

/// The modes that are heard, in the order of [`Partial::all`].
fn heard_modes(body: &modes::Body) -> Vec<&modes::Mode> {
    let known = by_name(body);
    let find = |partial: &Partial| known.get(&partial.label).copied();
    Partial::all(body).iter().filter_map(find).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factory;
    use modes::Family;

    fn solids() -> Vec<(Solid, &'static modes::Body)> {
        [0, 1, 2, 3]
            .map(|index| {
                let bank = factory::bank(index);
                let body = &bank.bodies[20];
                (Solid::of(body, &bank.material), body)
            })
            .into()
    }

    /// Volume within the triangles, in m³.
    fn volume_m3(solid: &Solid) -> f32 {
        let corner = |i: u32| solid.points_m[i as usize];
        let six = |t: &[u32; 3]| dot(corner(t[0]), cross(corner(t[1]), corner(t[2])));
        solid.triangles.iter().map(six).sum::<f32>() / 6.0
    }

    #[test]
    fn surfaces_are_closed_and_hold_the_body_s_mass() {
        for (index, (solid, body)) in solids().iter().enumerate() {
            assert_eq!(2 * solid.edges.len(), 3 * solid.triangles.len(), "closed");
            let density = factory::bank(index).material.density_kg_m3;
            let kg = f64::from(volume_m3(solid)) * density;
            if solid.thicker == 1.0 {
                assert!(
                    (kg / body.mass_kg - 1.0).abs() < 0.03,
                    "{kg} {}",
                    body.mass_kg
                );
            } else {
                assert!(kg > body.mass_kg);
            }
        }
    }

    #[test]
    fn normals_point_out_of_the_triangles() {
        for (solid, _) in solids() {
            for triangle in &solid.triangles {
                let [a, b, c] = triangle.map(|i| solid.points_m[i as usize]);
                let out = cross(add(b, -1.0, a), add(c, -1.0, a));
                for i in triangle {
                    assert!(
                        dot(out, solid.normals[*i as usize]) >= -1e-9,
                        "{triangle:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn on_the_strike_line_the_surface_moves_as_the_bank_says() {
        for (solid, body) in solids() {
            let modes = heard_modes(body);
            let count = body.line.len();
            for i in [0, count / 3, count - 1] {
                let place = i as f32 / (count - 1) as f32;
                let (at, normal) = solid.at([place, 0.0]);
                let away = |p: &Vector| {
                    let d = add(*p, -1.0, at);
                    dot(d, d)
                };
                let nearest = (0..solid.points_m.len())
                    .filter(|p| dot(solid.normals[*p], normal) > 0.9)
                    .min_by(|a, b| away(&solid.points_m[*a]).total_cmp(&away(&solid.points_m[*b])))
                    .unwrap();
                for (k, mode) in modes.iter().enumerate().take(8) {
                    let most = mode
                        .shape
                        .iter()
                        .flat_map(IntoIterator::into_iter)
                        .fold(0.0f32, |m, x| m.max(x.abs()));
                    // What twists goes with the way from the axis.
                    let across = match mode.label.family {
                        Family::Torsion if solid.kind == Kind::Bar => {
                            solid.points_m[nearest][1] / at[1]
                        }
                        _ => 1.0,
                    };
                    let told = across * dot(mode.shape.at(i), normal);
                    let drawn = dot(solid.motion(k)[nearest], normal);
                    assert!(
                        (told - drawn).abs() < 0.08 * most,
                        "{:?} {} at {place}: {told}, drawn {drawn}",
                        solid.kind,
                        mode.label
                    );
                }
            }
        }
    }
}
