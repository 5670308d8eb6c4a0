//! The hands: what they do to the instrument, out.

use super::matrix::Sums;
use super::slot::{Modulated, Slot, TUNING_MOST};
use super::source::Values;
use super::state::{Hands, bit};
use super::strip::{Finger, Strip};
use super::target::{
    BEND_SEMITONES, BOW_OCTAVES, DISTANCE_OCTAVES, FIRMNESS_OCTAVES, HAND_PER_S, HARDNESS_DECADES,
    MASS_OCTAVES, MOTOR_HZ, POSITION,
};
use super::zones::Role;
use super::{KeyHands, Source, Target, TouchHands, WholeHands};

/// Middle C, where [`Source::Key`] is 0, and keys from there to its ends.
const MIDDLE_KEY: f64 = 60.0;
const KEYS_TO_END: f64 = 48.0;

/// The controllers that a key follows.
struct Grip<'a> {
    /// The finger on the key, with the manager's added in MPE.
    finger: Finger,
    bend_semitones: f64,
    /// Where wheels and pedals are read.
    wheels: &'a Strip,
}

impl Hands {
    /// What hands do to what rings on `key` 0…127.
    #[must_use]
    pub fn key(&self, key: u8) -> KeyHands {
        let slot = self.slot(key);
        let grip = self.grip(slot);
        let sums = self.matrix.run(&values(key, slot, &grip));
        let bend = slot.tuning_semitones + grip.bend_semitones;
        let firm = FIRMNESS_OCTAVES * sums.of(Target::DamperFirmness);
        let hand = sums.of(Target::HandDamping).max(0.0);
        KeyHands {
            bend_semitones: (bend + BEND_SEMITONES * sums.of(Target::Bend))
                .clamp(-TUNING_MOST, TUNING_MOST),
            level: slot.volume * sums.level(),
            pan: (slot.pan + sums.of(Target::Pan)).clamp(-1.0, 1.0),
            felt: (1.0 - self.off(key, slot, &grip)) * firm.exp2(),
            hand_per_s: HAND_PER_S * hand * hand,
            bow_pressure: sums.of(Target::BowPressure),
            bow_speed_octaves: BOW_OCTAVES * sums.of(Target::BowSpeed),
            damping_modulation: slot.modulation[Modulated::Damping as usize],
        }
    }

    /// How `key` 0…127 was struck last.
    ///
    /// Ask after all events of the strike's own sample: hosts say what is special about a note right
    /// after it.
    #[must_use]
    pub fn touch(&self, key: u8) -> TouchHands {
        let slot = self.slot(key);
        let sums = self.sums(key, slot);
        TouchHands {
            velocity: slot.velocity,
            position: POSITION * sums.of(Target::StrikePosition),
            hardness_decades: HARDNESS_DECADES * sums.of(Target::Hardness),
            mass_octaves: MASS_OCTAVES * sums.of(Target::MalletMass),
            position_modulation: slot.modulation[Modulated::StrikePosition as usize],
            hardness_modulation: slot.modulation[Modulated::Hardness as usize],
        }
    }

    /// What hands do to what all keys share: they do it where a key was struck last, or on channel 1 if
    /// none was.
    #[must_use]
    pub fn whole(&self) -> WholeHands {
        let sums = match self.last {
            Some(key) => self.sums(key, self.slot(key)),
            None => {
                let grip = self.grip_on(0, None);
                self.matrix.run(&values(60, &Slot::REST, &grip))
            }
        };
        WholeHands {
            motor_speed_hz: MOTOR_HZ * sums.of(Target::MotorSpeed),
            motor_depth: sums.of(Target::MotorDepth),
            distance_octaves: DISTANCE_OCTAVES * sums.of(Target::ListenerDistance),
        }
    }

    /// How far the damper of `key` 0…127 is off its body, 0…1: all the way while the key is down or
    /// caught by the sostenuto pedal, else as far as the sustain pedal lifts it.
    ///
    /// A key that no note has struck follows the pedal that is lowest.
    #[must_use]
    pub fn dampers(&self, key: u8) -> f64 {
        let slot = self.slot(key);
        self.off(key, slot, &self.grip(slot))
    }

    fn off(&self, key: u8, slot: &Slot, grip: &Grip<'_>) -> f64 {
        if (self.held | grip.wheels.caught) & bit(key) != 0 {
            1.0
        } else if slot.note.is_some() {
            grip.wheels.lift()
        } else {
            self.strips.iter().map(Strip::lift).fold(0.0, f64::max)
        }
    }

    fn slot(&self, key: u8) -> &Slot {
        &self.slots[usize::from(key & 127)]
    }

    fn sums(&self, key: u8, slot: &Slot) -> Sums {
        self.matrix.run(&values(key, slot, &self.grip(slot)))
    }

    fn grip(&self, slot: &Slot) -> Grip<'_> {
        match slot.note {
            Some(note) => self.grip_on(note.channel, slot.left),
            None => Grip {
                finger: Finger::REST,
                bend_semitones: 0.0,
                wheels: &Strip::REST,
            },
        }
    }

    /// The controllers of `channel` 0…15; `left` is a finger that is no longer on it.
    fn grip_on(&self, channel: u8, left: Option<Finger>) -> Grip<'_> {
        let own = &self.strips[usize::from(channel)];
        let Role::Member(zone) = self.zones.role(channel) else {
            return Grip {
                finger: own.finger,
                bend_semitones: own.finger.bend * own.bend_range_semitones,
                wheels: own,
            };
        };
        let manager = &self.strips[usize::from(zone.manager())];
        let finger = left.unwrap_or(own.finger);
        let bend_range_semitones = self.member_ranges_semitones[zone as usize];
        Grip {
            finger: Finger {
                bend: finger.bend,
                brightness: finger.brightness + manager.finger.brightness,
                pressure: finger.pressure.max(manager.finger.pressure),
            },
            bend_semitones: finger.bend * bend_range_semitones
                + manager.finger.bend * manager.bend_range_semitones,
            wheels: manager,
        }
    }
}

fn values(key: u8, slot: &Slot, grip: &Grip<'_>) -> Values {
    let brightness = slot.brightness + grip.finger.brightness;
    let place = (f64::from(key) - MIDDLE_KEY) / KEYS_TO_END;
    let mut values = Values::default();
    for (source, value) in [
        (Source::Velocity, slot.velocity),
        (Source::ReleaseVelocity, slot.release),
        (Source::ModWheel, grip.wheels.mod_wheel.max(slot.vibrato)),
        (Source::Breath, grip.wheels.breath),
        (Source::Foot, grip.wheels.foot),
        (
            Source::Expression,
            grip.wheels.expression * slot.expression - 1.0,
        ),
        (Source::Brightness, brightness.clamp(-1.0, 1.0)),
        (Source::Pressure, grip.finger.pressure.max(slot.pressure)),
        (Source::SoftPedal, grip.wheels.soft),
        (Source::Key, place.clamp(-1.0, 1.0)),
        (Source::Random, slot.chance),
    ] {
        values.set(source, value);
    }
    values
}
