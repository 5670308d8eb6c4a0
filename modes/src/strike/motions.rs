//! How far each of a body's modes moves wherever it is struck.

use super::grid::StrikeGrid;
use super::line::StrikeLine;
use super::tables::ShapeTables;
use crate::ModeShape;
use std::sync::Arc;

/// φ·n of the modes of one body anywhere on its strike grid; bodies of one drawing share the numbers.
#[derive(Clone, Debug)]
pub struct Motions {
    shapes: Vec<ModeShape>,
    normals: Arc<[[f64; 3]]>,
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    /// At one point after the other, all modes of the body with most of those that share them.
    Points {
        grid: StrikeGrid,
        normal: Arc<[f32]>,
        width: usize,
    },
    /// As products of the tables' first functions.
    Products {
        tables: Arc<ShapeTables>,
        first: [usize; 2],
    },
}

impl Motions {
    /// Of modes with these `shapes` on `line`.
    ///
    /// # Panics
    ///
    /// If a shape has not one value for each point of the line.
    #[must_use]
    pub fn new(line: &StrikeLine, shapes: Vec<ModeShape>) -> Self {
        let kind = products(&shapes).unwrap_or_else(|| points(line, &shapes));
        Self {
            normals: line.normals.as_slice().into(),
            shapes,
            kind,
        }
    }

    /// The same as [`Self::new`], sharing the numbers of `other` if its first shapes are the same but for
    /// their size.
    ///
    /// # Panics
    ///
    /// As [`Self::new`].
    #[must_use]
    pub fn like(other: &Self, line: &StrikeLine, shapes: Vec<ModeShape>) -> Self {
        let mut pairs = shapes.iter().zip(&other.shapes);
        let shared = shapes.len() <= other.shapes.len()
            && pairs.all(|(own, theirs)| own.shares_with(theirs))
            && *line.normals == *other.normals;
        if !shared || !matches!(other.kind, Kind::Points { .. }) {
            return Self::new(line, shapes);
        }
        Self {
            shapes,
            ..other.clone()
        }
    }

    /// Number of modes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.shapes.len()
    }

    /// Whether there are no modes.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.shapes.is_empty()
    }

    /// How many numbers [`Self::at`] needs to reckon with.
    #[must_use]
    pub fn scratch_len(&self) -> usize {
        match &self.kind {
            Kind::Points { .. } => 0,
            Kind::Products { first, .. } => first[0] + first[1],
        }
    }

    /// Writes φ·n in kg^(−1/2) of each mode at `place` along and across, 0…1 each; what is beyond the modes
    /// is set to 0. `scratch` has [`Self::scratch_len`] numbers, whatever they are. Does not allocate.
    ///
    /// # Panics
    ///
    /// If `scratch` is shorter, or a row of the grid has fewer than
    /// [`Stencil::POINTS`](crate::Stencil::POINTS) points.
    pub fn at(&self, place: [f64; 2], scratch: &mut [f64], to: &mut [f64]) {
        to.fill(0.0);
        match &self.kind {
            Kind::Points {
                grid,
                normal,
                width,
            } => {
                for (point, weight) in grid.spot(place[0], place[1]).points() {
                    let there = &normal[point * width..][..self.shapes.len()];
                    for (to, normal) in to.iter_mut().zip(there) {
                        *to += weight * f64::from(*normal);
                    }
                }
                for (to, shape) in to.iter_mut().zip(&self.shapes) {
                    *to *= f64::from(shape.scale());
                }
            }
            Kind::Products { tables, first } => {
                let (along, rest) = scratch.split_at_mut(first[0]);
                let across = &mut rest[..first[1]];
                tables.blend(place, [along, across]);
                for (to, shape) in to.iter_mut().zip(&self.shapes) {
                    if let Some(product) = shape.as_product() {
                        let [i, j] = product.which;
                        *to = f64::from(product.height) * along[i] * across[j];
                    }
                }
            }
        }
    }
}

/// The functions that products need, if all are products of the same tables.
fn products(shapes: &[ModeShape]) -> Option<Kind> {
    let tables = shapes.first()?.as_product()?.tables;
    let mut first = [0; 2];
    for shape in shapes {
        let product = shape.as_product()?;
        if !Arc::ptr_eq(product.tables, tables) {
            return None;
        }
        first = [0, 1].map(|axis| first[axis].max(product.which[axis] + 1));
    }
    Some(Kind::Products {
        tables: Arc::clone(tables),
        first,
    })
}

fn points(line: &StrikeLine, shapes: &[ModeShape]) -> Kind {
    // Without the factors by which bodies of one drawing differ.
    let plain: Vec<ModeShape> = shapes.iter().map(ModeShape::unscaled).collect();
    let width = shapes.len();
    let mut normal = Vec::with_capacity(width * line.len());
    for (i, n) in line.normals.iter().enumerate() {
        normal.extend(plain.iter().map(|shape| {
            let u = shape.at(i);
            (0..3).map(|a| f64::from(u[a]) * n[a]).sum::<f64>() as f32
        }));
    }
    Kind::Points {
        grid: line.grid(),
        normal: normal.into(),
        width,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line() -> StrikeLine {
        StrikeLine::single(
            (0..7).map(|i| [f64::from(i), 0.0, 0.0]).collect(),
            vec![[0.0, 0.6, 0.8]; 7],
        )
    }

    fn shapes() -> Vec<ModeShape> {
        let shape = |mode: u8| {
            (0..7)
                .map(move |i| [3.0, f32::from(i * mode), 1.0])
                .collect()
        };
        (1..4).map(shape).collect()
    }

    fn at(motions: &Motions, place: [f64; 2]) -> Vec<f64> {
        let mut found = vec![7.0; 5];
        let mut scratch = vec![0.0; motions.scratch_len()];
        motions.at(place, &mut scratch, &mut found);
        found
    }

    #[test]
    fn points_are_told_along_the_normal_and_the_rest_is_still() {
        let motions = Motions::new(&line(), shapes());
        for (mode, found) in at(&motions, [0.3, 0.0]).into_iter().enumerate() {
            let along = 0.3 * 6.0 * (mode + 1) as f64;
            let expected = if mode < 3 { 0.6 * along + 0.8 } else { 0.0 };
            assert!((found - expected).abs() < 1e-6, "{found} {expected}");
        }
    }

    #[test]
    fn smaller_bodies_of_one_drawing_share_the_numbers() {
        let whole = Motions::new(&line(), shapes());
        let fewer: Vec<ModeShape> = shapes_of(&whole).take(2).map(|s| s.scaled(0.5)).collect();
        let small = Motions::like(&whole, &line(), fewer);
        let numbers = |motions: &Motions| match &motions.kind {
            Kind::Points { normal, .. } => normal.as_ptr(),
            Kind::Products { .. } => panic!("they are no products"),
        };
        assert_eq!(numbers(&small), numbers(&whole));
        let (own, theirs) = (at(&small, [0.7, 0.0]), at(&whole, [0.7, 0.0]));
        assert_eq!(own, [0.5 * theirs[0], 0.5 * theirs[1], 0.0, 0.0, 0.0]);
        let other = Motions::like(&whole, &line(), shapes());
        assert_ne!(numbers(&other), numbers(&whole));
    }

    fn shapes_of(motions: &Motions) -> impl Iterator<Item = &ModeShape> {
        motions.shapes.iter()
    }

    #[test]
    fn products_are_those_of_their_tables() {
        let strike = StrikeGrid {
            columns: 6,
            rows: 4,
            closed: true,
        };
        let values = [24, 12].map(|count: u8| (0..count).map(|i| f32::from(i).sin()).collect());
        let tables = Arc::new(ShapeTables::new(strike, [1, 1], values).unwrap());
        let shapes: Vec<ModeShape> = [[0, 1], [3, 2], [1, 0]]
            .map(|which| ModeShape::product(Arc::clone(&tables), which, 1.5))
            .into();
        let line = StrikeLine {
            points_m: vec![[0.0; 3]; 24],
            normals: vec![[0.0, 0.0, 1.0]; 24],
            rows: 4,
            closed: true,
        };
        let motions = Motions::new(&line, shapes.clone());
        assert_eq!(motions.scratch_len(), 4 + 3);
        let found = at(&motions, [0.37, 0.83]);
        for (shape, found) in shapes.iter().zip(found) {
            let expected = shape.normal_motion(&line, [0.37, 0.83]);
            assert!((found - expected).abs() < 1e-14, "{found} {expected}");
        }
    }
}
