//! Materials by name: those of O'Brien 2002 and those of real instruments.

use crate::{Material, Rayleigh, TABLE_1};
use thiserror::Error;

/// A material with a name, a damping to start with, and where both come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedMaterial {
    /// Name, found without regard to case.
    pub name: &'static str,
    /// λ, μ and ρ.
    pub material: Material,
    /// Damping to start with.
    pub damping: Rayleigh,
    /// Where λ, μ and ρ come from.
    pub source: &'static str,
    /// Where the damping comes from, and how good it is.
    pub damping_source: &'static str,
}

/// A name that no material bears.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "unknown material \"{name}\": did you mean \"{nearest}\"? Known are {}",
    known_names()
)]
pub struct UnknownMaterial {
    /// The name asked for.
    pub name: String,
    /// The known name nearest to it.
    pub nearest: &'static str,
}

impl Material {
    /// The material of that name among [`NAMED_MATERIALS`].
    ///
    /// # Errors
    ///
    /// If there is none; the message lists the names.
    pub fn named(name: &str) -> Result<Self, UnknownMaterial> {
        NamedMaterial::find(name).map(|found| found.material)
    }
}

impl NamedMaterial {
    /// The entry of that name in [`NAMED_MATERIALS`].
    ///
    /// # Errors
    ///
    /// If there is none; the message lists the names.
    pub fn find(name: &str) -> Result<&'static Self, UnknownMaterial> {
        let wanted = name.trim().to_lowercase();
        NAMED_MATERIALS
            .iter()
            .find(|entry| entry.name.to_lowercase() == wanted)
            .ok_or_else(|| UnknownMaterial {
                name: name.to_owned(),
                nearest: nearest_name(&wanted),
            })
    }
}

const REAL: [NamedMaterial; 7] = [
    NamedMaterial {
        name: "aluminium",
        material: Material::lame_of(68.9e9, 0.33, 2700.0),
        damping: Rayleigh {
            alpha1_s: 1e-7,
            alpha2_per_s: 0.0,
        },
        source: "alloy 6061-T6: 10,000 ksi = 68.9 GPa, ν 0.33, 2.70 g/cm³ (Aluminum Association)",
        damping_source: "the chimes of O'Brien 2002, Table 1",
    },
    NamedMaterial {
        name: "brass",
        material: Material::lame_of(110e9, 0.34, 8530.0),
        damping: loss_factor(1e-3),
        source: "cartridge brass UNS C26000: 16,000 ksi = 110 GPa, 0.308 lb/in³ = 8530 kg/m³ \
                 (Copper Development Association), ν 0.34 (AZoM datasheet 6341)",
        damping_source: "guess: the upper bound of the loss factor, 1e-3 (Cremer & Heckl, \
                         Structure-Borne Sound, 1988), met at 200 Hz and 2 kHz",
    },
    NamedMaterial {
        name: "bell bronze",
        material: Material::lame_of(110e9, 0.34, 8800.0),
        damping: loss_factor(1.0 / 2200.0),
        source: "UNS C91300, 19 % tin: 16,000 ksi = 110 GPa, 0.318 lb/in³ = 8800 kg/m³ \
                 (Copper Development Association), ν 0.34 of bronzes in general",
        damping_source: "guess: the quality factor 2200 that Csound's catalogue gives singing \
                         bowls, met at 200 Hz and 2 kHz",
    },
    NamedMaterial {
        name: "steel",
        material: Material::lame_of(200e9, 0.29, 7850.0),
        damping: Rayleigh {
            alpha1_s: 3e-8,
            alpha2_per_s: 5.0,
        },
        source: "Wang & James, KleinPAT, 2019, Table 4",
        damping_source: "guess: the same table",
    },
    NamedMaterial {
        name: "glass",
        material: Material::lame_of(62e9, 0.20, 2600.0),
        damping: Rayleigh {
            alpha1_s: 1e-7,
            alpha2_per_s: 1.0,
        },
        source: "Wang & James, KleinPAT, 2019, Table 4",
        damping_source: "guess: the same table",
    },
    NamedMaterial {
        name: "oak",
        material: Material::lame_of(12.3e9, 0.369, 760.0),
        damping: Rayleigh {
            alpha1_s: 2e-6,
            alpha2_per_s: 60.0,
        },
        source: "white oak along the grain at 12 % moisture: 1.78 Mpsi = 12.3 GPa, specific \
                 gravity 0.68 (dry mass; 760 kg/m³ with its water), ν_LR 0.369 (USDA Wood Handbook)",
        damping_source: "guess: wood in Wang & James, KleinPAT, 2019, Table 4",
    },
    NamedMaterial {
        name: "rosewood",
        material: Material::lame_of(22e9, 0.35, 1025.0),
        damping: loss_factor(4.5e-3),
        source: "Honduras rosewood along the grain: 22 GPa and 1025 kg/m³ (The Wood Database), \
                 ν 0.35 as hardwoods have (USDA Wood Handbook)",
        damping_source: "guess: loss factor 0.45 % of marimba bars (Hill, University of \
                         Illinois), met at 200 Hz and 2 kHz",
    },
];

const KNOWN: usize = REAL.len() + TABLE_1.len();

/// Every material with a name. Wood is taken as isotropic, with its stiffness along the grain.
pub static NAMED_MATERIALS: [NamedMaterial; KNOWN] = {
    let mut all = [REAL[0]; KNOWN];
    let mut i = 0;
    while i < KNOWN {
        all[i] = if i < REAL.len() {
            REAL[i]
        } else {
            let row = TABLE_1[i - REAL.len()];
            NamedMaterial {
                name: row.material_name,
                material: row.material,
                damping: row.rayleigh,
                source: "O'Brien 2002, Table 1",
                damping_source: "O'Brien 2002, Table 1",
            }
        };
        i += 1;
    }
    all
};

/// Rayleigh damping that meets a constant loss factor η at 200 Hz and 2 kHz.
const fn loss_factor(eta: f64) -> Rayleigh {
    Rayleigh::with_loss_factor(eta, 200.0, 2000.0)
}

fn known_names() -> String {
    let names: Vec<String> = NAMED_MATERIALS
        .iter()
        .map(|entry| format!("\"{}\"", entry.name))
        .collect();
    names.join(", ")
}

fn nearest_name(wanted: &str) -> &'static str {
    let mut nearest = (usize::MAX, NAMED_MATERIALS[0].name);
    for entry in &NAMED_MATERIALS {
        let edits = edit_distance(wanted, &entry.name.to_lowercase());
        if edits < nearest.0 {
            nearest = (edits, entry.name);
        }
    }
    nearest.1
}

/// Levenshtein's distance: insertions, deletions and replacements from `a` to `b`.
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, from) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &to) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(from != to);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_material_is_possible_sourced_and_named_once() {
        let mut names = BTreeSet::new();
        for entry in &NAMED_MATERIALS {
            assert_eq!(entry.material.check(), Ok(()), "{}", entry.name);
            assert!(entry.damping.alpha1_s > 0.0 && entry.damping.alpha2_per_s >= 0.0);
            assert!(!entry.source.is_empty() && !entry.damping_source.is_empty());
            assert!(names.insert(entry.name.to_lowercase()), "{}", entry.name);
            assert_eq!(NamedMaterial::find(entry.name), Ok(entry));
        }
    }

    /// Speed of sound along a rod, √(E/ρ): Kinsler & Frey and the CRC handbook agree to a few
    /// per cent on 5000 m/s for aluminium and steel, and 3500 m/s for brass.
    #[test]
    fn rods_carry_sound_at_handbook_speeds() {
        for (name, m_per_s) in [("aluminium", 5050.0), ("steel", 5050.0), ("brass", 3500.0)] {
            let m = Material::named(name).unwrap();
            let speed = (m.young_pa() / m.density_kg_m3).sqrt();
            assert!((speed / m_per_s - 1.0).abs() < 0.04, "{name}: {speed} m/s");
        }
    }

    #[test]
    fn case_and_spaces_around_do_not_matter() {
        let brass = Material::named("brass");
        assert!(brass.is_ok());
        assert_eq!(Material::named(" Brass "), brass);
    }

    #[test]
    fn an_unknown_name_gets_the_nearest_and_the_list_on_one_line() {
        let error = Material::named("aluminum").unwrap_err();
        assert_eq!(error.nearest, "aluminium");
        let message = error.to_string();
        assert!(message.contains("\"aluminum\"") && message.contains("\"bell bronze\""));
        assert!(!message.contains('\n'));
        assert_eq!(
            Material::named("bel bronse").unwrap_err().nearest,
            "bell bronze"
        );
    }

    #[test]
    fn edits_are_counted() {
        for (a, b, edits) in [("", "abc", 3), ("kitten", "sitting", 3), ("oak", "oak", 0)] {
            assert_eq!(edit_distance(a, b), edits);
            assert_eq!(edit_distance(b, a), edits);
        }
    }
}
