//! Triangles as a file gives them: they need not close, nor agree, nor be one body.

use super::MeshError;
use std::ops::Range;

/// Triangles of one or several objects, in the file's own units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Soup {
    /// Corners, in the file's units.
    pub points: Vec<[f64; 3]>,
    /// Corner numbers, counter-clockwise from outside if the file keeps to that.
    pub triangles: Vec<[u32; 3]>,
    /// The objects, in the file's order.
    pub objects: Vec<SoupObject>,
}

/// A named part of a [`Soup`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SoupObject {
    /// What the file calls it; empty if it has no name.
    pub name: String,
    /// Its triangles.
    pub triangles: Range<usize>,
}

impl Soup {
    /// Triangles that are a single object without a name.
    #[must_use]
    pub fn single(points: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Self {
        let object = SoupObject {
            name: String::new(),
            triangles: 0..triangles.len(),
        };
        Self {
            points,
            triangles,
            objects: vec![object],
        }
    }

    /// The points and the triangles.
    #[must_use]
    pub fn into_parts(self) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
        (self.points, self.triangles)
    }

    /// The objects of these names, alone.
    ///
    /// # Errors
    ///
    /// [`MeshError::NoSuchObject`] names those there are.
    pub fn only(&self, names: &[String]) -> Result<Self, MeshError> {
        let mut chosen = Self {
            points: self.points.clone(),
            ..Self::default()
        };
        for name in names {
            let object = self.object(name)?;
            let first = chosen.triangles.len();
            chosen.triangles.extend(object.triangles);
            chosen.objects.push(SoupObject {
                name: name.clone(),
                triangles: first..chosen.triangles.len(),
            });
        }
        Ok(chosen)
    }

    /// The objects called `name`, alone.
    ///
    /// # Errors
    ///
    /// [`MeshError::NoSuchObject`] names those there are.
    pub fn object(&self, name: &str) -> Result<Self, MeshError> {
        let chosen: Vec<[u32; 3]> = self
            .objects
            .iter()
            .filter(|object| object.name == name)
            .flat_map(|object| self.triangles[object.triangles.clone()].iter().copied())
            .collect();
        if chosen.is_empty() {
            return Err(MeshError::NoSuchObject {
                name: name.to_owned(),
                names: self.objects.iter().map(|o| o.name.clone()).collect(),
            });
        }
        let mut alone = Self::single(self.points.clone(), chosen);
        name.clone_into(&mut alone.objects[0].name);
        Ok(alone)
    }

    /// Adds `other` as further objects.
    pub fn append(&mut self, other: &Self) {
        let (point, triangle) = (self.points.len(), self.triangles.len());
        let shift = u32::try_from(point).unwrap_or(u32::MAX);
        self.points.extend_from_slice(&other.points);
        let moved = other.triangles.iter().map(|t| t.map(|i| i + shift));
        self.triangles.extend(moved);
        self.objects
            .extend(other.objects.iter().map(|o| SoupObject {
                name: o.name.clone(),
                triangles: o.triangles.start + triangle..o.triangles.end + triangle,
            }));
    }
}
