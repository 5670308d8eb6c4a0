//! What is drawn over the body: marks of strikes, and the control of its motion.

use super::super::solid::Vector;
use super::super::theme::{Theme, small};
use super::Sight;
use super::camera::Lens;
use egui::{
    Align2, CornerRadius, CursorIcon, EventFilter, Id, Key, Rect, Sense, Stroke, Ui, WidgetInfo,
    pos2, vec2,
};

/// Greatest exaggeration.
const MOST: f32 = 4.0;
/// That of a new editor.
const USUAL: f32 = 1.0;

/// What a mark means.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Mark {
    /// Notes strike here.
    Set,
    /// The last blow was here.
    Struck,
    /// A click would strike here.
    Pointed,
}

/// Draws a mark; faintly if the surface there, by its normal, faces away.
pub(super) fn mark(
    ui: &Ui,
    lens: &Lens,
    point_m: Vector,
    normal: Option<Vector>,
    mark: Mark,
    theme: &Theme,
) {
    let (at, _) = lens.place(point_m);
    let hidden = normal.is_some_and(|normal| lens.direction(normal)[2] < -0.05);
    let faint = if hidden { 0.45 } else { 1.0 };
    let painter = ui.painter();
    let ground = Stroke::new(3.0, theme.ground.gamma_multiply(0.8 * faint));
    match mark {
        Mark::Set => {
            painter.circle_stroke(at, 5.0, ground);
            painter.circle_stroke(at, 5.0, Stroke::new(1.5, theme.text.gamma_multiply(faint)));
        }
        Mark::Struck => {
            painter.circle_filled(at, 9.0, theme.glow.gamma_multiply(0.28 * faint));
            let ring = Stroke::new(1.5, theme.ground.gamma_multiply(faint));
            painter.circle(at, 4.5, theme.glow.gamma_multiply(faint), ring);
        }
        Mark::Pointed => {
            painter.circle_stroke(at, 7.0, ground);
            painter.circle_stroke(at, 7.0, Stroke::new(1.5, theme.text));
            painter.circle_filled(at, 1.5, theme.text);
        }
    }
}

/// The control of the motion in the lower right corner, and what the picture changes in the lower left.
pub(super) fn controls(ui: &Ui, area: Rect, motion: &mut f32, thicker: f32, sight: &Sight<'_, '_>) {
    let theme = sight.theme;
    let slot = Rect::from_min_size(
        pos2(area.right() - 148.0, area.bottom() - 18.0),
        vec2(146.0, 18.0),
    );
    let rail = Rect::from_min_max(
        pos2(slot.left() + 46.0, slot.center().y - 3.0),
        pos2(slot.right() - 30.0, slot.center().y + 3.0),
    );
    let response = ui.interact(slot, Id::unique("motion"), Sense::click_and_drag());
    if response.double_clicked() || response.triple_clicked() {
        *motion = USUAL;
    } else if let Some(at) = response
        .interact_pointer_pos()
        .filter(|_| response.is_pointer_button_down_on())
    {
        *motion = MOST * ((at.x - rail.left()) / rail.width());
    }
    if response.has_focus() {
        let filter = EventFilter {
            horizontal_arrows: true,
            ..EventFilter::default()
        };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let pressed = |key| f32::from(u8::from(ui.input(|input| input.key_pressed(key))));
        *motion += 0.2 * (pressed(Key::ArrowRight) - pressed(Key::ArrowLeft));
    }
    *motion = motion.clamp(0.0, MOST);
    response.widget_info(|| WidgetInfo::slider(true, f64::from(*motion), "Motion"));
    let painter = ui.painter();
    let lit = response.hovered() || response.has_focus();
    painter.text(
        slot.left_center(),
        Align2::LEFT_CENTER,
        "Motion",
        small(),
        if lit { theme.text } else { theme.quiet },
    );
    painter.rect_filled(rail, CornerRadius::same(3), theme.line);
    let x = rail.left() + rail.width() * *motion / MOST;
    let filled = Rect::from_min_max(rail.min, pos2(x, rail.bottom()));
    painter.rect_filled(
        filled,
        CornerRadius::same(3),
        theme.glow.gamma_multiply(0.75),
    );
    painter.circle_filled(pos2(x, rail.center().y), 4.5, theme.text);
    let value = if *motion < 0.05 {
        "off".to_owned()
    } else {
        format!("{motion:.1}×")
    };
    painter.text(
        slot.right_center(),
        Align2::RIGHT_CENTER,
        value,
        small(),
        theme.quiet,
    );
    response
        .on_hover_and_drag_cursor(CursorIcon::ResizeHorizontal)
        .on_hover_text(
            "How far the picture exaggerates the motion, which is slowed to be seen. The sound does not \
             change.",
        );
    let mut notes = Vec::new();
    if let Some(partial) = sight
        .alone
        .and_then(|mode| sight.shown().partials.get(mode))
    {
        notes.push(format!("{} alone, at rest along the lines", partial.label));
    }
    if thicker > 1.05 {
        notes.push(format!("drawn {thicker:.1}× as thick"));
    }
    painter.text(
        area.left_bottom() + vec2(2.0, -9.0),
        Align2::LEFT_CENTER,
        notes.join("; "),
        small(),
        theme.quiet,
    );
}
