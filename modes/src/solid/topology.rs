//! Which tetrahedra meet at which face.

use crate::mesh::TET_FACES;

/// Every face of every tetrahedron, sorted by its corners.
pub(super) struct Faces {
    faces: Vec<Face>,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Face {
    sorted: [u32; 3],
    tet: u32,
    local: u8,
}

impl Faces {
    pub(super) fn of(tets: &[[u32; 4]]) -> Self {
        let mut faces: Vec<Face> = (0u32..)
            .zip(tets)
            .flat_map(|(tet, corners)| {
                [0u8, 1, 2, 3].map(|local| {
                    let mut sorted = TET_FACES[usize::from(local)].map(|i| corners[i]);
                    sorted.sort_unstable();
                    Face { sorted, tet, local }
                })
            })
            .collect();
        faces.sort_unstable();
        Self { faces }
    }

    fn groups(&self) -> impl Iterator<Item = &[Face]> {
        self.faces.chunk_by(|a, b| a.sorted == b.sorted)
    }

    /// For each tetrahedron the one across each of its faces.
    pub(super) fn neighbours(&self, tets: usize) -> Vec<[Option<u32>; 4]> {
        let mut neighbours = vec![[None; 4]; tets];
        for group in self.groups() {
            if let &[a, b] = group {
                neighbours[a.tet as usize][usize::from(a.local)] = Some(b.tet);
                neighbours[b.tet as usize][usize::from(b.local)] = Some(a.tet);
            }
        }
        neighbours
    }

    /// Faces with nothing beyond, counter-clockwise from outside, and their tetrahedra.
    pub(super) fn outside(&self, tets: &[[u32; 4]]) -> Vec<([u32; 3], u32)> {
        self.groups()
            .filter(|group| group.len() == 1)
            .map(|group| {
                let face = group[0];
                let corners = tets[face.tet as usize];
                (
                    TET_FACES[usize::from(face.local)].map(|i| corners[i]),
                    face.tet,
                )
            })
            .collect()
    }
}
