//! Bessel functions of all orders up to one, by Miller's backward recurrence (DLMF §3.6).

/// Where values are scaled down on their way from the highest order.
const LARGE: f64 = 1e200;

/// Jᵥ(x) for v = `fraction`, `fraction` + 1, … (`count` of them), with `fraction` in 0…1 and x ≥ 0.
///
/// Normalised by (x/2)^μ = Σ (μ + 2k) Γ(μ + k)/k! J_{μ+2k}(x) (DLMF 10.23.15).
pub(super) fn bessel_j(fraction: f64, x: f64, count: usize) -> Vec<f64> {
    if x == 0.0 {
        return at_zero(fraction, count);
    }
    let values = backward(fraction, x, count, -1.0);
    // (μ + 2k) Γ(μ + k)/k!, whose Γ(μ) has a pole at 0.
    let first = libm::tgamma(1.0 + fraction);
    let (mut sum, mut gamma) = (first * values[0], first);
    for (k, value) in values.iter().step_by(2).enumerate().skip(1) {
        let k = k as f64;
        sum += (fraction + 2.0 * k) * gamma * value;
        gamma *= (fraction + k) / (k + 1.0);
    }
    let scale = (0.5 * x).powf(fraction) / sum;
    scaled(values, scale, count)
}

/// e^(−x) Iₙ(x) for n = 0, 1, … (`count` of them) and x ≥ 0, normalised by e^x = I₀ + 2 Σ Iₙ (DLMF
/// 10.35.5).
pub(super) fn bessel_i(x: f64, count: usize) -> Vec<f64> {
    if x == 0.0 {
        return at_zero(0.0, count);
    }
    let values = backward(0.0, x, count, 1.0);
    let sum = 2.0 * values.iter().sum::<f64>() - values[0];
    scaled(values, 1.0 / sum, count)
}

fn at_zero(fraction: f64, count: usize) -> Vec<f64> {
    let mut values = vec![0.0; count];
    if fraction == 0.0 && count > 0 {
        values[0] = 1.0;
    }
    values
}

fn scaled(values: Vec<f64>, scale: f64, count: usize) -> Vec<f64> {
    values.into_iter().take(count).map(|v| scale * v).collect()
}

/// A multiple of the solution of f(v − 1) = (2v/x) f(v) + `sign` f(v + 1) that dies away with rising
/// v, from v = `fraction` on.
fn backward(fraction: f64, x: f64, count: usize, sign: f64) -> Vec<f64> {
    #[expect(clippy::cast_sign_loss, reason = "x is positive")]
    let turning = count.max(x.ceil() as usize);
    // Beyond the turning point by so much that what is left out is below rounding.
    #[expect(clippy::cast_sign_loss, reason = "a root is positive")]
    let start = turning + 20 + (40.0 * turning as f64).sqrt() as usize;
    let mut values = vec![0.0; start + 2];
    values[start] = 1.0;
    let twice = 2.0 / x;
    for order in (1..=start).rev() {
        let factor = twice * (fraction + order as f64);
        values[order - 1] = factor * values[order] + sign * values[order + 1];
        if values[order - 1].abs() > LARGE {
            for value in &mut values[order - 1..] {
                *value /= LARGE;
            }
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn near(value: f64, expected: f64, what: &str) {
        let error = (value - expected).abs() / expected.abs().max(1e-3);
        assert!(error < 2e-13, "{what}: {value} {expected}");
    }

    /// Orders of halves are sines (DLMF 10.49.3).
    #[test]
    fn half_orders_are_elementary() {
        for x in [1e-3, 0.3, 2.0, 17.5, 60.0f64] {
            let scale = (2.0 / (PI * x)).sqrt();
            let found = bessel_j(0.5, x, 2);
            near(found[0], scale * x.sin(), "order 1/2");
            if x > 0.1 {
                near(found[1], scale * (x.sin() / x - x.cos()), "order 3/2");
            }
        }
    }

    #[test]
    fn whole_orders_are_those_of_the_library() {
        for x in [0.01, 1.0, 5.0, 24.0, 80.0] {
            let found = bessel_j(0.0, x, 30);
            for (n, value) in found.iter().enumerate() {
                let expected = libm::jn(n as i32, x);
                assert!((value - expected).abs() < 1e-13, "J{n}({x})");
            }
        }
    }

    /// Ai(−1) = (J_{1/3} + J_{−1/3})/3 at 2/3 and its slope (J_{2/3} − J_{−2/3})/3 (DLMF 9.6.6–7), with
    /// Ai(−1) = 0.53556 08832 92352, Ai′(−1) = −0.01016 05671 16645 (DLMF table 9.9); the negative
    /// orders by the recurrence.
    #[test]
    fn orders_of_thirds_are_airy_s() {
        let x = 2.0 / 3.0;
        let [third, two_thirds] = [1.0, 2.0].map(|thirds| bessel_j(thirds / 3.0, x, 1)[0]);
        let ai = (third + minus(1.0 / 3.0, x)) / 3.0;
        near(ai, 0.535_560_883_292_352, "Ai(−1)");
        let slope = (two_thirds - minus(2.0 / 3.0, x)) / 3.0;
        near(slope, -0.010_160_567_116_645, "Ai′(−1)");
    }

    /// J_{−v}(x) by the recurrence from J_{1−v} and J_{2−v}.
    fn minus(order: f64, x: f64) -> f64 {
        let above = bessel_j(1.0 - order, x, 2);
        2.0 * (1.0 - order) / x * above[0] - above[1]
    }

    #[test]
    fn modified_functions_meet_their_series() {
        for x in [0.1, 3.0, 12.0f64] {
            let found = bessel_i(x, 8);
            for (n, value) in found.iter().enumerate() {
                let mut term = (0.5 * x).powi(n as i32) / libm::tgamma(n as f64 + 1.0);
                let mut sum = 0.0;
                for k in 1..60 {
                    sum += term;
                    let k = f64::from(k);
                    term *= 0.25 * x * x / (k * (k + n as f64));
                }
                let expected = (-x).exp() * sum;
                assert!((value / expected - 1.0).abs() < 1e-13, "I{n}({x})");
            }
        }
    }
}
