//! The whole mesh of a body of revolution.

use super::{Elements, Mesh, number};
use crate::fem::{CELL_NODES, HEX20_NODES, Meridian};
use std::f64::consts::TAU;

/// `meridian`, which must keep off the axis, turned about it: twenty-node hexahedra, `around` of them
/// to each cell.
#[must_use]
pub fn revolve_hex20(meridian: &Meridian, around: usize) -> Mesh {
    let columns = 2 * around;
    let slot = |node: u32, column: usize| node as usize * columns + column % columns;
    let mut ids = vec![u32::MAX; meridian.nodes_m.len() * columns];
    let (mut nodes, mut hexes) = (Vec::new(), Vec::new());
    for cell in &meridian.cells {
        for a in 0..around {
            hexes.push(HEX20_NODES.map(|[x, t, y]| {
                let node = cell[local_node([x, y])];
                let column = match t {
                    -1.0 => 2 * a,
                    0.0 => 2 * a + 1,
                    _ => 2 * a + 2,
                };
                let id = &mut ids[slot(node, column)];
                if *id == u32::MAX {
                    *id = number(nodes.len());
                    let [r, z] = meridian.nodes_m[node as usize];
                    let (sin, cos) = (TAU * column as f64 / columns as f64).sin_cos();
                    nodes.push([r * cos, r * sin, z]);
                }
                *id
            }));
        }
    }
    Mesh {
        nodes,
        elements: Elements::Hex20(hexes),
    }
}

/// Which of a meridian cell's nodes is at `place`.
fn local_node(place: [f64; 2]) -> usize {
    let node = CELL_NODES.iter().position(|node| *node == place);
    node.expect("a hexahedron's nodes lie over those of its cell")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TubeGrid, tube_hex20};
    use crate::revolution::Bell;
    use crate::shape::Tube;

    #[test]
    fn a_tube_is_the_tube_s_own_mesh() {
        let grid = TubeGrid {
            around: 6,
            along: 4,
        };
        let meridian = crate::revolution::bell(&Bell::open(Tube::D5), [0, 4], 1).meridian;
        let (turned, own) = (revolve_hex20(&meridian, 6), tube_hex20(&Tube::D5, grid));
        assert_eq!(turned.nodes.len(), own.nodes.len());
        assert_eq!(turned.elements.iter().count(), own.elements.iter().count());
        let near = |p: &[f64; 3]| {
            let shifted = [p[0], p[1], p[2] + Tube::D5.length_m];
            own.nodes
                .iter()
                .any(|q| (0..3).all(|a| (shifted[a] - q[a]).abs() < 1e-12))
        };
        assert!(turned.nodes.iter().all(near));
    }
}
