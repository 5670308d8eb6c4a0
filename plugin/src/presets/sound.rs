//! What a preset makes of the parameters and of the tuning.

use crate::params::body::INSTRUMENT;
use crate::params::{GROUPS, Spec, specs};

/// Texts of Scala files; empty where there is none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Scala {
    /// Of the `.scl` file.
    pub scale: String,
    /// Of the `.kbm` file.
    pub keyboard: String,
}

impl Scala {
    /// Whether it says nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.scale.is_empty() && self.keyboard.is_empty()
    }
}

/// Values of parameters in their units, and a tuning if it brings one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sound {
    /// Those that are said; each once.
    pub values: Vec<(&'static Spec, f32)>,
    /// Empty: none of its own.
    pub scala: Scala,
}

impl Sound {
    /// That of a new instance, on the instrument of that index.
    #[must_use]
    pub fn init(instrument: usize) -> Self {
        let values = specs().filter(|spec| !Self::is_player_s(spec));
        let values = values.map(|spec| match spec.id {
            id if id == INSTRUMENT.id => (spec, instrument as f32),
            _ => (spec, spec.default),
        });
        Self {
            values: values.collect(),
            scala: Scala::default(),
        }
    }

    /// What is said of a parameter.
    #[must_use]
    pub fn get(&self, id: &str) -> Option<f32> {
        let found = self.values.iter().find(|(spec, _)| spec.id == id);
        found.map(|(_, value)| *value)
    }

    /// What each parameter is to be: as said, or else as in a new instance. How hands are understood
    /// belongs to the player and the keyboard and stays, unless something is said of it.
    pub fn wanted(&self) -> impl Iterator<Item = (&'static Spec, f32)> {
        specs().filter_map(|spec| {
            let said = self.get(spec.id);
            let usual = || (!Self::is_player_s(spec)).then_some(spec.default);
            Some((spec, said.or_else(usual)?))
        })
    }

    /// Whether a parameter is about the player rather than the sound.
    #[must_use]
    pub fn is_player_s(spec: &Spec) -> bool {
        let hands = GROUPS.iter().find(|group| group.name == "Hands");
        hands.is_some_and(|group| group.specs.iter().any(|other| other.id == spec.id))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{body::SIZE, hands::MPE, output::GAIN};

    #[test]
    fn what_is_not_said_is_as_new_but_hands_stay() {
        let sound = Sound {
            values: vec![(&SIZE, 2.0)],
            scala: Scala::default(),
        };
        let wanted: Vec<_> = sound.wanted().collect();
        assert!(wanted.contains(&(&SIZE, 2.0)));
        assert!(wanted.contains(&(&GAIN, GAIN.default)));
        assert!(wanted.iter().all(|(spec, _)| spec.id != MPE.id));
        let with = Sound {
            values: vec![(&MPE, 1.0)],
            ..sound
        };
        assert!(with.wanted().any(|pair| pair == (&MPE, 1.0)));
        assert_eq!(wanted.len() + 4, specs().count());
    }
}
