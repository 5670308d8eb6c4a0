//! What keys say to egui.

use egui::{Event as Said, Key, Modifiers};
use keyboard_types::{Key as Pressed, KeyState, KeyboardEvent};

/// What a key that goes down or up says; `pasted` is what it would paste.
pub(super) fn said(
    event: &KeyboardEvent,
    modifiers: Modifiers,
    pasted: impl FnOnce() -> Option<String>,
) -> Vec<Said> {
    let pressed = event.state == KeyState::Down;
    let name = event.key.to_string();
    if pressed && let Some(edit) = Edit::of(&name, modifiers) {
        return match edit {
            Edit::Copy => vec![Said::Copy],
            Edit::Cut => vec![Said::Cut],
            Edit::Paste => pasted().map(Said::Paste).into_iter().collect(),
        };
    }
    let capital = name.to_uppercase();
    let key = match name.as_str() {
        " " => Some(Key::Space),
        _ => Key::from_name(&name).or_else(|| Key::from_name(&capital)),
    };
    let key = key.map(|key| Said::Key {
        key,
        physical_key: None,
        pressed,
        repeat: event.repeat,
        modifiers,
    });
    let text = match &event.key {
        Pressed::Character(text) if pressed && !modifiers.ctrl && !modifiers.command => {
            let readable = !text.is_empty() && !text.contains(char::is_control);
            readable.then(|| Said::Text(text.clone()))
        }
        _ => None,
    };
    key.into_iter().chain(text).collect()
}

/// What is done with the clipboard.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Edit {
    Copy,
    Cut,
    Paste,
}

impl Edit {
    /// By a key's name: that of an editing key, a letter with the command key, or what was usual before.
    fn of(name: &str, modifiers: Modifiers) -> Option<Self> {
        let Modifiers { shift, command, .. } = modifiers;
        match name {
            "Copy" => Some(Self::Copy),
            "Cut" => Some(Self::Cut),
            "Paste" => Some(Self::Paste),
            "c" | "C" | "Insert" if command => Some(Self::Copy),
            "x" | "X" if command => Some(Self::Cut),
            "v" | "V" if command => Some(Self::Paste),
            "Delete" if shift => Some(Self::Cut),
            "Insert" if shift => Some(Self::Paste),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use keyboard_types::NamedKey;

    const CTRL: Modifiers = Modifiers::CTRL.plus(Modifiers::COMMAND);

    fn press(key: Pressed, modifiers: Modifiers) -> Vec<Said> {
        let event = KeyboardEvent {
            state: KeyState::Down,
            key,
            ..KeyboardEvent::default()
        };
        said(&event, modifiers, || Some("from elsewhere".to_owned()))
    }

    fn character(text: &str) -> Pressed {
        Pressed::Character(text.to_owned())
    }

    #[test]
    fn keys_are_pressed_and_write() {
        let pressed = |said: &[Said]| match said {
            [Said::Key { key, .. }, ..] => Some(*key),
            _ => None,
        };
        for (key, expected) in [
            (character("z"), Key::Z),
            (character("7"), Key::Num7),
            (character(" "), Key::Space),
            (Pressed::Named(NamedKey::ArrowDown), Key::ArrowDown),
            (Pressed::Named(NamedKey::Enter), Key::Enter),
            (Pressed::Named(NamedKey::Escape), Key::Escape),
            (Pressed::Named(NamedKey::Backspace), Key::Backspace),
        ] {
            let said = press(key.clone(), Modifiers::NONE);
            assert_eq!(pressed(&said), Some(expected), "{key}");
            let text = said.contains(&Said::Text(key.to_string()));
            assert_eq!(text, matches!(key, Pressed::Character(_)), "{key}");
        }
        let letter = press(character("\u{e4}"), Modifiers::NONE);
        assert_eq!(letter, [Said::Text("\u{e4}".to_owned())]);
        assert_eq!(press(character("\u{3}"), Modifiers::NONE), []);
    }

    #[test]
    fn letters_with_control_write_nothing() {
        let said = press(character("z"), CTRL);
        assert!(matches!(said[..], [Said::Key { key: Key::Z, .. }]));
    }

    #[test]
    fn the_clipboard_has_its_keys() {
        let paste = Said::Paste("from elsewhere".to_owned());
        let insert = || Pressed::Named(NamedKey::Insert);
        let delete = || Pressed::Named(NamedKey::Delete);
        for (key, modifiers, expected) in [
            (character("c"), CTRL, Said::Copy),
            (insert(), CTRL, Said::Copy),
            (character("X"), CTRL, Said::Cut),
            (delete(), Modifiers::SHIFT, Said::Cut),
            (character("v"), CTRL, paste.clone()),
            (insert(), Modifiers::SHIFT, paste.clone()),
            (Pressed::Named(NamedKey::Paste), Modifiers::NONE, paste),
        ] {
            assert_eq!(press(key.clone(), modifiers), [expected], "{key}");
        }
        let said = press(character("v"), Modifiers::NONE);
        assert!(matches!(said[..], [Said::Key { .. }, Said::Text(_)]));
        let nothing = KeyboardEvent {
            state: KeyState::Down,
            key: character("v"),
            ..KeyboardEvent::default()
        };
        assert_eq!(super::said(&nothing, CTRL, || None), []);
    }
}
