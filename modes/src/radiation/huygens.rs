//! From a mode's surface motion to two ears: Huygens' sum (O'Brien, Cook & Essl 2001, §3.3).

use super::turn::turned;
use super::{AIR_KG_M3, SOUND_M_S, Surface};
use crate::Ears;
use std::f64::consts::TAU;

/// Where the ears are in a body's own frame, in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Listener {
    /// Left and right ear.
    pub ears_m: [[f64; 3]; 2],
}

/// The way of the sound from each patch of a surface to the ears, and in the directions that tell
/// how much of the sound goes elsewhere.
pub struct Transfers {
    /// For each receiver, the ears first.
    ways: Vec<Ways>,
    /// Distance of each ear from the body's middle, in m.
    distances_m: [f64; 2],
}

/// The ways to one receiver from the patches that it hears.
#[derive(Default)]
struct Ways {
    patches: Vec<u32>,
    /// area·cos θ/r of each, in m.
    weights: Vec<f64>,
    /// Path of each in m beyond the way from the body's middle to the middle of the head.
    paths_m: Vec<f64>,
}

/// Ways whose phases are computed together.
const TOGETHER: usize = 64;

/// Directions over which a mode's radiation is averaged, beside those of the ears.
const DIRECTIONS: [[f64; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 0.0, -1.0],
];

/// An ear hears at most this much more or less of a mode than the mean over the directions.
const DIRECTIVITY: (f64, f64) = (0.1, 3.2);

impl Transfers {
    /// The ways from `surface`. A patch is heard where its normal points to (θ < 90°) and nothing of
    /// the body is in the way.
    #[must_use]
    pub fn new(surface: &Surface, listener: &Listener) -> Self {
        let [left, right] = listener.ears_m;
        let head = [0, 1, 2].map(|a| 0.5 * (left[a] + right[a]));
        let reference_m = norm(head);
        let receivers = [left, right]
            .into_iter()
            .chain(DIRECTIONS.map(|d| d.map(|x| x * reference_m)));
        let ways = receivers
            .map(|receiver| {
                let patches = surface.points_m.iter().zip(&surface.normals);
                let mut ways = Ways::default();
                for (i, ((&point, normal), area)) in patches.zip(&surface.areas_m2).enumerate() {
                    let way = [0, 1, 2].map(|a| receiver[a] - point[a]);
                    let r = norm(way);
                    let cos = (0..3).map(|a| way[a] * normal[a]).sum::<f64>() / r;
                    if cos > 0.0 && surface.is_heard_at(i, receiver) {
                        ways.patches.push(i as u32);
                        ways.weights.push(area * cos / r);
                        ways.paths_m.push(r - reference_m);
                    }
                }
                ways
            })
            .collect();
        Self {
            ways,
            distances_m: [norm(left), norm(right)],
        }
    }

    /// Eq. 10 for a mode of `hz` and surface `motion`, in Pa·m·kg^(−1/2)/m for each receiver: the
    /// pressure of Eqs. 2 and 5, of a unit modal displacement e^{iωt}, with the delay as a phase.
    fn sums(&self, hz: f64, motion: &[f32], receivers: usize) -> Vec<[f64; 2]> {
        let k = TAU * hz / SOUND_M_S;
        let velocity = AIR_KG_M3 * SOUND_M_S * TAU * hz;
        self.ways[..receivers]
            .iter()
            .map(|ways| {
                let [re, im] = ways.sum(k, motion);
                [velocity * re, velocity * im]
            })
            .collect()
    }

    /// Distance of each ear from the body's middle, in m.
    #[must_use]
    pub fn distances_m(&self) -> [f64; 2] {
        self.distances_m
    }

    /// What the paper's Eq. 10 alone gives at the two ears.
    #[must_use]
    pub fn raw(&self, hz: f64, motion: &[f32]) -> [[f64; 2]; 2] {
        let sums = self.sums(hz, motion, 2);
        [sums[0], sums[1]]
    }

    /// Complex pressure at the ears, in Pa per unit modal displacement.
    ///
    /// The paper leaves diffraction out, so that a body smaller than the wave does not short its own
    /// sound. Here Eq. 10 gives phases and the share of each direction, and the level is that of
    /// the power that the mode radiates: its decay rate by radiation, `radiation_per_s`, times ω²
    /// for a unit displacement.
    #[must_use]
    pub fn ears(&self, hz: f64, motion: &[f32], radiation_per_s: f64) -> Ears {
        let sums = self.sums(hz, motion, self.ways.len());
        let square = |z: &[f64; 2]| z[0] * z[0] + z[1] * z[1];
        let mean = sums[2..].iter().map(square).sum::<f64>() / DIRECTIONS.len() as f64;
        let omega = TAU * hz;
        let power_w = omega * omega * radiation_per_s;
        let all_round = (AIR_KG_M3 * SOUND_M_S * power_w / TAU).sqrt();
        [0, 1].map(|ear| {
            let level = all_round / self.distances_m[ear];
            let size = square(&sums[ear]).sqrt();
            if size == 0.0 {
                return [0.0; 2];
            }
            // Without a mean, as of what is odd about the axis, it is the most.
            let share = (size / mean.sqrt()).clamp(DIRECTIVITY.0, DIRECTIVITY.1);
            sums[ear].map(|x| (x / size * share * level) as f32)
        })
    }
}

impl Ways {
    /// Σ of weight times `motion` times i e^{−ikr}, real and imaginary part: the velocity is a quarter turn
    /// before the displacement.
    fn sum(&self, k: f64, motion: &[f32]) -> [f64; 2] {
        let (mut re, mut im) = (0.0, 0.0);
        let shares = self.patches.iter().zip(&self.weights);
        let mut shares = shares.map(|(patch, weight)| weight * f64::from(motion[*patch as usize]));
        for paths_m in self.paths_m.chunks(TOGETHER) {
            let (mut sin, mut cos) = ([0.0; TOGETHER], [0.0; TOGETHER]);
            for ((sin, cos), path_m) in sin.iter_mut().zip(&mut cos).zip(paths_m) {
                (*sin, *cos) = turned(k * path_m);
            }
            let turns = sin.iter().zip(&cos).take(paths_m.len());
            for ((sin, cos), share) in turns.zip(&mut shares) {
                re += share * sin;
                im += share * cos;
            }
        }
        [re, im]
    }
}

fn norm(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A breathing sphere radiates alike in all directions and is heard at the level of its power.
    #[test]
    fn a_breathing_sphere_is_heard_by_its_power() {
        let (radius, count) = (0.05, 4000_u16);
        let golden = std::f64::consts::PI * (3.0 - 5f64.sqrt());
        let normals: Vec<[f64; 3]> = (0..count)
            .map(|i| {
                let z = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(count);
                let (sin, cos) = (golden * f64::from(i)).sin_cos();
                let s = (1.0 - z * z).sqrt();
                [s * cos, s * sin, z]
            })
            .collect();
        let area = 4.0 * std::f64::consts::PI * radius * radius / f64::from(count);
        let surface = Surface {
            points_m: normals.iter().map(|n| n.map(|x| radius * x)).collect(),
            normals,
            areas_m2: vec![area; usize::from(count)],
            mouth_m: None,
        };
        let listener = Listener {
            ears_m: [[-0.1, -1.0, 0.0], [0.1, -1.0, 0.0]],
        };
        let transfers = Transfers::new(&surface, &listener);
        let motion = vec![1.0; usize::from(count)];
        let (hz, rate) = (1000.0, 0.5);
        let [left, right] = transfers.ears(hz, &motion, rate);
        let power = (TAU * hz).powi(2) * rate;
        let r = 1.01f64.sqrt();
        // W = 4πr² p²/(2ρc).
        let expected = (power * AIR_KG_M3 * SOUND_M_S / TAU).sqrt() / r;
        let size = f64::from(left[0]).hypot(f64::from(left[1]));
        assert!((size / expected - 1.0).abs() < 0.03, "{size} {expected}");
        assert!((left[0] / right[0] - 1.0).abs() < 0.01);
        // What reaches the ears starts from the near side, 5 cm nearer than the middle.
        let [raw, _] = transfers.raw(hz, &motion);
        let phase = raw[0].atan2(raw[1]);
        assert!(
            phase < 0.0 && phase > -TAU * hz / SOUND_M_S * radius,
            "{phase}"
        );
    }
}
