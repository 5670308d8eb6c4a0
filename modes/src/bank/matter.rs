//! What one body of a bank is made of.

use super::{Bank, Body};
use crate::{Damping, Material};
use serde::{Deserialize, Serialize};

/// What a body is made of, and what that takes of its motion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Matter {
    /// The material.
    pub material: Material,
    /// Its inner damping.
    pub damping: Damping,
}

impl Bank {
    /// What the bodies are made of that do not say otherwise.
    #[must_use]
    pub fn matter(&self) -> Matter {
        Matter {
            material: self.material,
            damping: self.damping,
        }
    }

    /// What `body`, one of this bank's, is made of.
    #[must_use]
    pub fn matter_of(&self, body: &Body) -> Matter {
        body.matter.unwrap_or_else(|| self.matter())
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample::bank;
    use super::Matter;

    #[test]
    fn a_body_that_says_nothing_is_of_the_bank_s_matter() {
        let mut bank = bank();
        let mut other = bank.matter();
        other.material.density_kg_m3 *= 3.0;
        bank.bodies[1].matter = Some(other);
        let found = bank.bodies.iter().map(|body| bank.matter_of(body));
        assert_eq!(found.collect::<Vec<Matter>>(), [bank.matter(), other]);
    }
}
