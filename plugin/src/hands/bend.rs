//! The middle of a pitch wheel.

/// From a host's 0…1 for a pitch wheel to −1…1.
///
/// A wheel's 14 bits have their middle at 8192, which as a share of 16,383 is a little above a half:
/// at 48 semitones 0.3 cents. Both 8192/16383 and ½ are exactly 0 here.
#[must_use]
pub fn bend_of_share(share: f64) -> f64 {
    const MIDDLE: f64 = 8192.0;
    let off = super::tame::within(share * 16_383.0, 0.0, 16_383.0, MIDDLE) - MIDDLE;
    // Half a step below the middle is ½; a whole step is a bend. A host's f32 is off by 0.001.
    if off.abs() < 0.6 { 0.0 } else { off / MIDDLE }
}

#[cfg(test)]
mod tests {
    use super::bend_of_share;

    #[test]
    fn wheels_rest_exactly_and_bend_by_their_14_bits() {
        assert_eq!(bend_of_share(0.5), 0.0);
        assert_eq!(bend_of_share(f64::NAN), 0.0);
        assert_eq!(bend_of_share(-3.0), -1.0);
        for bits in 0..16_384_u16 {
            let share = f64::from(f32::from(bits) / 16_383.0);
            let bend = (f64::from(bits) - 8192.0) / 8192.0;
            assert!((bend_of_share(share) - bend).abs() < 2e-7, "{bits}");
        }
        assert_eq!(bend_of_share(f64::from(8192.0_f32 / 16_383.0)), 0.0);
    }
}
