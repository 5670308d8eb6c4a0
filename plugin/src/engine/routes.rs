//! Which output each body is on, and bodies on their way from one to another.

use super::Split;
use super::damper::bit;
use super::oscillators::Buses;
use super::outputs::OUTPUTS;

/// How long a body that sounds takes from one output to another, in s.
const WAY_S: f64 = 0.005;

/// The outputs of all bodies.
#[derive(Clone)]
pub(super) struct Routes {
    /// The output of each body, or the one it is on its way to.
    to: [u8; 128],
    /// The one it comes from, and the samples that the rest of its way takes.
    from: [u8; 128],
    left: [u32; 128],
    /// Samples of a whole way.
    whole: u32,
    /// Bodies on their way.
    pub(super) moving: u128,
    /// Bodies that may have to move.
    pub(super) pending: u128,
    /// Bodies that are not in the main output, or not only.
    away: u128,
    /// How many bodies are lower, and the channel of the last blow.
    ranks: [u8; 128],
    channels: [u8; 128],
}

impl Routes {
    /// Of some bodies, as bits, all in the main output.
    pub(super) fn new(bodies: u128, step_s: f64) -> Self {
        let mut ranks = [0; 128];
        for (key, rank) in (0..).zip(&mut ranks) {
            // At most 127.
            *rank = (bodies & (bit(key) - 1)).count_ones() as u8;
        }
        #[expect(clippy::cast_sign_loss, reason = "a time is no less than nothing")]
        let whole = (WAY_S / step_s).round().max(1.0) as u32;
        Self {
            to: [0; 128],
            from: [0; 128],
            left: [0; 128],
            whole,
            moving: 0,
            pending: 0,
            away: 0,
            ranks,
            channels: [0; 128],
        }
    }

    /// Where the bodies of `old` are; those on their way are there. All may have to move from there.
    pub(super) fn inherit(&mut self, old: &Self) {
        *self = Self {
            ranks: self.ranks,
            left: [0; 128],
            moving: 0,
            pending: u128::MAX,
            ..old.clone()
        };
    }

    /// A key's body is struck on a channel.
    pub(super) fn strike(&mut self, key: u8, channel: u8) {
        let slot = usize::from(key & 127);
        if self.channels[slot] != channel {
            self.channels[slot] = channel;
            self.pending |= bit(key);
        }
    }

    fn wanted(&self, key: u8, split: Split) -> u8 {
        let slot = usize::from(key & 127);
        split.output(key, self.ranks[slot], self.channels[slot])
    }

    /// A body that is silent is where it belongs at once.
    pub(super) fn put(&mut self, key: u8, split: Split) {
        let to = self.wanted(key, split);
        self.to[usize::from(key & 127)] = to;
        self.moving &= !bit(key);
        self.pending &= !bit(key);
        self.away = (self.away & !bit(key)) | if to == 0 { 0 } else { bit(key) };
    }

    /// A body that sounds starts on its way to where it belongs; whether there is such a way. One on its
    /// way first arrives.
    pub(super) fn depart(&mut self, key: u8, split: Split) -> bool {
        let slot = usize::from(key & 127);
        if self.moving & bit(key) != 0 {
            return false;
        }
        self.pending &= !bit(key);
        let to = self.wanted(key, split);
        if to == self.to[slot] {
            return false;
        }
        self.from[slot] = std::mem::replace(&mut self.to[slot], to);
        self.left[slot] = self.whole;
        self.moving |= bit(key);
        self.away |= bit(key);
        true
    }

    /// The output of a body that is not on its way.
    pub(super) fn output(&self, key: u8) -> usize {
        usize::from(self.to[usize::from(key & 127)])
    }

    /// The outputs that some bodies are on, bit 0 for the main one, which always counts.
    pub(super) fn used(&self, bodies: u128) -> u8 {
        let mut used = 1;
        let mut away = self.away & bodies;
        while away != 0 {
            let slot = away.trailing_zeros() as usize;
            away &= away - 1;
            used |= 1 << self.to[slot];
            if self.moving >> slot & 1 == 1 {
                used |= 1 << self.from[slot];
            }
        }
        used
    }

    /// Shares the next `run` samples of a body that is on its way out to the outputs.
    pub(super) fn share(&self, key: u8, run: usize, sound: &Buses, outputs: &mut [Buses; OUTPUTS]) {
        let slot = usize::from(key & 127);
        let (from, to) = (usize::from(self.from[slot]), usize::from(self.to[slot]));
        let (left, whole) = (self.left[slot], f64::from(self.whole));
        for (side, sound) in sound.iter().enumerate() {
            for (n, (gone, sound)) in (0..).zip(sound).take(run).enumerate() {
                let before = f64::from(left.saturating_sub(gone)) / whole * sound;
                outputs[from][side][n] += before;
                outputs[to][side][n] += sound - before;
            }
        }
    }

    /// On by `run` samples.
    pub(super) fn advance(&mut self, run: usize) {
        let mut moving = self.moving;
        while moving != 0 {
            let slot = moving.trailing_zeros() as usize;
            moving &= moving - 1;
            // A run is within a cell.
            self.left[slot] = self.left[slot].saturating_sub(run as u32);
            if self.left[slot] == 0 {
                self.moving &= !(1 << slot);
                if self.to[slot] == 0 {
                    self.away &= !(1 << slot);
                }
            }
        }
    }

    /// All in the main output again.
    pub(super) fn reset(&mut self) {
        self.to = [0; 128];
        self.channels = [0; 128];
        (self.moving, self.pending, self.away) = (0, 0, 0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::GRID;
    use crate::engine::oscillators::SILENT;

    const STEP_S: f64 = 1.0 / 48_000.0;

    #[test]
    fn a_body_on_its_way_is_shared_out_in_full() {
        let mut routes = Routes::new(bit(60) | bit(61), STEP_S);
        assert!(!routes.depart(60, Split::Body), "the lowest is there");
        assert!(routes.depart(61, Split::Body));
        assert!(!routes.depart(61, Split::Main), "first it arrives");
        assert_eq!(routes.used(u128::MAX), 0b11);
        let sound = [[1.0; GRID]; 2];
        let mut last = 0.0;
        let mut samples = 0;
        while routes.moving != 0 {
            let mut outputs = [SILENT; OUTPUTS];
            routes.share(61, GRID, &sound, &mut outputs);
            for (old, new) in outputs[0][1].iter().zip(outputs[1][1]) {
                assert!((old + new - 1.0).abs() < 1e-15);
                assert!(new >= last && new - last < 1.01 / 240.0);
                last = new;
            }
            routes.advance(GRID);
            samples += GRID;
        }
        assert_eq!((last, samples), (1.0, 256));
        assert_eq!((routes.output(60), routes.output(61)), (0, 1));
        assert_eq!((routes.used(bit(60)), routes.used(bit(61))), (1, 0b11));
    }

    #[test]
    fn silent_bodies_are_there_at_once_and_channels_count_from_the_blow() {
        let mut routes = Routes::new(bit(60), STEP_S);
        routes.strike(60, 4);
        assert_eq!((routes.pending, routes.output(60)), (bit(60), 0));
        routes.put(60, Split::Channel);
        assert_eq!((routes.pending, routes.output(60)), (0, 4));
        assert_eq!(routes.used(u128::MAX), 0b1_0001);
        routes.strike(60, 4);
        assert_eq!(routes.pending, 0);
        routes.put(60, Split::Main);
        assert_eq!(routes.used(u128::MAX), 1);
    }
}
