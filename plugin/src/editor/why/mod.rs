//! Why a body sounds as it does: leaves that lie on one another where there is no room for all.

mod blow;
mod damping;

pub(super) use blow::Blow;
pub(super) use damping::damping;

use super::places::halves;
use super::tabs::{TABS, tabs};
use super::theme::{NEAR, Theme, small};
use egui::{Align2, Rect, Ui, pos2, vec2};

/// Least room in which all leaves lie side by side.
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
}

impl Leaf {
    const REASONS: [Self; 3] = [Self::Partials, Self::Damping, Self::Blow];

    fn name(self) -> &'static str {
        match self {
            Self::Body => "Object",
            Self::Partials => "Partials",
            Self::Damping => "Decay",
            Self::Blow => "Blow",
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
        if !with_body && area.width() >= ALL[0] && area.height() >= ALL[1] {
            return spread(ui, area, theme);
        }
        let mut all = Vec::new();
        if with_body {
            all.push(Leaf::Body);
        }
        all.extend(Leaf::REASONS);
        let names: Vec<&str> = all.iter().map(|leaf| leaf.name()).collect();
        self.open = self.open.min(all.len() - 1);
        self.open = tabs(ui, area, &names, self.open, theme);
        let rest = Rect::from_min_max(pos2(area.left(), area.top() + TABS + NEAR), area.max);
        vec![(all[self.open], rest)]
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
        .map(|(leaf, place)| {
            let at = place.left_top() + vec2(2.0, 0.0);
            ui.painter()
                .text(at, Align2::LEFT_TOP, leaf.name(), small(), theme.quiet);
            let top = pos2(place.left(), place.top() + NAME);
            (leaf, Rect::from_min_max(top, place.max))
        })
        .collect()
}
