//! One partial in words: its name, how long it rings, and what of its decay is due to what.

use super::ringing::{Ringing, hertz, seconds};
use super::theme::{Cause, SIDE, Theme, small};
use egui::{CornerRadius, Rect, Ui, pos2, vec2};

/// Writes it on one line at `place`.
pub(super) fn card(ui: &Ui, place: Rect, name: &str, ringing: &Ringing, theme: &Theme) {
    let head = format!(
        "{name}, {}, rings {}",
        hertz(ringing.hz),
        seconds(ringing.t60_s())
    );
    causes(ui, place, &head, ringing, theme);
}

/// Writes `head`, then what takes the energy, from the greatest down for as long as there is room.
pub(super) fn causes(ui: &Ui, place: Rect, head: &str, ringing: &Ringing, theme: &Theme) {
    let painter = ui.painter_at(place);
    let mut at = pos2(place.left(), place.top() + 8.0);
    let lay = |text: String, colour| painter.layout_no_wrap(text, small(), colour);
    let head = lay(head.to_owned(), theme.text);
    let width = head.size().x;
    painter.galley(at - vec2(0.0, 0.5 * head.size().y), head, theme.text);
    at.x += width + SIDE;
    let mut parts: Vec<(Cause, f64)> = Cause::ALL.into_iter().zip(ringing.shares()).collect();
    parts.sort_by(|a, b| b.1.total_cmp(&a.1));
    for (cause, share) in parts {
        let text = lay(
            format!("{} {:.0} %", cause.name(), 100.0 * share),
            theme.quiet,
        );
        let size = text.size();
        if share < 0.005 || at.x + 11.0 + size.x > place.right() {
            break;
        }
        let dot = Rect::from_center_size(at + vec2(4.0, 0.0), vec2(8.0, 8.0));
        painter.rect_filled(dot, CornerRadius::same(2), theme.cause(cause));
        painter.galley(at + vec2(11.0, -0.5 * size.y), text, theme.quiet);
        at.x += 11.0 + size.x + SIDE;
    }
}
