//! Spherical Bessel functions, the Legendre coefficients of a plane wave.

/// Orders kept in the expansion exp(−izu) = Σ (2k+1)(−i)^k jₖ(z) Pₖ(u).
pub(crate) const ORDERS: usize = 4;

/// j₀(z) to j₃(z) for |z| ≤ π/2 (Abramowitz & Stegun, 10.1.2).
pub(crate) fn spherical_bessel(z: f64) -> [f64; ORDERS] {
    let mut leading = 1.0;
    std::array::from_fn(|k| {
        if k > 0 {
            leading *= z / (2 * k + 1) as f64;
        }
        let mut term = 1.0;
        let mut sum = 1.0;
        for m in 1..14 {
            term *= -0.5 * z * z / (m * (2 * (k + m) + 1)) as f64;
            sum += term;
        }
        leading * sum
    })
}

#[cfg(test)]
mod tests {
    use super::spherical_bessel;

    #[test]
    fn agrees_with_closed_forms() {
        for i in 8..=16 {
            let z = f64::from(i) / 10.0;
            let (s, c) = z.sin_cos();
            let closed = [
                s / z,
                s / z.powi(2) - c / z,
                (3.0 / z.powi(3) - 1.0 / z) * s - 3.0 * c / z.powi(2),
                (15.0 / z.powi(4) - 6.0 / z.powi(2)) * s - (15.0 / z.powi(3) - 1.0 / z) * c,
            ];
            for (j, exact) in spherical_bessel(z).into_iter().zip(closed) {
                assert!((j - exact).abs() < 1e-13, "z = {z}: {j} against {exact}");
            }
        }
    }

    #[test]
    fn vanishes_at_the_origin_but_for_order_zero() {
        assert_eq!(spherical_bessel(0.0), [1.0, 0.0, 0.0, 0.0]);
    }
}
