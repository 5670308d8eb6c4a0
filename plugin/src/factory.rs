//! The banks that come with the plug-in, inside it.

use modes::Bank;
use std::sync::OnceLock;

/// One bank: its name, and its file's content.
type Entry = (&'static str, &'static [u8]);

include!(concat!(env!("OUT_DIR"), "/banks.rs"));

/// The factory's banks in the order of the `Instrument` parameter.
pub const BANKS: [Entry; COUNT] = FILES;

/// The bank at `index`, read once for all instances; the first if there is none.
///
/// # Panics
///
/// Never: the build that wrote the bank has read it.
#[must_use]
pub fn bank(index: usize) -> &'static Bank {
    static READ: [OnceLock<Bank>; COUNT] = [const { OnceLock::new() }; COUNT];
    let index = if index < COUNT { index } else { 0 };
    READ[index].get_or_init(|| {
        let bank = Bank::read(BANKS[index].1).expect("the bank is as it was built");
        bank.spread_out()
    })
}

/// The instruments' names for people.
pub fn titles() -> impl Iterator<Item = &'static str> {
    TITLES.into_iter()
}

/// The name of the instrument nearest to `index`.
#[must_use]
pub fn title(index: f32) -> &'static str {
    #[expect(clippy::cast_sign_loss, reason = "what is below 0 saturates")]
    let index = index.round() as usize;
    TITLES[index.min(COUNT - 1)]
}

#[cfg(test)]
mod tests {
    use super::{BANKS, TITLES, bank};

    #[test]
    fn banks_have_the_names_and_titles_that_are_listed() {
        for (index, (name, _)) in BANKS.iter().enumerate() {
            assert_eq!(bank(index).name, *name);
            assert_eq!(bank(index).title, TITLES[index]);
        }
        assert_eq!(bank(usize::MAX).name, "chimes");
        let keys: Vec<u8> = bank(0).bodies.iter().map(|body| body.key).collect();
        assert_eq!(keys, (36..=96).collect::<Vec<_>>());
    }

    #[test]
    fn all_banks_together_are_below_30_mb() {
        let bytes: usize = BANKS.iter().map(|(_, file)| file.len()).sum();
        assert!(bytes < 30_000_000, "{bytes}");
    }
}
