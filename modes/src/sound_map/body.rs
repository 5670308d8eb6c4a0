//! The sound map of a bank's body: how strikes at chosen places of its grid sound.

use super::Hearing;
use crate::{Body, Motions};
use std::ops::Range;

/// Ratio of frequencies that nobody tells apart, less 1: 0.2 % about 1 kHz, and more elsewhere (Wier, Jesteadt
/// & Green 1977, Frequency discrimination as a function of frequency and sensation level, JASA 61).
const ONE_PITCH: f64 = 2e-3;
/// Motion below which a place is taken to be held, as a share of the greatest anywhere.
const HELD: f32 = 1e-4;
/// How far beside a held place a strike is taken to land, as a share of the grid.
const BESIDE: f64 = 1e-3;

/// The timbres of strikes at places of one body, and their distances from a strike anywhere on it.
///
/// Modes of one pitch are one tone, whose energy is theirs together: which of a pair of equal frequency a
/// strike excites is not heard.
#[derive(Clone, Debug)]
pub struct BodyMap {
    range_db: f32,
    tones: Vec<Tone>,
    motions: Motions,
    /// Energy Σ(φ·n)² of a strike of unit impulse where it is greatest.
    greatest: f32,
    places: usize,
    /// Levels above the least that is heard, in dB: of one tone after the other at every place.
    levels_db: Vec<f32>,
    unit: f32,
}

/// Modes of one pitch.
#[derive(Clone, Debug, PartialEq)]
struct Tone {
    modes: Range<usize>,
    /// S of their frequency.
    sensitivity: f32,
}

/// By rising frequency, those together that lie within [`ONE_PITCH`] of the lowest of them.
fn tones(hearing: &Hearing, hz: &[f64]) -> Vec<Tone> {
    let mut tones: Vec<Tone> = Vec::new();
    for (mode, now_hz) in hz.iter().enumerate() {
        match tones.last_mut() {
            Some(tone) if *now_hz < hz[tone.modes.start] * (1.0 + ONE_PITCH) => {
                tone.modes.end = mode + 1;
            }
            _ => tones.push(Tone {
                modes: mode..mode + 1,
                sensitivity: (hearing.sensitivity)(*now_hz) as f32,
            }),
        }
    }
    tones
}

impl BodyMap {
    /// The map of `body` at `places`, each along and across its strike grid, 0…1.
    ///
    /// # Panics
    ///
    /// If a row of the grid has fewer than [`Stencil::POINTS`](crate::Stencil::POINTS) points, or a mode has
    /// not one value for each point.
    #[must_use]
    pub fn new(hearing: &Hearing, body: &Body, places: &[[f64; 2]]) -> Self {
        let hz: Vec<f64> = body.modes.iter().map(|mode| mode.hz).collect();
        let mut map = Self {
            range_db: hearing.range_db as f32,
            tones: tones(hearing, &hz),
            motions: Motions::new(
                &body.line,
                body.modes.iter().map(|mode| mode.shape.clone()).collect(),
            ),
            greatest: 0.0,
            places: places.len(),
            levels_db: Vec::new(),
            unit: 0.0,
        };
        let grid = body.line.grid();
        let points = (0..body.line.len()).map(|i| map.strike(grid.place(i)).iter().sum());
        map.greatest = points.fold(0.0, f32::max);
        map.levels_db = vec![0.0; map.tones.len() * places.len()];
        for (number, place) in places.iter().enumerate() {
            for (tone, level_db) in map.timbre_db(*place).into_iter().enumerate() {
                map.levels_db[tone * places.len() + number] = level_db;
            }
        }
        let levels = map.levels_db.chunks_exact(places.len().max(1));
        let heard = |there: &[f32]| there.iter().any(|level_db| *level_db > 0.0);
        let sensitivities = (map.tones.iter().zip(levels))
            .filter(|(_, there)| heard(there))
            .map(|(tone, _)| tone.sensitivity);
        map.unit = sensitivities.sum::<f32>().sqrt();
        map
    }

    /// The sonic distance of 1998, §5 in dB from a strike at a place along and across to that at each of the
    /// map's places: d² = Σ S(fᵢ) (H(log Eᵢ¹/E₀) − H(log Eᵢ²/E₀))², with the logarithms in dB.
    #[must_use]
    pub fn from_place_db(&self, place: [f64; 2]) -> Vec<f32> {
        let mut distances_db = vec![0.0; self.places];
        if self.places == 0 {
            return distances_db;
        }
        let there = self.levels_db.chunks_exact(self.places);
        for ((tone, here_db), there_db) in self.tones.iter().zip(self.timbre_db(place)).zip(there) {
            for (square, level_db) in distances_db.iter_mut().zip(there_db) {
                let apart_db = level_db - here_db;
                *square += tone.sensitivity * apart_db * apart_db;
            }
        }
        for distance_db in &mut distances_db {
            *distance_db = distance_db.sqrt();
        }
        distances_db
    }

    /// The sonic distance between strikes at two places, in dB.
    #[must_use]
    pub fn distance_db(&self, one: [f64; 2], other: [f64; 2]) -> f32 {
        let [one, other] = [one, other].map(|place| self.timbre_db(place));
        let levels = one.iter().zip(&other);
        let squares = self.tones.iter().zip(levels).map(|(tone, (one, other))| {
            let apart_db = one - other;
            tone.sensitivity * apart_db * apart_db
        });
        squares.sum::<f32>().sqrt()
    }

    /// √ΣS over the tones that are heard at any place: the sonic distance between strikes of which each differs
    /// by 1 dB. A distance over it is by how many dB a tone differs, on a square average weighed by the ear.
    #[must_use]
    pub fn unit(&self) -> f32 {
        self.unit
    }

    /// Levels of the tones of a strike at a place, in dB above the least that is heard.
    ///
    /// Where an edge is held every mode vanishes, but a timbre is left of them: that beside it.
    fn timbre_db(&self, place: [f64; 2]) -> Vec<f32> {
        let mut strike = self.strike(place);
        if strike.iter().sum::<f32>() <= HELD * HELD * self.greatest {
            let [along, across] = place;
            let around = (0..9).map(|i| {
                let [aside, on] = [i % 3, i / 3].map(|step| BESIDE * (f64::from(step) - 1.0));
                self.strike([along + on, across + aside])
            });
            let loudness = |strike: &Vec<f32>| strike.iter().sum::<f32>();
            let loudest = around.max_by(|a, b| loudness(a).total_cmp(&loudness(b)));
            strike = loudest.unwrap_or(strike);
        }
        let whole: f32 = strike.iter().sum();
        for level in &mut strike {
            let share_db = 10.0 * (*level / whole).log10();
            // Of a body that does not move at all nothing is heard: NaN is no greater than 0.
            *level = (share_db + self.range_db).max(0.0);
        }
        strike
    }

    /// The energy of each tone of a strike of unit impulse.
    fn strike(&self, place: [f64; 2]) -> Vec<f32> {
        let mut motion = vec![0.0; self.motions.len()];
        let mut scratch = vec![0.0; self.motions.scratch_len()];
        self.motions.at(place, &mut scratch, &mut motion);
        let energy = |tone: &Tone| {
            let modes = &motion[tone.modes.clone()];
            modes.iter().map(|x| x * x).sum::<f64>() as f32
        };
        self.tones.iter().map(energy).collect()
    }
}
