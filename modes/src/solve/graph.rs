//! Which unknowns of a pencil meet, nodes of the mesh taken as one.

use crate::fem::Pattern;

/// An undirected graph: neighbours of every vertex.
pub(super) struct Graph {
    start: Vec<u32>,
    neighbours: Vec<u32>,
}

impl Graph {
    pub(super) fn len(&self) -> usize {
        self.start.len() - 1
    }

    pub(super) fn neighbours(&self, vertex: usize) -> &[u32] {
        &self.neighbours[self.start[vertex] as usize..self.start[vertex + 1] as usize]
    }

    pub(super) fn edge_ends(&self) -> usize {
        self.neighbours.len()
    }

    /// The graph of the edges among `vertices`, renumbered in their order. `number` has an entry for
    /// each vertex of `self`, all `u32::MAX`, and is left so.
    pub(super) fn induced(&self, vertices: &[u32], number: &mut [u32]) -> Self {
        for (new, &old) in (0u32..).zip(vertices) {
            number[old as usize] = new;
        }
        let mut start = Vec::with_capacity(vertices.len() + 1);
        start.push(0);
        let mut neighbours = Vec::new();
        for &old in vertices {
            let inside = self.neighbours(old as usize).iter();
            neighbours.extend(
                inside
                    .map(|&other| number[other as usize])
                    .filter(|&new| new != u32::MAX),
            );
            start.push(u32::try_from(neighbours.len()).expect("no more than in the whole"));
        }
        for &old in vertices {
            number[old as usize] = u32::MAX;
        }
        Self { start, neighbours }
    }
}

/// The graph of `pattern` with neighbouring unknowns that meet the same others, as those of a node
/// do, made one vertex; and the first unknown of each vertex, then the number of unknowns.
pub(super) fn compressed(pattern: &Pattern) -> (Graph, Vec<u32>) {
    let n = pattern.unknowns();
    // A sum that tells which columns left of a row's diagonal have the row.
    let mut above = vec![0u64; n];
    for j in 0..n {
        for &row in &pattern.rows[pattern.column(j)][1..] {
            above[row as usize] = above[row as usize].wrapping_add(hash(j));
        }
    }
    let below = |j: usize| &pattern.rows[pattern.column(j)];
    let mut first = Vec::new();
    let mut vertex = vec![u32::MAX; n];
    for (number, j) in (0u32..).zip(0..n) {
        let twins = j > 0
            && below(j - 1)[1..] == *below(j)
            && above[j] == above[j - 1].wrapping_add(hash(j - 1));
        if !twins {
            vertex[j] = u32::try_from(first.len()).expect("no more than unknowns");
            first.push(number);
        }
    }
    first.push(u32::try_from(n).expect("unknowns are numbered in 32 bits"));
    let count = first.len() - 1;
    let edges = |visit: &mut dyn FnMut(usize, u32)| {
        for (v, &unknown) in first[..count].iter().enumerate() {
            for &row in &below(unknown as usize)[1..] {
                let other = vertex[row as usize];
                if other != u32::MAX {
                    visit(v, other);
                }
            }
        }
    };
    let mut start = vec![0u32; count + 1];
    edges(&mut |a, b| {
        start[a + 1] += 1;
        start[b as usize + 1] += 1;
    });
    let mut total = 0;
    for first in &mut start {
        total += *first;
        *first = total;
    }
    let mut next = start.clone();
    let mut neighbours = vec![0; start[count] as usize];
    edges(&mut |a, b| {
        for (from, to) in [(a, b as usize), (b as usize, a)] {
            neighbours[next[from] as usize] = u32::try_from(to).expect("a vertex number");
            next[from] += 1;
        }
    });
    (Graph { start, neighbours }, first)
}

/// Mixes the bits of an index (Steele, Lea & Flood 2014).
fn hash(index: usize) -> u64 {
    let mut z = (index as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z ^ (z >> 27)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TABLE_1;
    use crate::fem::{TetMass, assemble};
    use crate::mesh::{TubeGrid, tube_tet4};
    use crate::shape::Tube;

    #[test]
    fn a_mesh_comes_back_as_its_nodes() {
        let grid = TubeGrid {
            around: 8,
            along: 5,
        };
        let mesh = tube_tet4(&Tube::D5, grid, 1);
        let pencil = assemble(&mesh, &TABLE_1[0].material, TetMass::Lumped).unwrap();
        let (graph, first) = compressed(&pencil.pattern);
        assert_eq!(graph.len(), mesh.nodes.len());
        assert!(first.iter().enumerate().all(|(v, &f)| f as usize == 3 * v));
        let mut expected: Vec<u32> = mesh
            .elements
            .iter()
            .filter(|tet| tet.contains(&7))
            .flatten()
            .copied()
            .filter(|&node| node != 7)
            .collect();
        expected.sort_unstable();
        expected.dedup();
        let mut neighbours = graph.neighbours(7).to_vec();
        neighbours.sort_unstable();
        assert_eq!(neighbours, expected);
    }
}
