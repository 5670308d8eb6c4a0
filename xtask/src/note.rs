//! What musicians call a MIDI key.

/// A MIDI key's name, 60 being C4.
pub(crate) fn name(key: u8) -> String {
    const NAMES: [&str; 12] = [
        "C", "C♯", "D", "E♭", "E", "F", "F♯", "G", "A♭", "A", "B♭", "B",
    ];
    let octave = i32::from(key / 12) - 1;
    format!("{}{octave}", NAMES[usize::from(key % 12)])
}

#[cfg(test)]
mod tests {
    use super::name;

    #[test]
    fn keys_are_named_as_midi_names_them() {
        assert_eq!(name(74), "D5");
        assert_eq!(name(60), "C4");
        assert_eq!(name(0), "C-1");
    }
}
