//! The sonic distance of two strikes on one body.

/// What an ear makes of the energy in each mode.
#[derive(Clone, Copy, Debug)]
pub struct Hearing {
    /// Sensitivity S of the ear to a frequency in Hz, 0…1.
    pub sensitivity: fn(f64) -> f64,
    /// How far below the energy of the whole strike a mode is still heard, in dB: the paper's E₀.
    pub range_db: f64,
}

/// How a strike sounds, whatever its force: each mode's energy, in dB above the least that is heard.
#[derive(Clone, Debug, PartialEq)]
pub struct Timbre {
    levels_db: Vec<f64>,
}

/// Gain of the A filter without its constant of 2 dB, which leaves it below 1 at all frequencies (IEC
/// 61672-1, annex E).
#[must_use]
pub fn a_weighting(hz: f64) -> f64 {
    const POLES_HZ: [f64; 4] = [20.6, 107.7, 737.9, 12_194.0];
    let f2 = hz * hz;
    let [low, second, third, high] = POLES_HZ.map(|pole_hz| pole_hz * pole_hz);
    high * f2 * f2 / ((f2 + low) * ((f2 + second) * (f2 + third)).sqrt() * (f2 + high))
}

impl Hearing {
    /// Ears weighted by A that hear a mode 60 dB below the whole.
    pub const HUMAN: Self = Self {
        sensitivity: a_weighting,
        range_db: 60.0,
    };

    /// The timbre of a strike where the modes' displacements along it are `motions`.
    ///
    /// The energies Eᵢ = (aᵢ fᵢ)² of 1998, Eq. 11, go as Ψᵢ² and are those of a strike of a given
    /// energy: their sum is the same wherever the body is struck.
    #[must_use]
    pub fn timbre(&self, motions: impl Iterator<Item = f64>) -> Timbre {
        let mut levels_db: Vec<f64> = motions.map(|motion| motion * motion).collect();
        let whole: f64 = levels_db.iter().sum();
        for level in &mut levels_db {
            let share_db = 10.0 * (*level / whole).log10();
            // At a point where nothing moves nothing is heard: NaN is no greater than 0.
            *level = (share_db + self.range_db).max(0.0);
        }
        Timbre { levels_db }
    }

    /// The sonic distance in dB between two strikes on a body with modes of `hz`:
    /// d² = Σ S(fᵢ) (H(log Eᵢ¹/E₀) − H(log Eᵢ²/E₀))², with the logarithms in dB.
    #[must_use]
    pub fn distance_db(&self, hz: &[f64], one: &Timbre, other: &Timbre) -> f64 {
        let levels = one.levels_db.iter().zip(&other.levels_db);
        let square: f64 = hz
            .iter()
            .zip(levels)
            .map(|(hz, (one, other))| (self.sensitivity)(*hz) * (one - other).powi(2))
            .sum();
        square.sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EVEN: Hearing = Hearing {
        sensitivity: |_| 1.0,
        range_db: 60.0,
    };

    fn distance_db(hearing: &Hearing, one: [f64; 2], other: [f64; 2]) -> f64 {
        let [one, other] = [one, other].map(|motions| hearing.timbre(motions.into_iter()));
        hearing.distance_db(&[100.0, 1000.0], &one, &other)
    }

    /// All in one mode against half in each: −3 dB of the one, and of the other what is left of the
    /// range.
    #[test]
    fn two_modes_by_hand() {
        let half_db = 10.0 * 2f64.log10();
        let expected = half_db.hypot(60.0 - half_db);
        assert!((distance_db(&EVEN, [2.0, 0.0], [0.3, -0.3]) - expected).abs() < 1e-12);
    }

    #[test]
    fn force_and_sign_are_no_timbre() {
        assert!(distance_db(&EVEN, [1.0, 0.5], [-4.0, 2.0]) < 1e-12);
    }

    #[test]
    fn what_is_out_of_range_is_not_heard() {
        // −80 and −100 dB.
        assert!(distance_db(&EVEN, [1.0, 1e-4], [1.0, 1e-5]) < 1e-6);
        assert!(distance_db(&EVEN, [0.0, 0.0], [0.0, 0.0]) == 0.0);
    }

    #[test]
    fn the_ear_weighs() {
        let deaf_above = Hearing {
            sensitivity: |hz| if hz < 500.0 { 1.0 } else { 0.0 },
            ..EVEN
        };
        let half_db = 10.0 * 2f64.log10();
        let found = distance_db(&deaf_above, [1.0, 0.0], [1.0, 1.0]);
        assert!((found - half_db).abs() < 1e-12);
    }

    /// IEC 61672-1, table 3: −19.1 dB at 100 Hz, 0 at 1 kHz, +1.2 at 2 kHz, −1.1 at 8 kHz.
    #[test]
    fn a_weighting_is_the_standard_s() {
        for (hz, db) in [(100.0, -19.1), (1000.0, 0.0), (1995.3, 1.2), (7943.3, -1.1)] {
            let gain_db = 20.0 * a_weighting(hz).log10() + 2.0;
            assert!((gain_db - db).abs() < 0.06, "{hz} {gain_db}");
            assert!(a_weighting(hz) < 1.0);
        }
    }
}
