//! Parameters that are one of some names.

use super::mallets::MALLETS;
use crate::engine::Split;
use crate::factory;
use crate::hands::{Mpe, Source, Target};
use crate::shelf::{OWN, OWN_TITLE};

/// What is chosen; the names' order never changes, or songs choose something else.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Choice {
    /// A factory instrument, or the user's own.
    Instrument,
    /// A named mallet, or the one that the parameters describe.
    Mallet,
    /// What a key does.
    Keys,
    /// When MPE is understood.
    Mpe,
    /// Where an assignment takes its value from.
    Source,
    /// What an assignment moves.
    Target,
    /// What goes to which output.
    Outputs,
}

/// What a key can do, by number.
const KEYS: [&str; 3] = ["strike", "rub", "strike and rub"];

impl Choice {
    /// How many there are.
    pub(crate) const fn count(self) -> usize {
        match self {
            Self::Instrument => OWN + 1,
            Self::Mallet => MALLETS.len() + 1,
            Self::Keys => KEYS.len(),
            Self::Mpe => Mpe::ALL.len(),
            Self::Source => Source::ALL.len(),
            Self::Target => Target::ALL.len(),
            Self::Outputs => Split::ALL.len(),
        }
    }

    /// The name of that number; the last name if there are fewer.
    pub(crate) fn name(self, index: usize) -> &'static str {
        let index = index.min(self.count() - 1);
        match self {
            Self::Instrument if index == OWN => OWN_TITLE,
            Self::Instrument => factory::title(index as f32),
            Self::Mallet => index.checked_sub(1).map_or("as set", |at| MALLETS[at].0),
            Self::Keys => KEYS[index],
            Self::Mpe => Mpe::from_index(index).name(),
            Self::Source => Source::from_index(index).name(),
            Self::Target => Target::from_index(index).name(),
            Self::Outputs => Split::from_index(index).name(),
        }
    }

    /// All names in their order.
    pub(crate) fn names(self) -> impl Iterator<Item = &'static str> {
        (0..self.count()).map(move |index| self.name(index))
    }

    /// The number that `text`, in small letters, means: by name, by the name without what stands in
    /// brackets, or the number itself.
    pub(crate) fn parse(self, text: &str) -> Option<usize> {
        let plain = |name: &str| name.to_lowercase();
        let short = |name: &str| match name.split_once(" (") {
            Some((name, _)) => plain(name),
            None => plain(name),
        };
        self.names()
            .position(|name| plain(name) == text || short(name) == text)
            .or_else(|| text.parse().ok().filter(|index| *index < self.count()))
    }
}

#[cfg(test)]
mod tests {
    use super::Choice;
    use std::collections::HashSet;

    const ALL: [Choice; 7] = [
        Choice::Instrument,
        Choice::Mallet,
        Choice::Keys,
        Choice::Mpe,
        Choice::Source,
        Choice::Target,
        Choice::Outputs,
    ];

    #[test]
    fn names_are_read_back_in_any_case_and_numbers_too() {
        for choice in ALL {
            let names: HashSet<_> = choice.names().map(str::to_lowercase).collect();
            assert_eq!(names.len(), choice.count(), "{choice:?}");
            for (index, name) in choice.names().enumerate() {
                assert_eq!(choice.parse(&name.to_lowercase()), Some(index));
                assert_eq!(choice.parse(&index.to_string()), Some(index));
            }
            assert_eq!(choice.parse(&choice.count().to_string()), None);
            assert_eq!(choice.parse("something else"), None);
            assert_eq!(choice.name(usize::MAX), choice.name(choice.count() - 1));
        }
        assert_eq!(Choice::Source.parse("mod wheel"), Some(3));
        assert_eq!(Choice::Source.parse("mod wheel (cc 1)"), Some(3));
    }
}
