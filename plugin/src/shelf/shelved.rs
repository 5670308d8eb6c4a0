//! A bank from the shelf.

use super::Own;
use crate::factory;
use modes::Bank;
use std::ops::Deref;
use std::sync::Arc;

/// A bank that stays for as long as it is held.
#[derive(Clone, Debug)]
pub enum Shelved {
    /// One that came with the plug-in.
    Factory(&'static Bank),
    /// One of the user's own.
    Own(Arc<Own>),
    /// One whose drawing has been changed.
    Drawn(Arc<Bank>),
}

impl Shelved {
    /// The factory's at `index`; the first if there is none.
    #[must_use]
    pub fn factory(index: usize) -> Self {
        Self::Factory(factory::bank(index))
    }

    /// Whether it is the same, without a look at what is in it.
    #[must_use]
    pub fn is(&self, other: &Self) -> bool {
        std::ptr::eq(&raw const **self, &raw const **other)
    }
}

impl Deref for Shelved {
    type Target = Bank;

    fn deref(&self) -> &Bank {
        match self {
            Self::Factory(bank) => bank,
            Self::Own(own) => own.bank(),
            Self::Drawn(bank) => bank,
        }
    }
}
