//! Tables 1 and 2 of O'Brien, Shen and Gatchalian 2002, as printed.

use crate::{Material, Rayleigh};
use std::ops::RangeInclusive;

/// A row of Table 1: an example's material and its primary mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table1Row {
    /// The example's name in the paper.
    pub example: &'static str,
    /// Its name among [`crate::NAMED_MATERIALS`].
    pub material_name: &'static str,
    /// λ, μ and ρ.
    pub material: Material,
    /// α1 and α2.
    pub rayleigh: Rayleigh,
    /// Frequency of the primary mode, in Hz.
    pub base_hz: f64,
    /// Printed decay rate of the primary mode, in 1/s: Eq. 9, (α1 λ + α2)/2.
    pub decay_per_s: f64,
    /// How far the printed decay rate can be trusted.
    pub print: Print,
}

/// How a printed decay rate of Table 1 relates to Eq. 9 and its own row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Print {
    /// Eq. 9, rounded or cut to the one printed decimal.
    RoundedOrCut,
    /// Eq. 9 to within this fraction.
    Within(f64),
    /// Contradicts the row's own parameters, in this way.
    Misprint(&'static str),
}

impl Table1Row {
    /// Decay rate in 1/s of the primary mode by Eq. 9.
    #[must_use]
    pub fn computed_decay_per_s(&self) -> f64 {
        self.rayleigh.decay_per_s(self.base_hz)
    }

    /// Whether the printed decay rate is meant to agree with Eq. 9.
    #[must_use]
    pub fn self_consistent(&self) -> bool {
        !matches!(self.print, Print::Misprint(_))
    }

    /// Decay rates in 1/s that would print as this row does: half a unit of the last printed
    /// digit below, a whole unit above (half if rounded, a whole if cut).
    #[must_use]
    pub fn allowed_decay_per_s(&self) -> RangeInclusive<f64> {
        const LAST_DIGIT: f64 = 0.1;
        let (below, above) = match self.print {
            Print::Within(fraction) => (fraction * self.decay_per_s, fraction * self.decay_per_s),
            Print::RoundedOrCut | Print::Misprint(_) => (0.5 * LAST_DIGIT, LAST_DIGIT),
        };
        self.decay_per_s - below..=self.decay_per_s + above
    }
}

const ALUMINIUM: Material = lame(4.98e10, 2.57e10, 2700.0);
const ALUMINIUM_SHELF: Material = lame(4.98e10, 2.56e10, 2700.0);
const OAK: Material = lame(5.00e8, 1.00e8, 750.0);
const LIGHT_WOOD: Material = lame(5.00e8, 1.00e8, 550.0);
const METAL_DAMPING: Rayleigh = rayleigh(1e-7, 0.0);
const WOOD_DAMPING: Rayleigh = rayleigh(8e-6, 50.0);

/// Table 1. Three decay rates are misprints; the other eight follow Eq. 9.
pub const TABLE_1: [Table1Row; 11] = [
    Table1Row {
        example: "Chime (D3)",
        material_name: "O'Brien 2002 aluminium",
        material: ALUMINIUM,
        rayleigh: METAL_DAMPING,
        base_hz: 587.4,
        decay_per_s: 0.6,
        print: Print::RoundedOrCut,
    },
    Table1Row {
        example: "Bowl #1",
        material_name: "O'Brien 2002 bowl 1",
        material: lame(4.98e9, 2.57e9, 2700.0),
        rayleigh: rayleigh(1e-7, 30.0),
        base_hz: 551.3,
        decay_per_s: 15.6,
        print: Print::RoundedOrCut,
    },
    Table1Row {
        example: "Bowl #2",
        material_name: "O'Brien 2002 bowl 2",
        material: OAK,
        rayleigh: WOOD_DAMPING,
        base_hz: 216.7,
        decay_per_s: 22.4,
        print: Print::Misprint("Eq. 9 gives 32.4"),
    },
    Table1Row {
        example: "Bunny (Ceramic)",
        material_name: "O'Brien 2002 ceramic",
        material: lame(3.99e9, 2.05e9, 2700.0),
        rayleigh: rayleigh(1e-6, 10.0),
        base_hz: 855.9,
        decay_per_s: 19.5,
        print: Print::RoundedOrCut,
    },
    Table1Row {
        example: "Plastic Shelf",
        material_name: "O'Brien 2002 plastic shelf",
        material: lame(2.49e10, 1.28e10, 2700.0),
        rayleigh: rayleigh(1e-6, 50.0),
        base_hz: 488.9,
        decay_per_s: 29.7,
        print: Print::RoundedOrCut,
    },
    Table1Row {
        example: "Aluminum Shelf",
        material_name: "O'Brien 2002 aluminium shelf",
        material: ALUMINIUM_SHELF,
        rayleigh: METAL_DAMPING,
        base_hz: 691.5,
        decay_per_s: 0.9,
        print: Print::RoundedOrCut,
    },
    Table1Row {
        example: "Wood Shelf",
        material_name: "O'Brien 2002 wood shelf",
        material: OAK,
        rayleigh: WOOD_DAMPING,
        base_hz: 154.6,
        decay_per_s: 28.8,
        print: Print::RoundedOrCut,
    },
    Table1Row {
        example: "Bunny (Metal)",
        material_name: "O'Brien 2002 metal bunny",
        material: lame(4.99e10, 2.56e10, 2700.0),
        rayleigh: METAL_DAMPING,
        base_hz: 855.9,
        decay_per_s: 19.5,
        print: Print::Misprint(
            "the frequency and decay of the ceramic bunny's row; Eq. 9 gives 1.4",
        ),
    },
    Table1Row {
        example: "Blocks",
        material_name: "O'Brien 2002 blocks",
        material: LIGHT_WOOD,
        rayleigh: WOOD_DAMPING,
        base_hz: 1596.2,
        decay_per_s: 428.1,
        print: Print::Within(0.002),
    },
    Table1Row {
        example: "Boxes",
        material_name: "O'Brien 2002 boxes",
        material: LIGHT_WOOD,
        rayleigh: WOOD_DAMPING,
        base_hz: 159.1,
        decay_per_s: 49.0,
        print: Print::Misprint("Eq. 9 gives 29.0"),
    },
    Table1Row {
        example: "The End (T)",
        material_name: "O'Brien 2002 the end",
        material: lame(1.49e9, 7.70e8, 2700.0),
        rayleigh: rayleigh(2e-7, 30.0),
        base_hz: 247.7,
        decay_per_s: 15.2,
        print: Print::RoundedOrCut,
    },
];

/// A row of Table 2: a real wind chime, and the paper's model of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table2Row {
    /// Note as the paper names it, an octave or two below MIDI's name.
    pub note: &'static str,
    /// The maker's frequency, in Hz.
    pub ideal_hz: f64,
    /// Length of the real tube, in m.
    pub measured_length_m: f64,
    /// Frequency of the real tube, in Hz.
    pub measured_hz: f64,
    /// Frequency that the paper's model gives for that length, in Hz.
    pub computed_hz: f64,
    /// Length that the paper's model is tuned to, in m.
    pub adjusted_length_m: f64,
    /// Frequency that the paper's model then gives, in Hz.
    pub adjusted_hz: f64,
}

/// Table 2: tubes of 12.5 mm outer radius and 1 mm wall, of Table 1's first material.
pub const TABLE_2: [Table2Row; 6] = [
    chime("D3", 587.33, (0.505, 585.8), 589.17, (0.5061, 587.40)),
    chime("E3", 659.26, (0.475, 656.0), 665.03, (0.4770, 659.27)),
    chime("G3", 783.99, (0.435, 781.8), 787.01, (0.4366, 784.06)),
    chime("A4", 880.00, (0.410, 877.5), 884.70, (0.4115, 879.36)),
    chime("B4", 987.77, (0.388, 982.5), 984.75, (0.3878, 987.32)),
    chime("D4", 1174.66, (0.353, 1167.0), 1186.88, (0.3548, 1174.67)),
];

const fn chime(
    note: &'static str,
    ideal_hz: f64,
    (measured_length_m, measured_hz): (f64, f64),
    computed_hz: f64,
    (adjusted_length_m, adjusted_hz): (f64, f64),
) -> Table2Row {
    Table2Row {
        note,
        ideal_hz,
        measured_length_m,
        measured_hz,
        computed_hz,
        adjusted_length_m,
        adjusted_hz,
    }
}

const fn lame(lambda_pa: f64, mu_pa: f64, density_kg_m3: f64) -> Material {
    Material {
        lambda_pa,
        mu_pa,
        density_kg_m3,
    }
}

const fn rayleigh(alpha1_s: f64, alpha2_per_s: f64) -> Rayleigh {
    Rayleigh {
        alpha1_s,
        alpha2_per_s,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eq_9_gives_the_eight_consistent_decays_and_not_the_three_misprints() {
        for row in &TABLE_1 {
            let computed = row.computed_decay_per_s();
            assert_eq!(
                row.allowed_decay_per_s().contains(&computed),
                row.self_consistent(),
                "{}: {computed}",
                row.example
            );
        }
        let consistent = TABLE_1.iter().filter(|row| row.self_consistent()).count();
        assert_eq!(consistent, 8);
    }

    #[test]
    fn the_misprints_are_off_as_stated() {
        let computed = |example| {
            let row = TABLE_1.iter().find(|row| row.example == example).unwrap();
            (row.computed_decay_per_s() * 10.0).round() / 10.0
        };
        assert_eq!(computed("Bowl #2"), 32.4);
        assert_eq!(computed("Boxes"), 29.0);
        assert_eq!(computed("Bunny (Metal)"), 1.4);
    }

    #[test]
    fn every_material_is_possible() {
        assert!(TABLE_1.iter().all(|row| row.material.check().is_ok()));
    }

    /// "within 2% error" measured, "within ±1 Hz" adjusted (O'Brien 2002, §4).
    #[test]
    fn table_2_keeps_the_papers_own_claims() {
        for row in &TABLE_2 {
            assert!((row.computed_hz / row.measured_hz - 1.0).abs() < 0.02);
            assert!((row.adjusted_hz - row.ideal_hz).abs() < 1.0);
        }
    }
}
