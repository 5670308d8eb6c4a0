//! Roots of a function of one variable.

/// Rising roots of `f` between `low` and `high`, each bracketed by one of `steps` equal steps.
pub(super) fn roots(f: impl Fn(f64) -> f64, [low, high]: [f64; 2], steps: usize) -> Vec<f64> {
    let at = |i: usize| low + (high - low) * i as f64 / steps as f64;
    let values: Vec<f64> = (0..=steps).map(|i| f(at(i))).collect();
    (0..steps)
        .filter(|&i| values[i] * values[i + 1] < 0.0)
        .map(|i| between(&f, [at(i), values[i]], [at(i + 1), values[i + 1]]))
        .collect()
}

/// Steps of [`between`] at most; a dozen are the rule.
const FALSE_STEPS: usize = 40;

/// The root of `f` between two points, each with the value there, whose signs differ: by false position as
/// in Illinois (Dowell & Jarratt 1971, BIT 11), and by halves if that does not get there.
fn between(
    f: &impl Fn(f64) -> f64,
    [mut a, mut at_a]: [f64; 2],
    [mut b, mut at_b]: [f64; 2],
) -> f64 {
    let mut last = 0;
    for _ in 0..FALSE_STEPS {
        let x = (a * at_b - b * at_a) / (at_b - at_a);
        if !(a < x && x < b) {
            // Nothing is left between them but rounding.
            return if x <= a { a } else { b };
        }
        let at_x = f(x);
        if at_x == 0.0 {
            return x;
        }
        if at_x.is_sign_positive() == at_a.is_sign_positive() {
            (a, at_a) = (x, at_x);
            at_b *= if last == 1 { 0.5 } else { 1.0 };
            last = 1;
        } else {
            (b, at_b) = (x, at_x);
            at_a *= if last == -1 { 0.5 } else { 1.0 };
            last = -1;
        }
    }
    bisect(f, a, b)
}

/// The root of `f` between `low` and `high`, where its signs differ.
pub(super) fn bisect(f: &impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let sign = f(low).is_sign_positive();
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle).is_sign_positive() == sign {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Halvings (by the golden ratio) before what is left of a corner's sides is straight.
const GOLDEN_STEPS: usize = 18;

/// Where `f` comes down to zero with a sharp corner between `low` and `high`, the same slope on both
/// sides: by golden section first, then where the two sides meet.
pub(super) fn sharp_zero(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let (mut left, mut right) = (high - golden * (high - low), low + golden * (high - low));
    let (mut at_left, mut at_right) = (f(left), f(right));
    for _ in 0..GOLDEN_STEPS {
        if at_left < at_right {
            high = right;
            (right, at_right) = (left, at_left);
            left = high - golden * (high - low);
            at_left = f(left);
        } else {
            low = left;
            (left, at_left) = (right, at_right);
            right = low + golden * (high - low);
            at_right = f(right);
        }
    }
    let mut half = 0.5 * (high - low);
    let mut middle = 0.5 * (low + high);
    for _ in 0..2 {
        let (below, above) = (f(middle - half), f(middle + half));
        middle += half * (below - above) / (below + above);
        half *= 1e-3;
    }
    middle
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn roots_of_a_sine() {
        let found = roots(f64::sin, [0.5, 10.0], 19);
        assert_eq!(found.len(), 3);
        for (i, root) in found.into_iter().enumerate() {
            assert!((root - (i + 1) as f64 * PI).abs() < 1e-14 * root);
        }
    }

    #[test]
    fn a_corner_is_found_to_rounding() {
        let found = sharp_zero(|x| (x.sin() - 0.3).abs(), 0.28, 0.33);
        assert!((found - 0.3f64.asin()).abs() < 1e-15, "{found}");
    }
}
