//! The letters of "The End" (O'Brien et al. 2002, Figure 1).

use super::super::Soup;
use super::prism;

/// A letter's outline in squares of a grid, counter-clockwise; a stroke is two wide.
type Outline = &'static [[i32; 2]];

const T: Outline = &[
    [3, 0],
    [5, 0],
    [5, 8],
    [8, 8],
    [8, 10],
    [0, 10],
    [0, 8],
    [3, 8],
];

const H: Outline = &[
    [0, 0],
    [2, 0],
    [2, 4],
    [4, 4],
    [4, 0],
    [6, 0],
    [6, 6],
    [2, 6],
    [2, 10],
    [0, 10],
];

/// Slit on the right, as a lower-case e is.
const SMALL_E: Outline = &[
    [0, 0],
    [6, 0],
    [6, 1],
    [2, 1],
    [2, 3],
    [6, 3],
    [6, 7],
    [0, 7],
];

const E: Outline = &[
    [0, 0],
    [7, 0],
    [7, 2],
    [2, 2],
    [2, 4],
    [6, 4],
    [6, 6],
    [2, 6],
    [2, 8],
    [7, 8],
    [7, 10],
    [0, 10],
];

const N: Outline = &[
    [0, 0],
    [2, 0],
    [2, 5],
    [4, 5],
    [4, 0],
    [6, 0],
    [6, 7],
    [0, 7],
];

/// Its bowl is open to the stem by a slit, so that one line goes round it.
const D: Outline = &[
    [0, 0],
    [6, 0],
    [6, 10],
    [4, 10],
    [4, 7],
    [0, 7],
    [0, 3],
    [4, 3],
    [4, 2],
    [0, 2],
];

/// Letters, where each starts and what it is called.
const WORD: [(Outline, i32, &str); 6] = [
    (T, 0, "T"),
    (H, 9, "h"),
    (SMALL_E, 16, "e"),
    (E, 26, "E"),
    (N, 34, "n"),
    (D, 41, "d"),
];

/// Six letters, each an object of its own, `height_m` high and a fifth of that thick.
#[must_use]
pub fn the_end(height_m: f64) -> Soup {
    let square = 0.1 * height_m;
    let mut word = Soup::default();
    for (outline, start, name) in WORD {
        let outline: Vec<[f64; 2]> = outline
            .iter()
            .map(|&[x, y]| [square * f64::from(x + start), square * f64::from(y)])
            .collect();
        let mut letter = prism(&outline, 2.0 * square);
        name.clone_into(&mut letter.objects[0].name);
        word.append(&letter);
    }
    word
}
