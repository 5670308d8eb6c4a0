//! Which body to strike for a pitch.

/// Of the bodies whose keys are bits in `has_body`, each tuned to its key in equal temperament with
/// 440 Hz on key 69: the key of the one nearest to `hz`, and by how many semitones it is to be
/// retuned to get there. Of two bodies equally near, the lower.
///
/// For keys that a tuning takes far from where equal temperament has them. A body retuned by a few
/// semitones is as good as one that its maker cut a little shorter or longer; over an octave or so its
/// partials, its loudness and its decay are no longer those of an instrument. Keys may then share a
/// body.
///
/// `None` if there is no body or `hz` is no frequency. Allocates nothing.
#[must_use]
pub fn nearest_body(hz: f64, has_body: u128) -> Option<(u8, f64)> {
    if !(hz.is_finite() && hz > 0.0) {
        return None;
    }
    let key = 69.0 + 12.0 * (hz / 440.0).log2();
    let semitones = |body: u8| key - f64::from(body);
    (0..128)
        .filter(|body| has_body >> body & 1 == 1)
        .map(|body| (body, semitones(body)))
        .min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
}

#[cfg(test)]
mod tests {
    use super::nearest_body;

    const CHIMES: u128 = ((1 << 61) - 1) << 36;

    fn assert_near(hz: f64, has_body: u128, body: u8, semitones: f64) {
        let (key, by) = nearest_body(hz, has_body).unwrap();
        assert_eq!(key, body, "{hz} Hz");
        assert!((by - semitones).abs() < 1e-12, "{hz} Hz: {by}");
    }

    #[test]
    fn the_nearest_body_is_struck() {
        assert_near(440.0, CHIMES, 69, 0.0);
        assert_near(440.0 * (0.49_f64 / 12.0).exp2(), CHIMES, 69, 0.49);
        assert_near(440.0 * (0.51_f64 / 12.0).exp2(), CHIMES, 70, -0.49);
        assert_near(440.0 * 32.0, CHIMES, 96, 33.0);
        assert_near(6.875, CHIMES, 36, -39.0);
        assert_near(440.0, 1, 0, 69.0);
        assert_near(440.0, 1 << 127, 127, -58.0);
    }

    #[test]
    fn gaps_are_bridged_and_ties_go_down() {
        let two = 1 << 60 | 1 << 72;
        assert_near(440.0, two, 72, -3.0);
        assert_near(440.0 * (-3.0_f64 / 12.0).exp2(), 1 << 65 | 1 << 67, 65, 1.0);
    }

    #[test]
    fn without_a_body_or_a_frequency_there_is_none() {
        assert_eq!(nearest_body(440.0, 0), None);
        for hz in [0.0, -440.0, f64::NAN, f64::INFINITY] {
            assert_eq!(nearest_body(hz, CHIMES), None);
        }
    }
}
