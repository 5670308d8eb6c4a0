//! The beam of varying section that a bar nearly is, by finite elements of half its length.

use crate::analytic::rectangle_shear_coefficient;
use crate::fem::gauss::{GAUSS_2, GAUSS_3};
use crate::fem::{Constrained, Pattern, Pencil};
use crate::shape::Bar;
use crate::solve::lowest_of;
use crate::{Material, SolveError};
use std::sync::Arc;

/// Elements of three nodes over half the length.
const ELEMENTS: usize = 12;

/// Nodes of an element.
const NODES: usize = 3;

/// Deflection and rotation.
const FIELDS: usize = 2;

/// Frequencies in Hz of the first three bending modes of a Timoshenko beam of the bar's sections.
///
/// # Errors
///
/// As [`lowest_of`].
pub(super) fn beam_hz(bar: &Bar, material: &Material) -> Result<[f64; 3], SolveError> {
    let free = pencil(bar, material);
    // In the middle a symmetric mode does not rotate and an antisymmetric one does not deflect.
    let even = lowest_of(
        &Constrained::new(&free, 1, |unknown| unknown != 1).pencil,
        2,
    )?;
    let odd = lowest_of(
        &Constrained::new(&free, 1, |unknown| unknown != 0).pencil,
        1,
    )?;
    Ok([even[0], odd[0], even[1]])
}

fn pencil(bar: &Bar, material: &Material) -> Pencil {
    let nodes = 2 * ELEMENTS + 1;
    let columns: Vec<Vec<u32>> = (0..nodes * FIELDS)
        .map(|unknown| {
            let node = unknown / FIELDS;
            let last = (node + 2 - node % 2).min(nodes - 1);
            (unknown..(last + 1) * FIELDS)
                .map(|row| u32::try_from(row).expect("few unknowns"))
                .collect()
        })
        .collect();
    let pattern = Pattern::from_columns(&columns);
    let (mut stiffness, mut mass) = (vec![0.0; pattern.entries()], vec![0.0; pattern.entries()]);
    let half_m = 0.25 * bar.length_m / ELEMENTS as f64;
    let (young_pa, width_m) = (material.young_pa(), bar.width_m);
    for element in 0..ELEMENTS {
        let first = element * 2 * FIELDS;
        let thickness_m =
            |s: f64| bar.thickness_at_m(half_m * (2 * element + 1) as f64 + half_m * s);
        // Two points keep thin beams from locking.
        for (s, weight) in GAUSS_2 {
            let (values, slopes) = (shapes(s), slopes(s).map(|slope| slope / half_m));
            let t = thickness_m(s);
            let shear = rectangle_shear_coefficient(material.poisson());
            let bending_n_m2 = young_pa * width_m * t.powi(3) / 12.0;
            let shear_n = shear * material.mu_pa * width_m * t;
            // ψ' and w' − ψ of each unknown.
            let strains: [[f64; 2]; NODES * FIELDS] = std::array::from_fn(|i| {
                let node = i / FIELDS;
                if i % FIELDS == 0 {
                    [0.0, slopes[node]]
                } else {
                    [slopes[node], -values[node]]
                }
            });
            add(&pattern, &mut stiffness, first, |i, j| {
                weight
                    * half_m
                    * (bending_n_m2 * strains[i][0] * strains[j][0]
                        + shear_n * strains[i][1] * strains[j][1])
            });
        }
        for (s, weight) in GAUSS_3 {
            let values = shapes(s);
            let t = thickness_m(s);
            let mass_kg_m = material.density_kg_m3 * width_m * t;
            add(&pattern, &mut mass, first, |i, j| {
                let inertia = match (i % FIELDS, j % FIELDS) {
                    (0, 0) => mass_kg_m,
                    (1, 1) => mass_kg_m * t * t / 12.0,
                    _ => 0.0,
                };
                weight * half_m * inertia * values[i / FIELDS] * values[j / FIELDS]
            });
        }
    }
    Pencil {
        pattern: Arc::new(pattern),
        stiffness,
        mass,
        rigid: 2,
    }
}

fn shapes(s: f64) -> [f64; NODES] {
    [0.5 * s * (s - 1.0), 1.0 - s * s, 0.5 * s * (s + 1.0)]
}

fn slopes(s: f64) -> [f64; NODES] {
    [s - 0.5, -2.0 * s, s + 0.5]
}

fn add(pattern: &Pattern, values: &mut [f64], first: usize, entry: impl Fn(usize, usize) -> f64) {
    for j in 0..NODES * FIELDS {
        let column = pattern.column(first + j);
        for i in j..NODES * FIELDS {
            // Columns are full: rows follow each other from the diagonal on.
            values[column.start + i - j] += entry(i, j);
        }
    }
}
