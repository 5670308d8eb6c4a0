//! What a mesh's file tells before anything is built.

use modes::Up;
use modes::solid::{Soup, read_obj, upright};
use std::path::{Path, PathBuf};

/// What is in a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facts {
    /// The file.
    pub path: PathBuf,
    /// Its objects.
    pub objects: Vec<Part>,
    /// Triangles of all objects.
    pub triangles: usize,
    /// Which axis points up, if the mesh shows it.
    pub up: Option<Up>,
}

/// An object of a file, and the corners of its bounding box in the file's units.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// What the file calls it; empty if it has no name.
    pub name: String,
    /// The box's lowest corner.
    pub low: [f64; 3],
    /// Its highest.
    pub high: [f64; 3],
}

impl Facts {
    /// Those of the file at `path`; what is wrong with it, and the cure, if it is no mesh.
    pub(super) fn of(path: &Path) -> Result<Self, String> {
        let soup = read_obj(path).map_err(|error| error.to_string())?.soup;
        let objects = soup.objects.iter().map(|object| {
            let triangles = &soup.triangles[object.triangles.clone()];
            Part::of(&soup, &object.name, triangles)
        });
        Ok(Self {
            path: path.to_path_buf(),
            objects: objects.collect(),
            triangles: soup.triangles.len(),
            up: upright(&soup),
        })
    }

    /// The file's name.
    #[must_use]
    pub fn file_name(&self) -> String {
        let name = self.path.file_name().unwrap_or_default();
        name.to_string_lossy().into_owned()
    }

    /// The file's name without its ending.
    #[must_use]
    pub fn stem(&self) -> String {
        let stem = self.path.file_stem().unwrap_or_default();
        stem.to_string_lossy().into_owned()
    }

    /// Names of its objects, each once, in their order.
    #[must_use]
    pub fn names(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for part in &self.objects {
            if !part.name.is_empty() && !names.contains(&part.name.as_str()) {
                names.push(&part.name);
            }
        }
        names
    }

    /// The longest side of the box around the objects of these names, all if there are none, in the file's
    /// units.
    #[must_use]
    pub fn longest(&self, names: &[String]) -> f64 {
        let meant = |part: &&Part| names.is_empty() || names.contains(&part.name);
        let side = |axis: usize| {
            let parts = || self.objects.iter().filter(meant);
            let high = parts().map(|part| part.high[axis]).fold(f64::MIN, f64::max);
            high - parts().map(|part| part.low[axis]).fold(f64::MAX, f64::min)
        };
        (0..3).map(side).fold(0.0, f64::max)
    }
}

impl Part {
    fn of(soup: &Soup, name: &str, triangles: &[[u32; 3]]) -> Self {
        let (mut low, mut high) = ([f64::MAX; 3], [f64::MIN; 3]);
        let corners = triangles.iter().flatten();
        for point in corners.filter_map(|i| soup.points.get(*i as usize)) {
            for axis in 0..3 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        Self {
            name: name.to_owned(),
            low,
            high,
        }
    }
}

/// The size in m that a body `longest` file units long most likely has: instruments are between a few
/// centimetres and a few metres long, and files are in metres, centimetres or millimetres.
#[must_use]
pub fn guessed_size_m(longest: f64) -> f64 {
    let to_m = match longest {
        x if x <= 5.0 => 1.0,
        x if x < 20.0 => 1e-2,
        _ => 1e-3,
    };
    (to_m * longest).clamp(0.001, 10.0)
}
