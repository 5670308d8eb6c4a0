//! Why a body sounds as it does: leaves that lie on one another where there is no room for all.

mod blow;
mod damping;
mod fourier;
mod losses;
mod spectrum;

pub(super) use blow::Blow;
pub(super) use damping::damping;
pub(super) use spectrum::Spectrum;

use super::places::halves;
use super::tabs::{TABS, Tab, tabs};
use super::theme::{NEAR, Theme, small};
use egui::{Align2, Rect, Ui, pos2, vec2};

/// Least room in which all leaves lie side by side; with that height alone, partials and one other.
const ALL: [f32; 2] = [900.0, 620.0];
/// Height of a leaf's name there.
const NAME: f32 = 18.0;

/// What is on a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Leaf {
    /// The body itself, where it has no panel of its own.
    Body,
    /// How loud each mode is and how long it rings.
    Partials,
    /// What takes its energy at which frequency.
    Damping,
    /// What the mallet does to it.
    Blow,
    /// What has been heard of late.
    Spectrum,
}

impl Leaf {
    const REASONS: [Self; 4] = [Self::Partials, Self::Damping, Self::Blow, Self::Spectrum];

    fn tab(self) -> Tab {
        match self {
            Self::Body => (
                "Object",
                "The body that was struck: click it to strike it there",
            ),
            Self::Partials => (
                "Partials",
                "How loud each mode is, how long it rings and why; each can be trimmed by hand",
            ),
            Self::Damping => (
                "Decay",
                "What takes the sound away at which frequency; handles make it last or die",
            ),
            Self::Blow => (
                "Blow",
                "The force of the last blow: the shorter, the brighter it sounds",
            ),
            Self::Spectrum => ("Spectrum", "What has sounded in the last four seconds"),
        }
    }
}

/// Which leaf lies on top.
#[derive(Default)]
pub(super) struct Why {
    open: usize,
}

impl Why {
    /// Draws the tabs, if any are needed, in `area`; the leaves to draw, and where.
    pub(super) fn leaves(
        &mut self,
        ui: &Ui,
        area: Rect,
        with_body: bool,
        theme: &Theme,
    ) -> Vec<(Leaf, Rect)> {
        let tall = !with_body && area.height() >= ALL[1];
        if tall && area.width() >= ALL[0] {
            return spread(ui, area, theme);
        }
        if tall {
            let [above, below] = halves(area, 0.5, false);
            let first = named(ui, Leaf::Partials, above, theme);
            return vec![first, self.chosen(ui, below, &Leaf::REASONS[1..], theme)];
        }
        let mut all = Leaf::REASONS.to_vec();
        if with_body {
            all.insert(0, Leaf::Body);
        }
        vec![self.chosen(ui, area, &all, theme)]
    }

    /// The tabs of some leaves, and the one that lies on top.
    fn chosen(&mut self, ui: &Ui, area: Rect, all: &[Leaf], theme: &Theme) -> (Leaf, Rect) {
        let names: Vec<Tab> = all.iter().map(|leaf| leaf.tab()).collect();
        self.open = tabs(ui, area, &names, self.open.min(all.len() - 1), theme);
        let rest = Rect::from_min_max(pos2(area.left(), area.top() + TABS + NEAR), area.max);
        (all[self.open], rest)
    }
}

/// All reasons, each under its name.
fn spread(ui: &Ui, area: Rect, theme: &Theme) -> Vec<(Leaf, Rect)> {
    let [above, below] = halves(area, 0.5, false);
    let places = [above, below]
        .into_iter()
        .flat_map(|row| halves(row, 0.5, true));
    Leaf::REASONS
        .into_iter()
        .zip(places)
        .map(|(leaf, place)| named(ui, leaf, place, theme))
        .collect()
}

/// A leaf under its name.
fn named(ui: &Ui, leaf: Leaf, place: Rect, theme: &Theme) -> (Leaf, Rect) {
    let at = place.left_top() + vec2(2.0, 0.0);
    ui.painter()
        .text(at, Align2::LEFT_TOP, leaf.tab().0, small(), theme.quiet);
    let top = pos2(place.left(), place.top() + NAME);
    (leaf, Rect::from_min_max(top, place.max))
}
