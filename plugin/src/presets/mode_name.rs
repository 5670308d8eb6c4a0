//! The names of modes as people read them, and back.

use modes::{Family, Member, ModeLabel};

/// The families that a name can be of.
const FAMILIES: [Family; 9] = [
    Family::Bending,
    Family::Torsion,
    Family::Longitudinal,
    Family::Wall,
    Family::Lateral,
    Family::Shell,
    Family::Membrane,
    Family::Plate,
    Family::Other,
];

const MEMBERS: [Member; 3] = [Member::Single, Member::A, Member::B];

/// The name; where it leaves the waves around the axis unsaid and they are not the usual ones, with these.
pub(super) fn mode_name(label: &ModeLabel) -> String {
    let name = label.to_string();
    let order = if label.order == 0 { 1 } else { 0 };
    let said = ModeLabel { order, ..*label }.to_string() != name;
    if said || label.order == usual_order(label) {
        name
    } else {
        format!("{name} of order {}", label.order)
    }
}

/// Of a family whose names do not tell it.
fn usual_order(label: &ModeLabel) -> u16 {
    // Round bodies bend in pairs, with one wave around.
    u16::from(label.family == Family::Bending && label.member != Member::Single)
}

/// The mode that is called so.
pub(super) fn named_mode(name: &str) -> Option<ModeLabel> {
    let digits = name.split(|letter: char| !letter.is_ascii_digit());
    let numbers: Vec<u16> = digits.filter_map(|number| number.parse().ok()).collect();
    let orders = || [0, 1].into_iter().chain(numbers.iter().copied());
    // Some are counted from none in their names, and all from 1 in labels.
    let next = numbers.iter().filter_map(|number| number.checked_add(1));
    let indices: Vec<u16> = numbers.iter().copied().chain(next).collect();
    let indices = || indices.iter().copied().filter(|index| *index > 0);
    let labels = FAMILIES.into_iter().flat_map(|family| {
        MEMBERS.into_iter().flat_map(move |member| {
            orders().flat_map(move |order| {
                indices().map(move |index| ModeLabel {
                    family,
                    order,
                    index,
                    member,
                })
            })
        })
    });
    let mut labels = labels;
    labels.find(|label| mode_name(label) == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factory;

    #[test]
    fn every_mode_of_the_factory_is_found_by_its_name() {
        for index in 0..factory::BANKS.len() {
            for mode in &factory::bank(index).bodies[0].modes {
                let name = mode.label.to_string();
                assert_eq!(
                    mode_name(&mode.label),
                    name,
                    "the order goes without saying"
                );
                assert_eq!(named_mode(&name), Some(mode.label), "{name}");
            }
        }
    }

    #[test]
    fn unusual_orders_are_said_and_other_words_are_no_modes() {
        let label = ModeLabel {
            family: Family::Torsion,
            order: 7,
            index: 3,
            member: Member::B,
        };
        assert_eq!(mode_name(&label), "torsion 3 b of order 7");
        assert_eq!(named_mode("torsion 3 b of order 7"), Some(label));
        for word in [
            "",
            "wobble 3",
            "bending",
            "bending 70000",
            "bending 2 c",
            "shell (2,65535)",
        ] {
            assert_eq!(named_mode(word), None, "{word}");
        }
    }
}
