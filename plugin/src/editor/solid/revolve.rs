//! Tubes and bowls: a profile turned about the z axis.

use super::super::kind::Kind;
use super::{Skin, Vector};
use modes::Material;
use std::f64::consts::{PI, TAU};

/// Points around the axis.
const AROUND_TUBE: u32 = 32;
const AROUND_BOWL: u32 = 96;
/// Length over diameter from which a tube is drawn thicker than it is, lest it be a thread.
const SLENDER: f64 = 15.0;
/// Least radius that a tube is taken to have, in m.
const THINNEST_M: f64 = 1e-4;
/// Least share of a tube's radius that its bore may have in the picture.
const BORE: f64 = 0.3;

/// A point of the profile, from the axis and up, with the way out of the body, in m.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rim {
    pub(super) r_m: f64,
    pub(super) z_m: f64,
    pub(super) normal: [f64; 2],
    /// The sample of the strike line that it moves as.
    pub(super) sample: usize,
}

/// What is turned: a closed line of points that counts its corners twice.
#[derive(Clone, Debug)]
pub(super) struct Profile {
    /// Runs of points with smooth normals, with the body on the right.
    pub(super) runs: Vec<Vec<Rim>>,
    pub(super) around: u32,
    pub(super) thicker: f32,
    samples: usize,
}

impl Profile {
    /// That of a body: outside is its strike line; inside, a wall of even thickness that gives it its mass.
    pub(super) fn of(body: &modes::Body, material: &Material, kind: Kind) -> Self {
        let line = &body.line;
        let volume_m3 = body.mass_kg / material.density_kg_m3;
        let first = line.points_m[0];
        let thicker = match kind {
            Kind::Tube => (body.length_m / (2.0 * first[0].max(THINNEST_M)) / SLENDER).max(1.0),
            Kind::Bar | Kind::Bowl | Kind::Other => 1.0,
        };
        let mut outer: Vec<Rim> = (line.points_m.iter().zip(&line.normals))
            .enumerate()
            .map(|(sample, (point, normal))| Rim {
                r_m: match kind {
                    Kind::Tube => thicker * point[0].max(THINNEST_M),
                    Kind::Bar | Kind::Bowl | Kind::Other => point[0].max(0.0),
                },
                z_m: point[2],
                normal: [normal[0], normal[2]],
                sample,
            })
            .collect();
        // With the axis upwards and the body on the right, the outside runs downwards.
        let last = outer.len() - 1;
        if outer[0].z_m < outer[last].z_m {
            outer.reverse();
        }
        let wall_m = match kind {
            Kind::Tube => {
                bore_wall_m(first[0].max(THINNEST_M), volume_m3 / body.length_m) * thicker
            }
            Kind::Bar | Kind::Bowl | Kind::Other => shell_wall_m(&outer, volume_m3),
        };
        let inner: Vec<Rim> = outer.iter().rev().map(|rim| inside(rim, wall_m)).collect();
        let runs = match kind {
            Kind::Tube => {
                let ends = [edge(&outer[last], &inner[0]), edge(&inner[last], &outer[0])];
                let [below, above] = ends;
                vec![outer, below, inner, above]
            }
            // A bowl's wall ends at the rim alone: its base closes on the axis.
            Kind::Bar | Kind::Bowl | Kind::Other => {
                let above = edge(&inner[last], &outer[0]);
                vec![outer, inner, above]
            }
        };
        Self {
            runs,
            around: match kind {
                Kind::Tube => AROUND_TUBE,
                Kind::Bar | Kind::Bowl | Kind::Other => AROUND_BOWL,
            },
            thicker: thicker as f32,
            samples: line.len(),
        }
    }

    /// Angle about the axis of a point, in rad.
    pub(super) fn angle(&self, number: u32) -> f64 {
        TAU * f64::from(number % self.around) / f64::from(self.around)
    }

    /// The surface, and the place on the strike line of each point.
    pub(super) fn skin(&self) -> (Skin, Vec<f32>) {
        let (mut skin, mut places) = (Skin::default(), Vec::new());
        let share = |sample: usize| sample as f32 / (self.samples - 1) as f32;
        for run in &self.runs {
            let start = skin.points_m.len() as u32;
            for rim in run {
                for number in 0..=self.around {
                    let (sin, cos) = self.angle(number).sin_cos();
                    let turn =
                        |[r, z]: [f64; 2]| -> Vector { [r * cos, r * sin, z].map(|x| x as f32) };
                    skin.points_m.push(turn([rim.r_m, rim.z_m]));
                    skin.normals.push(turn(rim.normal));
                    places.push(share(rim.sample));
                }
            }
            let width = self.around + 1;
            for row in 0..run.len() as u32 - 1 {
                let upper = start + row * width;
                let lower = upper + width;
                skin.join(lower..lower + width, upper..upper + width);
            }
        }
        // What closes on the axis has no width there.
        let corner = |i: u32| skin.points_m[i as usize];
        let mut triangles = std::mem::take(&mut skin.triangles);
        triangles.retain(|[a, b, c]| {
            let [a, b, c] = [*a, *b, *c].map(corner);
            a != b && b != c && c != a
        });
        skin.triangles = triangles;
        (skin, places)
    }
}

/// The wall of a tube of which a metre has this much material in m².
fn bore_wall_m(outer_m: f64, section_m2: f64) -> f64 {
    let bore = (outer_m * outer_m - section_m2 / PI).max(0.0).sqrt();
    outer_m - bore.max(BORE * outer_m)
}

/// The even wall of a bowl of that volume: by halving, as its inside is smaller than its outside.
fn shell_wall_m(outer: &[Rim], volume_m3: f64) -> f64 {
    let turned = |line: &[Rim]| -> f64 {
        let slab = |pair: &[Rim]| {
            let [a, b] = [pair[0], pair[1]];
            PI / 3.0 * (a.z_m - b.z_m) * (a.r_m * a.r_m + a.r_m * b.r_m + b.r_m * b.r_m)
        };
        line.windows(2).map(slab).sum()
    };
    let rim = |wall_m: f64| {
        let inner: Vec<Rim> = outer.iter().map(|rim| inside(rim, wall_m)).collect();
        // Between the two edges of the rim nothing is missing if the rim is level.
        turned(outer) - turned(&inner)
    };
    let (mut thin, mut thick) = (0.0, 0.9 * outer[0].r_m);
    for _ in 0..40 {
        let wall_m = 0.5 * (thin + thick);
        if rim(wall_m) < volume_m3 {
            thin = wall_m;
        } else {
            thick = wall_m;
        }
    }
    thin
}

/// The point of the inside behind one of the outside.
fn inside(rim: &Rim, wall_m: f64) -> Rim {
    let r_m = rim.r_m - wall_m * rim.normal[0];
    Rim {
        // The axis is nobody's inside.
        r_m: if rim.r_m > 1e-9 { r_m.max(0.0) } else { 0.0 },
        z_m: rim.z_m - wall_m * rim.normal[1],
        normal: rim.normal.map(|x| -x),
        sample: rim.sample,
    }
}

/// The flat edge from one wall to the other.
fn edge(from: &Rim, to: &Rim) -> Vec<Rim> {
    let [dr, dz] = [to.r_m - from.r_m, to.z_m - from.z_m];
    let length = dr.hypot(dz).max(f64::MIN_POSITIVE);
    // The body is on the right of the way.
    let normal = [-dz / length, dr / length];
    [from, to].map(|rim| Rim { normal, ..*rim }).into()
}
