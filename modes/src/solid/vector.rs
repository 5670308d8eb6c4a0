//! Arithmetic of points and arrows in space.

pub(super) fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn scale(a: [f64; 3], by: f64) -> [f64; 3] {
    a.map(|x| by * x)
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(super) fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// The arrow of length 1 along `a`, or nothing along nothing.
pub(super) fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = norm(a);
    if length > 0.0 {
        scale(a, 1.0 / length)
    } else {
        [0.0; 3]
    }
}

pub(super) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    norm(sub(a, b))
}

/// The point a share `t` of the way from `a` to `b`.
pub(super) fn lerp(a: [f64; 3], b: [f64; 3], t: f64) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] + t * (b[i] - a[i]))
}

/// Twice the area of a triangle, along its normal.
pub(super) fn doubled_area([p, q, r]: [[f64; 3]; 3]) -> [f64; 3] {
    cross(sub(q, p), sub(r, p))
}

/// Six times the volume of a tetrahedron, positive if its last corner sees the others turn
/// clockwise.
pub(super) fn six_volumes([p, q, r, s]: [[f64; 3]; 4]) -> f64 {
    dot(cross(sub(q, p), sub(r, p)), sub(s, p))
}

/// The least and greatest coordinates of `points`.
pub(super) fn bounds(points: impl IntoIterator<Item = [f64; 3]>) -> ([f64; 3], [f64; 3]) {
    let none = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    points.into_iter().fold(none, |(low, high), p| {
        (
            [0, 1, 2].map(|a| low[a].min(p[a])),
            [0, 1, 2].map(|a| high[a].max(p[a])),
        )
    })
}

/// The whole number below `x`, or 0.
#[expect(
    clippy::cast_sign_loss,
    reason = "below 0 the cast gives 0, as it should"
)]
pub(super) fn whole(x: f64) -> usize {
    x as usize
}
