//! Colours whose lightness follows the level.

/// Hue at the lowest and the highest level, in degrees, by way of red.
const HUES_DEG: [f64; 2] = [285.0, 455.0];
/// Oklab lightness at the lowest and the highest level.
const LIGHTNESS: [f64; 2] = [0.10, 0.97];
/// Greatest chroma, before what no screen shows is taken off.
const CHROMA: f64 = 0.19;

/// The colour of a level, 0 the lowest and 1 the highest, as sRGB bytes.
///
/// Equal steps of level are equal steps of lightness to the eye (Ottosson 2020, *A perceptual
/// color space for image processing*), so that no level looks like an edge.
pub(super) fn of_level(level: f64) -> [u8; 3] {
    let level = level.clamp(0.0, 1.0);
    let between = |ends: [f64; 2]| ends[0] + level * (ends[1] - ends[0]);
    let lightness = between(LIGHTNESS);
    let hue = between(HUES_DEG).to_radians();
    // Little colour in the darkest and the lightest, most of it between.
    let wanted = CHROMA
        * (std::f64::consts::PI * level.powf(0.8))
            .sin()
            .max(0.0)
            .sqrt();
    let shown = |chroma: f64| linear_srgb(lightness, chroma * hue.cos(), chroma * hue.sin());
    let (mut least, mut most) = (0.0, wanted);
    if !on_screen(shown(most)) {
        for _ in 0..24 {
            let middle = 0.5 * (least + most);
            if on_screen(shown(middle)) {
                least = middle;
            } else {
                most = middle;
            }
        }
        most = least;
    }
    shown(most).map(encode)
}

fn on_screen(rgb: [f64; 3]) -> bool {
    rgb.iter().all(|part| (-1e-4..=1.0001).contains(part))
}

/// Oklab to linear sRGB, by Ottosson's matrices.
fn linear_srgb(lightness: f64, a: f64, b: f64) -> [f64; 3] {
    let cube = |x: f64| x * x * x;
    let l = cube(lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b);
    let m = cube(lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b);
    let s = cube(lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b);
    [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ]
}

/// A linear part of light as an sRGB byte (IEC 61966-2-1).
fn encode(linear: f64) -> u8 {
    let linear = linear.clamp(0.0, 1.0);
    let encoded = if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    };
    #[expect(clippy::cast_sign_loss, reason = "linear is at least 0")]
    let byte = (255.0 * encoded).round() as u8;
    byte
}

#[cfg(test)]
mod tests {
    use super::*;

    /// CIE luminance of an sRGB colour.
    fn luminance(colour: [u8; 3]) -> f64 {
        let linear = colour.map(|byte| {
            let encoded = f64::from(byte) / 255.0;
            if encoded <= 0.040_45 {
                encoded / 12.92
            } else {
                ((encoded + 0.055) / 1.055).powf(2.4)
            }
        });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    #[test]
    fn higher_levels_are_lighter() {
        let mut before = -1.0;
        for step in 0..=64 {
            let now = luminance(of_level(f64::from(step) / 64.0));
            assert!(now > before, "step {step}");
            before = now;
        }
        assert!(before > 0.85);
    }

    #[test]
    fn grey_has_no_colour() {
        let [r, g, b] = linear_srgb(1.0, 0.0, 0.0);
        for part in [r, g, b] {
            assert!((part - 1.0).abs() < 1e-6);
        }
    }
}
