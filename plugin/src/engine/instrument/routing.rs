//! Bodies go to the outputs where they belong.

use super::{Engine, keys};
use crate::engine::OUTPUTS;
use crate::engine::damper::bit;

/// Bodies on their way from one output to another at the same time; each moves sample by sample meanwhile.
const MOST_MOVING: u32 = 4;

/// The outputs whose bits are set.
pub(super) fn outputs(bits: u8) -> impl Iterator<Item = usize> {
    (0..OUTPUTS).filter(move |output| bits >> output & 1 == 1)
}

impl Engine {
    /// At a point of the grid: sends some of those that sound where they do not belong on their way, and
    /// says what outputs are used in this cell.
    pub(super) fn deal(&mut self) {
        self.routes.pending &= self.awake;
        for key in keys(self.routes.pending & !self.routes.moving) {
            if self.routes.moving.count_ones() >= MOST_MOVING {
                break;
            }
            self.carry(key);
        }
        self.used = self.routes.used(self.awake);
    }

    /// Sends a body on its way, if it has any: at a point of the grid, or while something pushes it.
    pub(super) fn carry(&mut self, key: u8) {
        if self.routes.pending & bit(key) == 0 || !self.routes.depart(key, self.settings.split) {
            return;
        }
        if let Some(body) = self.bodies[usize::from(key)].as_mut() {
            body.lead(self.kernel, self.step_s);
            self.driven |= bit(key);
        }
        self.used |= self.routes.used(bit(key));
    }
}
