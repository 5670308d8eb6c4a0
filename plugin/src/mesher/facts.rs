//! What a mesh's file tells before anything is built.

use modes::solid::{Soup, read_obj};
use std::path::{Path, PathBuf};

/// What is in a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facts {
    /// The file.
    pub path: PathBuf,
    /// Its objects, each with the longest side of its bounding box in the file's units.
    pub objects: Vec<(String, f64)>,
    /// The longest side of all in one, in the file's units.
    pub longest: f64,
    /// Triangles of all objects.
    pub triangles: usize,
}

impl Facts {
    /// Those of the file at `path`; what is wrong with it, and the cure, if it is no mesh.
    pub(super) fn of(path: &Path) -> Result<Self, String> {
        let soup = read_obj(path).map_err(|error| error.to_string())?.soup;
        let objects = soup.objects.iter();
        let objects = objects.map(|object| {
            let triangles = &soup.triangles[object.triangles.clone()];
            (object.name.clone(), longest(&soup, triangles))
        });
        Ok(Self {
            path: path.to_path_buf(),
            objects: objects.collect(),
            longest: longest(&soup, &soup.triangles),
            triangles: soup.triangles.len(),
        })
    }

    /// The file's name.
    #[must_use]
    pub fn file_name(&self) -> String {
        let name = self.path.file_name().unwrap_or_default();
        name.to_string_lossy().into_owned()
    }
}

/// The longest side of the bounding box of some triangles.
fn longest(soup: &Soup, triangles: &[[u32; 3]]) -> f64 {
    let side = |axis: usize| {
        let at = |i: &u32| soup.points.get(*i as usize).map(|point| point[axis]);
        let places = || triangles.iter().flatten().filter_map(at);
        places().fold(f64::MIN, f64::max) - places().fold(f64::MAX, f64::min)
    };
    (0..3).map(side).fold(0.0, f64::max)
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
