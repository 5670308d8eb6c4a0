//! What is written on a preset about it.

/// Name and all that helps to find it again.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Card {
    /// For people.
    pub name: String,
    /// What sort of sound it is, in one or two words.
    pub category: String,
    /// More words to find it by.
    pub tags: Vec<String>,
    /// Who made it.
    pub author: String,
    /// In one sentence, why it exists.
    pub about: String,
}

impl Card {
    /// The tags as they are typed: with commas between.
    #[must_use]
    pub fn tags_text(&self) -> String {
        self.tags.join(", ")
    }

    /// Tags from a text with commas between; each once, without space around.
    pub fn set_tags(&mut self, text: &str) {
        self.tags.clear();
        for tag in text.split(',').map(str::trim) {
            if !tag.is_empty() && !self.tags.iter().any(|other| other == tag) {
                self.tags.push(tag.to_owned());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Card;

    #[test]
    fn tags_are_typed_with_commas() {
        let mut card = Card::default();
        card.set_tags(" warm,soft ,, warm");
        assert_eq!(card.tags, ["warm", "soft"]);
        assert_eq!(card.tags_text(), "warm, soft");
    }
}
