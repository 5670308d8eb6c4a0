//! The four-node linear tetrahedron of O'Brien 2002 §3.3.

use super::isotropic::{add_block, determinant, inverse};
use crate::Material;

/// How a linear tetrahedron's mass is shared among its nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TetMass {
    /// By the shape functions (Eq. 14).
    Consistent,
    /// A quarter to each node (Eq. 15).
    Lumped,
}

/// Stiffness blocks and scalar masses between the nodes of one tetrahedron.
pub(super) struct Tet4 {
    pub(super) stiffness: [[[[f64; 3]; 3]; 4]; 4],
    pub(super) mass: [[f64; 4]; 4],
}

impl Tet4 {
    /// `None` if the tetrahedron is flat or inside out.
    pub(super) fn new(corners: &[[f64; 3]; 4], material: &Material, mass: TetMass) -> Option<Self> {
        let edge = |i: usize, a: usize| corners[i][a] - corners[0][a];
        // Rows are the edges from corner 0, so that the inverse's columns are gradients.
        let jacobian = [1, 2, 3].map(|i| [edge(i, 0), edge(i, 1), edge(i, 2)]);
        let det = determinant(&jacobian);
        if det.is_nan() || det <= 0.0 {
            return None;
        }
        let inv = inverse(&jacobian, det);
        let volume = det / 6.0;
        let mut gradients = [[0.0; 3]; 4];
        for (i, column) in [1, 2, 3].into_iter().enumerate() {
            for a in 0..3 {
                gradients[column][a] = inv[a][i];
                gradients[0][a] -= inv[a][i];
            }
        }
        let mut stiffness = [[[[0.0; 3]; 3]; 4]; 4];
        let mut masses = [[0.0; 4]; 4];
        let body = material.density_kg_m3 * volume;
        for i in 0..4 {
            for j in 0..4 {
                add_block(
                    &mut stiffness[i][j],
                    material,
                    volume,
                    &gradients[i],
                    &gradients[j],
                );
                let same = f64::from(u8::from(i == j));
                masses[i][j] = match mass {
                    TetMass::Consistent => body / 20.0 * (1.0 + same),
                    TetMass::Lumped => body / 4.0 * same,
                };
            }
        }
        Some(Self {
            stiffness,
            mass: masses,
        })
    }
}
