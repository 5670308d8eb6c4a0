//! From a closed surface to its mesh.

use super::body::Body;
use super::features::Features;
use super::filling::{STEPS, fitted};
use super::fit::{Curved, curve};
use super::hollow::hollow;
use super::quality::{dihedrals_deg, volume_length};
use super::repair::length;
use super::sheet::sheet;
use super::shell::{Outer, Wall};
use super::stuffing::Tets;
use super::{ClosedSurface, MeshError, Meshing, Note, Quality, Resolution, resolution, shell};
use crate::factory::Progress;
use crate::mesh::Mesh;

/// Volume over that of the surface below which parts are said to be lost.
const LOST: f64 = 0.97;

/// Nodes of a wall over those asked for from which that is said.
const MORE: f64 = 1.4;

/// A meshed body.
#[derive(Clone, Debug, PartialEq)]
pub struct Meshed {
    /// Ten-node tetrahedra, or the wedges of a thin wall, in m.
    pub mesh: Mesh,
    /// The surface that was filled, in m.
    pub surface: ClosedSurface,
    /// The elements' shapes.
    pub quality: Quality,
    /// What the owner should know, repairs included.
    pub notes: Vec<Note>,
}

/// Fills `surface` with ten-node tetrahedra, or makes a thin wall within it of wedges, its sharp edges kept and its curved sides followed by the
/// nodes in the middle of edges.
///
/// # Errors
///
/// [`MeshError`] if the body is too thin for the nodes allowed, or `progress` breaks.
pub fn mesh_solid(
    surface: &ClosedSurface,
    how: &Meshing,
    progress: &dyn Progress,
) -> Result<Meshed, MeshError> {
    check(surface, how)?;
    let mut notes = surface.notes.clone();
    let (
        Curved {
            mesh,
            straight_share,
        },
        straight,
    ) = elements(surface, how, progress, &mut notes)?;
    let quality = quality(&straight, &mesh, straight_share);
    let share = quality.volume_m3 / surface.volume_m3();
    if how.wall_m.is_none() && share < LOST && !notes.contains(&Note::Overlaps) {
        notes.push(Note::Lost { share });
    }
    if progress.advance(STEPS, STEPS).is_break() {
        return Err(MeshError::Cancelled);
    }
    Ok(Meshed {
        mesh,
        surface: surface.clone(),
        quality,
        notes,
    })
}

/// The body's elements, curved and straight.
fn elements(
    surface: &ClosedSurface,
    how: &Meshing,
    progress: &dyn Progress,
    notes: &mut Vec<Note>,
) -> Result<(Curved, Tets), MeshError> {
    if progress.advance(0, STEPS).is_break() {
        return Err(MeshError::Cancelled);
    }
    if how.wall_m.is_none()
        && let Some((wall, [thin_m, thick_m])) = sheet(surface, how)
    {
        notes.push(Note::Sheet { thin_m, thick_m });
        return Ok(walled(wall, how, thin_m, notes));
    }
    let features = Features::of(surface);
    if let (Some(wall_m), Some(outer)) = (how.wall_m, resolution::outer(surface, how)) {
        let (body, mut own) = (Body::new(surface, None), Vec::new());
        if let Some(wall) = hollow(surface, &body, &features, wall_m, how) {
            return Ok(walled(wall, how, wall_m, notes));
        }
        match fitted(surface, &body, &features, &outer, progress, &mut own) {
            Ok(fit) => {
                if let Some(wall) = shell::wall(&Outer::of(&fit), wall_m) {
                    notes.append(&mut own);
                    return Ok(walled(wall, how, wall_m, notes));
                }
            }
            Err(MeshError::Cancelled) => return Err(MeshError::Cancelled),
            // Cells in the wall may still do.
            Err(_) => {}
        }
    }
    let body = Body::new(surface, how.wall_m);
    let fit = fitted(surface, &body, &features, how, progress, notes)?;
    Ok((curve(&fit), fit.mesh))
}

/// The elements of a wall, and what its owner should know.
fn walled(wall: Wall, how: &Meshing, wall_m: f64, notes: &mut Vec<Note>) -> (Curved, Tets) {
    if wall.thinner > 0 {
        notes.push(Note::Thinner {
            points: wall.thinner,
        });
    }
    notes.extend(finer(how, wall_m, wall.mesh.nodes.len()));
    let curved = Curved {
        mesh: wall.mesh,
        straight_share: wall.flat_share,
    };
    (curved, wall.straight)
}

/// That a wall has more nodes than were asked for, its wedges being no wider.
fn finer(how: &Meshing, thin_m: f64, nodes: usize) -> Option<Note> {
    match how.resolution {
        Resolution::Nodes(asked) if nodes as f64 > MORE * asked as f64 => Some(Note::Finer {
            thin_m,
            nodes,
            asked,
        }),
        _ => None,
    }
}

/// That lengths are lengths.
fn check(surface: &ClosedSurface, how: &Meshing) -> Result<(), MeshError> {
    let (low, high) = surface.bounds_m();
    let longest = (0..3).map(|a| high[a] - low[a]).fold(0.0, f64::max);
    if let Some(wall_m) = how.wall_m {
        length("the wall", wall_m, (1e-4 * longest, longest))?;
    }
    if let Resolution::CellM(cell_m) = how.resolution {
        length("the cells' size", cell_m, (1e-3 * longest, longest))?;
    }
    Ok(())
}

fn quality(straight: &Tets, mesh: &Mesh, straight_share: f64) -> Quality {
    let (mut least, mut most, mut worst) = (180.0f64, 0.0f64, f64::INFINITY);
    for tet in &straight.tets {
        let corners = tet.map(|i| straight.points[i as usize]);
        let (low, high) = dihedrals_deg(corners);
        least = least.min(low);
        most = most.max(high);
        worst = worst.min(volume_length(corners));
    }
    Quality {
        min_dihedral_deg: least,
        max_dihedral_deg: most,
        min_volume_length: worst,
        elements: straight.tets.len(),
        nodes: mesh.nodes.len(),
        volume_m3: mesh.volume_m3(),
        straight_share,
    }
}
