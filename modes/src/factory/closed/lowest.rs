//! The lowest key's body as it is drawn, before it is brought to its size.

use crate::bank::Surface as Picture;
use crate::{Body, ModeShape, SolvedBody};
use std::sync::Arc;

/// A body, how it looks, and its shapes if they are products: then those of its modes are empty.
pub(super) struct Lowest {
    pub(super) solved: SolvedBody,
    pub(super) picture: Picture,
    pub(super) shapes: Option<Vec<ModeShape>>,
}

impl Lowest {
    /// Gives picture and shapes to `body`, which is this one so many times as large.
    pub(super) fn complete(self, body: &mut Body, larger: f64) {
        body.surface = Some(Arc::new(self.picture));
        let shapes = self.shapes.into_iter().flatten();
        for (mode, shape) in body.modes.iter_mut().zip(shapes) {
            // φ² is an inverse mass.
            mode.shape = shape.scaled(larger.powf(-1.5));
        }
    }
}

impl From<(SolvedBody, Picture)> for Lowest {
    fn from((solved, picture): (SolvedBody, Picture)) -> Self {
        Self {
            solved,
            picture,
            shapes: None,
        }
    }
}
