//! Where everything in the window is.

use super::theme::{APART, NEAR};
use egui::{Rect, pos2};

/// Height of what lies below the row from which on the body has a panel of its own.
const STACKED: f32 = 330.0;
/// Width from which on body, reasons and parameters stand side by side.
const ABREAST: f32 = 1400.0;

/// The places of the panels.
pub(super) struct Places {
    pub(super) header: Rect,
    pub(super) row: Rect,
    /// The body that was struck; where there is no room it is among the reasons.
    pub(super) body: Option<Rect>,
    /// Why it sounds as it does.
    pub(super) why: Rect,
    pub(super) pages: Rect,
    pub(super) hint: Rect,
}

impl Places {
    pub(super) fn of(all: Rect) -> Self {
        let inner = all.shrink2(egui::vec2(APART, 0.0));
        let slice = |top: f32, bottom: f32| {
            Rect::from_min_max(pos2(inner.left(), top), pos2(inner.right(), bottom))
        };
        let header = slice(all.top(), all.top() + 44.0);
        let hint = slice(all.bottom() - 24.0, all.bottom());
        let middle = slice(header.bottom(), hint.top());
        let row_height = (0.24 * middle.height()).clamp(100.0, 280.0);
        let row = slice(middle.top(), middle.top() + row_height);
        let rest = slice(row.bottom() + APART, middle.bottom());
        // Five knobs side by side at most.
        let pages_width = (0.5 * rest.width()).clamp(304.0, 500.0);
        let split = rest.right() - pages_width;
        let left = Rect::from_min_max(rest.min, pos2(split - APART, rest.bottom()));
        let (body, why) = if left.width() + pages_width > ABREAST {
            let [body, why] = halves(left, 0.5, true);
            (Some(body), why)
        } else if left.height() > STACKED {
            let [body, why] = halves(left, 0.53, false);
            (Some(body), why)
        } else {
            (None, left)
        };
        Self {
            header,
            row,
            body,
            why,
            pages: Rect::from_min_max(pos2(split, rest.top()), rest.max),
            hint,
        }
    }

    /// All that have a ground of their own.
    pub(super) fn panels(&self) -> impl Iterator<Item = Rect> {
        [self.row, self.why, self.pages]
            .into_iter()
            .chain(self.body)
    }
}

/// Two parts of an area, side by side or one above the other.
pub(super) fn halves(area: Rect, share: f32, abreast: bool) -> [Rect; 2] {
    let gap = 0.5 * (APART - NEAR);
    if abreast {
        let x = area.left() + share * area.width();
        [
            Rect::from_min_max(area.min, pos2(x - gap, area.bottom())),
            Rect::from_min_max(pos2(x + gap, area.top()), area.max),
        ]
    } else {
        let y = area.top() + share * area.height();
        [
            Rect::from_min_max(area.min, pos2(area.right(), y - gap)),
            Rect::from_min_max(pos2(area.left(), y + gap), area.max),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::vec2;

    #[test]
    fn panels_lie_side_by_side_in_every_window() {
        for size in [
            [640.0, 400.0],
            [1000.0, 680.0],
            [1280.0, 720.0],
            [1920.0, 1080.0],
            [3840.0, 2160.0],
        ] {
            let all = Rect::from_min_size(egui::Pos2::ZERO, vec2(size[0], size[1]));
            let panels: Vec<Rect> = Places::of(all).panels().collect();
            for (number, panel) in panels.iter().enumerate() {
                assert!(all.contains_rect(*panel), "{size:?} {panel:?}");
                assert!(
                    panel.width() > 280.0 && panel.height() > 96.0,
                    "{size:?} {panel:?}"
                );
                for other in &panels[..number] {
                    assert!(!panel.intersects(*other), "{size:?} {panel:?} {other:?}");
                }
            }
        }
    }
}
