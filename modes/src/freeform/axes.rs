//! Middle, principal axes and extent of a body, by its surface.

/// Where a body is and how it lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    /// Middle of its extent along its axes, in m.
    pub(super) middle_m: [f64; 3],
    /// Unit vectors: along its longest extent, then along the next and the shortest; right-handed.
    pub(super) axes: [[f64; 3]; 3],
    /// Half its extent along each, in m.
    pub(super) half_m: [f64; 3],
}

/// Sweeps of Jacobi's method: each more than squares what is left beside the diagonal.
const SWEEPS: usize = 12;

impl Frame {
    /// Of a surface of `triangles`: the axes are those of the second moments of its area.
    pub(super) fn of(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> Self {
        let corners = || triangles.iter().map(|t| t.map(|i| points[i as usize]));
        let (mut area, mut middle) = (0.0, [0.0; 3]);
        for triangle in corners() {
            let part = area_m2(&triangle);
            area += part;
            for a in 0..3 {
                middle[a] += part * triangle.iter().map(|p| p[a]).sum::<f64>() / 3.0;
            }
        }
        let middle = middle.map(|x| x / area);
        let mut moments = [[0.0; 3]; 3];
        for triangle in corners() {
            let part = area_m2(&triangle) / 12.0;
            let arms = triangle.map(|p| [0, 1, 2].map(|a| p[a] - middle[a]));
            let sum = [0, 1, 2].map(|a| arms.iter().map(|arm| arm[a]).sum::<f64>());
            for a in 0..3 {
                for b in 0..3 {
                    let own: f64 = arms.iter().map(|arm| arm[a] * arm[b]).sum();
                    moments[a][b] += part * (own + sum[a] * sum[b]);
                }
            }
        }
        let axes = principal(moments);
        let mut frame = Self {
            middle_m: middle,
            axes,
            half_m: [0.0; 3],
        };
        let used = || triangles.iter().flatten().map(|&i| points[i as usize]);
        let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for point in used() {
            for (end, x) in ends.iter_mut().zip(frame.local(point)) {
                *end = [end[0].min(x), end[1].max(x)];
            }
        }
        let centre = ends.map(|[low, high]| 0.5 * (low + high));
        frame.middle_m = frame.world(centre);
        frame.half_m = ends.map(|[low, high]| 0.5 * (high - low));
        frame
    }

    /// Coordinates of `point` along the axes from the middle, in m.
    pub(super) fn local(&self, point: [f64; 3]) -> [f64; 3] {
        let arm = [0, 1, 2].map(|a| point[a] - self.middle_m[a]);
        self.axes.map(|axis| (0..3).map(|a| axis[a] * arm[a]).sum())
    }

    /// The point at these coordinates along the axes from the middle, in m.
    pub(super) fn world(&self, local: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|a| {
            let along = (0..3).map(|i| self.axes[i][a] * local[i]).sum::<f64>();
            self.middle_m[a] + along
        })
    }
}

pub(super) fn area_m2(triangle: &[[f64; 3]; 3]) -> f64 {
    0.5 * doubled_area(triangle)
        .iter()
        .map(|x| x * x)
        .sum::<f64>()
        .sqrt()
}

/// Cross product of two sides: outwards, twice the area long.
pub(super) fn doubled_area([p, q, r]: &[[f64; 3]; 3]) -> [f64; 3] {
    let [u, v] = [q, r].map(|q| [0, 1, 2].map(|a| q[a] - p[a]));
    cross(u, v)
}

fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}

/// Eigenvectors of a symmetric matrix by falling eigenvalue, right-handed (Jacobi 1846).
fn principal(mut m: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    let mut vectors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let (difference, beside) = (m[q][q] - m[p][p], m[p][q]);
            if beside.abs() <= 1e-14 * (m[0][0] + m[1][1] + m[2][2]) {
                continue;
            }
            let angle = 0.5 * (2.0 * beside).atan2(difference);
            let (sin, cos) = angle.sin_cos();
            for row in &mut m {
                (row[p], row[q]) = (cos * row[p] - sin * row[q], sin * row[p] + cos * row[q]);
            }
            for k in 0..3 {
                (m[p][k], m[q][k]) = (cos * m[p][k] - sin * m[q][k], sin * m[p][k] + cos * m[q][k]);
                (vectors[p][k], vectors[q][k]) = (
                    cos * vectors[p][k] - sin * vectors[q][k],
                    sin * vectors[p][k] + cos * vectors[q][k],
                );
            }
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| m[j][j].total_cmp(&m[i][i]));
    let [first, second] = [vectors[order[0]], vectors[order[1]]];
    [first, second, cross(first, second)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::brick_tet10;

    #[test]
    fn a_brick_lies_along_its_sides_however_it_is_turned() {
        let mut mesh = brick_tet10([0.1, 0.3, 0.2], [2, 3, 2]);
        let (sin, cos) = 0.7f64.sin_cos();
        for p in &mut mesh.nodes {
            let [x, y, z] = *p;
            *p = [cos * x - sin * y + 1.0, sin * x + cos * y, z - 2.0];
        }
        let frame = Frame::of(&mesh.nodes, &mesh.surface());
        let near = |x: f64, y: f64| assert!((x - y).abs() < 1e-9, "{frame:?}");
        for (found, expected) in frame.half_m.iter().zip([0.15, 0.1, 0.05]) {
            near(*found, expected);
        }
        for (found, expected) in frame.middle_m.iter().zip([1.0, 0.0, -2.0]) {
            near(*found, expected);
        }
        near(frame.axes[0][1].abs(), cos);
        near(frame.axes[1][2].abs(), 1.0);
        let back = frame.local(frame.world([0.1, 0.2, 0.3]));
        for (found, expected) in back.iter().zip([0.1, 0.2, 0.3]) {
            near(*found, expected);
        }
    }
}
