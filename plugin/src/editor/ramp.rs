//! Colours for numbers: from one to another in steps that look alike.

use super::theme::Theme;
use egui::Color32;
use std::sync::LazyLock;

/// Colours that are worked out.
const STEPS: usize = 256;

/// A colour in OKLab (Ottosson 2020): lightness 0…1, green to red, blue to yellow. Equal distances look about
/// equally different.
type Lab = [f32; 3];

/// Colours from the one for 0 to the one for 1.
pub(super) struct Ramp {
    colours: [Color32; STEPS],
}

impl Ramp {
    /// The one of a theme.
    pub(super) fn of(theme: &Theme) -> &'static Self {
        static DARK: LazyLock<Ramp> = LazyLock::new(|| Ramp::through(&Theme::DARK.ramp));
        static LIGHT: LazyLock<Ramp> = LazyLock::new(|| Ramp::through(&Theme::LIGHT.ramp));
        if theme.dark { &DARK } else { &LIGHT }
    }

    /// Straight through OKLab from stop to stop, at one pace all the way.
    fn through(stops: &[Color32]) -> Self {
        let labs: Vec<Lab> = stops.iter().map(|stop| lab(*stop)).collect();
        let ways: Vec<f32> = labs.windows(2).map(|w| apart(w[0], w[1])).collect();
        let whole: f32 = ways.iter().sum();
        let colour = |step: usize| {
            let mut left = whole * step as f32 / (STEPS - 1) as f32;
            let mut leg = 0;
            while leg + 1 < ways.len() && left > ways[leg] {
                left -= ways[leg];
                leg += 1;
            }
            let share = left / ways[leg];
            let [from, to] = [labs[leg], labs[leg + 1]];
            srgb([0, 1, 2].map(|k| from[k] + share * (to[k] - from[k])))
        };
        Self {
            colours: std::array::from_fn(colour),
        }
    }

    /// The colour for a share 0…1.
    pub(super) fn colour(&self, share: f32) -> Color32 {
        #[expect(clippy::cast_sign_loss, reason = "what is below 0 saturates")]
        let step = (share * (STEPS - 1) as f32).round() as usize;
        self.colours[step.min(STEPS - 1)]
    }
}

fn apart(one: Lab, other: Lab) -> f32 {
    let squares = (0..3).map(|k| (one[k] - other[k]).powi(2));
    squares.sum::<f32>().sqrt()
}

/// A part of a colour from what screens take, 0…255, to light.
fn light(part: u8) -> f32 {
    let part = f32::from(part) / 255.0;
    if part <= 0.04045 {
        part / 12.92
    } else {
        ((part + 0.055) / 1.055).powf(2.4)
    }
}

/// And back.
fn part(light: f32) -> u8 {
    let part = if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * light.powf(1.0 / 2.4) - 0.055
    };
    #[expect(clippy::cast_sign_loss, reason = "what is below 0 saturates")]
    let part = (255.0 * part).round() as u8;
    part
}

fn times(rows: [[f32; 3]; 3], by: [f32; 3]) -> [f32; 3] {
    rows.map(|row| (0..3).map(|k| row[k] * by[k]).sum())
}

fn lab(colour: Color32) -> Lab {
    let rgb = [colour.r(), colour.g(), colour.b()].map(light);
    let cones = times(
        [
            [0.412_221_47, 0.536_332_54, 0.051_445_995],
            [0.211_903_5, 0.680_699_5, 0.107_396_96],
            [0.088_302_46, 0.281_718_85, 0.629_978_7],
        ],
        rgb,
    );
    times(
        [
            [0.210_454_26, 0.793_617_8, -0.004_072_047],
            [1.977_998_5, -2.428_592_2, 0.450_593_7],
            [0.025_904_037, 0.782_771_77, -0.808_675_77],
        ],
        cones.map(f32::cbrt),
    )
}

fn srgb(lab: Lab) -> Color32 {
    let cones = times(
        [
            [1.0, 0.396_337_78, 0.215_803_76],
            [1.0, -0.105_561_346, -0.063_854_17],
            [1.0, -0.089_484_18, -1.291_485_5],
        ],
        lab,
    );
    let [r, g, b] = times(
        [
            [4.076_741_7, -3.307_711_6, 0.230_969_94],
            [-1.268_438, 2.609_757_4, -0.341_319_4],
            [-0.004_196_086_3, -0.703_418_6, 1.707_614_7],
        ],
        cones.map(|x| x.powi(3)),
    )
    .map(part);
    Color32::from_rgb(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramps() -> [(&'static Ramp, Theme); 2] {
        [Theme::DARK, Theme::LIGHT].map(|theme| (Ramp::of(&theme), theme))
    }

    #[test]
    fn colours_go_to_lab_and_back() {
        for rgb in [[0, 0, 0], [255, 255, 255], [12, 200, 90], [253, 3, 130]] {
            let [r, g, b] = rgb;
            assert_eq!(
                srgb(lab(Color32::from_rgb(r, g, b))),
                Color32::from_rgb(r, g, b)
            );
        }
        // White is of no colour.
        let [l, a, b] = lab(Color32::WHITE);
        assert!((l - 1.0).abs() < 1e-4 && a.abs() < 1e-4 && b.abs() < 1e-4);
    }

    #[test]
    fn ramps_begin_and_end_with_their_stops() {
        for (ramp, theme) in ramps() {
            assert_eq!(Some(&ramp.colour(0.0)), theme.ramp.first());
            assert_eq!(Some(&ramp.colour(1.0)), theme.ramp.last());
            assert_eq!(ramp.colour(7.0), ramp.colour(1.0));
            assert_eq!(ramp.colour(f32::NAN), ramp.colour(0.0));
        }
    }

    /// Sixteen steps are as long as each other, but where the way bends.
    #[test]
    fn steps_look_alike() {
        for (ramp, theme) in ramps() {
            let labs: Vec<Lab> = (0..=16)
                .map(|i| lab(ramp.colour(i as f32 / 16.0)))
                .collect();
            let steps: Vec<f32> = labs.windows(2).map(|w| apart(w[0], w[1])).collect();
            let mean = steps.iter().sum::<f32>() / steps.len() as f32;
            for step in &steps {
                assert!((step / mean - 1.0).abs() < 0.2, "{} {steps:?}", theme.dark);
            }
        }
    }

    /// Who sees no colours reads the ramp by its lightness, which falls all the way and evenly.
    #[test]
    fn lightness_tells_it_all() {
        for (ramp, _) in ramps() {
            let lightness = |i: i32| lab(ramp.colour(i as f32 / 16.0))[0];
            let whole = lightness(0) - lightness(16);
            assert!(whole > 0.4, "{whole}");
            for i in 0..16 {
                let step = (lightness(i) - lightness(i + 1)) / whole * 16.0;
                assert!((step - 1.0).abs() < 0.25, "{step}");
            }
        }
    }
}
