//! What a first look is to tell: which object, where it was struck and with what, how long it rings and why.

use super::card::causes;
use super::kind::Kind;
use super::ringing::{Ringing, hertz, seconds};
use super::shown::Shown;
use super::theme::{Theme, body, small};
use crate::engine::Settings;
use egui::text::{LayoutJob, TextWrapping};
use egui::{Galley, Rect, Ui, pos2, vec2};
use std::sync::Arc;

/// Height that it takes.
pub(super) const CAPTION: f32 = 56.0;

/// Width in the upper right corner that it leaves free.
const CORNER: f32 = 68.0;

/// What it tells of.
pub(super) struct Told<'a> {
    pub(super) shown: &'a Shown,
    pub(super) settings: &'a Settings,
    /// Where it was struck last, or would be, 0…1.
    pub(super) position: f32,
    /// How long a blow lasts, in s.
    pub(super) contact_s: f64,
    /// What the mallet's head is of.
    pub(super) head: String,
    /// The decay of the partial that is heard last.
    pub(super) partial: Option<Ringing>,
}

/// Writes three lines at the top of `area`.
pub(super) fn caption(ui: &Ui, area: Rect, kind: Kind, told: &Told<'_>, theme: &Theme) {
    let painter = ui.painter().with_clip_rect(area);
    let at = area.left_top() + vec2(2.0, 0.0);
    let mut title = LayoutJob::simple_singleline(told.shown.title(), body(), theme.text);
    title.wrap = TextWrapping::truncate_at_width(area.width() - CORNER);
    painter.galley(at, painter.layout_job(title), theme.text);
    let fits = |galley: &Arc<Galley>| at.x + galley.size().x <= area.right();
    let blows = blows(kind, told).map(|text| painter.layout_no_wrap(text, small(), theme.quiet));
    let [.., shortest] = &blows;
    let blow = blows.iter().find(|blow| fits(blow)).unwrap_or(shortest);
    painter.galley(at + vec2(0.0, 18.0), Arc::clone(blow), theme.quiet);
    if let Some(ringing) = &told.partial {
        let head = format!(
            "rings {} at {}",
            seconds(ringing.t60_s()),
            hertz(ringing.hz)
        );
        let line = Rect::from_min_max(at + vec2(0.0, 33.0), pos2(area.right(), at.y + CAPTION));
        causes(ui, line, &head, ringing, theme);
    }
}

/// Where it was struck, with what and for how long; then the same in ever fewer words.
fn blows(kind: Kind, told: &Told<'_>) -> [String; 3] {
    let place = format!("struck {}", place(kind, told.position));
    let mass_g = 1e3 * told.settings.mallet.mass_kg;
    let contact_ms = 1e3 * told.contact_s;
    let head = &told.head;
    [
        format!("{place} by a mallet of {mass_g:.0} g ({head}) for {contact_ms:.2} ms"),
        format!("{place} by {mass_g:.0} g ({head})"),
        place,
    ]
}

/// A place 0…1 on the strike line in words.
pub(super) fn place(kind: Kind, position: f32) -> String {
    let [from, to] = kind.ends();
    let percent = 100.0 * position;
    if percent < 0.5 {
        format!("at {from}")
    } else if percent > 99.5 {
        format!("at {to}")
    } else if percent > 70.0 {
        format!("{:.0} % from {to}", 100.0 - percent)
    } else {
        format!("{percent:.0} % from {from}")
    }
}
