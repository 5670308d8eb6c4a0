//! What vibraphones are tuned to and made from.

use super::BarStock;
use crate::equal_temperament_hz;

/// F5, up to which the ratios of the partials stay.
const LAST_STRAIGHT_KEY: u8 = 77;

/// F6, the highest key of a vibraphone.
const HIGHEST_KEY: u8 = 89;

/// F3, its lowest.
const LOWEST_KEY: u8 = 53;

/// F♯3, whose bar is 0.360 m long (O'Brien 2001).
const F_SHARP_3: (u8, f64) = (54, 0.360);

/// How fast bars get shorter upwards: length as pitch to the power of minus this. At ½, bars of one
/// thickness would all be the same drawing stretched.
const SHORTENING: f64 = 0.48;

/// Share of the way from F5 to F6, 0 below and 1 above.
fn top_octave(key: u8) -> f64 {
    let key = key.clamp(LAST_STRAIGHT_KEY, HIGHEST_KEY);
    f64::from(key - LAST_STRAIGHT_KEY) / f64::from(HIGHEST_KEY - LAST_STRAIGHT_KEY)
}

/// A4.
const HIGHEST_FAR_KEY: u8 = 69;

/// Frequencies of the second and third bending modes as multiples of the first.
///
/// 4.01 and 10.17 (10.173 up to A4, where real bars lie farther out) up to F5, then falling by equal
/// steps a key to 3.5 and 6.5 at F6, as bars of Musser M55 and Ross sets do
/// (wyndorps.de, E_DIY_01); 3.5 and 6.5 above. Makers name 4 and 10; the bars of
/// those sets have 4 and up to 11, recorded bars 3.98 to 4.06 and 10.13 to 10.33: this is the side
/// of the makers' figures on which real bars lie.
#[must_use]
pub fn vibraphone_ratios(key: u8) -> [f64; 2] {
    let top = top_octave(key);
    let mix = |straight: f64, highest: f64| straight + top * (highest - straight);
    let third = if key <= HIGHEST_FAR_KEY {
        10.173
    } else {
        10.17
    };
    [mix(4.01, 3.5), mix(third, 6.5)]
}

/// Partials of a bar that is hollowed least, and of one hollowed most, over those asked for.
const SHALLOW: [f64; 2] = [0.85, 0.75];
const DEEP: [f64; 2] = [1.08, 1.12];

/// What an undercut of −1 (shallow) to 1 (deep) makes of the second and third partial of 0, as multiples
/// of the first.
#[must_use]
pub fn stretched(ratios: [f64; 2], undercut: f64) -> [f64; 2] {
    let end = if undercut < 0.0 { SHALLOW } else { DEEP };
    [0, 1].map(|i| ratios[i] * (1.0 + undercut.abs() * (end[i] - 1.0)))
}

/// The stock that the bar of MIDI `key` is cut from.
///
/// Up to F5 half an inch thick and as long as makes F♯3 0.360 m; from there to F6 thinner by equal
/// steps to 9.5 mm and shorter by equal ratios to 0.158 m, with which bars can have the partials of
/// [`vibraphone_ratios`]; above F6 the same proportions. Width from 57 mm at F3 to 38 mm at F6 by
/// equal steps.
#[must_use]
pub fn vibraphone_stock(key: u8) -> BarStock {
    const THICK_M: f64 = 0.0127;
    const TOP_THICKNESS_M: f64 = 0.0095;
    const TOP_LENGTH_M: f64 = 0.158;
    let hz = |key| equal_temperament_hz(key, 440.0);
    let straight = key.min(LAST_STRAIGHT_KEY);
    let straight_m = F_SHARP_3.1 * (hz(F_SHARP_3.0) / hz(straight)).powf(SHORTENING);
    let top = top_octave(key);
    let beyond = hz(HIGHEST_KEY) / hz(key.max(HIGHEST_KEY));
    let graduated = f64::from(key.clamp(LOWEST_KEY, HIGHEST_KEY) - LOWEST_KEY)
        / f64::from(HIGHEST_KEY - LOWEST_KEY);
    BarStock {
        length_m: beyond * straight_m.powf(1.0 - top) * TOP_LENGTH_M.powf(top),
        width_m: beyond * (0.057 + graduated * (0.038 - 0.057)),
        thickness_m: beyond * (THICK_M + top * (TOP_THICKNESS_M - THICK_M)),
    }
}
