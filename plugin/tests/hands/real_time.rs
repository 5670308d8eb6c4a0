//! Anything at all, at any rate, without memory.

use idiophone::hands::{
    Address, Assignment, Expression, Hands, KeyHands, Modulated, Mpe, Note, SLOTS, Settings,
    Source, Target,
};
use nice_assert_no_alloc::assert_no_alloc;

/// With the feature, the plug-in brings this allocator along.
#[cfg(not(feature = "assert_process_allocs"))]
#[global_allocator]
static ALLOCATOR: nice_assert_no_alloc::AllocDisabler = nice_assert_no_alloc::AllocDisabler;

const EVENTS: usize = 100_000;

/// Random numbers (`SplitMix64`, Steele et al. 2014).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: u8) -> u8 {
        u8::try_from(self.bits() % u64::from(n)).unwrap_or(0)
    }

    fn one_of<T: Copy>(&mut self, some: &[T]) -> T {
        some[usize::from(self.below(u8::try_from(some.len()).unwrap_or(1)))]
    }

    /// Mostly −1…1, sometimes a byte's share of 127, sometimes nonsense.
    fn value(&mut self) -> f64 {
        match self.below(8) {
            0 => self.one_of(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300]),
            1..=3 => f64::from(self.below(128)) / 127.0,
            _ => (self.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0,
        }
    }

    /// Few keys and channels, so that events meet; now and then impossible ones.
    fn key(&mut self) -> u8 {
        self.one_of(&[0, 59, 60, 61, 62, 127, 128, 255])
    }

    fn channel(&mut self) -> u8 {
        self.one_of(&[0, 1, 2, 3, 13, 14, 15, 200])
    }

    fn id(&mut self) -> i32 {
        i32::from(self.below(6)) - 1
    }

    fn address(&mut self) -> Address {
        let (channel, key, id) = (self.channel(), self.key(), self.id());
        Address {
            channel: (self.below(2) == 0).then_some(channel),
            key: (self.below(2) == 0).then_some(key),
            id: (self.below(2) == 0).then_some(id),
        }
    }

    fn settings(&mut self) -> Settings {
        Settings {
            velocity_curve: self.value(),
            mpe: self.one_of(&Mpe::ALL),
            bend_range_semitones: 100.0 * self.value(),
            member_bend_range_semitones: 100.0 * self.value(),
            assignments: [(); SLOTS].map(|()| Assignment {
                source: self.one_of(&Source::ALL),
                target: self.one_of(&Target::ALL),
                depth: self.value(),
                curve: self.value(),
            }),
        }
    }

    fn play(&mut self, hands: &mut Hands) {
        let channel = self.channel();
        match self.below(16) {
            0..=2 => {
                let note = Note {
                    channel,
                    key: self.key(),
                    id: (self.below(2) == 0).then_some(self.id()),
                };
                hands.note_on(note, self.value(), self.value());
            }
            3..=4 => {
                hands.note_off(self.address(), self.value());
            }
            5..=8 => {
                let ccs = [
                    1, 2, 4, 6, 7, 11, 38, 64, 66, 67, 74, 98, 100, 101, 121, 255,
                ];
                let cc = self.one_of(&ccs);
                hands.controller(channel, cc, self.value());
            }
            9 => {
                let number = self.one_of(&[0, 6]);
                let value = self.one_of(&[0, 1, 7, 12, 14, 15, 48, 127]);
                for (cc, byte) in [(101, 0), (100, number), (6, value)] {
                    hands.controller(channel, cc, f64::from(byte) / 127.0);
                }
            }
            10 => hands.pitch_bend(channel, self.value()),
            11 => hands.channel_pressure(channel, self.value()),
            12 => {
                let kind = self.one_of(&[
                    Expression::Tuning,
                    Expression::Pressure,
                    Expression::Brightness,
                    Expression::Volume,
                    Expression::Pan,
                    Expression::Vibrato,
                    Expression::Expression,
                ]);
                hands.expression(kind, self.address(), 130.0 * self.value());
            }
            13 => {
                let what = self.one_of(&Modulated::ALL);
                hands.modulation(what, self.address(), self.value());
            }
            14 if self.below(10) == 0 => hands.set(&self.settings()),
            15 if self.below(100) == 0 => hands.reset(),
            _ => {}
        }
    }
}

fn assert_in_range(hands: &Hands, key: u8) {
    let within = |value: f64, least: f64, most: f64| {
        assert!((least..=most).contains(&value), "{value} of key {key}");
    };
    let now = hands.key(key);
    within(now.bend_semitones, -120.0, 120.0);
    within(now.level, 0.0, 16.0);
    within(now.pan, -1.0, 1.0);
    within(now.felt, 0.0, 4.0);
    within(now.hand_per_s, 0.0, 115.13);
    within(now.bow_pressure, -1.0, 1.0);
    within(now.bow_speed_octaves, -2.0, 2.0);
    within(now.damping_modulation, -1.0, 1.0);
    within(hands.dampers(key), 0.0, 1.0);
    let touch = hands.touch(key);
    within(touch.velocity, 0.0, 1.0);
    within(touch.position, -0.5, 0.5);
    within(touch.hardness_decades, -2.0, 2.0);
    within(touch.mass_octaves, -2.0, 2.0);
    within(touch.position_modulation, -1.0, 1.0);
    within(touch.hardness_modulation, -1.0, 1.0);
    let whole = hands.whole();
    within(whole.motor_speed_hz, -12.0, 12.0);
    within(whole.motor_depth, -1.0, 1.0);
    within(whole.distance_octaves, -2.0, 2.0);
}

/// Everything stays in its range, nothing allocates, and a key that has changed is said to have.
#[test]
fn a_storm_of_events_leaves_everything_in_range() {
    let mut random = Random(53);
    let mut hands = Hands::new();
    let mut known: [KeyHands; 128] = std::array::from_fn(|_| hands.key(0));
    let (mut moved, mut spared) = (0, 0);
    // Aborts on the first allocation.
    assert_no_alloc(|| {
        for _ in 0..EVENTS {
            random.play(&mut hands);
            let changed = hands.changed();
            for key in [0, 1, 59, 60, 61, 62, 126, 127] {
                assert_in_range(&hands, key);
                let (now, before) = (hands.key(key), &mut known[usize::from(key)]);
                if changed >> key & 1 == 1 {
                    moved += u32::from(now != *before);
                    *before = now;
                } else {
                    assert_eq!(now, *before, "key {key}");
                    spared += 1;
                }
            }
        }
    });
    println!("{moved} changes, {spared} times none");
    assert!(moved > 10_000 && spared > 10_000);
}

/// The same events have the same effect.
#[test]
fn nothing_but_events_matters() {
    let play = || {
        let (mut random, mut hands) = (Random(15), Hands::new());
        for _ in 0..1000 {
            random.play(&mut hands);
        }
        (0..128).map(|key| hands.key(key)).collect::<Vec<_>>()
    };
    assert_eq!(play(), play());
}
