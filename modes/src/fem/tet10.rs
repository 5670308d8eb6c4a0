//! The ten-node tetrahedron, straight or curved.

use super::isotropic::{add_block, determinant, physical_gradients};
use crate::Material;

/// Corners that each mid-side node, from the fifth on, lies between.
pub const TET10_EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];

/// One part of a rule: three equal barycentric coordinates, or two pairs of equal ones.
enum Orbit {
    /// (a, a, a, 1 − 3a): four points.
    Triple(f64),
    /// (a, a, ½ − a, ½ − a): six points.
    Pairs(f64),
}

/// Four points, exact for degree 2; weights are fractions of the volume (Hammer, Marlowe & Stroud
/// 1956).
const DEGREE_2: [(Orbit, f64); 1] = [(Orbit::Triple(0.138_196_601_125_010_5), 0.25)];

/// Fourteen points, exact for degree 5 (Walkington 2000).
const DEGREE_5: [(Orbit, f64); 3] = [
    (
        Orbit::Triple(0.310_885_919_263_300_6),
        0.112_687_925_718_015_85,
    ),
    (
        Orbit::Triple(0.092_735_250_310_891_23),
        0.073_493_043_116_361_95,
    ),
    (
        Orbit::Pairs(0.045_503_704_125_649_65),
        0.042_546_020_777_081_47,
    ),
];

/// Stiffness blocks and scalar masses between the nodes of one tetrahedron.
pub(super) struct Tet10 {
    pub(super) stiffness: Box<[[[[f64; 3]; 3]; 10]; 10]>,
    pub(super) mass: [[f64; 10]; 10],
}

impl Tet10 {
    /// `None` if the tetrahedron is flat or inside out at a point of integration.
    pub(super) fn new(nodes: &[[f64; 3]; 10], material: &Material) -> Option<Self> {
        let mut stiffness = Box::new([[[[0.0; 3]; 3]; 10]; 10]);
        for (point, weight) in points(&DEGREE_2) {
            let (gradients, det) = physical_gradients(&shape_gradients(point), nodes)?;
            for (row, gi) in stiffness.iter_mut().zip(&gradients) {
                for (block, gj) in row.iter_mut().zip(&gradients) {
                    add_block(block, material, weight * det / 6.0, gi, gj);
                }
            }
        }
        let mut mass = [[0.0; 10]; 10];
        for (point, weight) in points(&DEGREE_5) {
            let (_, det) = physical_gradients(&shape_gradients(point), nodes)?;
            let values = shapes(point);
            let density = weight * det / 6.0 * material.density_kg_m3;
            for (row, vi) in mass.iter_mut().zip(values) {
                for (entry, vj) in row.iter_mut().zip(values) {
                    *entry += density * vi * vj;
                }
            }
        }
        Some(Self { stiffness, mass })
    }
}

/// Barycentric points of a rule and their weights.
fn points(rule: &[(Orbit, f64)]) -> impl Iterator<Item = ([f64; 4], f64)> + '_ {
    rule.iter().flat_map(|(orbit, weight)| {
        let points: Vec<[f64; 4]> = match *orbit {
            Orbit::Triple(a) => (0..4)
                .map(|odd| std::array::from_fn(|i| if i == odd { 1.0 - 3.0 * a } else { a }))
                .collect(),
            Orbit::Pairs(a) => TET10_EDGES
                .iter()
                .map(|pair| std::array::from_fn(|i| if pair.contains(&i) { a } else { 0.5 - a }))
                .collect(),
        };
        points.into_iter().map(|point| (point, *weight))
    })
}

/// Determinants of the Jacobian of the element with these `nodes`, at the points of both rules, then
/// at the nodes; six times the volume everywhere if the edges are straight.
pub(crate) fn tet10_jacobians(nodes: &[[f64; 3]; 10]) -> [f64; 28] {
    let of_nodes = (0..10).map(|node| {
        std::array::from_fn(|i| match node {
            0..4 => f64::from(u8::from(i == node)),
            _ => 0.5 * f64::from(u8::from(TET10_EDGES[node - 4].contains(&i))),
        })
    });
    let rules = points(&DEGREE_2).chain(points(&DEGREE_5)).map(|(at, _)| at);
    let mut jacobians = [0.0; 28];
    for (value, at) in jacobians.iter_mut().zip(rules.chain(of_nodes)) {
        let mut jacobian = [[0.0; 3]; 3];
        for (slope, node) in shape_gradients(at).iter().zip(nodes) {
            for a in 0..3 {
                for b in 0..3 {
                    jacobian[a][b] += slope[a] * node[b];
                }
            }
        }
        *value = determinant(&jacobian);
    }
    jacobians
}

/// Volume of the element with these `nodes`.
pub(crate) fn tet10_volume(nodes: &[[f64; 3]; 10]) -> f64 {
    let weights = points(&DEGREE_2)
        .map(|(_, weight)| weight)
        .chain(points(&DEGREE_5).map(|(_, weight)| weight));
    tet10_jacobians(nodes)
        .iter()
        .zip(weights)
        .skip(4)
        .map(|(jacobian, weight)| weight * jacobian / 6.0)
        .sum()
}

/// Shape functions of the ten nodes at barycentric `l`.
fn shapes(l: [f64; 4]) -> [f64; 10] {
    std::array::from_fn(|node| match node {
        0..4 => l[node] * (2.0 * l[node] - 1.0),
        _ => {
            let [p, q] = TET10_EDGES[node - 4];
            4.0 * l[p] * l[q]
        }
    })
}

/// Derivatives of [`shapes`] by the second to fourth coordinate, the first giving way.
fn shape_gradients(l: [f64; 4]) -> [[f64; 3]; 10] {
    std::array::from_fn(|node| {
        let mut by = [0.0; 4];
        match node {
            0..4 => by[node] = 4.0 * l[node] - 1.0,
            _ => {
                let [p, q] = TET10_EDGES[node - 4];
                by[p] = 4.0 * l[q];
                by[q] = 4.0 * l[p];
            }
        }
        [1, 2, 3].map(|i| by[i] - by[0])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEEL: Material = Material {
        lambda_pa: 1.1e11,
        mu_pa: 8.0e10,
        density_kg_m3: 7800.0,
    };

    /// Corner 0, then the edges from it.
    const CORNERS: [[f64; 3]; 4] = [
        [0.1, 0.2, 0.0],
        [1.1, 0.1, 0.1],
        [0.3, 1.2, 0.2],
        [0.0, 0.3, 1.5],
    ];

    fn barycentric() -> [[f64; 4]; 10] {
        std::array::from_fn(|node| {
            std::array::from_fn(|i| match node {
                0..4 => f64::from(u8::from(i == node)),
                _ => 0.5 * f64::from(u8::from(TET10_EDGES[node - 4].contains(&i))),
            })
        })
    }

    fn straight() -> [[f64; 3]; 10] {
        barycentric().map(|l| [0, 1, 2].map(|a| (0..4).map(|i| l[i] * CORNERS[i][a]).sum::<f64>()))
    }

    fn curved() -> [[f64; 3]; 10] {
        let mut nodes = straight();
        for (i, node) in nodes.iter_mut().enumerate().skip(4) {
            node[i % 3] += 0.04;
        }
        nodes
    }

    fn volume() -> f64 {
        let edges = [1, 2, 3].map(|i| [0, 1, 2].map(|a| CORNERS[i][a] - CORNERS[0][a]));
        determinant(&edges) / 6.0
    }

    #[test]
    fn shape_functions_are_one_at_home_and_zero_elsewhere() {
        for (j, at) in barycentric().into_iter().enumerate() {
            for (i, value) in shapes(at).into_iter().enumerate() {
                let expected = f64::from(u8::from(i == j));
                assert!((value - expected).abs() < 1e-15, "{i} at {j}");
            }
        }
    }

    #[test]
    fn gradients_match_finite_differences() {
        let (l, h) = ([0.2, 0.1, 0.4, 0.3], 1e-6);
        let gradients = shape_gradients(l);
        for a in 0..3 {
            let (mut up, mut down) = (l, l);
            up[a + 1] += h;
            up[0] -= h;
            down[a + 1] -= h;
            down[0] += h;
            for (i, (p, q)) in shapes(up).into_iter().zip(shapes(down)).enumerate() {
                let slope = (p - q) / (2.0 * h);
                assert!((gradients[i][a] - slope).abs() < 1e-9, "{i} by {a}");
            }
        }
    }

    /// ∫ l₁ᵖ l₂ᑫ l₃ʳ over the volume is 6 p! q! r! / (p + q + r + 3)! of it.
    #[test]
    fn rules_are_exact_to_their_degree() {
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        for (rule, degree) in [(&DEGREE_2[..], 2), (&DEGREE_5[..], 5)] {
            for p in 0..=degree {
                for q in 0..=degree - p {
                    for r in 0..=degree - p - q {
                        let sum: f64 = points(rule)
                            .map(|(l, w)| w * l[1].powi(p) * l[2].powi(q) * l[3].powi(r))
                            .sum();
                        let expected = 6.0 * factorial(p) * factorial(q) * factorial(r)
                            / factorial(p + q + r + 3);
                        assert!((sum - expected).abs() < 1e-15, "{p} {q} {r}");
                    }
                }
            }
        }
    }

    #[test]
    fn mass_sums_to_density_times_volume() {
        let element = Tet10::new(&straight(), &STEEL).unwrap();
        let total: f64 = element.mass.iter().flatten().sum();
        assert!((total / (volume() * STEEL.density_kg_m3) - 1.0).abs() < 1e-13);
    }

    /// Closed form for straight sides: ∫NᵢNⱼ of corners is V/70 on the diagonal and V/420 off it, of
    /// mid-side nodes 32 V/420 on the diagonal (from the formula above).
    #[test]
    fn mass_is_the_closed_form() {
        let element = Tet10::new(&straight(), &STEEL).unwrap();
        let unit = STEEL.density_kg_m3 * volume() / 420.0;
        for (i, j, expected) in [(0, 0, 6.0), (0, 3, 1.0), (4, 4, 32.0), (0, 4, -4.0)] {
            let error = element.mass[i][j] / unit - expected;
            assert!(error.abs() < 1e-12, "{i} {j}: {error:e}");
        }
    }

    #[test]
    fn rigid_motion_and_uniform_strain_are_exact() {
        let energy = |nodes: &[[f64; 3]; 10], motion: &dyn Fn([f64; 3]) -> [f64; 3]| {
            let element = Tet10::new(nodes, &STEEL).unwrap();
            let u = nodes.map(motion);
            let mut energy = 0.0;
            for i in 0..10 {
                for j in 0..10 {
                    for a in 0..3 {
                        for b in 0..3 {
                            energy += 0.5 * u[i][a] * element.stiffness[i][j][a][b] * u[j][b];
                        }
                    }
                }
            }
            energy
        };
        let expected = 0.5 * (STEEL.lambda_pa + 2.0 * STEEL.mu_pa) * 1e-6 * volume();
        let stretch = energy(&straight(), &|p| [1e-3 * p[0], 0.0, 0.0]);
        assert!((stretch / expected - 1.0).abs() < 1e-12);
        for nodes in [straight(), curved()] {
            let shift = energy(&nodes, &|_| [1e-3, 2e-3, -1e-3]);
            let turn = energy(&nodes, &|p| [-1e-3 * p[1], 1e-3 * p[0], 0.0]);
            assert!(shift.abs() < 1e-12 * expected);
            assert!(turn.abs() < 1e-12 * expected);
        }
    }

    #[test]
    fn an_inverted_element_is_refused() {
        let inverted = straight().map(|[x, y, z]| [y, x, z]);
        assert!(Tet10::new(&inverted, &STEEL).is_none());
        let mut folded = straight();
        folded[7] = folded[0];
        folded[7][2] -= 1.0;
        assert!(Tet10::new(&folded, &STEEL).is_none());
    }
}
