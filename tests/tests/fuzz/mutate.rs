//! Good files gone wrong.

use idiophone_tests::Noise;

/// Numbers at and beyond the ends of what numbers can be.
const NUMBERS: [&str; 20] = [
    "0",
    "-0",
    "-1",
    "1",
    "0.5",
    "127",
    "128",
    "255",
    "65536",
    "2147483647",
    "2147483648",
    "-2147483649",
    "18446744073709551615",
    "18446744073709551616",
    "1e-320",
    "1e38",
    "1e39",
    "1e308",
    "-1e308",
    "1e999",
];
/// Words that texts may stumble over.
const WORDS: [&str; 16] = [
    "nan",
    "inf",
    "null",
    "true",
    "\"",
    "\\",
    "\"\"",
    "[]",
    "{}",
    "[[",
    "}",
    "\n",
    "\u{0}",
    "\u{1f514}",
    "=",
    "#",
];

/// A place in something of some length, its end included.
fn place(noise: &mut Noise, len: usize) -> usize {
    noise.below(len as u64 + 1) as usize
}

/// A short piece of something of some length.
fn piece(noise: &mut Noise, len: usize) -> std::ops::Range<usize> {
    let start = place(noise, len);
    let most = [1, 8, 64, len][noise.below(4) as usize];
    start..(start + place(noise, most)).min(len)
}

/// A text with one to four changes.
pub(crate) fn text(noise: &mut Noise, good: &str) -> String {
    let mut letters: Vec<char> = good.chars().collect();
    for _ in 0..=noise.below(4) {
        change(noise, &mut letters);
    }
    letters.into_iter().collect()
}

fn change(noise: &mut Noise, text: &mut Vec<char>) {
    let range = piece(noise, text.len());
    match noise.below(8) {
        0 => {
            text.drain(range);
        }
        1 => {
            let twice: Vec<char> = text[range.clone()].to_vec();
            text.splice(range.start..range.start, twice);
        }
        2 => {
            let word = WORDS[noise.below(WORDS.len() as u64) as usize];
            text.splice(range.start..range.start, word.chars());
        }
        3 if !range.is_empty() => {
            let code = noise.below(0x250) as u32;
            text[range.start] = char::from_u32(code).unwrap_or('?');
        }
        4 => text.truncate(range.start),
        _ => replace_number(noise, text, range.start),
    }
}

/// Puts an extreme in the place of the number that follows a place.
fn replace_number(noise: &mut Noise, text: &mut Vec<char>, from: usize) {
    let digit = |letter: &char| letter.is_ascii_digit();
    let Some(start) = text[from..].iter().position(digit).map(|at| from + at) else {
        return;
    };
    let of = |letter: &char| digit(letter) || ".+-eE_".contains(*letter);
    let len = text[start..].iter().take_while(|letter| of(letter)).count();
    let number = NUMBERS[noise.below(NUMBERS.len() as u64) as usize];
    text.splice(start..start + len, number.chars());
}

/// Bytes with one to four changes.
pub(crate) fn bytes(noise: &mut Noise, good: &[u8]) -> Vec<u8> {
    let mut bytes = good.to_vec();
    for _ in 0..=noise.below(4) {
        let range = piece(noise, bytes.len());
        match noise.below(6) {
            0 => {
                bytes.drain(range);
            }
            1 => {
                let twice = bytes[range.clone()].to_vec();
                bytes.splice(range.start..range.start, twice);
            }
            2 => bytes.truncate(range.start),
            3 if !range.is_empty() => bytes[range.start] ^= 1 << noise.below(8),
            4 => bytes[range].fill_with(|| noise.below(256) as u8),
            _ => overwrite(noise, &mut bytes, range.start),
        }
    }
    bytes
}

/// Writes an extreme number over what stands at a place.
fn overwrite(noise: &mut Noise, bytes: &mut [u8], at: usize) {
    let doubles = [
        0.0,
        -1.0,
        f64::NAN,
        f64::INFINITY,
        1e308,
        1e-320,
        1e9,
        1e12,
        -1e9,
    ];
    let double = doubles[noise.below(doubles.len() as u64) as usize];
    let number = match noise.below(4) {
        0 => double.to_le_bytes().to_vec(),
        1 => (double as f32).to_le_bytes().to_vec(),
        2 => u64::MAX.to_le_bytes().to_vec(),
        _ => u32::MAX.to_le_bytes().to_vec(),
    };
    // Numbers stand at multiples of four from the end of the header, wherever that is.
    for (old, new) in bytes[at..].iter_mut().zip(number) {
        *old = new;
    }
}
