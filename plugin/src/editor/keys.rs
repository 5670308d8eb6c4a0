//! The computer's keys as a keyboard: two octaves, in the places of a piano's keys.

use egui::{Event, Key, Ui};

/// From the lowest up, the row at the bottom and the one above it.
const LOWER: [Key; 12] = [
    Key::Z,
    Key::S,
    Key::X,
    Key::D,
    Key::C,
    Key::V,
    Key::G,
    Key::B,
    Key::H,
    Key::N,
    Key::J,
    Key::M,
];
/// An octave higher, the rows at the top.
const UPPER: [Key; 17] = [
    Key::Q,
    Key::Num2,
    Key::W,
    Key::Num3,
    Key::E,
    Key::R,
    Key::Num5,
    Key::T,
    Key::Num6,
    Key::Y,
    Key::Num7,
    Key::U,
    Key::I,
    Key::Num9,
    Key::O,
    Key::Num0,
    Key::P,
];

/// Semitones from the lowest that a key of the computer plays.
fn semitones(key: Key) -> Option<u8> {
    let find = |keys: &[Key]| keys.iter().position(|other| *other == key);
    let at = find(&LOWER).or_else(|| find(&UPPER).map(|at| at + 12))?;
    u8::try_from(at).ok()
}

/// What is written on the key that plays so many semitones from the lowest.
pub(super) fn letter(semitones: u8) -> Option<&'static str> {
    let at = usize::from(semitones);
    LOWER.get(at).map(|key| key.symbol_or_name())
}

/// A key of the computer that goes down or up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Press {
    /// Plays a MIDI key.
    Down(u8),
    /// Lets go of it.
    Up(u8),
    /// An octave lower (−1) or higher (1) from now on.
    Octave(i8),
}

/// What has been pressed, unless someone types or holds a command key down; `lowest` is the MIDI key of
/// the lowest one.
pub(super) fn presses(ui: &Ui, lowest: u8) -> Vec<Press> {
    if ui.ctx().text_edit_focused() {
        return Vec::new();
    }
    ui.input(|input| {
        let press = |event: &Event| {
            let Event::Key {
                key,
                physical_key,
                pressed,
                repeat: false,
                modifiers,
            } = event
            else {
                return None;
            };
            if modifiers.command || modifiers.ctrl || modifiers.alt {
                return None;
            }
            let octave = match key {
                Key::Minus if *pressed => Some(Press::Octave(-1)),
                Key::Plus | Key::Equals if *pressed => Some(Press::Octave(1)),
                _ => None,
            };
            // The place counts, not what is printed there.
            octave.or_else(|| {
                let key = lowest.checked_add(semitones(physical_key.unwrap_or(*key))?)?;
                (key < 128).then_some(if *pressed {
                    Press::Down(key)
                } else {
                    Press::Up(key)
                })
            })
        };
        input.events.iter().filter_map(press).collect()
    })
}
