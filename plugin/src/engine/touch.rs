//! From a note and chance to how fast and where the mallet lands.

use super::{Hit, Settings};

/// Impact speed at full velocity, in m/s.
const FULL_SPEED_M_S: f64 = 5.0;

/// One blow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Touch {
    /// Impact speed, in m/s.
    pub(crate) speed_m_s: f64,
    /// Where along the strike grid, 0…1.
    pub(crate) position: f64,
    /// Where across it, 0…1.
    pub(crate) across: f64,
}

impl Touch {
    /// Speed and place of a hit, both a little off by `chance`, two numbers in −1…1.
    pub(crate) fn new(settings: &Settings, hit: &Hit, chance: [f64; 2]) -> Self {
        let decibels = settings.velocity_range_db * (hit.velocity - 1.0)
            + settings.speed_scatter_db * chance[1];
        let moved =
            settings.velocity_to_position * hit.velocity + settings.position_scatter * chance[0];
        Self {
            speed_m_s: FULL_SPEED_M_S * 10f64.powf(decibels / 20.0),
            position: reflect(settings.strike_position + hit.position + 0.5 * moved),
            across: settings.strike_across + hit.across,
        }
    }
}

/// Folds back at the ends of the line.
fn reflect(position: f64) -> f64 {
    let folded = position.abs();
    if folded > 1.0 { 2.0 - folded } else { folded }.clamp(0.0, 1.0)
}

/// Bits that depend on nothing but the key and the time (the finaliser of `SplitMix64`, Steele et al.
/// 2014), so that a song renders the same every time.
pub(crate) fn grain(key: u8, position: u64) -> u64 {
    let mut z = position.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (u64::from(key) << 56);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Two numbers in −1…1 that depend on nothing but the arguments.
pub(crate) fn chance(key: u8, position: u64) -> [f64; 2] {
    let first = grain(key, position);
    [first, grain(key, !position)].map(|bits| (bits >> 11) as f64 / (1u64 << 52) as f64 - 1.0)
}

#[cfg(test)]
mod tests {
    use super::{Touch, chance, reflect};
    use crate::engine::{Hit, Settings};

    #[test]
    fn velocity_spans_its_range_in_decibels() {
        let settings = Settings::default();
        let speed = |v| Touch::new(&settings, &Hit::plain(v).sane(), [0.0; 2]).speed_m_s;
        assert!((speed(1.0) - 5.0).abs() < 1e-12);
        assert!((speed(0.0) - 0.05).abs() < 1e-12);
        assert!((speed(0.5) - 0.5).abs() < 1e-12);
        for odd in [f64::NAN, -1.0, f64::NEG_INFINITY] {
            assert_eq!(speed(odd), speed(0.0));
        }
        assert_eq!(speed(f64::INFINITY), speed(1.0));
        let scattered = Settings {
            speed_scatter_db: 6.0,
            ..settings
        };
        let most = Touch::new(&scattered, &Hit::plain(0.5), [0.0, 1.0]).speed_m_s;
        assert!((most / speed(0.5) - 10f64.powf(0.3)).abs() < 1e-12);
    }

    #[test]
    fn strikes_stay_on_the_line() {
        assert_eq!(reflect(-0.25), 0.25);
        assert_eq!(reflect(1.25), 0.75);
        assert_eq!(reflect(0.5), 0.5);
    }

    #[test]
    fn chance_is_spread_evenly() {
        let draws: Vec<f64> = (0..10_000).map(|n| chance(60, n * 480)[0]).collect();
        let mean = draws.iter().sum::<f64>() / 1e4;
        let square = draws.iter().map(|x| x * x).sum::<f64>() / 1e4;
        assert!(draws.iter().all(|x| (-1.0..=1.0).contains(x)));
        assert!(mean.abs() < 0.03 && (square - 1.0 / 3.0).abs() < 0.02);
        assert_ne!(chance(60, 480), chance(61, 480));
    }
}
