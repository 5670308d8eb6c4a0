//! The half plane (r, z) of a body of revolution, cut into eight-node quadrilaterals.

/// Half steps (across, along) of a cell's nodes from its first corner: corners, then edge middles,
/// counter-clockwise when `across` is r and `along` is z.
const CELL: [[usize; 2]; 8] = [
    [0, 0],
    [2, 0],
    [2, 2],
    [0, 2],
    [1, 0],
    [2, 1],
    [1, 2],
    [0, 1],
];

/// Local coordinates of a cell's nodes, −1 to 1, as [`Meridian::cells`] numbers them.
pub(crate) const CELL_NODES: [[f64; 2]; 8] = [
    [-1.0, -1.0],
    [1.0, -1.0],
    [1.0, 1.0],
    [-1.0, 1.0],
    [0.0, -1.0],
    [1.0, 0.0],
    [0.0, 1.0],
    [-1.0, 0.0],
];

/// Sides of a cell as local nodes, start, middle, end, counter-clockwise; and the step to the cell
/// on the other side.
const SIDES: [([usize; 3], [isize; 2]); 4] = [
    ([0, 4, 1], [0, -1]),
    ([1, 5, 2], [1, 0]),
    ([2, 6, 3], [0, 1]),
    ([3, 7, 0], [-1, 0]),
];

/// A meridian: nodes and cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Meridian {
    /// (r, z) of each node, in m.
    pub nodes_m: Vec<[f64; 2]>,
    /// Node numbers of each cell: corners, then edge middles.
    pub cells: Vec<[u32; 8]>,
    /// Sides that touch the air: nodes from start over middle to end, the body on the left.
    pub sides: Vec<[u32; 3]>,
    /// Node at each half step (across, along), or `u32::MAX`.
    grid: Vec<u32>,
    half_steps_across: usize,
}

impl Meridian {
    /// The cells of a grid of `across` × `along` for which `present` holds, with nodes where
    /// `place_m` puts the half steps (across, along). Sides on the axis touch no air.
    pub fn new(
        [across, along]: [usize; 2],
        present: impl Fn(usize, usize) -> bool,
        place_m: impl Fn(usize, usize) -> [f64; 2],
    ) -> Self {
        let width = 2 * across + 1;
        let mut meridian = Self {
            nodes_m: Vec::new(),
            cells: Vec::new(),
            sides: Vec::new(),
            grid: vec![u32::MAX; width * (2 * along + 1)],
            half_steps_across: width,
        };
        for j in 0..along {
            for i in (0..across).filter(|&i| present(i, j)) {
                let cell = CELL.map(|[a, b]| meridian.node(2 * i + a, 2 * j + b, &place_m));
                meridian.cells.push(cell);
                for (nodes, [di, dj]) in SIDES {
                    let (Some(ni), Some(nj)) = (i.checked_add_signed(di), j.checked_add_signed(dj))
                    else {
                        meridian.expose(nodes.map(|node| cell[node]));
                        continue;
                    };
                    if ni >= across || nj >= along || !present(ni, nj) {
                        meridian.expose(nodes.map(|node| cell[node]));
                    }
                }
            }
        }
        meridian
    }

    /// Number of the node at a half step, made if it is new.
    fn node(
        &mut self,
        across: usize,
        along: usize,
        place_m: &impl Fn(usize, usize) -> [f64; 2],
    ) -> u32 {
        let slot = along * self.half_steps_across + across;
        if self.grid[slot] == u32::MAX {
            self.grid[slot] = self.nodes_m.len() as u32;
            self.nodes_m.push(place_m(across, along));
        }
        self.grid[slot]
    }

    fn expose(&mut self, side: [u32; 3]) {
        if side
            .iter()
            .any(|&node| self.nodes_m[node as usize][0] > 0.0)
        {
            self.sides.push(side);
        }
    }

    /// Number of the node at the half step (across, along), if there is one.
    #[must_use]
    pub fn node_at(&self, across: usize, along: usize) -> Option<u32> {
        let slot = along * self.half_steps_across + across;
        (across < self.half_steps_across)
            .then(|| self.grid.get(slot).copied())
            .flatten()
            .filter(|&node| node != u32::MAX)
    }

    /// Volume of the body, in m³.
    #[must_use]
    pub fn volume_m3(&self) -> f64 {
        self.cells
            .iter()
            .map(|cell| {
                let nodes = cell.map(|node| self.nodes_m[node as usize]);
                super::fourier::volume_m3(&nodes)
            })
            .sum()
    }
}
