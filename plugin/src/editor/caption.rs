//! What a first look is to tell: which object, where it was struck and with what, how long it rings and why.

use super::card::causes;
use super::figure::Kind;
use super::ringing::{Ringing, seconds};
use super::shown::Shown;
use super::theme::{Theme, body, small};
use crate::engine::Settings;
use egui::{Align2, Rect, Ui, pos2, vec2};

/// Height that it takes.
pub(super) const CAPTION: f32 = 56.0;
/// Width below which the mallet is left out.
const WIDE: f32 = 330.0;

/// What it tells of.
pub(super) struct Told<'a> {
    pub(super) shown: &'a Shown,
    pub(super) settings: &'a Settings,
    /// Where it was struck last, or would be, 0…1.
    pub(super) position: f32,
    /// How long a blow lasts, in s.
    pub(super) contact_s: f64,
    /// The name and decay of the partial that is told of.
    pub(super) partial: Option<(String, Ringing)>,
}

/// Writes three lines at the top of `area`.
pub(super) fn caption(ui: &Ui, area: Rect, kind: Kind, told: &Told<'_>, theme: &Theme) {
    let painter = ui.painter().with_clip_rect(area);
    let at = area.left_top() + vec2(2.0, 0.0);
    painter.text(at, Align2::LEFT_TOP, told.shown.title(), body(), theme.text);
    let mallet = &told.settings.mallet;
    let mut where_ = format!("struck {}", place(kind, told.position));
    if area.width() > WIDE {
        where_ += &format!(
            " by {:.0} g, touching for {:.2} ms",
            1e3 * mallet.mass_kg,
            1e3 * told.contact_s
        );
    }
    painter.text(
        at + vec2(0.0, 18.0),
        Align2::LEFT_TOP,
        where_,
        small(),
        theme.quiet,
    );
    if let Some((name, ringing)) = &told.partial {
        let head = format!("{name} rings {}", seconds(ringing.t60_s()));
        let line = Rect::from_min_max(at + vec2(0.0, 33.0), pos2(area.right(), at.y + CAPTION));
        causes(ui, line, &head, ringing, theme);
    }
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
