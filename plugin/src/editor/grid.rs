//! The scales behind the partials.

use super::axis::{Axis, notch};
use super::theme::{NEAR, Theme, small};
use egui::{Align2, CornerRadius, Painter, Rect, Stroke, pos2, vec2};

/// Levels in dB below the loudest that are drawn.
pub(super) const FLOOR_DB: f32 = 72.0;
/// Height of the line between the two halves, and of what is written above and below them.
const SCALE: f32 = 16.0;
/// Least height for words above and below.
const ROOMY: f32 = 200.0;

/// The two halves of the plot.
#[derive(Clone, Copy)]
pub(super) struct Halves {
    /// Levels, the loudest at the top.
    pub(super) up: Rect,
    /// Times, the longest at the bottom.
    pub(super) down: Rect,
    roomy: bool,
}

impl Halves {
    /// Splits an area, scales and words included.
    pub(super) fn of(area: Rect) -> Self {
        let roomy = area.height() > ROOMY;
        let words = if roomy { SCALE } else { 0.0 };
        let top = area.top() + words;
        let bottom = area.bottom() - words;
        let middle = top + 0.54 * (bottom - top - SCALE);
        let [left, right] = [area.left() + 38.0, area.right()];
        Self {
            up: Rect::from_min_max(pos2(left, top), pos2(right, middle)),
            down: Rect::from_min_max(pos2(left, middle + SCALE), pos2(right, bottom)),
            roomy,
        }
    }
}

/// Draws scales and words.
pub(super) fn grid(painter: &Painter, halves: &Halves, hz: &Axis, t60: &Axis, theme: &Theme) {
    let Halves { up, down, roomy } = *halves;
    let fine = Stroke::new(1.0, theme.line.gamma_multiply(0.55));
    for rect in [up, down] {
        painter.rect_filled(rect, CornerRadius::same(3), theme.ground);
    }
    let between = 0.5 * (up.bottom() + down.top());
    for tick in [50.0, 100.0, 200.0, 500.0, 1e3, 2e3, 5e3, 10e3, 20e3] {
        if !hz.holds(tick) {
            continue;
        }
        let x = hz.place(tick);
        painter.vline(x, up.y_range(), fine);
        painter.vline(x, down.y_range(), fine);
        let text = if tick < 1e3 {
            format!("{tick:.0}")
        } else {
            format!("{:.0}k", tick / 1e3)
        };
        if x < up.right() - 8.0 {
            let at = pos2(x, between);
            painter.text(at, Align2::CENTER_CENTER, text, small(), theme.quiet);
        }
    }
    let beside = |y: f32| pos2(up.left() - NEAR, y);
    notch(painter, beside(between), "Hz", theme);
    for db in [0.0, 24.0, 48.0] {
        let y = up.top() + up.height() * db / FLOOR_DB;
        painter.hline(up.x_range(), y, fine);
        if db > 0.0 {
            notch(painter, beside(y), &format!("−{db:.0} dB"), theme);
        }
    }
    for (time_s, text) in [(0.1, "0.1 s"), (1.0, "1 s"), (10.0, "10 s")] {
        let y = t60.place(time_s);
        painter.hline(down.x_range(), y, fine);
        notch(painter, beside(y), text, theme);
    }
    if roomy {
        let write = |at, anchor, text: &str| {
            painter.text(at, anchor, text, small(), theme.quiet);
        };
        let above = up.left_top() - vec2(0.0, 3.0);
        let text = "up: how loud each partial is after a blow; lit: how loud it is now";
        write(above, Align2::LEFT_BOTTOM, text);
        let below = down.left_bottom() + vec2(0.0, 3.0);
        let text = "down: how long it rings (60 dB); its colours: what takes its energy";
        write(below, Align2::LEFT_TOP, text);
    }
}
