//! Banks in closed form, and how a rendering is measured.

use idiophone::engine::{Engine, Mallet};
use modes::{
    Bank, Body, Damping, Family, Material, Member, Mode, ModeLabel, Motion, Provenance, Rayleigh,
    StrikeLine,
};
use std::f64::consts::{PI, TAU};

/// Points of a strike line.
const POINTS: usize = 121;

/// kL of the `k`-th bending mode of a free beam, k from 1: cos kL cosh kL = 1.
pub(crate) fn beam_root(k: usize) -> f64 {
    let mut root = (2 * k + 1) as f64 * PI / 2.0;
    for _ in 0..20 {
        let slope = -root.sin() + root.sinh() / root.cosh().powi(2);
        root -= (root.cos() - root.cosh().recip()) / slope;
    }
    root
}

/// Deflection of that mode at `x` of the length, 1 at the end (Rao, Mechanical Vibrations, §8.5).
pub(crate) fn beam_shape(k: usize, x: f64) -> f64 {
    let root = beam_root(k);
    let s = root * (x - 0.5);
    let half = 0.5 * root;
    if k % 2 == 1 {
        0.5 * (s.cos() / half.cos() + s.cosh() / half.cosh())
    } else {
        -0.5 * (s.sin() / half.sin() + s.sinh() / half.sinh())
    }
}

/// The bending modes below 20 kHz of a thin free tube whose fundamental is at `hz`.
pub(crate) fn chime(key: u8, hz: f64) -> Body {
    let length_m = 0.505 * (587.33 / hz).sqrt();
    let mass_kg = 0.35 * length_m / 0.505;
    let modes = (1..)
        .map(|k| (k, hz * (beam_root(k) / beam_root(1)).powi(2)))
        .take_while(|(_, hz)| *hz < 20e3)
        .map(|(k, hz)| {
            let height = 2.0 / mass_kg.sqrt();
            Mode {
                hz,
                coupling: TAU * hz * height * 0.6 * 4.0 * 0.0125 * length_m,
                // In phase with the displacement, the same at both ears.
                ears: [[
                    (TAU * hz * height * 0.6 * 4.0 * 0.0125 * length_m) as f32,
                    0.0,
                ]; 2],
                pipe_ears: [[0.0; 2]; 2],
                radiation_per_s: 0.0,
                support_per_s: 0.0,
                felt_per_s: 0.0,
                pipe_per_s: 0.0,
                residual: 0.0,
                label: ModeLabel {
                    family: Family::Bending,
                    order: 1,
                    index: k as u16,
                    member: Member::A,
                },
                shape: (0..POINTS)
                    .map(|i| {
                        let x = i as f64 / (POINTS - 1) as f64;
                        [(height * beam_shape(k, x)) as f32, 0.0, 0.0]
                    })
                    .collect(),
            }
        })
        .collect();
    Body {
        key,
        pitch_hz: hz,
        length_m,
        mass_kg,
        matter: None,
        line: StrikeLine::single(
            (0..POINTS)
                .map(|i| [0.0125, 0.0, length_m * i as f64 / (POINTS - 1) as f64])
                .collect(),
            vec![[1.0, 0.0, 0.0]; POINTS],
        ),
        surface: None,
        modes,
    }
}

/// The usual mallet with a head of this modulus, in Pa.
pub(crate) fn head(hardness_pa: f64) -> Mallet {
    Mallet {
        hardness_pa,
        ..Mallet::DEFAULT
    }
}

/// Frequency of a key, A4 = 440 Hz.
pub(crate) fn key_hz(key: u8) -> f64 {
    440.0 * 2f64.powf((f64::from(key) - 69.0) / 12.0)
}

/// Chimes for these keys, with the damping of the metal chime in O'Brien 2002, Table 1.
pub(crate) fn chimes(keys: impl IntoIterator<Item = u8>) -> Bank {
    Bank {
        name: "test chimes".into(),
        material: Material::from_young(70e9, 0.33, 2700.0).expect("aluminium is possible"),
        title: "Test chimes".into(),
        damping: Damping {
            rayleigh: Rayleigh {
                alpha1_s: 1e-7,
                alpha2_per_s: 0.0,
            },
            loss_factor: 0.0,
        },
        ears_m: [[-0.1, -1.0, 0.0], [0.1, -1.0, 0.0]],
        provenance: Provenance::default(),
        bodies: keys
            .into_iter()
            .map(|key| chime(key, key_hz(key)))
            .collect(),
        spread: None,
    }
}

/// The left channel of the next `samples`.
pub(crate) fn left(engine: &mut Engine, samples: usize) -> Vec<f64> {
    let (mut left, mut right) = (vec![0.0; samples], vec![0.0; samples]);
    engine.process(&mut left, &mut right);
    left.into_iter().map(f64::from).collect()
}

/// Blackman-Harris window, 4 terms, side lobes at −92 dB (Harris 1978, table 1).
pub(crate) fn window(n: usize, length: usize) -> f64 {
    let phase = TAU * (n as f64 + 0.5) / length as f64;
    0.358_75 - 0.488_29 * phase.cos() + 0.141_28 * (2.0 * phase).cos()
        - 0.011_68 * (3.0 * phase).cos()
}

/// A partial as found in a signal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Partial {
    /// Frequency, in Hz.
    pub(crate) hz: f64,
    /// Amplitude decay rate, in 1/s.
    pub(crate) decay_per_s: f64,
    /// Amplitude carried back to time 0.
    pub(crate) amplitude: f64,
}

/// Fits decaying sinusoids near the `expected` (frequency in Hz, decay rate in 1/s) to the samples
/// in `range`, all at once.
///
/// Least squares on e^(−dt) cos, e^(−dt) sin and t times each: the first order in what the decay
/// rate and the frequency are off, without bias from one partial to another.
pub(crate) fn fit(
    signal: &[f64],
    rate_hz: f64,
    expected: &[(f64, f64)],
    range: std::ops::Range<usize>,
) -> Vec<Partial> {
    let size = 4 * expected.len();
    let mut normal = vec![0.0; size * size];
    let mut right = vec![0.0; size];
    let mut row = vec![0.0; size];
    for n in range.clone() {
        let t = n as f64 / rate_hz;
        for (four, (hz, decay)) in row.chunks_exact_mut(4).zip(expected) {
            let (sin, cos) = (TAU * hz * t).sin_cos();
            let fall = (-decay * (n - range.start) as f64 / rate_hz).exp();
            // In units of its own decay time, so that fast and slow partials weigh alike.
            let time = decay.max(1.0) * t;
            four.copy_from_slice(&[fall * cos, fall * sin, time * fall * cos, time * fall * sin]);
        }
        for i in 0..size {
            right[i] += row[i] * signal[n];
            for j in 0..=i {
                normal[i * size + j] += row[i] * row[j];
            }
        }
    }
    solve(&mut normal, &mut right);
    let start = range.start as f64 / rate_hz;
    right
        .chunks_exact(4)
        .zip(expected)
        .map(|(c, (hz, decay))| {
            let square = c[0] * c[0] + c[1] * c[1];
            let unit = decay.max(1.0);
            let turn = (c[1] * c[2] - c[0] * c[3]) * unit / square;
            Partial {
                hz: hz + turn / TAU,
                decay_per_s: decay - (c[0] * c[2] + c[1] * c[3]) * unit / square,
                amplitude: square.sqrt() * (decay * start).exp(),
            }
        })
        .collect()
}

/// Solves a symmetric positive definite system in place by Cholesky's method.
fn solve(matrix: &mut [f64], right: &mut [f64]) {
    let size = right.len();
    for i in 0..size {
        for j in 0..=i {
            let dot: f64 = (0..j)
                .map(|k| matrix[i * size + k] * matrix[j * size + k])
                .sum();
            let rest = matrix[i * size + j] - dot;
            matrix[i * size + j] = if i == j {
                rest.sqrt()
            } else {
                rest / matrix[j * size + j]
            };
        }
    }
    for i in 0..size {
        let dot: f64 = (0..i).map(|k| matrix[i * size + k] * right[k]).sum();
        right[i] = (right[i] - dot) / matrix[i * size + i];
    }
    for i in (0..size).rev() {
        let dot: f64 = (i + 1..size).map(|k| matrix[k * size + i] * right[k]).sum();
        right[i] = (right[i] - dot) / matrix[i * size + i];
    }
}

/// Frequencies in Hz and decay rates in 1/s that the modes of `body` must have (O'Brien 2002, Eq. 9;
/// van den Doel & Pai 1998, Eq. 12).
pub(crate) fn expected(body: &Body, damping: Damping) -> Vec<(f64, f64)> {
    body.modes
        .iter()
        .map(
            |mode| match Motion::of(mode.hz, damping.decay_per_s(mode.hz)) {
                Motion::Ringing { hz, decay_per_s } => (hz, decay_per_s),
                Motion::Overdamped => panic!("chimes ring"),
            },
        )
        .collect()
}

/// Magnitudes of the windowed spectrum of a power of two of samples, up to half the rate.
pub(crate) fn spectrum(signal: &[f64]) -> Vec<f64> {
    let length = signal.len();
    assert!(length.is_power_of_two());
    let mut values: Vec<(f64, f64)> = (0..length)
        .map(|n| {
            let from = n.reverse_bits() >> (usize::BITS - length.trailing_zeros());
            (signal[from] * window(from, length), 0.0)
        })
        .collect();
    let mut half = 1;
    while half < length {
        for first in (0..length).step_by(2 * half) {
            for k in 0..half {
                let (sin, cos) = (-PI * k as f64 / half as f64).sin_cos();
                let (a, b) = (values[first + k], values[first + k + half]);
                let turned = (b.0 * cos - b.1 * sin, b.0 * sin + b.1 * cos);
                values[first + k] = (a.0 + turned.0, a.1 + turned.1);
                values[first + k + half] = (a.0 - turned.0, a.1 - turned.1);
            }
        }
        half *= 2;
    }
    values[..length / 2]
        .iter()
        .map(|(re, im)| re.hypot(*im))
        .collect()
}

/// 20 log₁₀ of a ratio.
pub(crate) fn db(ratio: f64) -> f64 {
    20.0 * ratio.log10()
}

/// Random numbers for tests (`SplitMix64`, Steele et al. 2014).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Uniform 64 bits.
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in 0…1.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform below `n`.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }
}
