//! Vectors of three components.

/// A place, a direction or a displacement.
pub type Vector = [f32; 3];

/// a·b.
pub(crate) fn dot(a: Vector, b: Vector) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a × b.
pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// a + share·b.
pub(crate) fn add(a: Vector, share: f32, b: Vector) -> Vector {
    [0, 1, 2].map(|k| a[k] + share * b[k])
}

/// The share 0…1 of the way from `a` to `b`.
pub(crate) fn between(a: Vector, b: Vector, share: f32) -> Vector {
    [0, 1, 2].map(|k| a[k] + share * (b[k] - a[k]))
}

/// The same direction with length 1; nothing stays nothing.
pub(crate) fn unit(a: Vector) -> Vector {
    let length = dot(a, a).sqrt();
    if length > 0.0 {
        a.map(|x| x / length)
    } else {
        a
    }
}
