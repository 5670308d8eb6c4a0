//! The banks that come with the plug-in, inside it.

use modes::Bank;
use std::sync::OnceLock;

static CHIMES: &[u8] = include_bytes!(env!("IDIOPHONE_BANK_CHIMES"));

/// The chimes of O'Brien 2002 over five octaves: read once, for all instances.
///
/// # Panics
///
/// Never: the build that wrote the bank has read it.
#[must_use]
pub fn chimes() -> &'static Bank {
    static BANK: OnceLock<Bank> = OnceLock::new();
    BANK.get_or_init(|| Bank::read(CHIMES).expect("the bank is as it was built"))
}
