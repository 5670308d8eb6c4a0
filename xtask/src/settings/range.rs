//! Telling a text at the end of a range from one beyond it.

/// How far a number is nudged to see whether it is still beyond the end.
const NUDGE: f64 = 1e-3;

/// What `read` makes of `text`; `None` if it refuses it or has clamped it to one of `ends`.
///
/// Plug-ins clamp without a word. A text that means the end itself is accepted: it is written as
/// the plug-in writes that end, or its number, moved a little inwards, moves the value.
pub(super) fn read(
    text: &str,
    read: &mut dyn FnMut(&str) -> Option<f64>,
    ends: [f64; 2],
    end_texts: &[String; 2],
) -> Option<f64> {
    let value = read(text).filter(|value| value.is_finite())?;
    let at_end = (0..2).find(|&end| value == ends[end]);
    let (Some(end), Some((number, unit))) = (at_end, split(text)) else {
        return Some(value);
    };
    if let Some((end_number, end_unit)) = split(&end_texts[end]) {
        let same_unit = unit.is_empty() || unit.eq_ignore_ascii_case(end_unit);
        if same_unit && (number - end_number).abs() <= NUDGE * end_number.abs() {
            return Some(value);
        }
    }
    let inwards = if end == 0 { 1.0 } else { -1.0 };
    let nudged = number + inwards * NUDGE * number.abs();
    (read(&format!("{nudged} {unit}"))? != value).then_some(value)
}

/// A leading number and what follows it.
fn split(text: &str) -> Option<(f64, &str)> {
    let text = text.trim();
    (1..=text.len())
        .rev()
        .filter(|&at| text.is_char_boundary(at))
        .find_map(|at| {
            let number = text[..at].parse::<f64>().ok()?;
            number.is_finite().then(|| (number, text[at..].trim()))
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plug-in's −60…6 dB as 0…1, clamped.
    fn gain(text: &str) -> Option<f64> {
        let db: f64 = text.trim_end_matches("dB").trim().parse().ok()?;
        Some(((db + 60.0) / 66.0).clamp(0.0, 1.0))
    }

    /// Times of 1 µs…1 s, logarithmic, in µs or ms.
    fn time(text: &str) -> Option<f64> {
        let (number, unit) = split(text)?;
        let s = number * if unit == "ms" { 1e-3 } else { 1e-6 };
        Some((s.log10() / 6.0 + 1.0).clamp(0.0, 1.0))
    }

    fn texts(low: &str, high: &str) -> [String; 2] {
        [low.to_owned(), high.to_owned()]
    }

    #[test]
    fn what_lies_within_is_taken() {
        let ends = texts("-60.0 dB", "6.0 dB");
        for (text, value) in [("-27", 0.5), ("-60 dB", 0.0), ("6 dB", 1.0), ("6.0", 1.0)] {
            assert_eq!(
                read(text, &mut gain, [0.0, 1.0], &ends),
                Some(value),
                "{text}"
            );
        }
    }

    #[test]
    fn what_was_clamped_is_refused() {
        let ends = texts("-60.0 dB", "6.0 dB");
        for text in ["7 dB", "-61", "1e30", "loud", "nan", ""] {
            assert_eq!(read(text, &mut gain, [0.0, 1.0], &ends), None, "{text}");
        }
    }

    #[test]
    fn an_end_may_be_given_in_another_unit() {
        let ends = texts("1 us", "1000000 us");
        assert_eq!(read("1000 ms", &mut time, [0.0, 1.0], &ends), Some(1.0));
        assert_eq!(read("0.001 ms", &mut time, [0.0, 1.0], &ends), Some(0.0));
        assert_eq!(read("1100 ms", &mut time, [0.0, 1.0], &ends), None);
        assert_eq!(read("0.0009 ms", &mut time, [0.0, 1.0], &ends), None);
    }

    #[test]
    fn numbers_lead_and_units_follow() {
        assert_eq!(split("12.5 ms"), Some((12.5, "ms")));
        assert_eq!(split("-3e-2µs"), Some((-0.03, "µs")));
        assert_eq!(split("inf dB"), None);
        assert_eq!(split("off"), None);
    }
}
