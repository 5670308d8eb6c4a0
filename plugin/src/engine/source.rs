//! What a mode sends to the ears, and how it is heard.

use super::oscillators::LANES;
use modes::{Ears, ModeLabel, ModeShape, StrikeLine};
use std::f64::consts::TAU;

/// Speed of sound in air at 20 °C, in m/s.
pub(super) const SOUND_M_S: f64 = 343.2;

/// Share of the strongest mode's reach below which no strike makes a mode heard: −140 dB.
const UNREACHED: f64 = 1e-7;

/// A mode as the engine needs it.
pub(crate) struct Reached {
    pub(crate) hz: f64,
    /// What of the sound comes from the body itself, and what through its resonator.
    direct: Ears,
    piped: Ears,
    /// Decay rates in 1/s by radiation, supports, resonator and felt.
    pub(crate) air: [f32; 4],
    pub(crate) shape: ModeShape,
    /// φ·n̂ where the strike line begins, in kg^(−1/2).
    pub(crate) start: f64,
    pub(crate) label: ModeLabel,
}

impl Reached {
    /// Sound pressure at the ear that gets more of it, resonator open, for a modal velocity of 1: in
    /// Pa·kg^(−1/2)·s/m over 2π.
    pub(crate) fn loudness(&self) -> f64 {
        loudest(&sum(&self.direct, &self.piped)) / self.hz
    }

    /// Whether a resonator is heard.
    pub(crate) fn is_piped(&self) -> bool {
        loudest(&self.piped) > 0.0
    }
}

/// What a mode sends to the ears, by itself and through the resonator below it.
pub(crate) fn heard(mode: &modes::Mode) -> Ears {
    sum(&mode.ears, &mode.pipe_ears)
}

fn sum(a: &Ears, b: &Ears) -> Ears {
    [0, 1].map(|ear| [0, 1].map(|part| a[ear][part] + b[ear][part]))
}

/// Size of the sound at the ear that gets more of it.
fn loudest(ears: &Ears) -> f64 {
    let size = |ear: &[f32; 2]| f64::from(ear[0]).hypot(f64::from(ear[1]));
    ears.iter().map(size).fold(0.0, f64::max)
}

/// The modes that a strike somewhere on the line makes heard, by rising frequency.
pub(crate) fn reached(body: &modes::Body) -> Vec<Reached> {
    let points = body.line.len();
    let sound = |mode: &&modes::Mode| {
        mode.hz.is_finite()
            && mode.hz > 0.0
            && loudest(&heard(mode)).is_finite()
            && mode.shape.len() == points
    };
    let mut all: Vec<(Reached, f64)> = body
        .modes
        .iter()
        .filter(sound)
        .map(|mode| {
            let reach = farthest(body, mode) * loudest(&heard(mode)) / mode.hz;
            let mode = Reached {
                hz: mode.hz,
                direct: mode.ears,
                piped: mode.pipe_ears,
                air: [
                    mode.radiation_per_s,
                    mode.support_per_s,
                    mode.pipe_per_s,
                    mode.felt_per_s,
                ],
                shape: mode.shape.clone(),
                start: moved(&body.line, &mode.shape, 0),
                label: mode.label,
            };
            (mode, reach)
        })
        .collect();
    let most = all.iter().fold(0.0, |m: f64, (_, reach)| m.max(*reach));
    all.retain(|(_, reach)| *reach > UNREACHED * most);
    all.sort_by(|(a, _), (b, _)| a.hz.total_cmp(&b.hz));
    all.into_iter().map(|(mode, _)| mode).collect()
}

/// φ·n̂ at point `i` of the line, in kg^(−1/2).
fn moved(line: &StrikeLine, shape: &ModeShape, i: usize) -> f64 {
    let (phi, normal) = (shape.at(i), line.normals[i]);
    (0..3).map(|k| f64::from(phi[k]) * normal[k]).sum()
}

/// The greatest φ·n̂ of a mode on the line, in kg^(−1/2), either way; of a product the greatest that it can
/// be, with no function above 1.
fn farthest(body: &modes::Body, mode: &modes::Mode) -> f64 {
    if let Some(product) = mode.shape.as_product() {
        return f64::from(product.height.abs());
    }
    let (points, scale) = mode.shape.as_points().unwrap_or_default();
    let most = points
        .iter()
        .zip(&body.line.normals)
        .map(|(phi, normal)| (0..3).map(|k| f64::from(phi[k]) * normal[k]).sum::<f64>())
        .fold(0.0f64, |most, moved| most.max(moved.abs()));
    most * f64::from(scale)
}

/// From the source to one ear, beside the way that the bank has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Way {
    /// Pressure over that of the bank.
    pub(crate) gain: f64,
    /// How much longer the way is, in m.
    pub(crate) longer_m: f64,
}

impl Way {
    /// As the bank has it.
    pub(crate) const AS_BUILT: Self = Self {
        gain: 1.0,
        longer_m: 0.0,
    };
}

/// How a body is heard.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hearing {
    /// Open share of the resonator.
    pub(crate) open: f64,
    /// 0 for both ears alike, 1 for each its own.
    pub(crate) width: f64,
    /// Left and right.
    pub(crate) ways: [Way; 2],
    /// Number of the table of trims.
    pub(crate) trims: u32,
}

impl Hearing {
    /// As the bank has it, resonator open.
    pub(crate) const AS_BUILT: Self = Self {
        open: 1.0,
        width: 1.0,
        ways: [Way::AS_BUILT; 2],
        trims: 0,
    };

    /// The same but for the resonator.
    pub(crate) fn without_pipe(self) -> Self {
        Self { open: 0.0, ..self }
    }
}

/// What sixteen modes send out.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    /// From x and from y to the left and the right ear.
    direct: [[[f32; LANES]; 2]; 2],
    /// The same through the open resonator.
    piped: [[[f32; LANES]; 2]; 2],
    /// The same power at both ears without phases, from y: directly, and what the resonator adds.
    plain: [[f32; LANES]; 2],
    /// Full scale per √(2 J), at the ear that gets more of it.
    pub(crate) weight: [f32; LANES],
}

impl Source {
    /// Nothing.
    pub(crate) const SILENT: Self = Self {
        direct: [[[0.0; LANES]; 2]; 2],
        piped: [[[0.0; LANES]; 2]; 2],
        plain: [[0.0; LANES]; 2],
        weight: [0.0; LANES],
    };

    /// Takes up a mode; `scale` takes Pa to full scale.
    pub(crate) fn set(&mut self, lane: usize, mode: &Reached, scale: f64) {
        // y is Ω times the displacement.
        let unit = scale / (TAU * mode.hz);
        let all = sum(&mode.direct, &mode.piped);
        for ear in 0..2 {
            // A displacement sin ωt of 1 sounds like re sin ωt + im cos ωt.
            for (from, part) in [(0, 1), (1, 0)] {
                self.direct[ear][from][lane] = (unit * f64::from(mode.direct[ear][part])) as f32;
                self.piped[ear][from][lane] = (unit * f64::from(mode.piped[ear][part])) as f32;
            }
        }
        let plain = |ears: &Ears| {
            let power: f64 = ears.iter().flatten().map(|x| f64::from(*x).powi(2)).sum();
            unit * (0.5 * power).sqrt()
        };
        self.plain[0][lane] = plain(&mode.direct) as f32;
        self.plain[1][lane] = (plain(&all) - plain(&mode.direct)) as f32;
        self.weight[lane] = (unit * loudest(&all)) as f32;
    }

    /// Whether mode `lane` sounds rather as mode `other_lane` of `other` does than as its opposite.
    pub(crate) fn agrees(&self, lane: usize, other: &Self, other_lane: usize) -> bool {
        let parts = [(0, 0), (0, 1), (1, 0), (1, 1)];
        let both = |[own, theirs]: [&[[[f32; LANES]; 2]; 2]; 2]| {
            let product = |(ear, part): (usize, usize)| {
                f64::from(own[ear][part][lane]) * f64::from(theirs[ear][part][other_lane])
            };
            parts.map(product).iter().sum::<f64>()
        };
        both([&self.direct, &other.direct]) + both([&self.piped, &other.piped]) >= 0.0
    }

    /// What of x and y of modes at `omega` in rad/s reaches the ears.
    #[inline(always)]
    pub(crate) fn gains(
        &self,
        hearing: &Hearing,
        omega: &[f64; LANES],
        gain: &mut [[[f32; LANES]; 2]; 2],
    ) {
        let [open, width] = [hearing.open, hearing.width].map(|x| x as f32);
        for (ear, way) in hearing.ways.iter().enumerate() {
            let level = way.gain as f32;
            let (own, both) = (level * width, level * (1.0 - width));
            let [direct, piped] = [&self.direct[ear], &self.piped[ear]];
            let (mut cos, mut sin) = ([1.0; LANES], [0.0; LANES]);
            if way.longer_m != 0.0 {
                for i in 0..LANES {
                    (cos[i], sin[i]) = delayed(omega[i] * way.longer_m / SOUND_M_S);
                }
            }
            for i in 0..LANES {
                let x = direct[0][i] + open * piped[0][i];
                let y = direct[1][i] + open * piped[1][i];
                let plain = self.plain[0][i] + open * self.plain[1][i];
                gain[ear][0][i] = own * (x * cos[i] - y * sin[i]);
                gain[ear][1][i] = own * (y * cos[i] + x * sin[i]) + both * plain;
            }
        }
    }
}

/// Cosine and sine of any angle, without a call to a library.
#[inline(always)]
pub(super) fn delayed(angle: f64) -> (f32, f32) {
    // Adding and taking away 1.5·2⁵² rounds to the nearest whole number.
    const WHOLE: f64 = 6_755_399_441_055_744.0;
    let turns = angle / TAU;
    let rest = (turns - ((turns + WHOLE) - WHOLE)) * TAU;
    let (sin, cos) = super::oscillators::turned(rest.abs());
    (cos as f32, if rest < 0.0 { -sin } else { sin } as f32)
}

#[cfg(test)]
mod tests {
    use super::delayed;

    #[test]
    fn delays_are_cosine_and_sine() {
        for i in -2000..2000 {
            let angle = f64::from(i) * 0.317;
            let (cos, sin) = delayed(angle);
            assert!((f64::from(cos) - angle.cos()).abs() < 1e-7, "{angle}");
            assert!((f64::from(sin) - angle.sin()).abs() < 1e-7, "{angle}");
        }
    }
}
