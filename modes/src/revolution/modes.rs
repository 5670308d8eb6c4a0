//! The modes of a body of revolution: pairs, which a small imperfection splits.

use super::Wall;
use super::line::{half_waves, sampled, strike_line};
use super::patches::{around, rectified_area, surface};
use super::solved::{Found, SolvedWall};
use crate::solve::Band;
use crate::{Family, Material, Member, ModeLabel, SolveError, SolvedBody, SolvedMode};

/// A small mass on the outside of a body of revolution, where its strike line begins, which splits
/// its pairs of modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Imperfection {
    /// The mass, in kg.
    pub mass_kg: f64,
    /// Its angle from the strike line, in degrees.
    pub angle_deg: f64,
}

/// Samples of the strike line to each half-wave of the mode that has most of them.
const SAMPLES_TO_HALF_WAVE: usize = 5;

/// Fewest samples of the strike line.
const FEWEST_SAMPLES: usize = 33;

/// Solves `wall` for every mode of `band`.
///
/// # Errors
///
/// As [`SolvedWall::new`].
pub fn revolution_modes(
    wall: Wall,
    material: &Material,
    band: Band,
    imperfection: Option<Imperfection>,
) -> Result<SolvedBody, SolveError> {
    Ok(SolvedWall::new(wall, material, band)?.body(imperfection))
}

impl SolvedWall {
    /// The modes by name and by rising frequency, pairs split by `imperfection`.
    #[must_use]
    pub fn body(&self, imperfection: Option<Imperfection>) -> SolvedBody {
        let found = &self.found;
        let half_waves = found.iter().map(|f| half_waves(&f.line)).max().unwrap_or(1);
        let samples = (SAMPLES_TO_HALF_WAVE * half_waves + 1).max(FEWEST_SAMPLES);
        let mut modes: Vec<SolvedMode> = found
            .iter()
            .enumerate()
            .flat_map(|(i, f)| members(&self.wall, f, index(&found[..=i]), samples, imperfection))
            .collect();
        modes.sort_by(|p, q| p.hz.total_cmp(&q.hz));
        SolvedBody {
            length_m: self.wall.length_m,
            mass_kg: self.mass_kg,
            line: strike_line(&self.wall, samples),
            surface: surface(&self.wall),
            modes,
            orthonormality: self.orthonormality,
        }
    }

    /// The mass in kg that makes the lowest pair beat at `beat_hz`.
    ///
    /// # Errors
    ///
    /// The greatest beat, in Hz, that a mass small beside what it moves can make; 0 without a pair.
    pub fn mass_for_beat_kg(&self, beat_hz: f64) -> Result<f64, f64> {
        /// Greatest share of a mode's mass that leaves its shape nearly as it is.
        const SMALL: f64 = 0.1;
        let pair = self.found.iter().find(|f| f.order > 0).ok_or(0.0)?;
        let moved = moved(pair);
        let beat = |mass_kg: f64| {
            let [a, b] = moved.map(|moved| loaded_hz(pair.hz, mass_kg, moved));
            (a - b).abs()
        };
        let greatest_kg = SMALL / moved[0].max(moved[1]);
        let greatest_hz = beat(greatest_kg);
        if beat_hz > greatest_hz {
            return Err(greatest_hz);
        }
        // Nearly proportional to the mass: each round adds a digit at least.
        let mut mass_kg = greatest_kg * beat_hz / greatest_hz;
        while beat_hz > 0.0 && (beat(mass_kg) / beat_hz - 1.0).abs() > 1e-12 {
            mass_kg *= beat_hz / beat(mass_kg);
        }
        Ok(mass_kg)
    }
}

/// |φ|² in 1/kg where the imperfection sits, of each member of a pair: A has the crest of U and W
/// there, B its node.
fn moved(found: &Found) -> [f64; 2] {
    let [u, v, w] = found.line[0];
    [u * u + w * w, v * v]
}

/// Frequency in Hz of a mode that moves `mass_kg` by |φ|² = `moved`: λ/(1 + δm |φ|²), first order in
/// δm (Rayleigh 1894, §90).
fn loaded_hz(hz: f64, mass_kg: f64, moved: f64) -> f64 {
    hz / (1.0 + mass_kg * moved).sqrt()
}

/// Which of its family and order the last of `found` is, from 1.
fn index(found: &[Found]) -> usize {
    let last = &found[found.len() - 1];
    found
        .iter()
        .filter(|f| f.family == last.family && f.order == last.order)
        .count()
}

/// The one mode of a solution without waves around the axis, or the pair that one with them is.
///
/// Of a pair, A has the crest of U and W at the imperfection's angle (or at the strike line, θ = 0)
/// and B its node.
fn members(
    wall: &Wall,
    found: &Found,
    index: usize,
    samples: usize,
    imperfection: Option<Imperfection>,
) -> Vec<SolvedMode> {
    let order = found.order as f64;
    let (mass_kg, angle) =
        imperfection.map_or((0.0, 0.0), |i| (i.mass_kg, i.angle_deg.to_radians()));
    let line = sampled(wall, &found.line, samples);
    let member = |member: Member, turn: f64, moved: f64| {
        // Amplitudes of cos m(θ − turn) and sin m(θ − turn) at the strike line.
        let (sin, cos) = (-order * turn).sin_cos();
        let keep = match (found.family, found.order) {
            (Family::Torsion, _) => [0.0, 1.0, 0.0],
            (_, 0) => [1.0, 0.0, 1.0],
            _ => [cos, sin, cos],
        };
        SolvedMode {
            hz: loaded_hz(found.hz, mass_kg, moved),
            residual: found.residual,
            label: ModeLabel {
                family: found.family,
                order: u16::try_from(found.order).unwrap_or(u16::MAX),
                index: u16::try_from(index).unwrap_or(u16::MAX),
                member,
            },
            shape: line
                .iter()
                .map(|u| {
                    [0, 1, 2]
                        .map(|a| exact(keep[a]) * u[a])
                        .map(|x| x as f32 + 0.0)
                })
                .collect(),
            motion: around(&found.sides, order, turn),
            rectified_area: rectified_area(wall, &found.sides, found.order),
            held: found.held,
            felt: found.felt,
            radiation_per_s: found.radiation_per_s,
        }
    };
    if found.order == 0 {
        let [crest, node] = moved(found);
        return vec![member(Member::Single, 0.0, crest + node)];
    }
    let quarter = std::f64::consts::FRAC_PI_2 / order;
    let [crest, node] = moved(found);
    vec![
        member(Member::A, angle, crest),
        member(Member::B, angle + quarter, node),
    ]
}

/// A factor that is 0 but for rounding is 0.
fn exact(factor: f64) -> f64 {
    if factor.abs() < 1e-12 { 0.0 } else { factor }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TABLE_1;
    use crate::revolution::{Bell, LAYERS, bowl};
    use crate::shape::{Bowl, Tube};

    fn chime() -> SolvedBody {
        let bell = Bell::open(Tube::D5);
        let material = &TABLE_1[0].material;
        revolution_modes(bell.wall(0.02, LAYERS), material, Band::AUDIBLE, None)
            .expect("a chime is solved")
    }

    #[test]
    fn shapes_on_the_line_are_those_of_a_beam_and_mirror() {
        let body = chime();
        let first = &body.modes[0];
        assert_eq!(first.label.to_string(), "bending 1 a");
        let last = body.line.len() - 1;
        assert_eq!(first.shape[0][0], first.shape[last][0]);
        // Mass-normalised, a thin free beam moves 2/√m at its ends (Blevins 1979, table 8-1).
        let expected = 2.0 / body.mass_kg.sqrt();
        let end = f64::from(first.shape[0][0].abs());
        assert!((end / expected - 1.0).abs() < 0.02, "{end} {expected}");
        assert!((body.mass_kg / (Tube::D5.volume_m3() * 2700.0) - 1.0).abs() < 1e-9);
        // Held near its node it moves little there, beside the next mode.
        assert!(first.held < 0.1 * body.modes[2].held);
    }

    #[test]
    fn partners_share_a_frequency_until_a_mass_splits_them() {
        let body = chime();
        for pair in body.modes.windows(2) {
            if pair[0].label.member == Member::A {
                assert_eq!(pair[1].label.member, Member::B);
                assert_eq!(pair[0].hz, pair[1].hz);
                assert!(pair[0].shape.iter().all(|u| u[1] == 0.0));
                assert!(pair[1].shape.iter().all(|u| u[0] == 0.0 && u[2] == 0.0));
            }
        }
        let bell = Bell::open(Tube::D5);
        let mass_kg = 1e-4;
        let imperfection = Some(Imperfection {
            mass_kg,
            angle_deg: 30.0,
        });
        let material = &TABLE_1[0].material;
        let split = revolution_modes(
            bell.wall(0.02, LAYERS),
            material,
            Band::AUDIBLE,
            imperfection,
        )
        .unwrap();
        // δf/f = −½ δm φ² with φ² = 4/m at the end of a beam.
        let expected = 0.5 * mass_kg * 4.0 / body.mass_kg;
        let shift = 1.0 - split.modes[0].hz / body.modes[0].hz;
        assert!((shift / expected - 1.0).abs() < 0.05, "{shift} {expected}");
        let of = |member| {
            let found = split
                .modes
                .iter()
                .find(|m| m.label.order == 1 && m.label.member == member);
            found.unwrap().shape[0][0] / body.modes[0].shape[0][0]
        };
        assert!((of(Member::A) - 0.75f32.sqrt()).abs() < 1e-3);
        assert!((of(Member::B).abs() - 0.5).abs() < 1e-3);
    }

    #[test]
    fn a_mass_is_found_for_a_beat() {
        let shape = Bowl {
            rim_radius_m: 0.09,
            base_radius_m: 0.045,
            height_m: 0.06,
            squareness: 2.0,
            base_wall_m: 0.002,
            rim_wall_m: 0.004,
        };
        let wall = bowl(&shape, 0.01, LAYERS).unwrap();
        let band = Band {
            high_hz: 2000.0,
            ..Band::AUDIBLE
        };
        let solved = SolvedWall::new(wall, &TABLE_1[0].material, band).unwrap();
        let mass_kg = solved.mass_for_beat_kg(1.5).unwrap();
        let imperfection = Imperfection {
            mass_kg,
            angle_deg: 0.0,
        };
        let modes = solved.body(Some(imperfection)).modes;
        let beat_hz = modes[1].hz - modes[0].hz;
        assert!((beat_hz / 1.5 - 1.0).abs() < 1e-9, "{beat_hz}");
        let greatest_hz = solved.mass_for_beat_kg(2000.0).unwrap_err();
        assert!(greatest_hz > 1.5 && greatest_hz < 50.0, "{greatest_hz}");
        assert_eq!(solved.mass_for_beat_kg(0.0), Ok(0.0));
    }
}
