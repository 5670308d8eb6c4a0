//! Mallets by name.

use crate::engine::Mallet;

const fn mallet(mass_g: f64, head_mm: f64, hardness_pa: f64, loss_s_m: f64) -> Mallet {
    Mallet {
        mass_kg: 1e-3 * mass_g,
        head_radius_m: 1e-3 * head_mm,
        hardness_pa,
        loss_s_m,
        ..Mallet::DEFAULT
    }
}

/// What players hold, from soft to hard. A name's place never changes; new ones go to the end.
///
/// Masses and radii are those of the heads that are sold for vibraphone, marimba, glockenspiel, tubular
/// bells (rawhide) and singing bowls (felt), with the share of the stick that moves with them; moduli are
/// those of the materials under small loads, losses give back a half (yarn) to nearly all (brass) of
/// the speed of a blow of 1 m/s.
pub(crate) const MALLETS: [(&str, Mallet); 10] = [
    ("yarn, soft", mallet(35.0, 20.0, 2e6, 0.7)),
    ("yarn, medium", mallet(32.0, 18.0, 8e6, 0.6)),
    ("yarn, hard", mallet(30.0, 16.0, 3e7, 0.5)),
    ("cord", mallet(30.0, 15.0, 1e8, 0.4)),
    ("felt", mallet(120.0, 25.0, 5e6, 0.6)),
    ("rubber", mallet(28.0, 15.0, 5e7, 0.3)),
    ("rawhide", mallet(200.0, 20.0, 1e9, 0.2)),
    ("plastic", mallet(15.0, 12.0, 3e9, 0.1)),
    ("wood", mallet(18.0, 12.0, 1e10, 0.1)),
    ("brass", mallet(35.0, 10.0, 1e11, 0.03)),
];

#[cfg(test)]
mod tests {
    use super::MALLETS;
    use crate::engine::Settings;

    #[test]
    fn all_are_allowed() {
        for (name, mallet) in MALLETS {
            let settings = Settings {
                mallet,
                ..Settings::DEFAULT
            };
            assert_eq!(settings.sane(), settings, "{name}");
        }
    }
}
