//! Which body a key strikes, and how far that is bent.

use crate::tuning::MtsClient;
use modes::equal_temperament_hz;
use modes::tuning::{Tuning, nearest_body};

/// Farthest that a key's own body is retuned, in semitones: beyond, its partials are no longer those of
/// such an instrument, and another body is nearer.
const FARTHEST: f64 = 12.0 + 1e-9;

/// Farthest that another body is retuned for a key that has none, in semitones: what lies outside the
/// instrument's range is silent.
const NEAR: f64 = 0.5 + 1e-9;

/// Pitch of key 69 as bodies are built, in Hz.
const A4_HZ: f64 = 440.0;

/// A key's body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// The key that the body was built for.
    pub(crate) body: u8,
    /// How far it is retuned.
    pub(crate) semitones: f64,
    hz: f64,
}

/// How keys are tuned, and which body each has struck.
///
/// A key strikes its own body, retuned; one that is tuned more than an octave away from it, or that has
/// none, the nearest. A body follows the key that struck it last.
pub(crate) struct Tuner {
    table: Tuning,
    master: Option<MtsClient>,
    places: [Option<Place>; 128],
    owners: [Option<u8>; 128],
    /// Whether a master tuned when last looked.
    led: bool,
    /// Whether the table has changed since.
    fresh: bool,
}

impl Tuner {
    /// Nothing is struck yet; a master tunes, or else the table.
    pub(crate) fn new(table: Tuning, master: Option<MtsClient>) -> Self {
        Self {
            table,
            master,
            places: [None; 128],
            owners: [None; 128],
            led: false,
            fresh: false,
        }
    }

    /// Forgets what was struck.
    pub(crate) fn reset(&mut self) {
        self.places = [None; 128];
        self.owners = [None; 128];
    }

    /// Another table; [`Tuner::follow`] tells what moves.
    pub(crate) fn set(&mut self, table: Tuning) {
        self.table = table;
        self.fresh = true;
    }

    /// Whether tunings may change at any time.
    pub(crate) fn may_change(&self) -> bool {
        self.master.is_some()
    }

    /// Gives a key that is struck on a channel one of the `bodies` whose bits are set; none if the key is
    /// silent.
    pub(crate) fn strike(&mut self, key: u8, channel: u8, bodies: u128) -> Option<u8> {
        let silenced = |master: &MtsClient| master.silences(key, Some(channel));
        if self.master.as_ref().is_some_and(silenced) {
            return None;
        }
        let place = place(key, self.hz(key)?, bodies)?;
        self.places[usize::from(key)] = Some(place);
        self.owners[usize::from(place.body)] = Some(key);
        Some(place.body)
    }

    /// The body that a key has struck, unless another has struck it since.
    pub(crate) fn place(&self, key: u8) -> Option<Place> {
        let place = *self.places.get(usize::from(key))?;
        place.filter(|place| self.owner(place.body) == Some(key))
    }

    /// The key that struck a body last.
    pub(crate) fn owner(&self, body: u8) -> Option<u8> {
        self.owners.get(usize::from(body)).copied().flatten()
    }

    /// Retunes what was struck; the keys that this moves, as bits. A key that falls silent stays where it
    /// is until it is struck again.
    pub(crate) fn follow(&mut self) -> u128 {
        let leads = self.master.as_ref().is_some_and(MtsClient::has_master);
        let led = std::mem::replace(&mut self.led, leads);
        if !(std::mem::take(&mut self.fresh) || led || leads) {
            return 0;
        }
        let mut moved = 0;
        for key in 0..128_u8 {
            let Some(place) = self.places[usize::from(key)] else {
                continue;
            };
            if let Some(hz) = self.hz(key)
                && hz != place.hz
            {
                let semitones = semitones(hz, place.body);
                self.places[usize::from(key)] = Some(Place {
                    semitones,
                    hz,
                    ..place
                });
                moved |= 1 << key;
            }
        }
        moved
    }

    fn hz(&self, key: u8) -> Option<f64> {
        match &self.master {
            Some(master) if master.has_master() => {
                // A key that the master has no pitch for keeps its own.
                let own = || equal_temperament_hz(key, A4_HZ);
                Some(master.tuning(key).unwrap_or_else(own))
            }
            _ => self.table.hz(key),
        }
    }
}

fn semitones(hz: f64, body: u8) -> f64 {
    12.0 * (hz / equal_temperament_hz(body, A4_HZ)).log2()
}

/// Where a key of that pitch finds its body.
fn place(key: u8, hz: f64, bodies: u128) -> Option<Place> {
    let has_own = bodies.checked_shr(key.into()).unwrap_or(0) & 1 == 1;
    let own = semitones(hz, key);
    if has_own && own.abs() <= FARTHEST {
        return Some(Place {
            body: key,
            semitones: own,
            hz,
        });
    }
    let (body, semitones) = nearest_body(hz, bodies)?;
    (has_own || semitones.abs() <= NEAR).then_some(Place {
        body,
        semitones,
        hz,
    })
}

#[cfg(test)]
#[path = "../tests/mts/fake.rs"]
mod fake;

#[cfg(test)]
mod tests {
    use super::fake::{Fake, build};
    use super::*;
    use modes::tuning::{KeyboardMap, Scale};

    const CHIMES: u128 = ((1 << 61) - 1) << 36;

    fn tuner(scale: &str, map: &str) -> Tuner {
        let scale = Scale::parse(scale.as_bytes()).unwrap();
        let map = match map {
            "" => KeyboardMap::default(),
            map => KeyboardMap::parse(map.as_bytes()).unwrap(),
        };
        Tuner::new(Tuning::new(&scale, &map), None)
    }

    #[test]
    fn in_equal_temperament_each_key_has_its_own_body_untouched() {
        let mut tuner = Tuner::new(Tuning::default(), None);
        for key in 0..128 {
            let body = tuner.strike(key, 0, CHIMES);
            let there = (36..=96).contains(&key);
            assert_eq!(body, there.then_some(key));
            assert_eq!(
                tuner.place(key).map(|place| place.semitones),
                body.map(|_| 0.0)
            );
        }
        assert_eq!(tuner.follow(), 0);
    }

    #[test]
    fn keys_keep_their_bodies_within_an_octave() {
        // Quarter tones around key 69.
        let mut tuner = tuner("\n1\n50.0", "");
        for (key, body, semitones) in [
            (69, 69, 0.0),
            (70, 70, -0.5),
            (93, 93, -12.0),
            (95, 82, 0.0),
            (97, 83, 0.0),
            (45, 45, 12.0),
            (37, 53, 0.0),
            (35, 52, 0.0),
        ] {
            assert_eq!(tuner.strike(key, 0, CHIMES), Some(body), "{key}");
            let place = tuner.place(key).unwrap();
            assert!(
                (place.semitones - semitones).abs() < 1e-9,
                "{key}: {place:?}"
            );
        }
    }

    #[test]
    fn what_is_unmapped_or_out_of_range_is_silent() {
        let mut tuner = tuner("\n2\n3/2\n2/1", "2\n0\n69\n60\n60\n261.6\n2\n0\nx\n");
        assert_eq!(tuner.strike(60, 0, CHIMES), Some(60));
        assert_eq!(tuner.strike(61, 0, CHIMES), None);
        assert_eq!(tuner.strike(70, 0, CHIMES), None);
        assert_eq!(tuner.place(61), None);
        let mut plain = Tuner::new(Tuning::default(), None);
        assert_eq!(plain.strike(35, 0, CHIMES), None);
    }

    #[test]
    fn a_body_follows_its_last_key() {
        let mut tuner = tuner("\n1\n50.0", "");
        tuner.strike(82, 0, CHIMES);
        assert_eq!(tuner.owner(82), Some(82));
        tuner.strike(95, 0, CHIMES);
        assert_eq!(tuner.owner(82), Some(95));
        assert_eq!(tuner.place(82), None);
        assert_eq!(tuner.place(95).map(|place| place.body), Some(82));
        tuner.set(Tuning::default());
        assert_eq!(tuner.follow(), 1 << 82 | 1 << 95);
        assert!((tuner.place(95).unwrap().semitones - 13.0).abs() < 1e-9);
        tuner.reset();
        assert_eq!(tuner.owner(82), None);
    }

    #[test]
    fn a_master_goes_before_the_table_and_what_rings_follows_it() {
        let Some(library) = build("tuner", &[]) else {
            return;
        };
        let master = Fake::of(&library);
        master.name(None);
        let mut tuner = Tuner::new(Tuning::default(), MtsClient::open(&library).ok());
        assert!(tuner.may_change() && master.clients() == 1);
        assert_eq!(tuner.strike(60, 0, CHIMES), Some(60));
        assert_eq!(tuner.follow(), 0, "no master");
        for key in 0..128 {
            // A quarter tone up.
            let hz = equal_temperament_hz(key, A4_HZ) * (1.0f64 / 24.0).exp2();
            master.tune(key, hz);
        }
        master.master(true);
        assert_eq!(tuner.follow(), 1 << 60);
        assert_eq!(tuner.follow(), 0, "it keeps still");
        assert!((tuner.place(60).unwrap().semitones - 0.5).abs() < 1e-12);
        assert_eq!(tuner.strike(61, 0, CHIMES), None, "silenced by the master");
        assert_eq!(tuner.strike(64, 0, CHIMES), Some(64));
        master.master(false);
        assert_eq!(tuner.follow(), 1 << 60 | 1 << 64);
        assert_eq!(tuner.place(64).map(|place| place.semitones), Some(0.0));
        drop(tuner);
        assert_eq!(master.clients(), 0);
    }
}
