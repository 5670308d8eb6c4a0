//! What the far air sees of flat shapes: their transforms, in closed form, over a half sphere.

use super::bessel::bessel_j;
use super::quadrature::gauss_kept;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Points by which directions are summed, at least, and to a radian by which waves pass over half of the
/// body.
const FEWEST: f64 = 12.0;
const TO_A_RADIAN: f64 = 0.5;

/// Where the transform is within this of its root's, as a share of it, it counts as there.
const MEETS: f64 = 1e-6;

fn points(radians: f64) -> usize {
    #[expect(clippy::cast_sign_loss, reason = "radians are not negative")]
    let count = (FEWEST + TO_A_RADIAN * radians) as usize;
    count
}

/// ∫₀¹ J(κρ) J(qρ) ρ dρ of one order, for one κ and any q (DLMF 10.22.4, 10.22.5).
pub(super) struct Hankel {
    order: usize,
    root: f64,
    /// J at κ of the order and the next.
    rim: [f64; 2],
    /// Where q is κ.
    same: f64,
}

impl Hankel {
    pub(super) fn new(order: u16, root: f64) -> Self {
        let order = usize::from(order);
        let j = bessel_j(0.0, root, order + 2);
        let rim = [j[order], j[order + 1]];
        // J′ = (m/κ) J − J_{m+1}.
        let share = order as f64 / root;
        let slope = share * rim[0] - rim[1];
        let same = 0.5 * (slope * slope + (1.0 - share * share) * rim[0] * rim[0]);
        Self {
            order,
            root,
            rim,
            same,
        }
    }

    pub(super) fn at(&self, q: f64) -> f64 {
        let apart = self.root * self.root - q * q;
        if apart.abs() < MEETS * self.root * self.root {
            return self.same;
        }
        let j = bessel_j(0.0, q, self.order + 2);
        let [own, next] = [j[self.order], j[self.order + 1]];
        (self.root * self.rim[1] * own - q * self.rim[0] * next) / apart
    }
}

/// ∫ |∫ f e^{ik·x} dS|² dΩ over a half sphere for a disc of radius 1 and f = a(ρ) cos mθ, k = `waves`:
/// e^{ik·x} gives 2π iᵐ Jₘ(qρ) cos mφ around, and `transform` is ∫ a Jₘ(qρ) ρ dρ. `mean_square` is that of
/// the cosine.
pub(super) fn disc(waves: f64, mean_square: f64, transform: impl Fn(f64) -> f64) -> f64 {
    let heights = gauss_kept(points(waves));
    let sum = heights.iter().map(|(cos, weight)| {
        let flat = transform(waves * (1.0 - cos * cos).sqrt());
        weight * flat * flat
    });
    TAU * TAU * TAU * mean_square * sum.sum::<f64>()
}

/// The same for sin(mπx/a) sin(nπy/b) on a rectangle, k in 1/m.
pub(super) fn rectangle(wave_per_m: f64, half_waves: [u16; 2], sides_m: [f64; 2]) -> f64 {
    let count = points(0.5 * wave_per_m * sides_m[0].hypot(sides_m[1]));
    let rule = gauss_kept(count);
    let mut sum = 0.0;
    for (cos, weight) in rule {
        let along = wave_per_m * (1.0 - cos * cos).sqrt();
        for (turn, share) in rule {
            let (y, x) = (FRAC_PI_2 * turn).sin_cos();
            let flat = side(half_waves[0], sides_m[0], along * x)
                * side(half_waves[1], sides_m[1], along * y);
            sum += weight * share * flat;
        }
    }
    TAU * sum
}

/// |∫₀ᵃ sin(mπx/a) e^{ikx} dx|².
fn side(half_waves: u16, side_m: f64, wave_per_m: f64) -> f64 {
    let half = 0.5 * wave_per_m * side_m;
    let own = FRAC_PI_2 * f64::from(half_waves);
    let apart = own * own - half * half;
    let size = if apart.abs() < MEETS * own * own {
        0.5 * side_m
    } else if half_waves.is_multiple_of(2) {
        side_m * own * half.sin() / apart
    } else {
        side_m * own * half.cos() / apart
    };
    size * size
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn transforms_are_their_integrals() {
        let rule = gauss_kept(60);
        for order in [0u16, 1, 4, 11] {
            let root = 14.3;
            let hankel = Hankel::new(order, root);
            let j = |x: f64| bessel_j(0.0, x, usize::from(order) + 1)[usize::from(order)];
            for q in [0.0, 3.7, root, root * (1.0 + 1e-5), 22.0] {
                let sum = rule.iter().map(|(r, w)| w * j(root * r) * j(q * r) * r);
                let expected: f64 = sum.sum();
                let error = (hankel.at(q) - expected).abs();
                assert!(error < 1e-9, "{order} {q}: {} {expected}", hankel.at(q));
            }
        }
        for (half_waves, wave) in [(1, 0.0), (2, 3.0), (5, PI * 5.0 / 0.7), (9, 61.0)] {
            let side_m = 0.7;
            let [re, im] = [f64::cos, f64::sin].map(|part: fn(f64) -> f64| {
                let at = |x: f64| (PI * f64::from(half_waves) * x).sin();
                let sum = rule
                    .iter()
                    .map(|(x, w)| w * at(*x) * part(wave * side_m * x));
                side_m * sum.sum::<f64>()
            });
            let (found, expected) = (side(half_waves, side_m, wave), re * re + im * im);
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
    }
}
