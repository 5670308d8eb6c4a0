//! Where each body stands before the listener.

use std::f64::consts::FRAC_PI_4;

/// Left and right gain of a body at `place` in its row (0 leftmost, 1 rightmost).
///
/// Constant power, with 1 in both ears for a body in the middle; each body is an omnidirectional
/// source (O'Brien 2002, §3.4).
pub(crate) fn ears(place: f64, width: f64) -> [f64; 2] {
    let angle = FRAC_PI_4 * (1.0 + width * (2.0 * place - 1.0));
    let (sin, cos) = angle.sin_cos();
    [
        cos * std::f64::consts::SQRT_2,
        sin * std::f64::consts::SQRT_2,
    ]
}

#[cfg(test)]
mod tests {
    use super::ears;

    #[test]
    fn power_is_constant_and_low_bodies_stand_left() {
        for place in [0.0, 0.2, 0.5, 1.0] {
            let [left, right] = ears(place, 0.5);
            assert!((left * left + right * right - 2.0).abs() < 1e-12);
            assert!(place == 0.5 || (left > right) == (place < 0.5));
        }
        let [left, right] = ears(0.9, 0.0);
        assert!((left - 1.0).abs() < 1e-12 && (right - 1.0).abs() < 1e-12);
    }
}
