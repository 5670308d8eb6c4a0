//! What keys are called.

/// A key's name, with C4 for key 60.
pub(crate) fn key_name(key: u8) -> String {
    const NAMES: [&str; 12] = [
        "C", "C#", "D", "D#", "E", "F", "F#", "G", "G#", "A", "A#", "B",
    ];
    let octave = i32::from(key / 12) - 1;
    format!("{}{octave}", NAMES[usize::from(key % 12)])
}

/// The names of rising keys, those that follow each other by the first and the last.
pub(crate) fn key_names(keys: &[u8]) -> String {
    let runs = keys.chunk_by(|a, b| a + 1 == *b);
    let names = runs.map(|run| match run {
        [first, .., last] => format!("{} to {}", key_name(*first), key_name(*last)),
        _ => run.iter().map(|key| key_name(*key)).collect(),
    });
    names.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_have_names() {
        assert_eq!((key_name(60), key_name(61)), ("C4".into(), "C#4".into()));
        assert_eq!((key_name(0), key_name(127)), ("C-1".into(), "G9".into()));
    }

    #[test]
    fn runs_of_keys_have_one_name() {
        assert_eq!(key_names(&[60]), "C4");
        assert_eq!(
            key_names(&[36, 78, 79, 80, 90, 91]),
            "C2, F#5 to G#5, F#6 to G6"
        );
    }
}
