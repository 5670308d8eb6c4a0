//! Which presets are looked for.

use super::entry::Entry;

/// Which shelf of the library.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// All of it.
    #[default]
    All,
    /// What the user has marked.
    Favourites,
    /// The user's own.
    User,
    /// Those that play an instrument of that name.
    Instrument(String),
    /// Those of that category.
    Category(String),
}

/// What is looked for.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Search {
    /// On which shelf.
    pub kind: Kind,
    /// Words that all have to be somewhere on the card, in any case.
    pub text: String,
}

impl Search {
    /// Whether an entry is one of those. Broken ones are on the user's shelf.
    #[must_use]
    pub fn finds(&self, entry: &Entry) -> bool {
        self.is_on_shelf(entry) && self.has_words(entry)
    }

    fn is_on_shelf(&self, entry: &Entry) -> bool {
        match (&self.kind, &entry.preset) {
            (Kind::All, _) => true,
            (Kind::Favourites, _) => entry.favourite,
            (Kind::User, _) => entry.is_user_s(),
            (_, Err(_)) => false,
            (Kind::Instrument(name), Ok(preset)) => preset.instrument() == name,
            (Kind::Category(name), Ok(preset)) => preset.card.category == *name,
        }
    }

    fn has_words(&self, entry: &Entry) -> bool {
        let mut card = entry.name().to_lowercase();
        if let Ok(preset) = &entry.preset {
            for text in [
                preset.instrument(),
                &preset.card.category,
                &preset.card.tags_text(),
                &preset.card.author,
                &preset.card.about,
            ] {
                card.push('\n');
                card += &text.to_lowercase();
            }
        }
        let text = self.text.to_lowercase();
        text.split_whitespace().all(|word| card.contains(word))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::presets::{Library, factory};

    fn count(kind: Kind, text: &str) -> usize {
        let search = Search {
            kind,
            text: text.to_owned(),
        };
        let library = Library::open(None);
        library
            .entries()
            .iter()
            .filter(|entry| search.finds(entry))
            .count()
    }

    #[test]
    fn words_narrow_the_search_in_any_case_and_order() {
        let all = count(Kind::All, "");
        assert_eq!(all, factory().len());
        let one = count(Kind::All, "VIBRAPHONE");
        let two = count(Kind::All, "slow vibraphone");
        assert!(0 < two && two < one && one < all, "{two} {one} {all}");
        assert_eq!(count(Kind::All, "vibraphone slow"), two);
        assert_eq!(count(Kind::All, "qqq"), 0);
    }

    #[test]
    fn shelves_hold_their_own() {
        let shelf = |title: &str| count(Kind::Instrument(title.to_owned()), "");
        let all: usize = crate::factory::titles().map(shelf).sum();
        assert_eq!(all, factory().len());
        assert_eq!(count(Kind::User, ""), 0);
        assert_eq!(count(Kind::Favourites, ""), 0);
        assert!(count(Kind::Category(factory()[0].card.category.clone()), "") > 0);
    }
}
