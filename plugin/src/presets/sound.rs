//! What a preset makes of the parameters and of the tuning.

use super::trim::{TrimList, same};
use crate::params::body::INSTRUMENT;
use crate::params::output::OUTPUTS;
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

/// Values of parameters in their units, trims of single modes, and a tuning if it brings one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sound {
    /// Those that are said; each once.
    pub values: Vec<(&'static Spec, f32)>,
    /// Empty: none of its own.
    pub scala: Scala,
    /// Modes that are not as built; the others are.
    pub trims: TrimList,
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
            ..Self::default()
        }
    }

    /// What is said of a parameter.
    #[must_use]
    pub fn get(&self, id: &str) -> Option<f32> {
        let found = self.values.iter().find(|(spec, _)| spec.id == id);
        found.map(|(_, value)| *value)
    }

    /// What each parameter is to be: as said, or else as in a new instance. How hands are understood
    /// belongs to the player and the keyboard, and what goes to which output to the song: they stay, unless
    /// something is said of them.
    pub fn wanted(&self) -> impl Iterator<Item = (&'static Spec, f32)> {
        specs().filter_map(|spec| {
            let said = self.get(spec.id);
            let usual = || (!Self::is_player_s(spec)).then_some(spec.default);
            Some((spec, said.or_else(usual)?))
        })
    }

    /// Whether modes are trimmed as here, as far as a file tells.
    #[must_use]
    pub fn is_trimmed(&self, trims: &TrimList) -> bool {
        same(&self.trims, trims)
    }

    /// Whether a parameter is about the player and the song rather than the sound.
    #[must_use]
    pub fn is_player_s(spec: &Spec) -> bool {
        let hands = GROUPS.iter().find(|group| group.name == "Hands");
        let understood =
            hands.is_some_and(|group| group.specs.iter().any(|other| other.id == spec.id));
        understood || spec.id == OUTPUTS.id
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
            ..Sound::default()
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
        assert!(wanted.iter().all(|(spec, _)| spec.id != OUTPUTS.id));
        assert_eq!(wanted.len() + 5, specs().count());
    }
}
