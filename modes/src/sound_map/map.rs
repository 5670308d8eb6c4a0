//! Timbre over a grid of strike points.

use super::{Hearing, Timbre};

/// The timbres of strikes on a grid of points, rows of so many columns each.
#[derive(Clone, Debug)]
pub struct SoundMap {
    hearing: Hearing,
    hz: Vec<f64>,
    columns: usize,
    timbres: Vec<Timbre>,
}

impl SoundMap {
    /// The map of a body with modes of `hz` on `rows` × `columns` points; `motion` gives the
    /// displacement of a mode at a row and column along the strike.
    #[must_use]
    pub fn new(
        hearing: Hearing,
        hz: Vec<f64>,
        [rows, columns]: [usize; 2],
        motion: impl Fn(usize, [usize; 2]) -> f64,
    ) -> Self {
        let timbre = |at: [usize; 2]| hearing.timbre((0..hz.len()).map(|mode| motion(mode, at)));
        let timbres = (0..rows)
            .flat_map(|row| (0..columns).map(move |column| [row, column]))
            .map(timbre)
            .collect();
        Self {
            hearing,
            hz,
            columns,
            timbres,
        }
    }

    /// Rows and columns.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        let columns = self.columns.max(1);
        [self.timbres.len() / columns, self.columns]
    }

    /// The sonic distance between strikes at two points (row, column), in dB.
    ///
    /// # Panics
    ///
    /// If a point is not on the grid.
    #[must_use]
    pub fn distance_db(&self, one: [usize; 2], other: [usize; 2]) -> f64 {
        let [one, other] = [one, other].map(|at| &self.timbres[at[0] * self.columns + at[1]]);
        self.hearing.distance_db(&self.hz, one, other)
    }

    /// The distance of every point from `one`, row by row, in dB: the map as it looks from there.
    ///
    /// # Panics
    ///
    /// If the point is not on the grid.
    #[must_use]
    pub fn from_point_db(&self, one: [usize; 2]) -> Vec<f64> {
        self.points()
            .map(|other| self.distance_db(one, other))
            .collect()
    }

    /// At every point, row by row, the distance to that of its four neighbours that differs most, in
    /// dB: where it is great, timbre changes fast.
    #[must_use]
    pub fn change_db(&self) -> Vec<f64> {
        let [rows, columns] = self.size();
        self.points()
            .map(|[row, column]| {
                let near = [
                    (row > 0).then(|| [row - 1, column]),
                    (column > 0).then(|| [row, column - 1]),
                    (row + 1 < rows).then(|| [row + 1, column]),
                    (column + 1 < columns).then(|| [row, column + 1]),
                ];
                let distances = near.into_iter().flatten();
                distances
                    .map(|other| self.distance_db([row, column], other))
                    .fold(0.0, f64::max)
            })
            .collect()
    }

    /// How many rows and columns of strike points, evenly spread from edge to edge, the body needs so
    /// that neighbouring ones differ by less than `distance_db`; nothing for a direction in which even
    /// neighbours of this grid differ by more, and which wants a finer map.
    #[must_use]
    pub fn points_needed(&self, distance_db: f64) -> [Option<usize>; 2] {
        let [rows, columns] = self.size();
        [
            self.needed(rows, [1, 0], distance_db),
            self.needed(columns, [0, 1], distance_db),
        ]
    }

    fn needed(&self, count: usize, way: [usize; 2], distance_db: f64) -> Option<usize> {
        let within = |step: &usize| self.farthest_db([step * way[0], step * way[1]]) < distance_db;
        // Steps up to the first that is too wide: all shorter ones are close enough.
        let widest = (1..count).take_while(within).last();
        if count < 2 {
            return Some(count);
        }
        widest.map(|step| (count - 1).div_ceil(step) + 1)
    }

    /// The greatest distance between points that are `apart`, in dB.
    fn farthest_db(&self, apart: [usize; 2]) -> f64 {
        let [rows, columns] = self.size();
        self.points()
            .map(|at| (at, [at[0] + apart[0], at[1] + apart[1]]))
            .filter(|(_, other)| other[0] < rows && other[1] < columns)
            .map(|(at, other)| self.distance_db(at, other))
            .fold(0.0, f64::max)
    }

    fn points(&self) -> impl Iterator<Item = [usize; 2]> {
        let [rows, columns] = self.size();
        (0..rows).flat_map(move |row| (0..columns).map(move |column| [row, column]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytic::{ClosedMode, RectangularMembrane};
    use std::f64::consts::{FRAC_PI_2, PI};

    const EVEN: Hearing = Hearing {
        sensitivity: |_| 1.0,
        range_db: 60.0,
    };

    /// Two modes whose energies are cos² and sin² of an angle that rises from `from` to `to`.
    fn turning(columns: usize, [from, to]: [f64; 2]) -> SoundMap {
        let angle = move |column: usize| from + (to - from) * column as f64 / (columns - 1) as f64;
        SoundMap::new(
            EVEN,
            vec![1.0, 2.0],
            [1, columns],
            move |mode, [_, column]| {
                if mode == 0 {
                    angle(column).cos()
                } else {
                    angle(column).sin()
                }
            },
        )
    }

    #[test]
    fn distances_along_a_line_by_hand() {
        let map = turning(3, [PI / 8.0, 3.0 * PI / 8.0]);
        assert_eq!(map.size(), [1, 3]);
        let [low, high] = [(PI / 8.0).sin(), (PI / 8.0).cos()].map(|x| 20.0 * x.log10());
        let middle = 10.0 * 0.5f64.log10();
        let near = (high - middle).hypot(low - middle);
        let far = 2f64.sqrt() * (high - low);
        for (found, expected) in map.from_point_db([0, 0]).into_iter().zip([0.0, near, far]) {
            assert!((found - expected).abs() < 1e-12);
        }
        assert!((map.change_db()[1] - near).abs() < 1e-12);
    }

    /// About 45° a small turn changes both levels by 20/ln 10 times twice itself: so many dB to a
    /// radian. Ends a little off ask for a little more.
    #[test]
    fn points_needed_are_the_change_over_the_distance() {
        let reach = 0.01;
        let map = turning(4001, [FRAC_PI_2 / 2.0 - reach, FRAC_PI_2 / 2.0 + reach]);
        let change_db = 2f64.sqrt() * 20.0 / 10f64.ln() * 2.0 * reach;
        for steps in [4.0, 9.5, 20.2] {
            let [rows, columns] = map.points_needed(change_db / steps);
            let expected = (steps * (1.0 + reach)).ceil() + 1.0;
            let found = columns.unwrap() as f64;
            assert!((found - expected).abs() < 1.5, "{found} {expected}");
            assert_eq!(rows, Some(1));
        }
        assert_eq!(map.points_needed(1e-9)[1], None);
    }

    /// Points that the symmetry of a square exchanges sound alike.
    #[test]
    fn a_square_s_map_has_its_symmetry() {
        let square = RectangularMembrane {
            sides_m: [1.0; 2],
            tension_n_m: 1e5,
            mass_kg_m2: 1.0,
        };
        // Up to a frequency, so that of a pair of equal ones both are taken.
        let modes = square.modes(2000.0);
        let hz = modes.iter().map(ClosedMode::hz).collect();
        let at = |i: usize| (i as f64 + 0.5) / 8.0;
        let map = SoundMap::new(Hearing::HUMAN, hz, [8, 8], |mode, [row, column]| {
            modes[mode].displacement([at(column), at(row)])
        });
        assert!(map.distance_db([1, 2], [1, 5]) < 1e-6);
        assert!(map.distance_db([1, 2], [6, 2]) < 1e-6);
        assert!(map.distance_db([1, 2], [3, 3]) > 1.0);
        // A mirror about the diagonal exchanges the members of pairs, which have one frequency.
        let levels = |p, q| map.distance_db(p, q);
        assert!((levels([1, 2], [3, 0]) - levels([2, 1], [0, 3])).abs() < 1e-6);
    }
}
