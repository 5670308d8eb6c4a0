//! How modes move a body of revolution: as on the strike line, with the waves of their order around.

use super::revolve::Profile;
use super::{Vector, by_name, heard_modes};
use modes::{Member, ModeLabel};
use std::collections::HashMap;

/// The modes of a body of revolution.
#[derive(Clone, Debug)]
pub(super) struct Turned {
    modes: Vec<Waves>,
    /// Sample of the strike line, cosine and sine of the angle of each point.
    points: Vec<(usize, f32, f32)>,
    /// Points around, the last of them being the first.
    width: usize,
}

/// Motion outwards, around and along, in kg^(−1/2), at each sample of the line: what goes with cos mθ,
/// and what with sin mθ.
#[derive(Clone, Debug)]
struct Waves {
    order: u16,
    cos: Vec<Vector>,
    sin: Vec<Vector>,
}

impl Turned {
    pub(super) fn of(body: &modes::Body, profile: &Profile) -> Self {
        let (modes, known) = (heard_modes(body), by_name(body));
        let mut points = Vec::new();
        for rim in profile.runs.iter().flatten() {
            points.extend((0..=profile.around).map(|number| {
                let (sin, cos) = profile.angle(number).sin_cos();
                (rim.sample, cos as f32, sin as f32)
            }));
        }
        Self {
            modes: modes.iter().map(|mode| waves(&known, mode)).collect(),
            points,
            width: profile.around as usize + 1,
        }
    }

    pub(super) fn motion(&self, mode: usize) -> Vec<Vector> {
        let Some(Waves { order, cos, sin }) = self.modes.get(mode) else {
            return vec![[0.0; 3]; self.points.len()];
        };
        let turns: Vec<(f32, f32)> = (0..self.width)
            .map(|i| {
                let turn =
                    f32::from(*order) * std::f32::consts::TAU * (i % (self.width - 1)) as f32
                        / (self.width - 1) as f32;
                (turn.cos(), turn.sin())
            })
            .collect();
        (self.points.iter().zip(turns.iter().cycle()))
            .map(|((sample, c, s), (wave_c, wave_s))| {
                let [out, round, up] =
                    [0, 1, 2].map(|a| wave_c * cos[*sample][a] + wave_s * sin[*sample][a]);
                [out * c - round * s, out * s + round * c, up]
            })
            .collect()
    }
}

/// From what a mode does on the line, at θ = 0, to what it does around.
///
/// Of a pair with its antinode at θ₀, one goes out with U cos m(θ − θ₀) and around with V sin m(θ − θ₀),
/// the other with U sin m(θ − θ₀) and −V cos m(θ − θ₀): what one does at θ = 0 is what the other does a
/// quarter of a wave on, but for a sign that the bank leaves open. A wall that bends without being
/// stretched has mV = −U, which tells it.
fn waves(known: &HashMap<ModeLabel, &modes::Mode>, mode: &modes::Mode) -> Waves {
    let order = mode.label.order;
    let own: Vec<Vector> = mode.shape.iter().collect();
    let still = vec![[0.0; 3]; own.len()];
    if order == 0 || mode.label.member == Member::Single {
        return Waves {
            order,
            cos: own,
            sin: still,
        };
    }
    let Some(other) = partner(&mode.label).and_then(|label| known.get(&label)) else {
        let round = |[out, _, _]: &Vector| [0.0, -out / f32::from(order), 0.0];
        let sin = own.iter().map(round).collect();
        return Waves {
            order,
            cos: own,
            sin,
        };
    };
    // out·(what goes around a quarter wave on) is below zero where the sign is right.
    let agree: f32 = (own.iter().zip(other.shape.iter()))
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum();
    let sign = if agree <= 0.0 { 1.0 } else { -1.0 };
    let sin = other.shape.iter().map(|u| u.map(|x| sign * x)).collect();
    Waves {
        order,
        cos: own,
        sin,
    }
}

/// The name of the other of a pair.
fn partner(label: &ModeLabel) -> Option<ModeLabel> {
    let member = match label.member {
        Member::A => Member::B,
        Member::B => Member::A,
        Member::Single => return None,
    };
    Some(ModeLabel { member, ..*label })
}
