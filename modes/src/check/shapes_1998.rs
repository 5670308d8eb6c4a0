//! The shapes of van den Doel & Pai 1998 against published roots, and what their strikes leave.

use super::{CheckError, Row, greater};
use crate::analytic::square_1998::{LOWEST_HZ, STRIKES_M, membrane, struck};
use crate::analytic::{ClosedMode, LSpectrum, TautString, bessel_zeros, clamped_plate_roots};
use crate::shape::BarEnds;
use crate::sound_map::{Hearing, SoundMap};
use std::f64::consts::PI;

const BLEVINS: &str = "Blevins 1979, table 8-1";

/// βL of thin bars, whose frequencies go as its square.
const BARS: [(&str, BarEnds, [f64; 3]); 3] = [
    (
        "bar clamped at both ends",
        BarEnds::Clamped,
        [4.730_040_74, 7.853_204_62, 10.995_607_8],
    ),
    (
        "bar free at both ends",
        BarEnds::Free,
        [4.730_040_74, 7.853_204_62, 10.995_607_8],
    ),
    (
        "cantilever",
        BarEnds::Cantilever,
        [1.875_104_07, 4.694_091_13, 7.854_757_44],
    ),
];

/// Zeros of J₀ to J₂ (DLMF §10.21).
const ZEROS: [[f64; 2]; 3] = [
    [2.404_825_557_695_77, 5.520_078_110_286_31],
    [3.831_705_970_207_51, 7.015_586_669_815_62],
    [5.135_622_301_840_68, 8.417_244_140_399_86],
];

/// λ² of the clamped round plate (Leissa 1969, table 2.1), good to four digits.
const PLATE: [[f64; 2]; 3] = [[10.2158, 39.771], [21.26, 60.82], [34.88, 84.58]];

/// Eigenvalues of the L of unit squares (Betcke & Trefethen 2005; Fox, Henrici & Moler 1967), and half
/// of their last digit.
const ELL: [(f64, f64); 3] = [
    (9.639_723_844_021_9, 5e-12),
    (15.197_252, 5e-7),
    (2.0 * PI * PI, 1e-12),
];

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = string();
    rows.extend(bars());
    rows.extend(round());
    rows.extend(ell());
    rows.extend(strikes());
    rows.push(map());
    Ok(rows)
}

/// A piano's C4.
fn string() -> Vec<Row> {
    let wire = TautString::from_wire([0.66, 0.0005], 7850.0, 2e11, 740.0);
    let n = 10u16;
    let wave_per_m = f64::from(n) * PI / wire.length_m;
    let square = (wire.tension_n + wire.bending_n_m2 * wave_per_m * wave_per_m) / wire.mass_kg_m;
    let expected = wave_per_m * square.sqrt() / (2.0 * PI);
    vec![Row::relative(
        "stiff string, partial 10",
        (expected, wire.hz(n), "Hz"),
        1e-12,
        "ω² = (T k² + EI k⁴)/μ",
    )]
}

fn bars() -> impl Iterator<Item = Row> {
    BARS.into_iter().flat_map(|(name, ends, roots)| {
        roots.into_iter().zip(1..).map(move |(published, index)| {
            Row::relative(
                format!("{name}, root {index}"),
                (published, ends.root(index), ""),
                5e-9,
                BLEVINS,
            )
        })
    })
}

fn round() -> Vec<Row> {
    let mut rows = Vec::new();
    for (order, (zeros, squares)) in (0u16..).zip(ZEROS.into_iter().zip(PLATE)) {
        let found = bessel_zeros(order, 10.0);
        rows.extend(
            (1..)
                .zip(zeros.into_iter().zip(found))
                .map(|(i, pair): (u16, _)| {
                    let (published, found) = pair;
                    let name = format!("circular membrane ({order},{i}), zero");
                    Row::relative(name, (published, found, ""), 1e-13, "DLMF §10.21")
                }),
        );
        let found = clamped_plate_roots(order, 10.0);
        rows.extend(
            (1..)
                .zip(squares.into_iter().zip(found))
                .map(|(i, pair): (u16, _)| {
                    let (published, found) = pair;
                    let name = format!("clamped round plate ({order},{i}), λ²");
                    Row::relative(
                        name,
                        (published, found * found, ""),
                        2e-4,
                        "Leissa 1969, table 2.1",
                    )
                }),
        );
    }
    rows
}

fn ell() -> Vec<Row> {
    const HIGHEST: f64 = 16.0;
    let spectrum = LSpectrum::new(HIGHEST);
    let roots = spectrum.roots();
    let mut rows: Vec<Row> = ELL
        .iter()
        .zip(&roots)
        .zip(1..)
        .map(|((&(published, digit), root), index): (_, u16)| {
            Row::absolute(
                format!("L of unit squares, eigenvalue {index}"),
                (published, root * root, ""),
                digit,
                "Fox, Henrici & Moler 1967; Betcke & Trefethen 2005",
            )
        })
        .collect();
    rows.push(Row::absolute(
        format!(
            "L of unit squares: motion left on the edge, {} modes",
            roots.len()
        ),
        (0.0, spectrum.worst_sine(), ""),
        1e-10,
        "sine of the angle (Betcke & Trefethen 2005)",
    ));
    let weyl = (3.0 * HIGHEST - 8.0) * HIGHEST / (4.0 * PI) + 5.0 / 18.0;
    rows.push(Row::absolute(
        format!("L of unit squares: modes up to wave number {HIGHEST}"),
        (weyl, roots.len() as f64, ""),
        2.0,
        "Weyl's law with perimeter and corners",
    ));
    rows
}

/// Half-waves of the loudest mode in Figs. 5 to 7.
const LOUDEST: [([f64; 2], &str); 3] = [([4.0, 4.0], "5"), ([2.0, 1.0], "6"), ([1.0, 1.0], "7")];

fn strikes() -> impl Iterator<Item = Row> {
    STRIKES_M
        .into_iter()
        .zip(LOUDEST)
        .map(|([x, y], (waves, figure))| {
            let found = struck([x, y]);
            let loudest = found.iter().fold(found[0], |loudest, mode| {
                let louder = mode.amplitude.abs() > (1.0 + 1e-9) * loudest.amplitude.abs();
                if louder { *mode } else { loudest }
            });
            let [m, n] = waves;
            Row::relative(
                format!("1998, Fig. {figure}: square membrane struck at ({x}, {y}), loudest mode"),
                (LOWEST_HZ * m.hypot(n) / 2f64.sqrt(), loudest.hz, "Hz"),
                1e-12,
                "greatest sin mπx sin nπy / √(m² + n²)",
            )
        })
}

/// Mirror images on the square sound alike, and the map knows.
fn map() -> Row {
    let modes = membrane().modes(4000.0);
    let hz = modes.iter().map(ClosedMode::hz).collect();
    let side = 24;
    let at = |i: usize| (i as f64 + 0.5) / side as f64;
    let map = SoundMap::new(Hearing::HUMAN, hz, [side, side], |mode, [row, column]| {
        modes[mode].displacement([at(column), at(row)])
    });
    let twins = (0..side * side).map(|i| {
        let (row, column) = (i / side, i % side);
        map.distance_db([row, column], [side - 1 - row, column])
    });
    Row::absolute(
        "1998, §5: sonic distance of strikes that mirror each other on the square, greatest",
        (0.0, twins.fold(0.0, greater), "dB"),
        1e-6,
        "symmetry",
    )
}

#[cfg(test)]
mod tests {
    #[test]
    fn all_rows_are_within_their_bounds() {
        for row in super::rows().unwrap() {
            assert!(row.ok, "{row:?}");
        }
    }
}
