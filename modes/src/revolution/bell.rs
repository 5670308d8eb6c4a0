//! Tubes hung from one end: chimes, and tubular bells with a plug in the top.

use super::Wall;
use crate::Family;
use crate::fem::Meridian;
use crate::shape::Tube;

/// A tube with a plug in its upper end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bell {
    /// The tube.
    pub tube: Tube,
    /// Length of the plug, in m; 0 for an open tube.
    pub plug_m: f64,
    /// Where the tube is held, as a share of its length from the top.
    pub hung_at: f64,
    /// Where the felt touches, as a share of its length from the top.
    pub felt_at: f64,
}

/// Cells from the axis to the wall, where there is a plug, for each layer of the wall.
const PLUG_CELLS: usize = 2;

impl Bell {
    /// `tube` without a plug, hung at the node of its lowest mode.
    #[must_use]
    pub fn open(tube: Tube) -> Self {
        Self {
            tube,
            plug_m: 0.0,
            hung_at: 0.2242,
            felt_at: 0.03,
        }
    }

    /// The meridian of this bell, of cells no longer than `max_element_m` and `layers` of them through
    /// the wall, with the top at z = 0 and the tube hanging down from it: position 0 of the strike
    /// line is the top.
    #[must_use]
    pub fn wall(&self, max_element_m: f64, layers: usize) -> Wall {
        bell(self, self.cells(max_element_m), layers)
    }

    /// Cells along the plug and along the rest of the tube.
    #[must_use]
    pub fn cells(&self, max_element_m: f64) -> [usize; 2] {
        #[expect(clippy::cast_sign_loss, reason = "lengths are positive")]
        let count = |length_m: f64| (length_m / max_element_m).ceil().max(0.0) as usize;
        [
            count(self.plug_m),
            count(self.tube.length_m - self.plug_m).max(3),
        ]
    }
}

/// The meridian of `bell` with `cells` along its plug and along the rest, `layers` of them through the
/// wall.
#[must_use]
pub fn bell(bell: &Bell, cells: [usize; 2], layers: usize) -> Wall {
    let tube = &bell.tube;
    let [plug, open] = cells;
    let along = plug + open;
    let inside = if plug > 0 { layers * PLUG_CELLS } else { 0 };
    let height = |j: usize| {
        let j = j as f64;
        let split = 2.0 * plug as f64;
        // Strictly rising z: from the lower end up, the plug last.
        if j <= 2.0 * open as f64 {
            -tube.length_m + (tube.length_m - bell.plug_m) * j / (2.0 * open as f64)
        } else {
            -bell.plug_m * (1.0 - (j - 2.0 * open as f64) / split)
        }
    };
    let radius = |i: usize| {
        if i <= 2 * inside && inside > 0 {
            tube.inner_radius_m() * i as f64 / (2 * inside) as f64
        } else {
            tube.inner_radius_m() + tube.wall_m * (i - 2 * inside) as f64 / (2 * layers) as f64
        }
    };
    let meridian = Meridian::new(
        [inside + layers, along],
        |i, j| i >= inside || j >= open,
        |i, j| [radius(i), height(j)],
    );
    let outer = |j: usize| {
        meridian
            .node_at(2 * (inside + layers), j)
            .unwrap_or(u32::MAX)
    };
    let line: Vec<u32> = (0..=2 * along).rev().map(outer).collect();
    let nearest = |share: f64| {
        let below =
            |node: &u32| (meridian.nodes_m[*node as usize][1] + share * tube.length_m).abs();
        line.iter()
            .copied()
            .min_by(|p, q| below(p).total_cmp(&below(q)))
    };
    let heard = meridian
        .sides
        .iter()
        .copied()
        .filter(|side| {
            let [r, z] = meridian.nodes_m[side[1] as usize];
            let wall = r > tube.inner_radius_m() + 0.9 * tube.wall_m;
            wall || z == 0.0 || z == -tube.length_m
        })
        .collect();
    Wall {
        length_m: tube.length_m,
        line_normals: vec![[1.0, 0.0]; line.len()],
        mirrors: plug == 0,
        held: nearest(bell.hung_at).into_iter().collect(),
        felt: nearest(bell.felt_at).into_iter().collect(),
        line,
        heard,
        mouth_m: None,
        family: Family::Wall,
        meridian,
    }
}
