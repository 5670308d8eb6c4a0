//! From triangles as they come to a closed surface.

mod clean;
pub(super) mod edges;
mod holes;
mod orient;
mod pieces;
mod weld;

use super::closed::signed_volume;
use super::tree::Tree;
use super::vector::{bounds, doubled_area, norm, scale, sub};
use super::{ClosedSurface, MeshError, Note, Soup};
use edges::Edges;

/// Sizes that a body may have, in m.
const SIZES_M: (f64, f64) = (1e-4, 100.0);

/// Sizes that need no note, in m.
const USUAL_M: (f64, f64) = (5e-3, 10.0);

/// What a mesh is to become.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repair {
    /// Longest side of the bounding box, in m; without, the file's unit tells.
    pub size_m: Option<f64>,
    /// What one of the file's units is, in m.
    pub unit_m: f64,
    /// Which of several pieces are the body.
    pub pieces: Pieces,
}

impl Default for Repair {
    /// All of a file in metres.
    fn default() -> Self {
        Self {
            size_m: None,
            unit_m: 1.0,
            pieces: Pieces::default(),
        }
    }
}

/// Which of several separate pieces to keep.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pieces {
    /// All: where they overlap they are one.
    #[default]
    All,
    /// The one that encloses most, with the hollows in it.
    Largest,
    /// The n-th from the largest, counted from 0, with the hollows in it.
    Nth(usize),
}

/// Triangles on their way to a surface.
struct Work {
    points: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    notes: Vec<Note>,
}

impl Work {
    fn corners(&self, triangle: &[u32; 3]) -> [[f64; 3]; 3] {
        triangle.map(|i| self.points[i as usize])
    }

    fn area(&self) -> f64 {
        let area = |t| 0.5 * norm(doubled_area(self.corners(t)));
        self.triangles.iter().map(area).sum()
    }
}

/// Closes `soup`: welds its points, drops what has no area or lies double, turns faces to agree and
/// pieces outwards, closes small holes, and scales.
///
/// # Errors
///
/// [`MeshError`] says what keeps it from being a solid.
pub fn repair(soup: &Soup, how: &Repair) -> Result<ClosedSurface, MeshError> {
    if let Some(size_m) = how.size_m {
        length("the size", size_m, SIZES_M)?;
    }
    check(soup)?;
    let mut work = Work {
        points: soup.points.clone(),
        triangles: soup.triangles.clone(),
        notes: Vec::new(),
    };
    weld::weld(&mut work);
    clean::drop_flat(&mut work);
    clean::drop_doubles(&mut work);
    if work.triangles.len() < 3 {
        return Err(MeshError::TooFewFaces {
            faces: work.triangles.len(),
        });
    }
    orient::agree(&mut work)?;
    holes::close(&mut work)?;
    pieces::choose(&mut work, how.pieces)?;
    // Pieces turned where others share an edge with them open it.
    holes::close(&mut work)?;
    let many = Edges::of(&work.triangles).many_faced();
    if many > 0 {
        work.notes.push(Note::ManyFaced { edges: many });
    }
    let (volume, area) = (signed_volume(&work.points, &work.triangles), work.area());
    // A sphere has 0.094, a sheet as thin as a thousandth of its width about 4e-4.
    if volume.is_nan() || volume < 1e-7 * area.powf(1.5) && !encloses(&work) {
        return Err(MeshError::Flat);
    }
    sized(work, how)
}

/// That each corner is a point in space.
fn check(soup: &Soup) -> Result<(), MeshError> {
    let good = |&i: &u32| {
        let point = soup.points.get(i as usize);
        // Squares of coordinates must be finite too.
        point.is_some_and(|p| p.iter().all(|x| x.abs() < 1e100))
    };
    match soup.triangles.iter().position(|t| !t.iter().all(good)) {
        Some(triangle) => Err(MeshError::BadTriangle { triangle }),
        None => Ok(()),
    }
}

/// Whether a point of a grid over the box is inside: a surface that turns inside out halfway has no
/// volume but encloses some.
fn encloses(work: &Work) -> bool {
    const GRID: usize = 12;
    let tree = Tree::new(&work.points, &work.triangles);
    let used = work.triangles.iter().flatten();
    let (low, high) = bounds(used.map(|&i| work.points[i as usize]));
    let side = sub(high, low);
    if side.iter().any(|&x| x < 1e-5 * norm(side)) {
        return false;
    }
    let place =
        |step: usize, a: usize| low[a] + (high[a] - low[a]) * (step as f64 + 0.47) / GRID as f64;
    (0..GRID.pow(3)).any(|n| {
        let p = [
            place(n % GRID, 0),
            place(n / GRID % GRID, 1),
            place(n / GRID / GRID, 2),
        ];
        tree.winding(p).abs() > 0.75
    })
}

/// That a length is between two.
pub(super) fn length(
    what: &'static str,
    value_m: f64,
    (least_m, most_m): (f64, f64),
) -> Result<(), MeshError> {
    if (least_m..=most_m).contains(&value_m) {
        return Ok(());
    }
    Err(MeshError::Length {
        what,
        value_m,
        least_m,
        most_m,
    })
}

/// The surface in metres about the middle of its box, without the points that no triangle uses.
fn sized(mut work: Work, how: &Repair) -> Result<ClosedSurface, MeshError> {
    let used = work.triangles.iter().flatten();
    let (low, high) = bounds(used.map(|&i| work.points[i as usize]));
    let longest = (0..3).map(|a| high[a] - low[a]).fold(0.0, f64::max);
    let longest_m = how.size_m.unwrap_or(how.unit_m * longest);
    length("the body's longest side", longest_m, SIZES_M)?;
    if !(USUAL_M.0..=USUAL_M.1).contains(&longest_m) {
        work.notes.push(Note::Size { longest_m });
    }
    let middle = [0, 1, 2].map(|a| 0.5 * (low[a] + high[a]));
    let mut ids = vec![u32::MAX; work.points.len()];
    let mut points_m = Vec::new();
    for corner in work.triangles.iter_mut().flatten() {
        let id = &mut ids[*corner as usize];
        if *id == u32::MAX {
            *id = u32::try_from(points_m.len()).unwrap_or(u32::MAX);
            let from_middle = sub(work.points[*corner as usize], middle);
            points_m.push(scale(from_middle, longest_m / longest));
        }
        *corner = *id;
    }
    Ok(ClosedSurface {
        points_m,
        triangles: work.triangles,
        notes: work.notes,
    })
}
