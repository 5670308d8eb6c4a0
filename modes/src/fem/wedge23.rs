//! The twenty-three-node wedge of thin walls: a triangle of ten nodes on either side, three nodes between.
//!
//! Quadratic displacements on a curved triangle cannot bend without stretching, and a thin wall of them comes
//! out sharp. Cubic ones can, nearly: what is left falls with the fourth power of the triangle's side.

use super::gauss::{GAUSS_2, GAUSS_3};
use super::isotropic::{add_block, determinant, physical_gradients};
use crate::Material;

/// Nodes of a wedge.
pub(crate) const WEDGE_NODES: usize = 23;

/// Nodes of a triangle on one side.
pub(crate) const CUBIC_NODES: usize = 10;

/// Shares of the three corners in each node of the cubic triangle: the corners; two nodes on each side in
/// turn, the one nearer to where the side begins first; the middle.
pub(crate) const CUBIC_SHARES: [[f64; 3]; CUBIC_NODES] = {
    let (near, far) = (2.0 / 3.0, 1.0 / 3.0);
    [
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [near, far, 0.0],
        [far, near, 0.0],
        [0.0, near, far],
        [0.0, far, near],
        [far, 0.0, near],
        [near, 0.0, far],
        [far; 3],
    ]
};

/// Six points (r, s) of a triangle and their weights, exact for degree 4 (Dunavant 1985).
const DEGREE_4: [([f64; 2], f64); 6] = {
    let (a, b) = (0.445_948_490_915_965, 0.091_576_213_509_771);
    let (v, w) = (0.111_690_794_839_005_5, 0.054_975_871_827_661);
    [
        ([a, a], v),
        ([1.0 - 2.0 * a, a], v),
        ([a, 1.0 - 2.0 * a], v),
        ([b, b], w),
        ([1.0 - 2.0 * b, b], w),
        ([b, 1.0 - 2.0 * b], w),
    ]
};

/// Twelve points, exact for degree 6 (Dunavant 1985).
const DEGREE_6: [([f64; 2], f64); 12] = {
    let (a, b) = (0.249_286_745_170_91, 0.063_089_014_491_502);
    let (c, d) = (0.310_352_451_033_785, 0.053_145_049_844_816);
    let e = 1.0 - c - d;
    let (u, v, w) = (
        0.058_393_137_863_189_5,
        0.025_422_453_185_103_5,
        0.041_425_537_809_187,
    );
    [
        ([a, a], u),
        ([1.0 - 2.0 * a, a], u),
        ([a, 1.0 - 2.0 * a], u),
        ([b, b], v),
        ([1.0 - 2.0 * b, b], v),
        ([b, 1.0 - 2.0 * b], v),
        ([c, d], w),
        ([d, c], w),
        ([c, e], w),
        ([e, c], w),
        ([d, e], w),
        ([e, d], w),
    ]
};

/// Nodes of a wedge at which something is known.
type Nodes = [[f64; 3]; WEDGE_NODES];

/// Stiffness blocks and scalar masses between the nodes of one wedge.
pub(super) struct Wedge23 {
    pub(super) stiffness: Box<[[[[f64; 3]; 3]; WEDGE_NODES]; WEDGE_NODES]>,
    pub(super) mass: Box<[[f64; WEDGE_NODES]; WEDGE_NODES]>,
}

impl Wedge23 {
    /// `None` if the wedge is flat or inside out at a point of integration.
    pub(super) fn new(nodes: &Nodes, material: &Material) -> Option<Self> {
        let mut stiffness = Box::new([[[[0.0; 3]; 3]; WEDGE_NODES]; WEDGE_NODES]);
        for (at, weight) in points(&DEGREE_4, &GAUSS_2) {
            let (gradients, det) = physical_gradients(&shape_gradients(at), nodes)?;
            for (row, gi) in stiffness.iter_mut().zip(&gradients) {
                for (block, gj) in row.iter_mut().zip(&gradients) {
                    add_block(block, material, weight * det, gi, gj);
                }
            }
        }
        let mut mass = Box::new([[0.0; WEDGE_NODES]; WEDGE_NODES]);
        for (at, weight) in points(&DEGREE_6, &GAUSS_3) {
            let det = jacobian(nodes, at);
            if det.is_nan() || det <= 0.0 {
                return None;
            }
            let values = shapes(at);
            let density = weight * det * material.density_kg_m3;
            for (row, vi) in mass.iter_mut().zip(values) {
                for (entry, vj) in row.iter_mut().zip(values) {
                    *entry += density * vi * vj;
                }
            }
        }
        Some(Self { stiffness, mass })
    }
}

/// Points of a rule in the triangle and one across it, and their weights.
fn points<const N: usize>(
    triangle: &'static [([f64; 2], f64)],
    across: &'static [(f64, f64); N],
) -> impl Iterator<Item = ([f64; 3], f64)> {
    across.iter().flat_map(move |&(zeta, through)| {
        let level = triangle.iter();
        level.map(move |&([r, s], weight)| ([r, s, zeta], weight * through))
    })
}

/// Least determinant of the Jacobian of the wedge with these `nodes`, over its points of integration and its
/// corners.
pub(crate) fn wedge23_least_jacobian(nodes: &Nodes) -> f64 {
    let rules = points(&DEGREE_4, &GAUSS_2).chain(points(&DEGREE_6, &GAUSS_3));
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let corners = corners
        .into_iter()
        .flat_map(|[r, s]| [[r, s, -1.0], [r, s, 1.0]]);
    let all = rules.map(|(at, _)| at).chain(corners);
    all.map(|at| jacobian(nodes, at))
        .fold(f64::INFINITY, f64::min)
}

/// Volume of the wedge with these `nodes`.
pub(crate) fn wedge23_volume(nodes: &Nodes) -> f64 {
    let rule = points(&DEGREE_6, &GAUSS_3);
    rule.map(|(at, weight)| weight * jacobian(nodes, at)).sum()
}

fn jacobian(nodes: &Nodes, at: [f64; 3]) -> f64 {
    let mut jacobian = [[0.0; 3]; 3];
    for (slope, node) in shape_gradients(at).iter().zip(nodes) {
        for (row, d) in jacobian.iter_mut().zip(slope) {
            for (entry, coordinate) in row.iter_mut().zip(node) {
                *entry += d * coordinate;
            }
        }
    }
    determinant(&jacobian)
}

/// Shape functions of the wedge's nodes at (r, s, ζ): below, above, between.
fn shapes([r, s, zeta]: [f64; 3]) -> [f64; WEDGE_NODES] {
    let l = [1.0 - r - s, r, s];
    let plane = cubic_shapes([r, s]);
    let bubble = 1.0 - zeta * zeta;
    std::array::from_fn(|node| match place(node) {
        Place::Side(k, side) => {
            let corner = if k < 3 { 0.5 * l[k] * bubble } else { 0.0 };
            0.5 * plane[k] * (1.0 + side * zeta) - corner
        }
        Place::Between(k) => l[k] * bubble,
    })
}

/// Derivatives of [`shapes`] by r, s, ζ.
fn shape_gradients([r, s, zeta]: [f64; 3]) -> [[f64; 3]; WEDGE_NODES] {
    let l = [1.0 - r - s, r, s];
    let (plane, slopes) = (cubic_shapes([r, s]), cubic_gradients([r, s]));
    let bubble = 1.0 - zeta * zeta;
    let between = |k: usize| {
        let [by_r, by_s] = SLOPES[k];
        [bubble * by_r, bubble * by_s, -2.0 * zeta * l[k]]
    };
    std::array::from_fn(|node| match place(node) {
        Place::Side(k, side) => {
            let share = 0.5 * (1.0 + side * zeta);
            let [by_r, by_s] = slopes[k];
            let own = [share * by_r, share * by_s, 0.5 * side * plane[k]];
            match k {
                0..3 => [0, 1, 2].map(|a| own[a] - 0.5 * between(k)[a]),
                _ => own,
            }
        }
        Place::Between(k) => between(k),
    })
}

/// Where a wedge's node is.
enum Place {
    /// Its number in the triangle, and ζ.
    Side(usize, f64),
    /// Its corner.
    Between(usize),
}

fn place(node: usize) -> Place {
    match node {
        0..CUBIC_NODES => Place::Side(node, -1.0),
        _ if node < 2 * CUBIC_NODES => Place::Side(node - CUBIC_NODES, 1.0),
        _ => Place::Between(node - 2 * CUBIC_NODES),
    }
}

/// Derivatives of a triangle's three barycentric coordinates by r, s.
const SLOPES: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];

/// Shape functions of the cubic triangle.
fn cubic_shapes([r, s]: [f64; 2]) -> [f64; CUBIC_NODES] {
    let l = [1.0 - r - s, r, s];
    CUBIC_SHARES.map(|node| (0..3).map(|k| factor(node[k], l[k]).0).product())
}

/// Derivatives of [`cubic_shapes`] by r, s.
pub(crate) fn cubic_gradients([r, s]: [f64; 2]) -> [[f64; 2]; CUBIC_NODES] {
    let l = [1.0 - r - s, r, s];
    CUBIC_SHARES.map(|node| {
        let factors = [0, 1, 2].map(|k| factor(node[k], l[k]));
        let by = |k: usize| factors[k].1 * factors[(k + 1) % 3].0 * factors[(k + 2) % 3].0;
        [0, 1].map(|a| (0..3).map(|k| by(k) * SLOPES[k][a]).sum())
    })
}

/// What a barycentric coordinate `l` adds to a node where it is `own`, and its derivative: 1 there, 0 at all
/// thirds below.
fn factor(own: f64, l: f64) -> (f64, f64) {
    match (3.0 * own).round() {
        0.0 => (1.0, 0.0),
        1.0 => (3.0 * l, 3.0),
        2.0 => (1.5 * l * (3.0 * l - 1.0), 9.0 * l - 1.5),
        _ => (
            0.5 * l * (3.0 * l - 1.0) * (3.0 * l - 2.0),
            13.5 * l * l - 9.0 * l + 1.0,
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEEL: Material = Material {
        lambda_pa: 1.1e11,
        mu_pa: 8.0e10,
        density_kg_m3: 7800.0,
    };

    /// Places of the nodes at r, s, ζ.
    fn local() -> Nodes {
        std::array::from_fn(|node| match place(node) {
            Place::Side(k, side) => [CUBIC_SHARES[k][1], CUBIC_SHARES[k][2], side],
            Place::Between(k) => [CUBIC_SHARES[k][1], CUBIC_SHARES[k][2], 0.0],
        })
    }

    /// Where a wedge that leans has its way along r, s, ζ.
    const LEANING: [[f64; 3]; 3] = [[1.0, 0.0, 0.2], [0.1, 0.9, 0.0], [0.0, -0.1, 0.1]];

    /// A thin wedge that leans.
    fn straight() -> Nodes {
        local().map(|at| [0, 1, 2].map(|a| (0..3).map(|k| at[k] * LEANING[k][a]).sum()))
    }

    /// A wedge of a cylinder's wall.
    fn curved() -> Nodes {
        local().map(|[r, s, zeta]| {
            let (sin, cos) = (0.5 * r).sin_cos();
            let radius = 2.0 + 0.1 * zeta;
            [radius * cos, radius * sin, s]
        })
    }

    #[test]
    fn shape_functions_are_one_at_home_and_zero_elsewhere() {
        for (j, at) in local().into_iter().enumerate() {
            for (i, value) in shapes(at).into_iter().enumerate() {
                let expected = f64::from(u8::from(i == j));
                assert!((value - expected).abs() < 1e-14, "{i} at {j}: {value}");
            }
        }
    }

    #[test]
    fn gradients_match_finite_differences() {
        let (x, h) = ([0.2, 0.3, -0.4], 1e-6);
        let gradients = shape_gradients(x);
        for a in 0..3 {
            let (mut up, mut down) = (x, x);
            up[a] += h;
            down[a] -= h;
            for (i, (p, q)) in shapes(up).into_iter().zip(shapes(down)).enumerate() {
                let slope = (p - q) / (2.0 * h);
                assert!((gradients[i][a] - slope).abs() < 1e-8, "{i} by {a}");
            }
        }
    }

    /// ∫ lᵖ mᑫ nʳ over a triangle's area is 2 p! q! r! / (p + q + r + 2)! of it.
    #[test]
    fn rules_are_exact_to_their_degree() {
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        for (rule, degree) in [(&DEGREE_4[..], 4), (&DEGREE_6[..], 6)] {
            for p in 0..=degree {
                for q in 0..=degree - p {
                    let r = degree - p - q;
                    let sum: f64 = rule
                        .iter()
                        .map(|([x, y], w)| w * (1.0 - x - y).powi(p) * x.powi(q) * y.powi(r))
                        .sum();
                    let expected =
                        factorial(p) * factorial(q) * factorial(r) / factorial(degree + 2);
                    assert!((sum - expected).abs() < 1e-13, "{degree}: {p} {q} {r}");
                }
            }
        }
    }

    #[test]
    fn mass_sums_to_density_times_volume() {
        let slab = determinant(&LEANING);
        let ring = 0.5 * 0.5 * 2.0 * 0.2;
        for (nodes, volume, error) in [(straight(), slab, 1e-12), (curved(), ring, 1e-4)] {
            let element = Wedge23::new(&nodes, &STEEL).unwrap();
            let total: f64 = element.mass.iter().flatten().sum();
            assert!((total / (volume * STEEL.density_kg_m3) - 1.0).abs() < error);
            assert!((wedge23_volume(&nodes) / volume - 1.0).abs() < error);
        }
    }

    fn energy(nodes: &Nodes, motion: &dyn Fn([f64; 3]) -> [f64; 3]) -> f64 {
        let element = Wedge23::new(nodes, &STEEL).unwrap();
        let u = nodes.map(motion);
        let mut energy = 0.0;
        for i in 0..WEDGE_NODES {
            for j in 0..WEDGE_NODES {
                for a in 0..3 {
                    for b in 0..3 {
                        energy += 0.5 * u[i][a] * element.stiffness[i][j][a][b] * u[j][b];
                    }
                }
            }
        }
        energy
    }

    #[test]
    fn rigid_motion_uniform_strain_and_uniform_bending_are_exact() {
        let slab = straight();
        let volume = wedge23_volume(&slab);
        let expected = 0.5 * (STEEL.lambda_pa + 2.0 * STEEL.mu_pa) * 1e-6 * volume;
        let stretch = energy(&slab, &|p| [1e-3 * p[0], 0.0, 0.0]);
        assert!((stretch / expected - 1.0).abs() < 1e-12);
        for nodes in [slab, curved()] {
            let shift = energy(&nodes, &|_| [1e-3, 2e-3, -1e-3]);
            let turn = energy(&nodes, &|p| [-1e-3 * p[1], 1e-3 * p[0], 0.0]);
            assert!(shift.abs() < 1e-11 * expected);
            assert!(turn.abs() < 1e-11 * expected);
        }
        // A flat plate bent to a cylinder, thinner where it is stretched: E/(1 − ν²) κ² h³/24 to an area.
        let plate = local().map(|[r, s, zeta]| [r, s, 0.05 * zeta]);
        let nu = STEEL.poisson();
        let bent = energy(&plate, &|[x, _, z]| {
            let thinning = 0.5 * nu / (1.0 - nu) * z * z;
            [-1e-3 * x * z, 0.0, 1e-3 * (0.5 * x * x + thinning)]
        });
        let rigidity = STEEL.young_pa() / (1.0 - nu * nu) * 0.1f64.powi(3) / 12.0;
        let expected = 0.5 * 0.5 * rigidity * 1e-6;
        assert!((bent / expected - 1.0).abs() < 1e-10, "{}", bent / expected);
    }

    #[test]
    fn an_inverted_element_is_refused() {
        let inverted = straight().map(|[x, y, z]| [y, x, z]);
        assert!(Wedge23::new(&inverted, &STEEL).is_none());
        assert!(wedge23_least_jacobian(&inverted) < 0.0);
    }
}
