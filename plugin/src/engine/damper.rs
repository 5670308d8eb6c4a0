//! What takes the energy out of a body besides its material.

/// Decay rate of a felt damper on a released key, in 1/s: 60 dB in 0.25 s.
const FELT_PER_S: f64 = 27.631_021_115_928_547;

/// Decay rate of a hand that silences a body, in 1/s: 60 dB in 60 ms, slow enough not to click.
const CHOKE_PER_S: f64 = 115.129_254_649_702_28;

/// Keys, pedal and hands on the bodies, one bit a key.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Damper {
    held: u128,
    choked: u128,
    pedal: bool,
}

impl Damper {
    /// A key goes down: no hand stays on its body.
    pub(crate) fn press(&mut self, key: u8) {
        self.held |= bit(key);
        self.choked &= !bit(key);
    }

    /// A key comes up.
    pub(crate) fn release(&mut self, key: u8) {
        self.held &= !bit(key);
    }

    /// The sustain pedal moves.
    pub(crate) fn pedal(&mut self, down: bool) {
        self.pedal = down;
    }

    /// Hands on the bodies whose bits are set, keys up.
    pub(crate) fn choke(&mut self, keys: u128) {
        self.choked |= keys;
        self.held &= !keys;
    }

    /// Extra decay rate on a body, in 1/s.
    pub(crate) fn decay_per_s(&self, key: u8, note_off_damps: bool) -> f64 {
        if self.choked & bit(key) != 0 {
            CHOKE_PER_S
        } else if note_off_damps && !self.pedal && self.held & bit(key) == 0 {
            FELT_PER_S
        } else {
            0.0
        }
    }
}

/// The bit of a key 0…127.
pub(crate) fn bit(key: u8) -> u128 {
    1 << (key & 127)
}

#[cfg(test)]
mod tests {
    use super::{CHOKE_PER_S, Damper, FELT_PER_S};
    use modes::t60_s;

    #[test]
    fn dampers_take_the_stated_times() {
        assert!((t60_s(FELT_PER_S) - 0.25).abs() < 1e-12);
        assert!((t60_s(CHOKE_PER_S) - 0.06).abs() < 1e-12);
    }

    #[test]
    fn pedal_and_keys_hold_the_felt_off() {
        let mut damper = Damper::default();
        damper.press(60);
        assert_eq!(damper.decay_per_s(60, true), 0.0);
        damper.pedal(true);
        damper.release(60);
        assert_eq!(damper.decay_per_s(60, true), 0.0);
        damper.pedal(false);
        assert_eq!(damper.decay_per_s(60, true), FELT_PER_S);
        assert_eq!(damper.decay_per_s(60, false), 0.0);
        damper.choke(u128::MAX);
        assert_eq!(damper.decay_per_s(60, false), CHOKE_PER_S);
        damper.press(60);
        assert_eq!(damper.decay_per_s(60, true), 0.0);
    }
}
