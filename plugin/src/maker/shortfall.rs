//! What is said of bodies that cannot be as the knobs draw them.

use super::Drawing;
use crate::key_name::key_names;
use crate::notices::{Notice, Subject};
use modes::RecipeError;

/// The keys of a drawing that cannot be built.
#[derive(Debug, Default)]
pub(super) struct Shortfall {
    /// Those whose bodies go part of the way.
    pub(super) partly: Vec<u8>,
    /// Those whose bodies stay as they were.
    pub(super) not: Vec<u8>,
}

impl Shortfall {
    /// What to tell of it; nothing if nothing is short.
    pub(super) fn notice(mut self, drawing: &Drawing) -> Option<Notice> {
        self.partly.sort_unstable();
        self.not.sort_unstable();
        let partly = (self.partly, "go as far as they can");
        let not = (self.not, "stay as they were");
        let said: Vec<String> = [partly, not]
            .into_iter()
            .filter(|(keys, _)| !keys.is_empty())
            .map(|(keys, what)| format!("{} {what}", key_names(&keys)))
            .collect();
        (!said.is_empty()).then(|| {
            let knobs = drawing.turned().join(" and ");
            let text = format!(
                "{knobs} cannot go this far at every pitch: {}. Turn {knobs} back for all keys.",
                said.join("; ")
            );
            notice(text)
        })
    }
}

/// What to tell of a drawing that no key can have.
pub(super) fn refused(drawing: &Drawing, error: &RecipeError) -> Notice {
    let knobs = drawing.turned().join(" and ");
    notice(format!(
        "{knobs} cannot go this far, and the bodies stay as they were: {error}"
    ))
}

fn notice(text: String) -> Notice {
    Notice {
        subject: Subject::Drawing,
        text,
        cure: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use modes::Recipe;

    fn broad(width: f32) -> Drawing {
        Drawing {
            width,
            ..Drawing::OWN
        }
    }

    #[test]
    fn a_notice_names_the_knob_the_keys_and_the_cure() {
        let none = Shortfall::default();
        assert_eq!(none.notice(&broad(2.0)), None);
        let short = Shortfall {
            partly: vec![91, 78, 90],
            not: vec![96],
        };
        let notice = short.notice(&broad(2.0)).unwrap();
        assert_eq!(notice.subject, Subject::Drawing);
        let text = notice.text;
        assert!(text.starts_with("Breadth cannot go this far"), "{text}");
        assert!(
            text.contains("F#5, F#6 to G6 go as far as they can; C7 stay"),
            "{text}"
        );
        assert!(text.ends_with("Turn Breadth back for all keys."), "{text}");
    }

    #[test]
    fn a_bowl_whose_wall_runs_into_itself_is_told() {
        let text = Recipe::FACTORY
            .iter()
            .find(|(name, _)| *name == "oak-bowls");
        let recipe = Recipe::parse(text.unwrap().1, "oak-bowls").unwrap();
        let error = broad(0.5).apply(&recipe).unwrap_err();
        let text = refused(&broad(0.5), &error).text;
        assert!(
            text.contains("Breadth") && text.contains("would do"),
            "{text}"
        );
    }
}
