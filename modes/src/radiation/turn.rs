//! Sine and cosine of many angles, such that a compiler takes several at a time.

use std::f64::consts::TAU;

/// Sine and cosine of any angle of less than 10⁹ radians, to 10⁻¹³: series for a quarter of it, doubled
/// twice.
#[inline(always)]
pub(super) fn turned(angle: f64) -> (f64, f64) {
    // Adding and taking away 1.5·2⁵² rounds to the nearest whole number.
    const WHOLE: f64 = 6_755_399_441_055_744.0;
    let turns = angle * TAU.recip();
    let rest = (turns - ((turns + WHOLE) - WHOLE)) * (0.25 * TAU);
    let square = rest * rest;
    let (mut odd, mut even) = (1.0, 1.0);
    for k in [14.0, 12.0, 10.0, 8.0, 6.0, 4.0, 2.0] {
        odd = 1.0 - square * (1.0 / (k * (k + 1.0))) * odd;
        even = 1.0 - square * (1.0 / ((k + 1.0) * (k + 2.0))) * even;
    }
    let (mut sin, mut cos) = (rest * odd, 1.0 - 0.5 * square * even);
    for _ in 0..2 {
        (sin, cos) = (2.0 * sin * cos, cos * cos - sin * sin);
    }
    (sin, cos)
}

#[cfg(test)]
mod tests {
    use super::turned;

    #[test]
    fn turns_are_sines_and_cosines() {
        for i in -5000..=5000 {
            let angle = 0.173 * f64::from(i);
            let (sin, cos) = turned(angle);
            assert!((sin - angle.sin()).abs() < 1e-12, "{angle}");
            assert!((cos - angle.cos()).abs() < 1e-12, "{angle}");
        }
        assert_eq!(turned(0.0), (0.0, 1.0));
    }
}
