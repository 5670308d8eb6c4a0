//! What can be seen of an engine while it plays.

use super::{Body, Engine, keys};
use crate::engine::body::Sound;
use crate::engine::touch::Touch;

/// The last blow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Struck {
    /// Whose body.
    pub key: u8,
    /// Where along it, 0…1.
    pub position: f64,
    /// Where across it, 0…1.
    pub across: f64,
    /// How hard, 0…1.
    pub velocity: f64,
    /// How many blows there were before; goes round.
    pub count: u32,
}

/// What holds a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Share of the felt's weight on it, 0…1.
    pub felt: f64,
    /// Decay rate that a hand gives all modes alike, in 1/s.
    pub hand_per_s: f64,
    /// Open share of the resonator, 0…1.
    pub open: f64,
    /// Frequencies over those as built.
    pub ratio: f64,
}

impl Default for Held {
    /// Hands off.
    fn default() -> Self {
        Self {
            felt: 0.0,
            hand_per_s: 0.0,
            open: 1.0,
            ratio: 1.0,
        }
    }
}

impl Engine {
    /// The last blow since the instrument came.
    #[must_use]
    pub fn struck(&self) -> Option<Struck> {
        self.struck
    }

    pub(super) fn remember(&mut self, key: u8, touch: &Touch, velocity: f64) {
        self.struck = Some(Struck {
            key,
            position: touch.position,
            across: touch.across,
            velocity,
            count: self.struck.map_or(0, |last| last.count.wrapping_add(1)),
        });
    }

    /// Writes the energy of each key's body in J.
    pub fn energies_j(&self, out: &mut [f32; 128]) {
        *out = [0.0; 128];
        for key in keys(self.awake) {
            let Some(body) = self.body(key) else {
                continue;
            };
            let packs = &self.packs[body.ringing()];
            let modes = packs.iter().flat_map(|pack| pack.x.iter().zip(&pack.y));
            let twice: f64 = modes.map(|(x, y)| x * x + y * y).sum();
            out[usize::from(key)] = (0.5 * twice) as f32;
        }
    }

    /// Writes how loud each mode of a key's body is now, as an amplitude over full scale, in the order of
    /// [`Partial::all`](super::super::Partial::all); how many were written.
    pub fn levels(&self, key: u8, out: &mut [f32]) -> usize {
        self.each_mode(key, out, |sound| sound.power.sqrt())
    }

    /// Writes how far each mode of a key's body swings now, in m·kg^(1/2), in the order of
    /// [`Partial::all`](super::super::Partial::all); how many were written.
    pub fn swings(&self, key: u8, out: &mut [f32]) -> usize {
        self.each_mode(key, out, |sound| sound.swing)
    }

    /// Writes what `of` says of each mode of a key's body; how many were written.
    fn each_mode(&self, key: u8, out: &mut [f32], of: impl Fn(&Sound) -> f64) -> usize {
        let Some(body) = self.body(key) else {
            return 0;
        };
        let mut written = 0;
        for (out, sound) in out.iter_mut().zip(body.sounds(&self.packs)) {
            *out = of(&sound) as f32;
            written += 1;
        }
        written
    }

    /// What holds a key's body, as far as its modes have been told; one that sleeps is told what a blow
    /// would find.
    #[must_use]
    pub fn held(&self, key: u8) -> Held {
        let tuned = self.body(key).and_then(Body::tuned);
        tuned.map_or_else(Held::default, |tuned| Held {
            felt: tuned.drain.felt,
            hand_per_s: tuned.drain.hand_per_s,
            open: tuned.drain.resonator,
            ratio: tuned.ratio,
        })
    }
}
