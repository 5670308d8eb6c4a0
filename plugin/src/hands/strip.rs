//! One MIDI channel's controllers.

use super::rpn::Rpn;
use super::tame::{about_64, unipolar};

/// What a finger does, which in MPE has a channel of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Finger {
    /// Pitch bend as a share of its range, −1…1.
    pub(super) bend: f64,
    /// CC 74, −1…1.
    pub(super) brightness: f64,
    /// Channel pressure, 0…1.
    pub(super) pressure: f64,
}

impl Finger {
    pub(super) const REST: Self = Self {
        bend: 0.0,
        brightness: 0.0,
        pressure: 0.0,
    };
}

/// A channel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Strip {
    pub(super) finger: Finger,
    pub(super) mod_wheel: f64,
    pub(super) breath: f64,
    pub(super) foot: f64,
    /// CC 11, 0…1, at rest 1.
    pub(super) expression: f64,
    pub(super) soft: f64,
    /// CC 64, 0…1.
    pub(super) sustain: f64,
    /// Whether CC 66 is down.
    pub(super) sostenuto: bool,
    /// The keys that were down when the sostenuto pedal went down.
    pub(super) caught: u128,
    /// The keys whose last note came on this channel.
    pub(super) keys: u128,
    /// Full pitch bend, in semitones.
    pub(super) bend_range_semitones: f64,
    pub(super) rpn: Rpn,
}

/// Positions of CC 64 between which the felt lifts off.
///
/// Felt rests fully on the bars over the first quarter of a pedal's way, and is clear of them over
/// the last: so a pedal that only knows up and down is right, and one that shakes at either end is
/// quiet.
const LIFTS: (f64, f64) = (0.25, 0.75);

impl Strip {
    /// Untouched.
    pub(super) const REST: Self = Self {
        finger: Finger::REST,
        mod_wheel: 0.0,
        breath: 0.0,
        foot: 0.0,
        expression: 1.0,
        soft: 0.0,
        sustain: 0.0,
        sostenuto: false,
        caught: 0,
        keys: 0,
        bend_range_semitones: 2.0,
        rpn: Rpn::NULL,
    };

    /// Takes in a controller that moves; whether it is one of ours.
    pub(super) fn move_controller(&mut self, cc: u8, value: f64, down: u128) -> bool {
        let share = unipolar(value);
        match cc {
            1 => self.mod_wheel = share,
            2 => self.breath = share,
            4 => self.foot = share,
            11 => self.expression = super::tame::within(value, 0.0, 1.0, 1.0),
            64 => self.sustain = share,
            66 => self.press_sostenuto(share >= 0.5, down),
            67 => self.soft = share,
            74 => self.finger.brightness = about_64(value),
            _ => return false,
        }
        true
    }

    /// The sostenuto pedal catches the keys that are `down` when it goes down, and no others.
    fn press_sostenuto(&mut self, pressed: bool, down: u128) {
        if pressed && !self.sostenuto {
            self.caught = down;
        } else if !pressed {
            self.caught = 0;
        }
        self.sostenuto = pressed;
    }

    /// How far the sustain pedal holds the felt off, 0…1.
    pub(super) fn lift(&self) -> f64 {
        ((self.sustain - LIFTS.0) / (LIFTS.1 - LIFTS.0)).clamp(0.0, 1.0)
    }

    /// CC 121 as MMA RP-015 has it: wheels, pedals, pressure, bend and parameter number go to rest; the
    /// sound controllers 70 to 79, so brightness, and what parameters were set stay.
    pub(super) fn reset_controllers(&mut self) {
        *self = Self {
            finger: Finger {
                brightness: self.finger.brightness,
                ..Finger::REST
            },
            keys: self.keys,
            bend_range_semitones: self.bend_range_semitones,
            ..Self::REST
        };
    }

    /// All to rest, as when a channel enters or leaves MPE (RP-053, §2.1.4).
    pub(super) fn reset_all(&mut self, bend_range_semitones: f64) {
        *self = Self {
            keys: self.keys,
            bend_range_semitones,
            rpn: self.rpn,
            ..Self::REST
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_felt_lifts_between_two_places() {
        let mut strip = Strip::REST;
        for (sustain, lift) in [
            (0.0, 0.0),
            (0.25, 0.0),
            (0.375, 0.25),
            (0.5, 0.5),
            (0.7, 0.9),
            (0.75, 1.0),
            (1.0, 1.0),
        ] {
            assert!(strip.move_controller(64, sustain, 0));
            assert!((strip.lift() - lift).abs() < 1e-12, "{sustain}");
        }
        strip.move_controller(64, f64::NAN, 0);
        assert_eq!(strip.lift(), 0.0);
    }

    #[test]
    fn sostenuto_catches_once() {
        let mut strip = Strip::REST;
        strip.move_controller(66, 1.0, 0b101);
        strip.move_controller(66, 0.9, 0b111);
        assert_eq!(strip.caught, 0b101);
        strip.move_controller(66, 0.4, 0b111);
        assert_eq!(strip.caught, 0);
        strip.move_controller(66, 0.5, 0b010);
        assert_eq!(strip.caught, 0b010);
    }

    /// MMA RP-015.
    #[test]
    fn reset_all_controllers_spares_the_sound() {
        let mut strip = Strip::REST;
        for cc in [1, 2, 4, 11, 64, 66, 67, 74] {
            assert!(strip.move_controller(cc, 0.9, 1));
        }
        strip.finger.bend = 0.5;
        strip.finger.pressure = 0.5;
        strip.bend_range_semitones = 7.0;
        strip.rpn.hear(101, 0.0);
        let brightness = strip.finger.brightness;
        strip.reset_controllers();
        assert!(brightness > 0.0 && strip.finger.brightness == brightness);
        assert_eq!(strip.bend_range_semitones, 7.0);
        let rest = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0);
        let Strip {
            mod_wheel,
            breath,
            foot,
            expression,
            soft,
            sustain,
            ..
        } = strip;
        assert_eq!((mod_wheel, breath, foot, expression, soft, sustain), rest);
        assert_eq!((strip.sostenuto, strip.caught), (false, 0));
        assert_eq!((strip.finger.bend, strip.finger.pressure), (0.0, 0.0));
        assert_eq!(strip.rpn, Rpn::NULL);
    }

    #[test]
    fn other_controllers_are_not_ours() {
        let ours = [1, 2, 4, 11, 64, 66, 67, 74];
        for cc in 0..=255 {
            let mut strip = Strip::REST;
            assert_eq!(strip.move_controller(cc, 0.5, 0), ours.contains(&cc));
        }
    }
}
