//! A mode's displacement at the points where its body is struck.

use crate::{ShapeTables, StrikeLine};
use std::sync::Arc;

/// Mass-normalised displacement φ over the strike grid, in kg^(−1/2): at each of its points, or as a
/// product of tables.
///
/// Bodies that are one drawing at many sizes share the numbers and differ by a factor.
#[derive(Clone, Debug)]
pub struct ModeShape {
    values: Values,
    scale: f32,
}

#[derive(Clone, Debug)]
enum Values {
    /// At each point.
    Points(Arc<[[f32; 3]]>),
    /// A function along times one across.
    Product {
        tables: Arc<ShapeTables>,
        which: [u32; 2],
    },
}

/// A shape that is a product of tables, along the normals of the strike line.
#[derive(Clone, Copy, Debug)]
pub struct Product<'a> {
    /// The tables.
    pub tables: &'a Arc<ShapeTables>,
    /// Which function along and which across.
    pub which: [usize; 2],
    /// What their product is multiplied by, in kg^(−1/2).
    pub height: f32,
}

impl ModeShape {
    /// `height` in kg^(−1/2) times the function along and the function across that `which` says, along
    /// the normals of the strike line, which are [0, 0, 1].
    ///
    /// # Panics
    ///
    /// If `tables` has no such functions.
    #[must_use]
    pub fn product(tables: Arc<ShapeTables>, which: [u32; 2], height: f32) -> Self {
        let counts = tables.counts();
        let within = (0..2).all(|axis| (which[axis] as usize) < counts[axis]);
        assert!(within, "functions {which:?} are none of {counts:?}");
        Self {
            values: Values::Product { tables, which },
            scale: height,
        }
    }

    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        match &self.values {
            Values::Points(values) => values.len(),
            Values::Product { tables, .. } => tables.strike().columns * tables.strike().rows,
        }
    }

    /// Whether there are no points.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// φ at point `i`, in kg^(−1/2).
    ///
    /// # Panics
    ///
    /// If there is no such point.
    #[must_use]
    pub fn at(&self, i: usize) -> [f32; 3] {
        match &self.values {
            Values::Points(values) => values[i].map(|x| self.scale * x),
            Values::Product { tables, which } => {
                let value = tables.at_point(which.map(|number| number as usize), i);
                [0.0, 0.0, self.scale * value]
            }
        }
    }

    /// φ at each point in turn, in kg^(−1/2).
    pub fn iter(&self) -> impl ExactSizeIterator<Item = [f32; 3]> + DoubleEndedIterator + '_ {
        (0..self.len()).map(|i| self.at(i))
    }

    /// The numbers at each point and what they are to be multiplied by to be φ in kg^(−1/2), if it is not a
    /// product.
    #[must_use]
    pub fn as_points(&self) -> Option<(&[[f32; 3]], f32)> {
        match &self.values {
            Values::Points(values) => Some((values, self.scale)),
            Values::Product { .. } => None,
        }
    }

    /// What it is a product of, if it is one.
    #[must_use]
    pub fn as_product(&self) -> Option<Product<'_>> {
        match &self.values {
            Values::Points(_) => None,
            Values::Product { tables, which } => Some(Product {
                tables,
                which: which.map(|number| number as usize),
                height: self.scale,
            }),
        }
    }

    /// φ·n on `line` at `place` along and across, 0…1 each, in kg^(−1/2).
    ///
    /// # Panics
    ///
    /// If the shape has fewer points than the line, or a row of it fewer than
    /// [`Stencil::POINTS`](crate::Stencil::POINTS).
    #[must_use]
    pub fn normal_motion(&self, line: &StrikeLine, place: [f64; 2]) -> f64 {
        if let Some(product) = self.as_product() {
            return f64::from(product.height) * product.tables.at(product.which, place);
        }
        let spot = line.grid().spot(place[0], place[1]);
        spot.value(|i| {
            let (u, n) = (self.at(i), line.normals[i]);
            (0..3).map(|a| f64::from(u[a]) * n[a]).sum()
        })
    }

    /// What the shared numbers are multiplied by.
    #[must_use]
    pub(crate) fn scale(&self) -> f32 {
        self.scale
    }

    /// The shared numbers as they are.
    #[must_use]
    pub(crate) fn unscaled(&self) -> Self {
        Self {
            scale: 1.0,
            ..self.clone()
        }
    }

    /// The same shape times `factor`, sharing its numbers.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            values: self.values.clone(),
            scale: (f64::from(self.scale) * factor) as f32,
        }
    }

    /// Numbers to change, one for each point and no longer shared with other shapes.
    pub fn make_mut(&mut self) -> &mut [[f32; 3]] {
        if self.scale != 1.0 || self.as_product().is_some() {
            *self = self.iter().collect();
        }
        match &mut self.values {
            Values::Points(values) => Arc::make_mut(values),
            Values::Product { .. } => &mut [],
        }
    }

    /// Whether both are the same numbers in memory.
    #[must_use]
    pub fn shares_with(&self, other: &Self) -> bool {
        match (&self.values, &other.values) {
            (Values::Points(own), Values::Points(theirs)) => Arc::ptr_eq(own, theirs),
            (
                Values::Product { tables, which },
                Values::Product {
                    tables: t,
                    which: w,
                },
            ) => Arc::ptr_eq(tables, t) && which == w,
            _ => false,
        }
    }
}

impl From<Vec<[f32; 3]>> for ModeShape {
    fn from(values: Vec<[f32; 3]>) -> Self {
        Self {
            values: Values::Points(values.into()),
            scale: 1.0,
        }
    }
}

impl FromIterator<[f32; 3]> for ModeShape {
    fn from_iter<I: IntoIterator<Item = [f32; 3]>>(values: I) -> Self {
        values.into_iter().collect::<Vec<_>>().into()
    }
}

impl PartialEq for ModeShape {
    fn eq(&self, other: &Self) -> bool {
        match (self.as_product(), other.as_product()) {
            (Some(own), Some(theirs)) => {
                own.which == theirs.which
                    && own.height == theirs.height
                    && (Arc::ptr_eq(own.tables, theirs.tables) || own.tables == theirs.tables)
            }
            (None, None) => self.iter().eq(other.iter()),
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::StrikeGrid;

    #[test]
    fn scaled_shapes_share_their_numbers_until_changed() {
        let shape = ModeShape::from(vec![[1.0, 2.0, 3.0], [0.0, -1.0, 0.5]]);
        let mut half = shape.scaled(0.5);
        assert!(half.shares_with(&shape));
        assert_eq!(half.at(1), [0.0, -0.5, 0.25]);
        assert_eq!(
            half,
            ModeShape::from(vec![[0.5, 1.0, 1.5], [0.0, -0.5, 0.25]])
        );
        half.make_mut()[0][0] = 7.0;
        assert!(!half.shares_with(&shape));
        assert_eq!(
            (half.at(0), half.at(1)),
            ([7.0, 1.0, 1.5], [0.0, -0.5, 0.25])
        );
        assert_eq!(shape.at(0), [1.0, 2.0, 3.0]);
    }

    /// One function along, 1 + x, and two across, y and 2 − y.
    fn tables() -> Arc<ShapeTables> {
        let strike = StrikeGrid {
            columns: 6,
            rows: 4,
            closed: false,
        };
        let along = (0..11).map(|i| 1.0 + i as f32 / 10.0).collect();
        let across = (0..4).flat_map(|i| [i as f32 / 3.0, 2.0 - i as f32 / 3.0]);
        let tables = ShapeTables::new(strike, [2, 1], [along, across.collect()]);
        Arc::new(tables.unwrap())
    }

    #[test]
    fn products_are_told_at_points_and_between() {
        let shape = ModeShape::product(tables(), [0, 1], 2.0).scaled(2.0);
        assert_eq!(shape.len(), 24);
        assert_eq!(shape.at(0), [0.0, 0.0, 8.0]);
        assert_eq!(shape.at(23), [0.0, 0.0, 8.0]);
        let line = StrikeLine {
            points_m: vec![[0.0; 3]; 24],
            normals: vec![[0.0, 0.0, 1.0]; 24],
            rows: 4,
            closed: false,
        };
        let between = shape.normal_motion(&line, [0.25, 0.5]);
        assert!((between - 4.0 * 1.25 * 1.5).abs() < 1e-6, "{between}");
    }

    #[test]
    fn products_are_equal_by_their_tables_and_become_points_when_changed() {
        let shape = ModeShape::product(tables(), [0, 1], 2.0);
        assert_eq!(shape, ModeShape::product(tables(), [0, 1], 2.0));
        assert_ne!(shape, ModeShape::product(tables(), [0, 0], 2.0));
        assert_ne!(shape, shape.scaled(1.5));
        let mut changed = shape.clone();
        changed.make_mut()[3] = [0.0; 3];
        assert_eq!((changed.at(3), changed.at(0)), ([0.0; 3], shape.at(0)));
        assert!(changed.as_product().is_none() && shape.as_product().is_some());
    }
}
