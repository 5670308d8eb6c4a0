//! The pitch of a MIDI key.

/// Pitch in Hz of MIDI key `key` in equal temperament, where key 69 is A4 at `a4_hz`.
#[must_use]
pub fn equal_temperament_hz(key: u8, a4_hz: f64) -> f64 {
    a4_hz * ((f64::from(key) - 69.0) / 12.0).exp2()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn octaves_are_exact() {
        for (key, hz) in [(9, 13.75), (57, 220.0), (69, 440.0), (117, 7040.0)] {
            assert_eq!(equal_temperament_hz(key, 440.0), hz);
        }
    }

    /// The ideal frequencies of O'Brien 2002, Table 2, at the keys that MIDI gives them.
    #[test]
    fn table_2_to_its_last_digit() {
        let ideal_hz = crate::TABLE_2.map(|chime| chime.ideal_hz);
        for (key, hz) in [74, 76, 79, 81, 83, 86].into_iter().zip(ideal_hz) {
            assert!((equal_temperament_hz(key, 440.0) - hz).abs() <= 0.005);
        }
    }
}
