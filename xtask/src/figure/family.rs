//! Kinds of motion: their names and colours.

use modes::{Family, ModeLabel};
use plotters::style::RGBColor;

/// All kinds, in the order of the legend.
pub(super) const FAMILIES: [Family; 9] = [
    Family::Bending,
    Family::Shell,
    Family::Wall,
    Family::Torsion,
    Family::Lateral,
    Family::Longitudinal,
    Family::Membrane,
    Family::Plate,
    Family::Other,
];

/// A kind's colour and its name in the legend.
pub(super) fn look(family: Family) -> (RGBColor, &'static str) {
    match family {
        Family::Bending => (RGBColor(255, 176, 64), "bending"),
        Family::Shell => (RGBColor(255, 112, 96), "shell"),
        Family::Wall => (RGBColor(158, 134, 255), "wall"),
        Family::Torsion => (RGBColor(86, 180, 240), "torsion"),
        Family::Lateral => (RGBColor(72, 208, 144), "lateral"),
        Family::Longitudinal => (RGBColor(236, 132, 200), "longitudinal"),
        Family::Membrane => (RGBColor(220, 210, 96), "membrane"),
        Family::Plate => (RGBColor(120, 200, 196), "plate"),
        Family::Other => (RGBColor(168, 172, 184), "other"),
    }
}

/// A mode's name without its place in a pair: `bending 2`.
pub(super) fn name(label: ModeLabel) -> String {
    ModeLabel {
        member: modes::Member::Single,
        ..label
    }
    .to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn kinds_look_different() {
        let looks: HashSet<_> = FAMILIES
            .into_iter()
            .map(|family| {
                let (RGBColor(r, g, b), name) = look(family);
                ([r, g, b], name)
            })
            .collect();
        assert_eq!(looks.len(), FAMILIES.len());
    }

    #[test]
    fn both_of_a_pair_have_one_name() {
        let label = |member| ModeLabel {
            family: Family::Shell,
            order: 2,
            index: 1,
            member,
        };
        assert_eq!(name(label(modes::Member::A)), "shell (2,0)");
        assert_eq!(name(label(modes::Member::B)), "shell (2,0)");
    }
}
