//! Numbers from outside, made harmless.

/// `value` inside `least`…`most`; `rest` if it is not a number.
pub(super) fn within(value: f64, least: f64, most: f64, rest: f64) -> f64 {
    if value.is_nan() {
        rest
    } else {
        value.clamp(least, most)
    }
}

/// A value 0…1; what is no number is 0.
pub(super) fn unipolar(value: f64) -> f64 {
    within(value, 0.0, 1.0, 0.0)
}

/// A value −1…1; what is no number is 0.
pub(super) fn bipolar(value: f64) -> f64 {
    within(value, -1.0, 1.0, 0.0)
}

/// The MIDI byte that a host gives as a share of 127.
pub(super) fn seven_bit(value: f64) -> u8 {
    u8::try_from((unipolar(value) * 127.0).round() as i32).unwrap_or(0)
}

/// From a controller's 0…1 to −1…1 with the byte 64 at 0, which is where MIDI has the middle.
pub(super) fn about_64(value: f64) -> f64 {
    const MIDDLE: f64 = 64.0 / 127.0;
    let off = within(value, 0.0, 1.0, MIDDLE) - MIDDLE;
    if off < 0.0 {
        off / MIDDLE
    } else {
        off / (1.0 - MIDDLE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_and_nan_rests() {
        assert_eq!(within(f64::NAN, 0.0, 4.0, 1.0), 1.0);
        assert_eq!(within(f64::INFINITY, 0.0, 4.0, 1.0), 4.0);
        assert_eq!(unipolar(-1e300), 0.0);
        assert_eq!(bipolar(f64::NEG_INFINITY), -1.0);
    }

    #[test]
    fn bytes_come_back_and_64_is_the_middle() {
        for byte in 0..=127_u8 {
            // As a host that computes in f32 has it.
            let value = f64::from(f32::from(byte) / 127.0);
            assert_eq!(seven_bit(value), byte);
            let off = about_64(f64::from(byte) / 127.0);
            let expected = if byte < 64 {
                (f64::from(byte) - 64.0) / 64.0
            } else {
                (f64::from(byte) - 64.0) / 63.0
            };
            assert!((off - expected).abs() < 1e-14);
        }
        assert_eq!(about_64(64.0 / 127.0), 0.0);
        assert_eq!(about_64(f64::NAN), 0.0);
        assert_eq!(seven_bit(f64::NAN), 0);
    }
}
