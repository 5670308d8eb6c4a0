//! Which triangles meet at which edge.

/// Every side of every triangle, sorted by its edge.
pub(in crate::solid) struct Edges {
    sides: Vec<Side>,
}

/// A triangle's side.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::solid) struct Side {
    /// The lower end, then the higher.
    pub(in crate::solid) edge: [u32; 2],
    /// The triangle.
    pub(in crate::solid) triangle: u32,
    /// Whether the triangle goes from the lower to the higher.
    pub(in crate::solid) up: bool,
}

impl Edges {
    pub(in crate::solid) fn of(triangles: &[[u32; 3]]) -> Self {
        let mut sides: Vec<Side> = (0u32..)
            .zip(triangles)
            .flat_map(|(triangle, &[a, b, c])| {
                [[a, b], [b, c], [c, a]].map(|[p, q]| Side {
                    edge: [p.min(q), p.max(q)],
                    triangle,
                    up: p < q,
                })
            })
            .collect();
        sides.sort_unstable();
        Self { sides }
    }

    /// The sides at each edge in turn.
    pub(in crate::solid) fn iter(&self) -> impl Iterator<Item = &[Side]> {
        self.sides.chunk_by(|a, b| a.edge == b.edge)
    }

    /// Edges with more than two faces.
    pub(in crate::solid) fn many_faced(&self) -> usize {
        self.iter().filter(|sides| sides.len() > 2).count()
    }

    /// For each triangle, the neighbours across edges with just two faces, and whether the two agree
    /// on which side is out.
    pub(in crate::solid) fn neighbours(&self, triangles: usize) -> Vec<[Option<(u32, bool)>; 3]> {
        let mut neighbours = vec![[None; 3]; triangles];
        for sides in self.iter() {
            let &[a, b] = sides else { continue };
            for (one, other) in [(a, b), (b, a)] {
                let slots: &mut [_; 3] = &mut neighbours[one.triangle as usize];
                if let Some(free) = slots.iter_mut().find(|slot| slot.is_none()) {
                    *free = Some((other.triangle, one.up != other.up));
                }
            }
        }
        neighbours
    }
}
