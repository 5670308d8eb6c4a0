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

#[cfg(test)]
mod tests {
    use super::chimes;
    use crate::engine::Settings;

    #[test]
    fn the_bank_holds_five_octaves_with_the_damping_that_the_parameters_start_with() {
        let bank = chimes();
        let keys: Vec<u8> = bank.bodies.iter().map(|body| body.key).collect();
        assert_eq!(keys, (36..=96).collect::<Vec<_>>());
        assert_eq!(bank.damping, Settings::DEFAULT.damping);
    }
}
