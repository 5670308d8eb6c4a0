//! Files that chance has been at: whatever comes of them is an error with a line, or a tuning.

use super::super::{KeyboardMap, Scale, Tuning, nearest_body};

const SCL: &[u8] =
    b"! a.scl\n!\nA scale\n 7\n!\n 9/8\n 386.31371\n 4/3\n 3/2 fifth\n 5/3\n -12.5\n 2\n";
const KBM: &[u8] =
    b"! a.kbm\n12\n0\n127\n60\n69\n440.0\n7\n! Mapping\n0\nx\n1\nx\n2\n3\nx\n4\n-9\n5\nx\n6\n";

const PIECES: [&[u8]; 22] = [
    b"\n",
    b"\r",
    b"!",
    b"/",
    b".",
    b"-",
    b"0",
    b" 1/0 ",
    b"x",
    b"\0",
    b"\xff\xfe",
    b"\xef\xbb\xbf",
    b"\xc3",
    b"NaN",
    b"1e308",
    b"-2147483648",
    b"99999999999999999999",
    b"120000.0",
    b"\n\n\n\n",
    b"127",
    b"1000000",
    "٣½\u{2028}".as_bytes(),
];

/// Steele, Lea & Flood 2014.
struct SplitMix(u64);

impl SplitMix {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n as u64) as usize
    }

    /// The file with a few bytes changed, lost, doubled or put in.
    fn mangle(&mut self, file: &[u8]) -> Vec<u8> {
        let mut file = file.to_vec();
        for _ in 0..self.below(4) {
            let at = self.below(file.len() + 1);
            let end = (at + self.below(8)).min(file.len());
            match self.below(5) {
                0 => file.truncate(at),
                1 => drop(file.drain(at..end)),
                2 => drop(file.splice(at..at, file[at..end].to_vec())),
                3 => drop(file.splice(at..end, PIECES[self.below(PIECES.len())].to_vec())),
                _ => {
                    if let Some(byte) = file.get_mut(at) {
                        *byte ^= 1 << self.below(8);
                    }
                }
            }
        }
        file
    }
}

fn names_its_line(error: &impl ToString, file: &[u8]) {
    let text = error.to_string();
    let number = text.strip_prefix("line ").unwrap();
    let number: usize = number.split(':').next().unwrap().parse().unwrap();
    assert!((1..=file.len() + 1).contains(&number), "{text}");
    assert!(!text.contains(char::is_control), "{text:?}");
}

#[test]
fn no_file_gets_past_an_error_or_a_tuning() {
    let mut random = SplitMix(1523);
    let (mut scales, mut maps) = (vec![Scale::default()], vec![KeyboardMap::default()]);
    let mut refused = 0;
    for _ in 0..30_000 {
        let file = random.mangle(SCL);
        match Scale::parse(&file) {
            Ok(scale) => scales.push(scale),
            Err(error) => {
                names_its_line(&error, &file);
                refused += 1;
            }
        }
        let file = random.mangle(KBM);
        match KeyboardMap::parse(&file) {
            Ok(map) => maps.push(map),
            Err(error) => {
                names_its_line(&error, &file);
                refused += 1;
            }
        }
    }
    let read = scales.len() + maps.len();
    assert!(refused > 10_000 && read > 10_000, "{refused}, {read}");
    for (scale, map) in scales.iter().zip(&maps) {
        let tuning = Tuning::new(scale, map);
        for key in 0..=255 {
            let (hz, semitones) = (tuning.hz(key), tuning.offset_semitones(key));
            assert_eq!(hz.is_some(), semitones.is_some());
            let Some((hz, semitones)) = hz.zip(semitones) else {
                continue;
            };
            assert!(hz.is_finite() && hz > 0.0 && semitones.is_finite());
            let (_, by) = nearest_body(hz, u128::MAX).unwrap();
            assert!(
                by.abs() <= 0.5 + 1e-9 || !(8.2..12_544.0).contains(&hz),
                "{hz}, {by}"
            );
        }
    }
}
