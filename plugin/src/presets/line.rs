//! Which line of a text something is on.

use std::ops::Range;

/// The line, counted from 1, of a span's beginning; 1 without a span.
pub(super) fn line(text: &str, span: Option<Range<usize>>) -> usize {
    let at = span.map_or(0, |span| span.start.min(text.len()));
    let before = &text.as_bytes()[..at];
    1 + before.iter().filter(|byte| **byte == b'\n').count()
}

#[cfg(test)]
mod tests {
    use super::line;

    #[test]
    fn lines_are_counted_from_one() {
        assert_eq!(line("a\nb", None), 1);
        assert_eq!(line("a\nb", Some(0..1)), 1);
        assert_eq!(line("a\nb", Some(2..3)), 2);
        assert_eq!(line("a\nb", Some(99..100)), 2);
    }
}
