//! A mode's displacement at the points where its body is struck.

use std::sync::Arc;

/// Mass-normalised displacement φ at each point of the strike grid, in kg^(−1/2).
///
/// Bodies that are one drawing at many sizes share the numbers and differ by a factor.
#[derive(Clone, Debug)]
pub struct ModeShape {
    values: Arc<[[f32; 3]]>,
    scale: f32,
}

impl ModeShape {
    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether there are no points.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// φ at point `i`, in kg^(−1/2).
    ///
    /// # Panics
    ///
    /// If there is no such point.
    #[must_use]
    pub fn at(&self, i: usize) -> [f32; 3] {
        self.values[i].map(|x| self.scale * x)
    }

    /// φ at each point in turn, in kg^(−1/2).
    pub fn iter(&self) -> impl ExactSizeIterator<Item = [f32; 3]> + DoubleEndedIterator + '_ {
        self.values.iter().map(|u| u.map(|x| self.scale * x))
    }

    /// The same shape times `factor`, sharing its numbers.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            values: Arc::clone(&self.values),
            scale: (f64::from(self.scale) * factor) as f32,
        }
    }

    /// Numbers to change, no longer shared with other shapes.
    pub fn make_mut(&mut self) -> &mut [[f32; 3]] {
        if self.scale != 1.0 {
            *self = self.iter().collect();
        }
        Arc::make_mut(&mut self.values)
    }

    /// Whether both are the same numbers in memory.
    #[must_use]
    pub fn shares_with(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.values, &other.values)
    }
}

impl From<Vec<[f32; 3]>> for ModeShape {
    fn from(values: Vec<[f32; 3]>) -> Self {
        Self {
            values: values.into(),
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
        self.iter().eq(other.iter())
    }
}

#[cfg(test)]
mod tests {
    use super::ModeShape;

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
}
