//! The bars of a recipe: what each is cut from, what it is hollowed to, and how far that can be had.

use crate::bar::{
    BarFineness, BarStock, BarTuneError, BarTuning, TunedBar, retune_bar, stretched, tune_bar,
    vibraphone_ratios, vibraphone_stock,
};
use crate::{Recipe, equal_temperament_hz};

/// Pitch of key 69, in Hz, for which a vibraphone's stock is measured.
const STOCK_A4_HZ: f64 = 440.0;

/// Halvings by which ratios within reach are looked for, and drawings.
const RATIO_STEPS: usize = 6;
const DRAWING_STEPS: usize = 5;

/// The bars of a recipe.
#[derive(Clone, Copy)]
pub(super) struct Bars<'a> {
    pub(super) recipe: &'a Recipe,
    /// The partials asked for; a vibraphone's without.
    pub(super) asked: Option<[f64; 2]>,
    /// Thickness and width of the stock over a vibraphone's.
    pub(super) times: [f64; 2],
    /// How far the undercut stretches the partials.
    pub(super) undercut: f64,
    /// Cells across half the width and through the thickness.
    pub(super) cells: [usize; 2],
}

impl Bars<'_> {
    /// The second and third partial of the bar of `key`, as multiples of the first.
    pub(super) fn ratios(&self, key: u8) -> [f64; 2] {
        let own = self.asked.unwrap_or_else(|| vibraphone_ratios(key));
        stretched(own, self.undercut)
    }

    /// How finely they are cut; `finer` times as finely as they are shipped.
    pub(super) fn fineness(&self, finer: usize) -> BarFineness {
        BarFineness {
            max_element_m: self.recipe.mesh.max_element_m / finer as f64,
            across: finer * self.cells[0],
            through: finer * self.cells[1],
        }
    }

    /// The bar of `key`; beginning with what was its `last`, if that is known.
    pub(super) fn tuned(&self, key: u8, last: Option<&TunedBar>) -> Result<TunedBar, BarTuneError> {
        self.tuned_to(key, (self.ratios(key), self.times), last)
    }

    /// The bar of `key` with these ratios, of stock so many times as thick and as wide.
    fn tuned_to(
        &self,
        key: u8,
        (ratios, times): ([f64; 2], [f64; 2]),
        last: Option<&TunedBar>,
    ) -> Result<TunedBar, BarTuneError> {
        let (stock, tuning) = self.stock(key, ratios, times);
        let material = &self.recipe.material;
        match last {
            Some(last) => retune_bar(last, &stock, material, self.fineness(1), &tuning),
            None => tune_bar(&stock, material, self.fineness(1), &tuning),
        }
    }

    /// What that bar is cut from, and what it is tuned to.
    fn stock(
        &self,
        key: u8,
        ratios: [f64; 2],
        [thicker, wider]: [f64; 2],
    ) -> (BarStock, BarTuning) {
        let asked = &self.recipe.tuning;
        let tuning = BarTuning {
            pitch_hz: equal_temperament_hz(key, asked.a4_hz),
            ratios,
            tolerance_cents: asked.tolerance_cents,
        };
        // At another pitch the same drawing at another size: all stock has its key's partials.
        let mut stock = vibraphone_stock(key).scaled(STOCK_A4_HZ / asked.a4_hz);
        stock.thickness_m *= thicker;
        stock.width_m *= wider;
        // A thicker bar of the same drawing is as much longer as the root: bending goes with t/l².
        stock.length_m *= thicker.sqrt();
        (stock, tuning)
    }

    /// Of the ratios from a vibraphone's own to those asked for, the farthest that the bar of `key` was
    /// found to have.
    pub(super) fn ratios_within(&self, key: u8) -> Option<[f64; 2]> {
        let (own, asked) = (vibraphone_ratios(key), self.ratios(key));
        let at =
            |share: f64| between(own, asked, share).map(|ratio| (100.0 * ratio).round() / 100.0);
        let bar = |share: f64| self.tuned_to(key, (at(share), self.times), None).ok();
        let (share, _) = farthest(RATIO_STEPS, bar(0.0)?, |share, _| bar(share));
        Some(at(share))
    }

    /// Of the drawings from a vibraphone's own to the one asked for, the farthest that the bar of `key`
    /// was found to have, and what share of the way that is.
    pub(super) fn nearest(&self, key: u8) -> Option<(f64, TunedBar)> {
        let (ratios, asked) = (vibraphone_ratios(key), self.ratios(key));
        let bar = |share: f64, last: Option<&TunedBar>| {
            let drawn = (
                between(ratios, asked, share),
                between([1.0; 2], self.times, share),
            );
            self.tuned_to(key, drawn, last).ok()
        };
        Some(farthest(DRAWING_STEPS, bar(0.0, None)?, |share, near| {
            bar(share, Some(near))
        }))
    }
}

/// What is a share of the way from one to the other.
fn between(from: [f64; 2], to: [f64; 2], share: f64) -> [f64; 2] {
    [0, 1].map(|i| from[i] + share * (to[i] - from[i]))
}

/// The largest share below 1 at which `bar`, told of the nearest so far, finds one; `own` is that of 0.
fn farthest(
    steps: usize,
    own: TunedBar,
    bar: impl Fn(f64, &TunedBar) -> Option<TunedBar>,
) -> (f64, TunedBar) {
    let (mut near, mut far) = ((0.0, own), 1.0);
    for _ in 0..steps {
        let share = 0.5 * (near.0 + far);
        match bar(share, &near.1) {
            Some(found) => near = (share, found),
            None => far = share,
        }
    }
    near
}
