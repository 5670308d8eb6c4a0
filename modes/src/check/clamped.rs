//! The clamped bar and plate of O'Brien 2001, and the blocks and boxes of O'Brien 2002.

use super::{CheckError, Row, aluminium};
use crate::fem::{Constrained, Pencil, TetMass, assemble};
use crate::mesh::{BarGrid, BarPart, Mesh, bar_hex20, hollow_cube_hex20};
use crate::shape::Bar;
use crate::solve::{lowest, lowest_of};
use crate::{Material, TABLE_1};
use std::f64::consts::TAU;

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = bar()?;
    rows.extend(plate()?);
    rows.extend(cubes()?);
    Ok(rows)
}

/// What is left of `mesh`, `thick_m` thick and its top at z = 0, when the section where `held` is not
/// free to move or turn; it may grow thicker and thinner, as thin plates do.
fn clamped(
    (mesh, thick_m): (&Mesh, f64),
    material: &Material,
    held: impl Fn(&[f64; 3]) -> bool,
) -> Result<Pencil, CheckError> {
    let free = assemble(mesh, material, TetMass::Consistent)?;
    let kept = |unknown: usize| {
        let node = &mesh.nodes[unknown / 3];
        let middle = (node[2] + 0.5 * thick_m).abs() < 1e-6 * thick_m;
        !held(node) || (unknown % 3 == 2 && !middle)
    };
    Ok(Constrained::new(&free, 0, kept).pencil)
}

/// βL of a thin bar clamped at one end (Blevins 1979, table 8-1).
const CANTILEVER: [f64; 4] = [1.875_104, 4.694_091, 7.854_757, 10.995_541];

fn bar() -> Result<Vec<Row>, CheckError> {
    let bar = Bar::uniform(0.5, 0.006, 0.004);
    let grid = BarGrid {
        along: 25,
        across: 1,
        through: 1,
    };
    let mesh = bar_hex20(&bar, grid, BarPart::Whole);
    let pencil = clamped((&mesh, bar.thickness_m), &aluminium(), |node| {
        node[0] == -0.5 * bar.length_m
    })?;
    // Sideways it is half as stiff again: of ten modes, those up and down are picked by their order.
    let hz = lowest_of(&pencil, 10)?;
    let speed = (aluminium().young_pa() / aluminium().density_kg_m3 / 12.0).sqrt();
    Ok(CANTILEVER
        .into_iter()
        .enumerate()
        .map(|(index, beta)| {
            let expected =
                beta * beta * speed * bar.thickness_m / (TAU * bar.length_m * bar.length_m);
            let near = |hz: &f64| (hz / expected).ln().abs();
            let nearest = hz
                .iter()
                .copied()
                .min_by(|p, q| near(p).total_cmp(&near(q)));
            Row::relative(
                format!("bar clamped at one end, bending {}", index + 1),
                (expected, nearest.unwrap_or(f64::NAN), "Hz"),
                3e-3,
                "thin bar, as in O'Brien 2001, Fig. 5",
            )
        })
        .collect())
}

/// λ² = 2πf a² √(ρh/D) of a thin square plate of edge a clamped all around (Leissa 1969, table 4.25):
/// the first four different ones.
const PLATE: [(&str, f64, usize); 4] = [
    ("(1,1)", 35.985, 0),
    ("(1,2)", 73.394, 1),
    ("(2,2)", 108.22, 3),
    ("(1,3) − (3,1)", 131.58, 4),
];

fn plate() -> Result<Vec<Row>, CheckError> {
    let (edge_m, thick_m) = (0.3, 0.0015);
    let grid = BarGrid {
        along: 10,
        across: 10,
        through: 1,
    };
    let mesh = bar_hex20(&Bar::uniform(edge_m, edge_m, thick_m), grid, BarPart::Whole);
    let border = 0.5 * edge_m * (1.0 - 1e-12);
    let material = aluminium();
    let pencil = clamped((&mesh, thick_m), &material, |node| {
        node[0].abs() > border || node[1].abs() > border
    })?;
    let hz = lowest_of(&pencil, 6)?;
    let bending = material.young_pa() / (12.0 * (1.0 - material.poisson().powi(2)));
    let speed = (bending / material.density_kg_m3).sqrt();
    Ok(PLATE
        .into_iter()
        .map(|(name, factor, index)| {
            let expected = factor * speed * thick_m / (TAU * edge_m * edge_m);
            Row::relative(
                format!("square plate clamped all around, {name}"),
                (expected, hz[index], "Hz"),
                5e-3,
                "thin plate (Leissa 1969), as in O'Brien 2001, Fig. 7",
            )
        })
        .collect())
}

/// Edges of the blocks and of the boxes, in m; their walls are a twentieth of that (O'Brien 2002,
/// §5).
const EDGES_M: [f64; 2] = [0.05, 0.5];

fn cubes() -> Result<Vec<Row>, CheckError> {
    let blocks = TABLE_1.iter().find(|row| row.example == "Blocks");
    let material = blocks.expect("Table 1 has blocks").material;
    let mut hz = [0.0; 2];
    for (hz, edge_m) in hz.iter_mut().zip(EDGES_M) {
        let mesh = hollow_cube_hex20(edge_m, edge_m / 20.0, 8);
        let pencil = assemble(&mesh, &material, TetMass::Consistent)?;
        *hz = lowest(&pencil, 0)?;
    }
    let [block_hz, box_hz] = hz;
    Ok(vec![Row::relative(
        "hollow boxes ten times as large as blocks: fundamental of the one over that of the other",
        (0.1, box_hz / block_hz, ""),
        1e-9,
        "similar bodies: f ∝ 1/size (O'Brien 2002, Fig. 5)",
    )])
}
