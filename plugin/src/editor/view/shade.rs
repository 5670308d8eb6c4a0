//! The light on a surface.

use super::super::solid::{Vector, dot, unit};
use egui::Color32;

/// Where the lamp is, as the eye sees it: left, above, near.
const LAMP: Vector = [-0.42, 0.66, 0.62];
/// Sharpness of what the lamp mirrors.
const POLISH: i32 = 26;

/// How a surface takes up light.
pub(super) struct Shade {
    own: [f32; 3],
    out: [f32; 3],
    in_: [f32; 3],
    /// Share that is mirrored rather than spread.
    metal: f32,
    lamp: Vector,
}

fn parts(colour: Color32) -> [f32; 3] {
    [colour.r(), colour.g(), colour.b()].map(f32::from)
}

impl Shade {
    /// Of a material of this colour; what moves outwards and inwards has the two others.
    pub(super) fn new(own: Color32, [out, in_]: [Color32; 2], metal: bool) -> Self {
        Self {
            own: parts(own),
            out: parts(out),
            in_: parts(in_),
            metal: if metal { 0.62 } else { 0.12 },
            lamp: unit(LAMP),
        }
    }

    /// The colour of a map that lies on the surface where the normal is so: in a soft light, lest shade be taken
    /// for what the map says.
    pub(super) fn mapped(&self, normal: Vector, own: Color32) -> Color32 {
        let light = 0.74 + 0.26 * dot(normal, self.lamp).max(0.0);
        #[expect(clippy::cast_sign_loss, reason = "colours are not negative")]
        let [r, g, b] = parts(own).map(|x| (light * x) as u8);
        Color32::from_rgb(r, g, b)
    }

    /// The colour where the normal is so for the eye and the surface moves so far along it, −1…1.
    pub(super) fn colour(&self, normal: Vector, out: f32) -> Color32 {
        let towards = if out < 0.0 { &self.in_ } else { &self.out };
        let warm = 0.8 * out.abs();
        let facing = normal[2].max(0.0);
        let lit = dot(normal, self.lamp).max(0.0);
        // The way to the eye, mirrored.
        let mirrored = [0, 1, 2].map(|k| 2.0 * normal[2] * normal[k] - f32::from(u8::from(k == 2)));
        let spark = dot(mirrored, self.lamp).max(0.0).powi(POLISH);
        // A bright ceiling over a dim floor, with a soft line between.
        let sky = 0.5 + 0.5 * (2.6 * mirrored[1]).clamp(-1.0, 1.0);
        let spread = 0.24 + 0.64 * lit;
        let mirror = 0.26 + 0.72 * sky * sky + 0.22 * (1.0 - sky) * (1.0 - facing);
        let body = spread + self.metal * (mirror - spread);
        let edge = 1.0 - 0.2 * (1.0 - facing).powi(3);
        let mut rgb = [0.0; 3];
        for k in 0..3 {
            let base = self.own[k] + warm * (towards[k] - self.own[k]);
            let gloss = 210.0 * (0.25 + 0.5 * self.metal) * spark;
            rgb[k] = (base * (body * edge + 0.25 * warm) + gloss).clamp(0.0, 255.0);
        }
        #[expect(clippy::cast_sign_loss, reason = "colours are not negative")]
        let [r, g, b] = rgb.map(|x| x as u8);
        Color32::from_rgb(r, g, b)
    }
}
