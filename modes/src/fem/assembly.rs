//! From a mesh to K and M.

use super::hex20::Hex20;
use super::pencil::{Pattern, Pencil};
use super::tet4::{Tet4, TetMass};
use super::tet10::Tet10;
use super::wedge23::Wedge23;
use crate::mesh::{Elements, Mesh};
use crate::{Material, SolveError};
use std::sync::Arc;

/// Rigid motions of a free body: three translations, three rotations.
const FREE_BODY: usize = 6;

/// K and M of a free body; `mass` says how linear tetrahedra share theirs out.
///
/// # Errors
///
/// [`SolveError::BadElement`] if an element is flat or inside out.
pub fn assemble(mesh: &Mesh, material: &Material, mass: TetMass) -> Result<Pencil, SolveError> {
    let pattern = pattern(mesh);
    let mut pencil = Pencil {
        stiffness: vec![0.0; pattern.entries()],
        mass: vec![0.0; pattern.entries()],
        pattern: Arc::new(pattern),
        rigid: FREE_BODY,
    };
    match &mesh.elements {
        Elements::Tet4(tets) => {
            for (index, tet) in tets.iter().enumerate() {
                let corners = tet.map(|node| mesh.nodes[node as usize]);
                let element =
                    Tet4::new(&corners, material, mass).ok_or(SolveError::BadElement { index })?;
                add(&mut pencil, tet, |i, j| {
                    (&element.stiffness[i][j], element.mass[i][j])
                });
            }
        }
        Elements::Tet10(tets) => {
            for (index, tet) in tets.iter().enumerate() {
                let nodes = tet.map(|node| mesh.nodes[node as usize]);
                let element =
                    Tet10::new(&nodes, material).ok_or(SolveError::BadElement { index })?;
                add(&mut pencil, tet, |i, j| {
                    (&element.stiffness[i][j], element.mass[i][j])
                });
            }
        }
        Elements::Hex20(hexes) => {
            for (index, hex) in hexes.iter().enumerate() {
                let nodes = hex.map(|node| mesh.nodes[node as usize]);
                let element =
                    Hex20::new(&nodes, material).ok_or(SolveError::BadElement { index })?;
                add(&mut pencil, hex, |i, j| {
                    (&element.stiffness[i][j], element.mass[i][j])
                });
            }
        }
        Elements::Wedge23(wedges) => {
            for (index, wedge) in wedges.iter().enumerate() {
                let nodes = wedge.map(|node| mesh.nodes[node as usize]);
                let element =
                    Wedge23::new(&nodes, material).ok_or(SolveError::BadElement { index })?;
                add(&mut pencil, wedge, |i, j| {
                    (&element.stiffness[i][j], element.mass[i][j])
                });
            }
        }
    }
    Ok(pencil)
}

/// Three unknowns to a node, coupled wherever an element joins two nodes.
fn pattern(mesh: &Mesh) -> Pattern {
    let mut neighbours: Vec<Vec<u32>> = vec![Vec::new(); mesh.nodes.len()];
    for element in mesh.elements.iter() {
        for &i in element {
            let below = element.iter().copied().filter(|&j| j >= i);
            neighbours[i as usize].extend(below);
        }
    }
    let mut columns = Vec::with_capacity(3 * mesh.nodes.len());
    for list in &mut neighbours {
        list.sort_unstable();
        list.dedup();
        let rows: Vec<u32> = list.iter().flat_map(|&j| 3 * j..3 * j + 3).collect();
        // The node itself comes first; its own block keeps only the lower triangle.
        columns.extend((0..3).map(|a| rows[a..].to_vec()));
    }
    Pattern::from_columns(&columns)
}

fn add<'a>(
    pencil: &mut Pencil,
    nodes: &[u32],
    block: impl Fn(usize, usize) -> (&'a [[f64; 3]; 3], f64),
) {
    for (i, &row_node) in nodes.iter().enumerate() {
        for (j, &column_node) in nodes.iter().enumerate() {
            if row_node < column_node {
                continue;
            }
            let (stiffness, mass) = block(i, j);
            for b in 0..3u32 {
                let first = if row_node == column_node { b } else { 0 };
                let entry = pencil
                    .pattern
                    .entry(3 * row_node + first, 3 * column_node + b);
                for a in first..3 {
                    let at = entry + (a - first) as usize;
                    pencil.stiffness[at] += stiffness[a as usize][b as usize];
                    if a == b {
                        pencil.mass[at] += mass;
                    }
                }
            }
        }
    }
}
