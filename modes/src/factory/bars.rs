//! What the bars of a recipe are hollowed to.

use crate::bar::{stretched, vibraphone_ratios};

/// What bars are hollowed to.
#[derive(Clone, Copy)]
pub(super) struct Bars {
    /// The partials asked for; a vibraphone's without.
    pub(super) ratios: Option<[f64; 2]>,
    /// Thickness and width of the stock over a vibraphone's.
    pub(super) times: [f64; 2],
    /// How far the undercut stretches the partials.
    pub(super) undercut: f64,
}

impl Bars {
    /// The second and third partial of the bar of `key`, as multiples of the first.
    pub(super) fn ratios(&self, key: u8) -> [f64; 2] {
        let own = self.ratios.unwrap_or_else(|| vibraphone_ratios(key));
        stretched(own, self.undercut)
    }
}
