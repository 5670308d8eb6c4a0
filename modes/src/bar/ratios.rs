//! What vibraphones are tuned to and made from.

use super::BarStock;
use crate::equal_temperament_hz;

/// F5, up to which the partials stay at 1 : 4 : 10.
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

/// Frequencies of the second and third bending modes as multiples of the first.
///
/// 4 and 10 up to F5, then falling by equal steps a key to 3.5 and 6.5 at F6, as bars of Musser M55
/// and Ross sets do (wyndorps.de, E_DIY_01; their third mode starts from 11 at the bottom, where 10
/// is what makers name); 3.5 and 6.5 above.
#[must_use]
pub fn vibraphone_ratios(key: u8) -> [f64; 2] {
    let top = top_octave(key);
    [4.0 - 0.5 * top, 10.0 - 3.5 * top]
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
