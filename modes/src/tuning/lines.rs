//! The lines of a Scala file, numbered, without its comments.

use super::ScalaError;
use std::ops::RangeInclusive;

/// The text of a file: UTF-8 or UTF-16 with a mark in front, UTF-8 without, or else Latin-1, which
/// all older files are in.
pub(super) fn decode(file: &[u8]) -> String {
    let wide = |unit: fn([u8; 2]) -> u16| {
        let units = file.as_chunks().0[1..].iter().map(|pair| unit(*pair));
        char::decode_utf16(units)
            .map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect()
    };
    match file {
        [0xff, 0xfe, ..] => wide(u16::from_le_bytes),
        [0xfe, 0xff, ..] => wide(u16::from_be_bytes),
        _ => {
            let file = file.strip_prefix(b"\xef\xbb\xbf").unwrap_or(file);
            let latin_1 = || file.iter().copied().map(char::from).collect();
            str::from_utf8(file).map_or_else(|_| latin_1(), str::to_owned)
        }
    }
}

/// `text` without space around it and without control characters, which might upset a terminal.
pub(super) fn printable(text: &str) -> String {
    text.trim().replace(char::is_control, " ")
}

/// One line, without its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Line<'a> {
    /// Counted from 1, comments included.
    pub(super) number: usize,
    pub(super) text: &'a str,
}

/// Those lines of a text that are not comments.
///
/// Lines end as on Unix, Windows or the old Macintosh.
#[derive(Debug)]
pub(super) struct Lines<'a> {
    rest: &'a str,
    number: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn of(text: &'a str) -> Self {
        Self {
            rest: text,
            number: 0,
        }
    }

    /// The next line that is not blank either, or an error that the file ends before what is
    /// `missing`.
    pub(super) fn filled(
        &mut self,
        missing: impl FnOnce() -> String,
    ) -> Result<Line<'a>, ScalaError> {
        self.find(|line| !line.text.trim().is_empty())
            .ok_or_else(|| self.end(missing()))
    }

    pub(super) fn end(&self, missing: String) -> ScalaError {
        ScalaError::End {
            line: self.number.max(1),
            missing,
        }
    }

    fn any(&mut self) -> Option<Line<'a>> {
        if self.rest.is_empty() {
            return None;
        }
        let (text, rest) = match self.rest.find(['\n', '\r']) {
            Some(end) => {
                let (text, rest) = self.rest.split_at(end);
                let after = rest.strip_prefix("\r\n");
                (text, after.unwrap_or(&rest[1..]))
            }
            None => (self.rest, ""),
        };
        self.rest = rest;
        self.number += 1;
        Some(Line {
            number: self.number,
            text,
        })
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        loop {
            let line = self.any()?;
            if !line.text.starts_with('!') {
                return Some(line);
            }
        }
    }
}

impl Line<'_> {
    /// The first word, which other text may follow.
    pub(super) fn word(&self) -> &str {
        self.text.split_whitespace().next().unwrap_or_default()
    }

    /// The first word as a whole number in `allowed`, or an error that says what `it` must be.
    pub(super) fn whole(&self, it: &str, allowed: RangeInclusive<i32>) -> Result<i32, ScalaError> {
        let number = self.word().parse().ok();
        number
            .filter(|number| allowed.contains(number))
            .ok_or_else(|| {
                let (low, high) = allowed.into_inner();
                self.error(format!("{it} must be a whole number from {low} to {high}"))
            })
    }

    /// An error about this line.
    pub(super) fn error(&self, fault: impl Into<String>) -> ScalaError {
        const LONGEST: usize = 40;
        let mut text = printable(self.text);
        if let Some((end, _)) = text.char_indices().nth(LONGEST) {
            text.truncate(end);
            text.push('…');
        }
        ScalaError::Line {
            line: self.number,
            found: text,
            fault: fault.into(),
        }
    }
}
