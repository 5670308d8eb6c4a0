//! A body-centred cubic lattice over a box: the corners of its cells and their middles.

use super::vector::sub;

/// Steps to the fourteen neighbours in half cells: along the axes, then along the diagonals.
pub(super) const NEIGHBOURS: [[i64; 3]; 14] = [
    [2, 0, 0],
    [0, 2, 0],
    [0, 0, 2],
    [1, 1, 1],
    [1, 1, -1],
    [1, -1, 1],
    [1, -1, -1],
    [-2, 0, 0],
    [0, -2, 0],
    [0, 0, -2],
    [-1, -1, -1],
    [-1, -1, 1],
    [-1, 1, -1],
    [-1, 1, 1],
];

/// Points of a lattice at most: they take some 100 bytes each.
const MOST_POINTS: f64 = 6e6;

/// A lattice whose outer cells lie around the box, so that the box's own sides are planes of points.
pub(super) struct Lattice {
    /// The lattice's first corner, in m.
    low_m: [f64; 3],
    /// Sides of a cell, in m.
    pub(super) cell_m: [f64; 3],
    /// Cells along each axis.
    cells: [i64; 3],
}

impl Lattice {
    /// Cells of about `edge_m` that fit the box whole.
    pub(super) fn fitting((low_m, high_m): ([f64; 3], [f64; 3]), edge_m: f64) -> Self {
        let side = sub(high_m, low_m);
        let within = side.map(|side| (side / edge_m).round().max(1.0));
        let cell_m = [0, 1, 2].map(|a| side[a] / within[a]);
        Self {
            low_m: [0, 1, 2].map(|a| low_m[a] - cell_m[a]),
            cell_m,
            cells: within.map(|count| count as i64 + 2),
        }
    }

    /// `edge_m`, or the least more with which a lattice over the box has no more points than it may.
    pub(super) fn feasible_m((low_m, high_m): ([f64; 3], [f64; 3]), mut edge_m: f64) -> f64 {
        let side = sub(high_m, low_m);
        let points =
            |edge_m: f64| 2.0 * side.map(|side| side / edge_m + 4.0).iter().product::<f64>();
        edge_m = edge_m.max(1e-6 * side.into_iter().fold(0.0, f64::max));
        while points(edge_m) > MOST_POINTS {
            edge_m *= 1.02;
        }
        edge_m
    }

    /// Number of points: two to a cell, those of the last planes included.
    pub(super) fn len(&self) -> usize {
        2 * self
            .cells
            .iter()
            .map(|&n| n.unsigned_abs() as usize + 1)
            .product::<usize>()
    }

    /// Number of the point at `half` cells from the first corner; all three even or all odd.
    pub(super) fn number(&self, half: [i64; 3]) -> Option<usize> {
        let cell = half.map(|x| x.div_euclid(2));
        let inside = (0..3).all(|a| (0..=self.cells[a]).contains(&cell[a]));
        inside.then(|| {
            let at = (cell[0] * (self.cells[1] + 1) + cell[1]) * (self.cells[2] + 1) + cell[2];
            2 * at.unsigned_abs() as usize + half[0].rem_euclid(2).unsigned_abs() as usize
        })
    }

    /// Whether a point is in the box or on its sides.
    pub(super) fn in_box(&self, number: usize) -> bool {
        let half = self.half(number);
        (0..3).all(|a| (2..=2 * (self.cells[a] - 1)).contains(&half[a]))
    }

    /// Half cells from the first corner.
    pub(super) fn half(&self, number: usize) -> [i64; 3] {
        let (at, odd) = ((number / 2) as i64, (number % 2) as i64);
        let (ny, nz) = (self.cells[1] + 1, self.cells[2] + 1);
        [at / nz / ny, at / nz % ny, at % nz].map(|cell| 2 * cell + odd)
    }

    /// Where a point is, in m.
    pub(super) fn place(&self, number: usize) -> [f64; 3] {
        let half = self.half(number);
        [0, 1, 2].map(|a| self.low_m[a] + 0.5 * self.cell_m[a] * half[a] as f64)
    }

    /// The neighbour in a direction of [`NEIGHBOURS`].
    pub(super) fn neighbour(&self, number: usize, direction: usize) -> Option<usize> {
        let (half, step) = (self.half(number), NEIGHBOURS[direction]);
        self.number([0, 1, 2].map(|a| half[a] + step[a]))
    }

    /// The tetrahedra: every edge between the middles of two cells with each side of the face between
    /// them. The first two corners are the middles.
    pub(super) fn tetrahedra(&self) -> impl Iterator<Item = [usize; 4]> + '_ {
        let middles = (0..self.len()).filter(|number| number % 2 == 1);
        middles.flat_map(move |middle| (0..12).filter_map(move |side| self.beside(middle, side)))
    }

    /// The tetrahedron of a cell's middle with one of the four sides of the next face along one of the
    /// three axes.
    fn beside(&self, middle: usize, side: usize) -> Option<[usize; 4]> {
        const RING: [[i64; 2]; 5] = [[1, 1], [-1, 1], [-1, -1], [1, -1], [1, 1]];
        let (axis, half) = (side / 4, self.half(middle));
        let step = |along: i64, [across, over]: [i64; 2]| {
            let mut to = half;
            to[axis] += along;
            to[(axis + 1) % 3] += across;
            to[(axis + 2) % 3] += over;
            self.number(to)
        };
        let [from, to] = [RING[side % 4], RING[side % 4 + 1]];
        Some([middle, step(2, [0, 0])?, step(1, from)?, step(1, to)?])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solid::vector::six_volumes;

    #[test]
    fn tetrahedra_face_out_and_fill_the_box() {
        let lattice = Lattice::fitting(([0.0; 3], [4.0, 3.0, 2.0]), 1.0);
        let volumes: Vec<f64> = lattice
            .tetrahedra()
            .map(|tet| six_volumes(tet.map(|n| lattice.place(n))) / 6.0)
            .collect();
        assert!(volumes.iter().all(|v| (v - 1.0 / 12.0).abs() < 1e-12));
        assert!(volumes.iter().sum::<f64>() > 24.0);
    }

    #[test]
    fn numbers_and_places_agree() {
        let lattice = Lattice::fitting(([0.0; 3], [4.0, 3.0, 2.0]), 1.0);
        for number in 0..lattice.len() {
            assert_eq!(lattice.number(lattice.half(number)), Some(number));
        }
    }
}
