//! What the air takes from a mode of any shape: the body as a sphere of the same surface.

use super::axes::{area_m2, doubled_area};
use crate::radiation::{AIR_KG_M3, SOUND_M_S};
use std::f64::consts::{PI, TAU};

/// The waves of a mode on a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Waves {
    /// ∫(φ·n)² dS, in m²/kg.
    pub(super) square: f64,
    /// Share of it that moves the whole surface outwards at once.
    pub(super) breathing: f64,
    /// Wave number of the rest, in rad/m.
    pub(super) number_per_m: f64,
}

impl Waves {
    /// Of a motion `phi` at the nodes of a closed surface.
    ///
    /// The wave number is that of ∫|∇(φ·n)|² = k²∫(φ·n)² over flat triangles.
    pub(super) fn of(
        points: &[[f64; 3]],
        triangles: &[[u32; 3]],
        phi: impl Fn(u32) -> [f64; 3],
    ) -> Self {
        let (mut area, mut flow, mut square, mut slope) = (0.0, 0.0, 0.0, 0.0);
        for triangle in triangles {
            let corners = triangle.map(|i| points[i as usize]);
            let part = area_m2(&corners);
            if part <= 0.0 {
                continue;
            }
            let normal = doubled_area(&corners).map(|x| x / (2.0 * part));
            let w = triangle.map(|i| {
                let u = phi(i);
                (0..3).map(|a| u[a] * normal[a]).sum::<f64>()
            });
            let sum: f64 = w.iter().sum();
            area += part;
            flow += part * sum / 3.0;
            square += part / 12.0 * (w.iter().map(|w| w * w).sum::<f64>() + sum * sum);
            slope += slope_squared(&corners, w) / (4.0 * part);
        }
        let breathing = if square > 0.0 {
            (flow * flow / (area * square)).min(1.0)
        } else {
            0.0
        };
        let rest = square * (1.0 - breathing);
        let number_per_m = if rest > 0.0 {
            (slope / rest).sqrt()
        } else {
            0.0
        };
        Self {
            square,
            breathing,
            number_per_m,
        }
    }

    /// Amplitude decay rate in 1/s by radiation of a mode of `hz` that moves so on `area_m2`.
    ///
    /// The part that breathes and the rest each radiate as the waves on a sphere of the same area do:
    /// order n with n(n + 1) = (ka)² of the waves, and of the rest at least the first, since it moves no
    /// air as a whole. W = ½ρc ω²σ∫(φ·n)² dS for a unit displacement, d = W/ω².
    pub(super) fn radiation_per_s(&self, hz: f64, area_m2: f64) -> f64 {
        let radius_m = (area_m2 / (4.0 * PI)).sqrt();
        let ka = TAU * hz / SOUND_M_S * radius_m;
        let order = 0.5 * ((1.0 + 4.0 * (self.number_per_m * radius_m).powi(2)).sqrt() - 1.0);
        let efficiency = self.breathing * efficiency(0.0, ka)
            + (1.0 - self.breathing) * efficiency(order.max(1.0), ka);
        0.5 * AIR_KG_M3 * SOUND_M_S * self.square * efficiency
    }
}

/// Twice the triangle's area, squared, times the square of the slope of the plane through `w` at its
/// corners.
fn slope_squared([p, q, r]: &[[f64; 3]; 3], w: [f64; 3]) -> f64 {
    let sides = [[r, q], [p, r], [q, p]].map(|[to, from]| [0, 1, 2].map(|a| to[a] - from[a]));
    let turned = [0, 1, 2].map(|a| (0..3).map(|i| w[i] * sides[i][a]).sum::<f64>());
    turned.iter().map(|x| x * x).sum()
}

/// Highest order that is told apart: beyond, what is slower than sound is silent.
const HIGHEST: f64 = 400.0;

/// Radiation resistance over ρc of the waves of `order` on a sphere, σ = 1/(x²|h′ₙ(x)|²) with x = ka
/// (Morse & Ingard 1968, §7.2); between whole orders on the logarithms.
fn efficiency(order: f64, x: f64) -> f64 {
    let order = order.min(HIGHEST);
    let share = order.fract();
    #[expect(clippy::cast_sign_loss, reason = "orders are not negative")]
    let [low, high] = resistances(order as usize, x);
    if share == 0.0 || low == 0.0 || high == 0.0 {
        return if share < 0.5 { low } else { high };
    }
    (low.ln() * (1.0 - share) + high.ln() * share).exp()
}

/// 1/(x²|h′|²) of the orders n and n + 1.
fn resistances(n: usize, x: f64) -> [f64; 2] {
    // h₀ and h₁, real and imaginary part; upwards the imaginary part is what counts and is stable.
    let (sin, cos) = x.sin_cos();
    let mut before = [sin / x, -cos / x];
    let mut now = [sin / (x * x) - cos / x, -cos / (x * x) - sin / x];
    let resistance = |slope: [f64; 2]| {
        let square = x * x * (slope[0] * slope[0] + slope[1] * slope[1]);
        // What is too large for a number leaves nothing to radiate.
        if square.is_finite() {
            1.0 / square
        } else {
            0.0
        }
    };
    // h′₀ = −h₁, h′ₙ = hₙ₋₁ − (n + 1)/x hₙ.
    let mut last = resistance(now);
    for order in 1..=n + 1 {
        let factor = (order as f64 + 1.0) / x;
        let next = resistance([0, 1].map(|i| before[i] - factor * now[i]));
        if order == n + 1 {
            return [last, next];
        }
        last = next;
        let factor = (2.0 * order as f64 + 1.0) / x;
        (before, now) = (now, [0, 1].map(|i| factor * now[i] - before[i]));
    }
    [last, last]
}

#[cfg(test)]
mod tests {
    use super::super::outside::Outside;
    use super::*;
    use crate::mesh::ball_tet10;

    const RADIUS_M: f64 = 0.1;

    /// Decay rate of a ball whose surface moves radially by `radial` of the cosine from the z axis.
    fn decay_per_s(hz: f64, radial: impl Fn(f64) -> f64) -> f64 {
        let mesh = ball_tet10(RADIUS_M, 6, 1);
        let outside = Outside::of(&mesh);
        let waves = Waves::of(&mesh.nodes, &outside.triangles, |node| {
            let p = mesh.nodes[node as usize].map(|x| x / RADIUS_M);
            p.map(|x| x * radial(p[2]))
        });
        waves.radiation_per_s(hz, 4.0 * PI * RADIUS_M * RADIUS_M)
    }

    /// Closed forms (Morse & Ingard 1968, §7.1–7.2), with W = ½ω²·resistance of a unit displacement.
    #[test]
    fn a_breathing_and_a_shaken_sphere_radiate_as_they_should() {
        for hz in [20.0, 200.0, 2000.0, 20_000.0] {
            let x = TAU * hz / SOUND_M_S * RADIUS_M;
            let plane = 0.5 * AIR_KG_M3 * SOUND_M_S * 4.0 * PI * RADIUS_M * RADIUS_M;
            let breathing = plane * x * x / (1.0 + x * x);
            let found = decay_per_s(hz, |_| 1.0);
            assert!(
                (found / breathing - 1.0).abs() < 0.02,
                "{hz}: {found} {breathing}"
            );
            let shaken = plane / 3.0 * x.powi(4) / (4.0 + x.powi(4));
            let found = decay_per_s(hz, |cos| cos);
            assert!(
                (found / shaken - 1.0).abs() < 0.05,
                "{hz}: {found} {shaken}"
            );
        }
    }

    /// Order 2 at low frequencies: |h′₂| → 9/x⁴, σ → x⁶/81; mean of P₂² is 1/5.
    #[test]
    fn a_squeezed_sphere_radiates_as_a_quadrupole() {
        let hz = 100.0;
        let x = TAU * hz / SOUND_M_S * RADIUS_M;
        let plane = 0.5 * AIR_KG_M3 * SOUND_M_S * 4.0 * PI * RADIUS_M * RADIUS_M;
        let expected = plane / 5.0 * x.powi(6) / 81.0;
        let found = decay_per_s(hz, |cos| 1.5 * cos * cos - 0.5);
        assert!((found / expected - 1.0).abs() < 0.25, "{found} {expected}");
    }

    #[test]
    fn orders_between_lie_between() {
        for x in [0.01, 0.5, 3.0, 50.0] {
            let [low, middle, high] = [2.0, 2.4, 3.0].map(|order| efficiency(order, x));
            assert!(low.min(high) <= middle && middle <= low.max(high), "{x}");
        }
        assert_eq!(efficiency(1e6, 1.0), 0.0);
        assert!((efficiency(3.0, 1e4) - 1.0).abs() < 1e-3);
    }
}
