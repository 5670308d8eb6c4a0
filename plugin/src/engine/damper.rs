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

impl Dampers {
    /// The damper with a share `felt` of its weight; a body without a felt of its own (`has_felt`) is
    /// damped by hand.
    pub(crate) fn new(felt: f64, has_felt: bool) -> Self {
        if has_felt {
            Self {
                felt,
                hand_per_s: 0.0,
            }
        } else {
            Self {
                felt: 0.0,
                hand_per_s: HAND_PER_S * felt,
            }
        }
    }

    /// Nothing.
    pub(crate) const OFF: Self = Self {
        felt: 0.0,
        hand_per_s: 0.0,
    };

    /// A hand that silences the body.
    pub(crate) const CHOKE: Self = Self {
        felt: 0.0,
        hand_per_s: CHOKE_PER_S,
    };
}

/// The bit of a key 0…127.
pub(crate) fn bit(key: u8) -> u128 {
    1 << (key & 127)
}

#[cfg(test)]
mod tests {
    use super::{CHOKE_PER_S, Dampers, HAND_PER_S};
    use modes::t60_s;

    #[test]
    fn dampers_take_the_stated_times() {
        assert!((t60_s(HAND_PER_S) - 0.25).abs() < 1e-12);
        assert!((t60_s(CHOKE_PER_S) - 0.06).abs() < 1e-12);
        assert_eq!(Dampers::new(0.5, true).felt, 0.5);
        assert_eq!(Dampers::new(0.5, false).hand_per_s, 0.5 * HAND_PER_S);
    }
}
