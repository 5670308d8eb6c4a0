//! The output's level, left over right, and its greatest peak.

use super::theme::{Theme, small};
use egui::{Align2, CornerRadius, CursorIcon, Id, Rect, Role, Sense, Ui, WidgetInfo, pos2, vec2};

/// Level in dB at the meter's left end.
const LOW_DB: f32 = -60.0;
/// How fast the bars fall, in dB/s.
const FALL_DB_S: f32 = 40.0;

/// What the meter remembers.
pub(super) struct Meter {
    levels_db: [f32; 2],
    peak_db: f32,
}

impl Default for Meter {
    fn default() -> Self {
        Self {
            levels_db: [f32::NEG_INFINITY; 2],
            peak_db: f32::NEG_INFINITY,
        }
    }
}

impl Meter {
    /// A frame has come.
    pub(super) fn hear(&mut self, peaks: [f32; 2]) {
        for (level, peak) in self.levels_db.iter_mut().zip(peaks) {
            let db = 20.0 * peak.max(1e-9).log10();
            *level = level.max(db);
            self.peak_db = self.peak_db.max(db);
        }
    }

    /// Draws it at `area`; a click forgets the peak.
    pub(super) fn show(&mut self, ui: &Ui, area: Rect, theme: &Theme) {
        let response = ui.interact(area, Id::unique("meter"), Sense::CLICK);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, "Forget the peak"));
        if response.clicked() {
            self.peak_db = f32::NEG_INFINITY;
        }
        let number = 56.0;
        let bars = Rect::from_min_max(area.min, pos2(area.right() - number, area.bottom()));
        let painter = ui.painter();
        for (row, level) in self.levels_db.iter().enumerate() {
            let bar = Rect::from_min_size(
                pos2(bars.left(), bars.center().y - 7.0 + 8.0 * row as f32),
                vec2(bars.width(), 6.0),
            );
            painter.rect_filled(bar, CornerRadius::same(2), theme.line);
            let share = (1.0 - level / LOW_DB).clamp(0.0, 1.0);
            let lit = Rect::from_min_size(bar.min, vec2(share * bar.width(), bar.height()));
            let colour = if *level >= -0.1 {
                theme.alarm
            } else {
                theme.glow
            };
            painter.rect_filled(lit, CornerRadius::same(2), colour);
        }
        let loud = self.peak_db >= -0.1;
        let text = if self.peak_db < LOW_DB {
            "−∞ dB".to_owned()
        } else {
            format!("{:.1} dB", self.peak_db).replace('-', "−")
        };
        painter.text(
            area.right_center(),
            Align2::RIGHT_CENTER,
            text,
            small(),
            if loud { theme.alarm } else { theme.quiet },
        );
        self.fall(ui);
        response
            .on_hover_cursor(CursorIcon::PointingHand)
            .on_hover_text("Output level and greatest peak; click to forget the peak");
    }

    fn fall(&mut self, ui: &Ui) {
        let passed_s = ui.input(|input| input.stable_dt).min(0.1);
        for level in &mut self.levels_db {
            if *level > LOW_DB {
                *level -= FALL_DB_S * passed_s;
                ui.ctx().request_repaint();
            } else {
                *level = f32::NEG_INFINITY;
            }
        }
    }
}
