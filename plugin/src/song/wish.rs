//! Which instrument a song wants, by name: numbers change their meaning when instruments are added.

use super::INSTRUMENT;
use crate::factory;
use crate::params::body;
use crate::shelf::{OWN, OWN_NAME, OWN_TITLE};
use nice_plug::plugin::ParamValue;
use nice_plug::prelude::PluginState;
use serde::{Deserialize, Serialize};

/// An instrument as a song names it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub(super) enum Wish {
    /// By its name, with the one for people.
    Named { name: String, title: String },
    /// By its number alone, in songs from before names.
    Number(i32),
}

impl Wish {
    /// For the instrument at an index of the parameter.
    pub(super) fn of(index: usize) -> Self {
        let (name, title) = match factory::BANKS.get(index) {
            Some((name, _)) => (*name, factory::title(index as f32)),
            None => (OWN_NAME, OWN_TITLE),
        };
        Self::Named {
            name: name.to_owned(),
            title: title.to_owned(),
        }
    }

    /// What a field says; none if it is no wish.
    pub(super) fn read(field: &str) -> Option<Self> {
        serde_json::from_str(field).ok()
    }

    /// As a field.
    pub(super) fn write(&self) -> String {
        // Texts and numbers always make JSON.
        serde_json::to_string(self).unwrap_or_default()
    }

    /// Its place in the parameter; none if this version has no such instrument.
    pub(super) fn index(&self) -> Option<usize> {
        match self {
            Self::Named { name, .. } if name == OWN_NAME => Some(OWN),
            Self::Named { name, .. } => factory::BANKS.iter().position(|(other, _)| other == name),
            Self::Number(number) => usize::try_from(*number).ok().filter(|index| *index <= OWN),
        }
    }

    /// What to call it.
    pub(super) fn title(&self) -> String {
        match self {
            Self::Named { title, .. } => format!("\"{title}\""),
            Self::Number(number) => format!("instrument {}", i64::from(*number) + 1),
        }
    }
}

/// Sets the instrument's number by its name. One that this version does not have stays in the field, and
/// the first stands in.
pub(crate) fn resolve(state: &mut PluginState) {
    let id = body::INSTRUMENT.id;
    let saved = match state.params.get(id) {
        Some(ParamValue::I32(number)) => *number,
        _ => return,
    };
    let named = state.fields.get(INSTRUMENT);
    let named = named.and_then(|field| Wish::read(field));
    let wish = named.unwrap_or_else(|| {
        let wish = Wish::Number(saved);
        state.fields.insert(INSTRUMENT.to_owned(), wish.write());
        wish
    });
    let number = i32::try_from(wish.index().unwrap_or(0)).unwrap_or(0);
    state.params.insert(id.to_owned(), ParamValue::I32(number));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_instrument_is_found_by_its_name_and_by_its_number() {
        for index in 0..=OWN {
            let wish = Wish::of(index);
            assert_eq!(wish.index(), Some(index));
            assert_eq!(Wish::read(&wish.write()), Some(wish));
            assert_eq!(Wish::read(&index.to_string()).unwrap().index(), Some(index));
        }
        assert_eq!(Wish::of(0).title(), "\"Wind chimes\"");
        for field in ["99", "-1", "{\"name\":\"gong\",\"title\":\"Gong\"}"] {
            assert_eq!(Wish::read(field).unwrap().index(), None);
        }
        for field in ["", "[]", "\"gong\"", "{}", "1e300"] {
            assert_eq!(Wish::read(field), None, "{field}");
        }
    }
}
