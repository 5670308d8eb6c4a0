//! Twenty-node hexahedra on a grid of cells, some of them left out.

use super::{Elements, Mesh, number};
use crate::fem::HEX20_NODES;

/// The cells of a grid of `counts` for which `present` holds, with nodes where `place_m` puts the half
/// steps of the grid; cells of the last axis follow each other first.
#[must_use]
pub fn cells_hex20(
    counts: [usize; 3],
    present: impl Fn([usize; 3]) -> bool,
    place_m: impl Fn([usize; 3]) -> [f64; 3],
) -> Mesh {
    let steps = counts.map(|count| 2 * count + 1);
    let slot = |[i, j, k]: [usize; 3]| (i * steps[1] + j) * steps[2] + k;
    let mut ids = vec![u32::MAX; steps.iter().product()];
    let (mut nodes, mut hexes) = (Vec::new(), Vec::new());
    for i in 0..counts[0] {
        for j in 0..counts[1] {
            for k in (0..counts[2]).filter(|&k| present([i, j, k])) {
                hexes.push(HEX20_NODES.map(|local| {
                    let step = |a: usize, cell: usize| match local[a] {
                        -1.0 => 2 * cell,
                        0.0 => 2 * cell + 1,
                        _ => 2 * cell + 2,
                    };
                    let at = [step(0, i), step(1, j), step(2, k)];
                    let id = &mut ids[slot(at)];
                    if *id == u32::MAX {
                        *id = number(nodes.len());
                        nodes.push(place_m(at));
                    }
                    *id
                }));
            }
        }
    }
    Mesh {
        nodes,
        elements: Elements::Hex20(hexes),
    }
}

/// A hollow cube of edge `edge_m` and walls `wall_m` thick: one cell through each wall, `along` cells
/// between the walls.
#[must_use]
pub fn hollow_cube_hex20(edge_m: f64, wall_m: f64, along: usize) -> Mesh {
    let half_step = |step: usize| {
        let inner = (2 * along) as f64;
        match step {
            0..=2 => 0.5 * wall_m * step as f64,
            _ if step <= 2 + 2 * along => {
                wall_m + (edge_m - 2.0 * wall_m) * (step - 2) as f64 / inner
            }
            _ => edge_m - wall_m * (1.0 - 0.5 * (step - 2 - 2 * along) as f64),
        }
    };
    let wall = |cell: usize| cell == 0 || cell == along + 1;
    cells_hex20(
        [along + 2; 3],
        |cell| cell.into_iter().any(wall),
        |step| step.map(half_step),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;
    use crate::fem::{TetMass, assemble};

    #[test]
    fn a_hollow_cube_weighs_its_walls() {
        let (edge_m, wall_m) = (0.05, 0.0025);
        let mesh = hollow_cube_hex20(edge_m, wall_m, 3);
        let material = Material::from_young(1e9, 0.3, 550.0).unwrap();
        let pencil = assemble(&mesh, &material, TetMass::Consistent).unwrap();
        let shift: Vec<f64> = (0..pencil.unknowns())
            .map(|u| f64::from(u8::from(u % 3 == 0)))
            .collect();
        let mut moved = vec![0.0; shift.len()];
        pencil.multiply(&pencil.mass, &shift, &mut moved);
        let mass_kg: f64 = shift.iter().zip(&moved).map(|(x, y)| x * y).sum();
        let expected = 550.0 * (edge_m.powi(3) - (edge_m - 2.0 * wall_m).powi(3));
        assert!((mass_kg / expected - 1.0).abs() < 1e-12);
    }
}
