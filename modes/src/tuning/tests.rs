//! Scales and keyboard maps against closed forms, and against what no one meant to write.

mod hostile;
mod keyboards;
mod refusals;
mod scales;

use super::{KeyboardMap, Scale, Tuning};

fn scale(notes: &[&str]) -> Scale {
    let text = format!("! a.scl\n!\nA scale\n {}\n!\n", notes.len()) + &notes.join("\n") + "\n";
    Scale::parse(text.as_bytes()).unwrap()
}

/// A map of the seven numbers that come first, in their order, and the entries.
fn map(head: [&str; 7], entries: &str) -> KeyboardMap {
    KeyboardMap::parse(map_text(head, entries).as_bytes()).unwrap()
}

fn map_text(head: [&str; 7], entries: &str) -> String {
    let entries = entries.replace(' ', "\n");
    format!("! a.kbm\n!\n{}\n! Mapping.\n{entries}\n", head.join("\n"))
}

/// Asserts the pitch of a key to 1e-9 cents.
fn assert_hz(tuning: &Tuning, key: u8, hz: f64) {
    let found = tuning.hz(key).unwrap();
    let cents = 1200.0 * (found / hz).log2();
    assert!(cents.abs() < 1e-9, "key {key}: {found} Hz, not {hz} Hz");
}
