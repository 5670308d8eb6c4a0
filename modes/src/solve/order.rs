//! The order of elimination.

use super::dissection::nested_dissection;
use super::graph::{Graph, compressed};
use crate::fem::Pattern;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

/// Meshes of fewer nodes are left to minimum degree.
const DISSECT_FROM: usize = 3_000;

/// The unknowns of `pattern` in the order of elimination, and the place of each in it.
pub(super) fn order(pattern: &Pattern) -> (Vec<u32>, Vec<u32>) {
    let (graph, first) = compressed(pattern);
    let vertices = if graph.len() < DISSECT_FROM {
        minimum_degree(&graph)
    } else {
        nested_dissection(graph, &minimum_degree)
    };
    let order: Vec<u32> = vertices
        .iter()
        .flat_map(|&v| first[v as usize]..first[v as usize + 1])
        .collect();
    let mut place = vec![0; order.len()];
    for (at, &unknown) in (0u32..).zip(&order) {
        place[unknown as usize] = at;
    }
    (order, place)
}

/// Amestoy, Davis & Duff 1996.
fn minimum_degree(graph: &Graph) -> Vec<u32> {
    let n = graph.len();
    let mut start = vec![0u32; n + 1];
    let mut rows = Vec::with_capacity(graph.edge_ends());
    for v in 0..n {
        rows.extend(graph.neighbours(v).iter().filter(|&&u| u as usize > v));
        start[v + 1] = u32::try_from(rows.len()).expect("fewer than the pencil's entries");
    }
    for v in 0..n {
        rows[start[v] as usize..start[v + 1] as usize].sort_unstable();
    }
    let matrix = SymbolicSparseColMatRef::new_checked(n, n, &start, None, &rows);
    let (mut order, mut place) = (vec![0u32; n], vec![0u32; n]);
    let scratch = amd::order_maybe_unsorted_scratch::<u32>(n, rows.len());
    amd::order_maybe_unsorted(
        &mut order,
        &mut place,
        matrix,
        amd::Control::default(),
        MemStack::new(&mut MemBuffer::new(scratch)),
    )
    .expect("the graph fits in memory");
    order
}
