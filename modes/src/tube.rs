//! Free tubes, cut to a pitch.

mod tune;

pub use tune::{TubeTuning, TuneError, predicted_length_m, retune_tube, tune_tube};

use crate::mesh::TubeGrid;
use crate::shape::Tube;

/// How finely a tube is cut: cells around it, and the longest cell along it in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fineness {
    /// Cells around the axis, an even number.
    pub around: usize,
    /// Longest cell along the axis, in m.
    pub max_element_m: f64,
}

impl Fineness {
    /// The grid that cuts `tube` this finely.
    #[must_use]
    pub fn grid(&self, tube: &Tube) -> TubeGrid {
        #[expect(clippy::cast_sign_loss, reason = "lengths are positive")]
        let along = (tube.length_m / self.max_element_m).ceil().max(1.0) as usize;
        TubeGrid {
            around: self.around,
            along,
        }
    }
}
