//! Which shape a recipe takes out of a mesh's file, how large, and which way up.

use std::fmt::{self, Display, Formatter};
use std::path::PathBuf;

/// A shape out of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshShape {
    /// The file, in Wavefront's OBJ format.
    pub file: PathBuf,
    /// Those of its objects that are meant, together one body; all if none is named.
    pub objects: Vec<String>,
    /// How large it is.
    pub scale: MeshScale,
    /// Thickness of its wall, in m; without, it is solid.
    pub wall_m: Option<f64>,
    /// Which of the file's axes points up.
    pub up: Up,
}

/// How large a mesh is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeshScale {
    /// The longest side of its bounding box, in m.
    Longest(f64),
    /// What one of the file's units is, in m.
    Unit(f64),
}

/// The axis of a file that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// The first.
    X,
    /// The second, as most programs write meshes.
    Y,
    /// The third, as in banks.
    #[default]
    Z,
}

impl Up {
    /// All of them, in the order of the file's axes.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// The one of that name, as recipes have it: `x`, `y` or `z`.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|up| up.name() == name)
    }

    /// Its name, as recipes have it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        }
    }

    /// A point of the file turned so that this axis is the third; right-handed as before.
    #[must_use]
    pub fn turned(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self {
            Self::X => [y, z, x],
            Self::Y => [x, -z, y],
            Self::Z => [x, y, z],
        }
    }
}

impl Display for MeshShape {
    /// The file, and the objects if some are named.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        if self.objects.is_empty() {
            return Ok(());
        }
        write!(f, " ({})", self.objects.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::Up;

    #[test]
    fn the_axis_comes_to_point_up_and_nothing_is_mirrored() {
        for (axis, up) in Up::ALL.into_iter().enumerate() {
            let unit = |a: usize| [0, 1, 2].map(|b| f64::from(u8::from(a == b)));
            assert_eq!(up.turned(unit(axis)), [0.0, 0.0, 1.0], "{}", up.name());
            let [u, v, w] = [0, 1, 2].map(|a| up.turned(unit(a)));
            let volume = u[0] * (v[1] * w[2] - v[2] * w[1])
                + u[1] * (v[2] * w[0] - v[0] * w[2])
                + u[2] * (v[0] * w[1] - v[1] * w[0]);
            assert_eq!(volume, 1.0);
            assert_eq!(Up::named(up.name()), Some(up));
        }
        assert_eq!(Up::named("Y"), None);
    }
}
