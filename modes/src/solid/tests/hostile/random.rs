//! Bytes and triangles by chance.

use super::files::*;
use crate::factory::Silent;
use crate::solid::tests::nodes;
use crate::solid::{Meshing, Repair, Soup, mesh_solid, parse_obj, repair};

/// A generator of Marsaglia 2003, for bytes that no one would write.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % most as u64) as usize
    }
}

/// A cube's file with pieces swapped, doubled, cut out or replaced by words that may mean something.
fn spoilt(random: &mut Random) -> Vec<u8> {
    const WORDS: [&str; 14] = [
        "v", "f", "o", "-1", "0", "9", "1e308", "-0.0", "nan", "\n", "\\\n", "1//", "/", "\u{fe}",
    ];
    let cube = cube();
    let mut words: Vec<&str> = cube.split_inclusive([' ', '\n']).collect();
    for _ in 0..1 + random.below(6) {
        let at = random.below(words.len());
        match random.below(4) {
            0 => words[at] = WORDS[random.below(WORDS.len())],
            1 => words.insert(at, WORDS[random.below(WORDS.len())]),
            2 => drop(words.remove(at)),
            _ => words.swap(at, 0),
        }
    }
    let mut bytes = words.concat().into_bytes();
    if random.below(4) == 0 {
        let at = random.below(bytes.len());
        bytes[at] = random.below(256) as u8;
    }
    bytes
}

#[test]
fn no_bytes_make_it_panic() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut read = 0;
    for _ in 0..4_000 {
        let bytes = spoilt(&mut random);
        if let Ok(file) = parse_obj(&bytes, "a.obj", None) {
            read += usize::from(repair(&file.soup, &Repair::default()).is_ok());
        }
    }
    // Some are still solids, or nothing behind the reader was tried.
    assert!(read > 100, "{read}");
}

/// Triangles between points of a coarse grid: everything coincides, crosses and lies double.
#[test]
fn no_triangles_make_it_panic() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let mut solids = 0;
    let how = Meshing {
        most_nodes: 4_000,
        ..nodes(300)
    };
    for _ in 0..300 {
        let points = (0..4 + random.below(12)).map(|_| [0; 3].map(|_| random.below(4) as f64));
        let points: Vec<[f64; 3]> = points.collect();
        let count = 4 + random.below(40);
        let triangles = (0..count).map(|_| [0; 3].map(|_| random.below(points.len()) as u32));
        let soup = Soup::single(points.clone(), triangles.collect());
        if let Ok(surface) = repair(&soup, &Repair::default()) {
            solids += usize::from(mesh_solid(&surface, &how, &Silent).is_ok());
        }
    }
    assert!(solids > 20, "{solids}");
}
