//! The twenty-node serendipity hexahedron, stiffness by 2×2×2 points.
//!
//! Reduced integration frees thin walls of the locking that full integration suffers (Zienkiewicz,
//! Taylor & Too 1971); the zero-energy modes it allows in one element cannot pass between two.

use super::gauss::{GAUSS_2, GAUSS_3};
use super::isotropic::{add_block, physical_gradients};
use crate::Material;

/// Local coordinates (ξ, η, ζ) of the nodes: corners first, then edge middles.
pub const HEX20_NODES: [[f64; 3]; 20] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
    [0.0, -1.0, -1.0],
    [1.0, 0.0, -1.0],
    [0.0, 1.0, -1.0],
    [-1.0, 0.0, -1.0],
    [0.0, -1.0, 1.0],
    [1.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [-1.0, 0.0, 1.0],
    [-1.0, -1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
];

/// Stiffness blocks and scalar masses between the nodes of one hexahedron.
pub(super) struct Hex20 {
    pub(super) stiffness: Box<[[[[f64; 3]; 3]; 20]; 20]>,
    pub(super) mass: Box<[[f64; 20]; 20]>,
}

impl Hex20 {
    /// `None` if the hexahedron is flat or inside out at a point of integration.
    pub(super) fn new(nodes: &[[f64; 3]; 20], material: &Material) -> Option<Self> {
        let mut stiffness = Box::new([[[[0.0; 3]; 3]; 20]; 20]);
        for (point, weight) in points(&GAUSS_2) {
            let (gradients, det) = gradients_at(nodes, point)?;
            for i in 0..20 {
                for j in 0..20 {
                    let block = &mut stiffness[i][j];
                    add_block(block, material, weight * det, &gradients[i], &gradients[j]);
                }
            }
        }
        let mut mass = Box::new([[0.0; 20]; 20]);
        for (point, weight) in points(&GAUSS_3) {
            let (_, det) = gradients_at(nodes, point)?;
            let values = hex20_weights(point);
            let density = weight * det * material.density_kg_m3;
            for i in 0..20 {
                for j in 0..20 {
                    mass[i][j] += density * values[i] * values[j];
                }
            }
        }
        Some(Self { stiffness, mass })
    }
}

fn points<const N: usize>(rule: &[(f64, f64); N]) -> impl Iterator<Item = ([f64; 3], f64)> + '_ {
    rule.iter().flat_map(move |&(x, wx)| {
        rule.iter()
            .flat_map(move |&(y, wy)| rule.iter().map(move |&(z, wz)| ([x, y, z], wx * wy * wz)))
    })
}

/// What each node's value counts for at local coordinates `x` of a hexahedron.
pub(crate) fn hex20_weights(x: [f64; 3]) -> [f64; 20] {
    HEX20_NODES.map(|node| shape(node, x))
}

/// Shape function of the node at local coordinates `node`, at `x`.
fn shape(node: [f64; 3], x: [f64; 3]) -> f64 {
    let factor = |a: usize| 1.0 + node[a] * x[a];
    match node.iter().position(|&c| c == 0.0) {
        None => {
            let sum = node[0] * x[0] + node[1] * x[1] + node[2] * x[2];
            0.125 * factor(0) * factor(1) * factor(2) * (sum - 2.0)
        }
        Some(middle) => {
            let [p, q] = [(middle + 1) % 3, (middle + 2) % 3];
            0.25 * (1.0 - x[middle] * x[middle]) * factor(p) * factor(q)
        }
    }
}

/// Derivatives of [`shape`] by the local coordinates.
fn shape_gradient(node: [f64; 3], x: [f64; 3]) -> [f64; 3] {
    let factor = |a: usize| 1.0 + node[a] * x[a];
    let mut gradient = [0.0; 3];
    match node.iter().position(|&c| c == 0.0) {
        None => {
            let sum = node[0] * x[0] + node[1] * x[1] + node[2] * x[2];
            for (a, slope) in gradient.iter_mut().enumerate() {
                let [p, q] = [(a + 1) % 3, (a + 2) % 3];
                *slope = 0.125 * node[a] * factor(p) * factor(q) * (sum - 2.0 + factor(a));
            }
        }
        Some(middle) => {
            let [p, q] = [(middle + 1) % 3, (middle + 2) % 3];
            let bubble = 1.0 - x[middle] * x[middle];
            gradient[middle] = -0.5 * x[middle] * factor(p) * factor(q);
            gradient[p] = 0.25 * bubble * node[p] * factor(q);
            gradient[q] = 0.25 * bubble * node[q] * factor(p);
        }
    }
    gradient
}

/// Gradients by x, y, z of all shape functions at local point `x`, and the Jacobian's determinant.
fn gradients_at(nodes: &[[f64; 3]; 20], x: [f64; 3]) -> Option<([[f64; 3]; 20], f64)> {
    physical_gradients(&HEX20_NODES.map(|node| shape_gradient(node, x)), nodes)
}

#[cfg(test)]
mod tests {
    use super::super::isotropic::determinant;
    use super::*;

    const STEEL: Material = Material {
        lambda_pa: 1.1e11,
        mu_pa: 8.0e10,
        density_kg_m3: 7800.0,
    };

    fn skewed() -> [[f64; 3]; 20] {
        HEX20_NODES.map(|[x, y, z]| [x + 0.2 * y, y - 0.1 * z, 1.5 * z + 0.1 * x])
    }

    #[test]
    fn shape_functions_are_one_at_home_and_zero_elsewhere() {
        for (i, &node) in HEX20_NODES.iter().enumerate() {
            for (j, &at) in HEX20_NODES.iter().enumerate() {
                let expected = f64::from(u8::from(i == j));
                assert!((shape(node, at) - expected).abs() < 1e-15, "{i} at {j}");
            }
        }
    }

    #[test]
    fn gradients_match_finite_differences() {
        let (x, h) = ([0.3, -0.2, 0.7], 1e-6);
        for node in HEX20_NODES {
            let gradient = shape_gradient(node, x);
            for a in 0..3 {
                let (mut up, mut down) = (x, x);
                up[a] += h;
                down[a] -= h;
                let slope = (shape(node, up) - shape(node, down)) / (2.0 * h);
                assert!((gradient[a] - slope).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn mass_sums_to_density_times_volume() {
        let element = Hex20::new(&skewed(), &STEEL).unwrap();
        let total: f64 = element.mass.iter().flatten().sum();
        let jacobian = [[1.0, 0.0, 0.1], [0.2, 1.0, 0.0], [0.0, -0.1, 1.5]];
        let expected = 8.0 * determinant(&jacobian) * STEEL.density_kg_m3;
        assert!((total / expected - 1.0).abs() < 1e-12);
    }

    #[test]
    fn rigid_motion_and_uniform_strain_are_exact() {
        let nodes = skewed();
        let element = Hex20::new(&nodes, &STEEL).unwrap();
        let energy = |motion: &dyn Fn([f64; 3]) -> [f64; 3]| {
            let u = nodes.map(motion);
            let mut energy = 0.0;
            for i in 0..20 {
                for j in 0..20 {
                    for a in 0..3 {
                        for b in 0..3 {
                            energy += 0.5 * u[i][a] * element.stiffness[i][j][a][b] * u[j][b];
                        }
                    }
                }
            }
            energy
        };
        let stretch = energy(&|p| [1e-3 * p[0], 0.0, 0.0]);
        let jacobian = [[1.0, 0.0, 0.1], [0.2, 1.0, 0.0], [0.0, -0.1, 1.5]];
        let volume = 8.0 * determinant(&jacobian);
        let expected = 0.5 * (STEEL.lambda_pa + 2.0 * STEEL.mu_pa) * 1e-6 * volume;
        assert!((stretch / expected - 1.0).abs() < 1e-12);
        assert!(energy(&|_| [1e-3, 2e-3, -1e-3]).abs() < 1e-12 * expected);
        assert!(energy(&|p| [-1e-3 * p[1], 1e-3 * p[0], 0.0]).abs() < 1e-12 * expected);
    }

    #[test]
    fn an_inverted_element_is_refused() {
        let inverted = skewed().map(|[x, y, z]| [y, x, z]);
        assert!(Hex20::new(&inverted, &STEEL).is_none());
    }
}
