//! Nodes and the elements that join them.

mod bar;
mod blocks;
mod cells;
mod revolve;
mod round;
mod surface;
mod tube;

use crate::fem::{tet10_volume, wedge23_volume};

pub use bar::{BarGrid, BarPart, bar_hex20};
pub use blocks::{Block, blocks_tet10, brick_tet10};
pub use cells::{cells_hex20, hollow_cube_hex20};
pub use revolve::revolve_hex20;
pub use round::{ball_tet10, cylinder_tet10, hollow_ball_tet10};
pub(crate) use surface::{Face, TET_FACES};
pub use tube::{TubeGrid, tube_hex20, tube_tet4, tube_tet10};

/// A volume mesh of one kind of element.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Node coordinates, in m.
    pub nodes: Vec<[f64; 3]>,
    /// The elements.
    pub elements: Elements,
}

impl Mesh {
    /// Volume of the curved tetrahedra or wedges, in m³; 0 of other elements.
    pub(crate) fn volume_m3(&self) -> f64 {
        let node = |node: u32| self.nodes[node as usize];
        match &self.elements {
            Elements::Tet10(tets) => tets.iter().map(|tet| tet10_volume(&tet.map(node))).sum(),
            Elements::Wedge23(wedges) => {
                let volume = |wedge: &[u32; 23]| wedge23_volume(&wedge.map(node));
                wedges.iter().map(volume).sum()
            }
            Elements::Tet4(_) | Elements::Hex20(_) => 0.0,
        }
    }
}

/// Node numbers of each element.
#[derive(Clone, Debug, PartialEq)]
pub enum Elements {
    /// Four-node linear tetrahedra, positively oriented.
    Tet4(Vec<[u32; 4]>),
    /// Ten-node tetrahedra: corners, then the middles of [`crate::fem::TET10_EDGES`].
    Tet10(Vec<[u32; 10]>),
    /// Twenty-node serendipity hexahedra; local order as in [`crate::fem::HEX20_NODES`].
    Hex20(Vec<[u32; 20]>),
    /// Twenty-three-node wedges of a wall: ten nodes of a triangle on its inner side, counter-clockwise
    /// seen from outside, then the ten over them, then three halfway between the corners. Of the ten the
    /// corners come first, then two nodes on each side in turn, then the middle.
    Wedge23(Vec<[u32; 23]>),
}

impl Elements {
    /// The node numbers of every element in turn.
    pub fn iter(&self) -> Box<dyn Iterator<Item = &[u32]> + '_> {
        match self {
            Self::Tet4(elements) => Box::new(elements.iter().map(<[u32; 4]>::as_slice)),
            Self::Tet10(elements) => Box::new(elements.iter().map(<[u32; 10]>::as_slice)),
            Self::Hex20(elements) => Box::new(elements.iter().map(<[u32; 20]>::as_slice)),
            Self::Wedge23(elements) => Box::new(elements.iter().map(<[u32; 23]>::as_slice)),
        }
    }
}

/// A node's number.
fn number(index: usize) -> u32 {
    u32::try_from(index).expect("meshes have fewer than 2^32 nodes")
}
