//! Bars: a rounded section along the x axis, hollowed from below.

use super::{Skin, Vector};
use modes::Material;
use modes::shape::{Bar as Cut, Undercut};
use std::f32::consts::FRAC_PI_2;

/// Distance of the strike line from the middle of a bar, as a share of its width.
const STRUCK_ASIDE: f64 = 0.1;
/// Length from which stock is half an inch thick, and that from which on it is of one proportion, in m,
/// with their thicknesses.
const LONG: [f64; 2] = [0.223, 0.0127];
const SHORT: [f64; 2] = [0.158, 0.0095];
/// How much of the half length the arch takes, and how steep its flanks are, in the picture.
const ARCH: f64 = 0.66;
const STEEP: f64 = 3.0;
/// Radius of the edges as a share of the thickness.
const ROUND: f64 = 0.16;
/// Sections along the bar, and points on each rounded edge.
const ALONG: u32 = 72;
const CORNER: u32 = 4;
/// Parts into which the flat sides across the bar are cut.
const ACROSS: u32 = 6;

/// A bar as it is drawn: of its own length, width and mass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bar {
    cut: Cut,
    /// Where y is struck, in m.
    pub(super) aside_m: f64,
}

impl Bar {
    pub(super) fn of(body: &modes::Body, material: &Material) -> Self {
        let aside_m = body.line.points_m.first().map_or(0.0, |point| point[1]);
        let width_m = if aside_m > 0.0 {
            aside_m / STRUCK_ASIDE
        } else {
            0.15 * body.length_m
        };
        let volume_m3 = body.mass_kg / material.density_kg_m3;
        let share = ((body.length_m - SHORT[0]) / (LONG[0] - SHORT[0])).clamp(0.0, 1.0);
        let shrunk = (body.length_m / SHORT[0]).min(1.0);
        let stock_m = shrunk * (SHORT[1] + share * (LONG[1] - SHORT[1]));
        let thickness_m = stock_m.max(volume_m3 / (body.length_m * width_m));
        let with = |centre_thickness_m: f64| Cut {
            undercut: Undercut {
                centre_thickness_m,
                half_length_m: 0.5 * ARCH * body.length_m,
                exponent: STEEP,
            },
            ..Cut::uniform(body.length_m, width_m, thickness_m)
        };
        // What an arch takes goes with its depth.
        let [full, hollow] = [thickness_m, 0.0].map(|centre_m| with(centre_m).volume_m3());
        let left = ((volume_m3 - hollow) / (full - hollow)).clamp(0.1, 1.0);
        Self {
            cut: with(left * thickness_m),
            aside_m,
        }
    }

    /// Half the length, in m.
    pub(super) fn half_m(&self) -> f64 {
        0.5 * self.cut.length_m
    }

    /// Height in a bar's thickness at x of a point at z: 1 on top, −1 below.
    pub(super) fn height(&self, [x, _, z]: Vector) -> f32 {
        let thick_m = self.cut.thickness_at_m(f64::from(x)) as f32;
        1.0 + 2.0 * z / thick_m
    }

    /// The surface, and the place on the strike line of each point.
    pub(super) fn skin(&self) -> (Skin, Vec<f32>) {
        let mut skin = Skin::default();
        let half_m = self.half_m();
        let mut rows: Vec<(u32, u32)> = Vec::new();
        for i in 0..=ALONG {
            let x_m = half_m * (2.0 * f64::from(i) / f64::from(ALONG) - 1.0);
            rows.push(self.section(&mut skin, x_m, None));
        }
        for pair in rows.windows(2) {
            skin.join(pair[0].0..pair[0].1, pair[1].0..pair[1].1);
        }
        for way in [-1.0f32, 1.0] {
            let (start, end) = self.section(&mut skin, half_m * f64::from(way), Some(way));
            let middle = end;
            let z = -0.5 * self.cut.thickness_at_m(half_m);
            skin.points_m.push([half_m as f32 * way, 0.0, z as f32]);
            skin.normals.push([way, 0.0, 0.0]);
            for i in start..end - 1 {
                let [a, b] = if way > 0.0 { [i, i + 1] } else { [i + 1, i] };
                skin.triangles.push([middle, a, b]);
            }
        }
        let place = |point: &Vector| (point[0].abs() / half_m as f32).min(1.0);
        let places = skin.points_m.iter().map(place).collect();
        (skin, places)
    }

    /// Adds the outline of the section at x, counter-clockwise with x towards the eye and with its first
    /// point at its end again; `flat` is the way that all its normals point. The range of its points.
    fn section(&self, skin: &mut Skin, x_m: f64, flat: Option<f32>) -> (u32, u32) {
        let start = skin.points_m.len() as u32;
        let thick_m = self.cut.thickness_at_m(x_m);
        let radius_m = ROUND * thick_m.min(self.cut.thickness_m);
        let [wide, high] = [0.5 * self.cut.width_m - radius_m, 0.5 * thick_m - radius_m];
        // Along the bottom it slopes.
        let slope = {
            let step_m = 1e-3 * self.cut.length_m;
            let [a, b] = [-step_m, step_m].map(|d| self.cut.thickness_at_m(x_m + d));
            if flat.is_some() {
                0.0
            } else {
                (b - a) / (2.0 * step_m)
            }
        };
        let mut put = |y: f64, z: f64, out: [f64; 2]| {
            skin.points_m
                .push([x_m, y, z - 0.5 * thick_m].map(|x| x as f32));
            let lean = if out[1] < 0.0 { -slope * out[1] } else { 0.0 };
            let length = (out[0].powi(2) + out[1].powi(2) + lean * lean).sqrt();
            skin.normals.push(match flat {
                Some(way) => [way, 0.0, 0.0],
                None => [lean, out[0], out[1]].map(|x| (x / length) as f32),
            });
        };
        // Right, top, left, bottom: each corner turns by a quarter.
        let corners = [[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]];
        for (number, [right, up]) in (0u8..).zip(corners) {
            for step in 0..=CORNER {
                let turn = f64::from(FRAC_PI_2)
                    * (f64::from(number) - 1.0 + f64::from(step) / f64::from(CORNER));
                let (sin, cos) = turn.sin_cos();
                let [y, z] = [right * wide + radius_m * cos, up * high + radius_m * sin];
                put(y, z, [cos, sin]);
            }
            // The flats on top and below, from the corner's end to the next corner.
            if number % 2 == 1 {
                for part in 1..ACROSS {
                    let y = right * wide * (1.0 - 2.0 * f64::from(part) / f64::from(ACROSS));
                    put(y, up * (high + radius_m), [0.0, up]);
                }
            }
        }
        let (point, normal) = (skin.points_m[start as usize], skin.normals[start as usize]);
        skin.points_m.push(point);
        skin.normals.push(normal);
        (start, skin.points_m.len() as u32)
    }
}
