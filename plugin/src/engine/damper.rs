//! What takes the energy out of a body besides its material.

/// Decay rate of a hand on a released body that has no felt, in 1/s: 60 dB in 0.25 s.
const HAND_PER_S: f64 = 27.631_021_115_928_547;

/// Decay rate of a hand that silences a body, in 1/s: 60 dB in 60 ms, slow enough not to click.
const CHOKE_PER_S: f64 = 115.129_254_649_702_28;

/// What lies on a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Dampers {
    /// Share of the felt's weight.
    pub(crate) felt: f64,
    /// Decay rate by a hand, in 1/s.
    pub(crate) hand_per_s: f64,
}

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

    /// What lies on a body; one without a felt of its own (`has_felt`) is damped by hand.
    pub(crate) fn on(&self, key: u8, note_off_damps: bool, has_felt: bool) -> Dampers {
        let free = Dampers {
            felt: 0.0,
            hand_per_s: 0.0,
        };
        if self.choked & bit(key) != 0 {
            Dampers {
                hand_per_s: CHOKE_PER_S,
                ..free
            }
        } else if !note_off_damps || self.pedal || self.held & bit(key) != 0 {
            free
        } else if has_felt {
            Dampers { felt: 1.0, ..free }
        } else {
            Dampers {
                hand_per_s: HAND_PER_S,
                ..free
            }
        }
    }
}

/// The bit of a key 0…127.
pub(crate) fn bit(key: u8) -> u128 {
    1 << (key & 127)
}

#[cfg(test)]
mod tests {
    use super::{CHOKE_PER_S, Damper, Dampers, HAND_PER_S};
    use modes::t60_s;

    #[test]
    fn dampers_take_the_stated_times() {
        assert!((t60_s(HAND_PER_S) - 0.25).abs() < 1e-12);
        assert!((t60_s(CHOKE_PER_S) - 0.06).abs() < 1e-12);
    }

    #[test]
    fn pedal_and_keys_hold_dampers_off() {
        let hand = |hand_per_s| Dampers {
            felt: 0.0,
            hand_per_s,
        };
        let mut damper = Damper::default();
        damper.press(60);
        assert_eq!(damper.on(60, true, false), hand(0.0));
        damper.pedal(true);
        damper.release(60);
        assert_eq!(damper.on(60, true, true), hand(0.0));
        damper.pedal(false);
        assert_eq!(damper.on(60, true, false), hand(HAND_PER_S));
        let felt = Dampers {
            felt: 1.0,
            hand_per_s: 0.0,
        };
        assert_eq!(damper.on(60, true, true), felt);
        assert_eq!(damper.on(60, false, true), hand(0.0));
        damper.choke(u128::MAX);
        assert_eq!(damper.on(60, false, true), hand(CHOKE_PER_S));
        damper.press(60);
        assert_eq!(damper.on(60, true, true), hand(0.0));
    }
}
