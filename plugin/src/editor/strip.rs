//! How hard clicks and computer keys strike.

use super::knob::notches;
use super::theme::{Theme, small};
use egui::{
    Align2, CornerRadius, CursorIcon, EventFilter, Id, Key, Rect, Sense, Stroke, StrokeKind, Ui,
    WidgetInfo, pos2, vec2,
};

/// Velocity of a new editor.
const USUAL: f32 = 100.0;

/// Draws a strip at `area` whose height is the velocity, 1…127.
pub(super) fn strip(ui: &Ui, area: Rect, velocity: &mut f32, theme: &Theme) {
    let response = ui.interact(area, Id::unique("velocity"), Sense::click_and_drag());
    let rail = Rect::from_min_max(
        pos2(area.center().x - 7.0, area.top() + 2.0),
        pos2(area.center().x + 7.0, area.bottom() - 18.0),
    );
    let at = response.interact_pointer_pos();
    if response.double_clicked() || response.triple_clicked() {
        *velocity = USUAL;
    } else if let Some(at) = at.filter(|_| response.is_pointer_button_down_on()) {
        *velocity = 127.0 * (rail.bottom() - at.y) / rail.height();
    }
    if response.hovered() {
        *velocity += 4.0 * notches(ui);
    }
    if response.has_focus() {
        ui.memory_mut(|memory| {
            memory.set_focus_lock_filter(
                response.id,
                EventFilter {
                    vertical_arrows: true,
                    ..EventFilter::default()
                },
            );
        });
        ui.input(|input| {
            *velocity += 2.0 * f32::from(u8::from(input.key_pressed(Key::ArrowUp)));
            *velocity -= 2.0 * f32::from(u8::from(input.key_pressed(Key::ArrowDown)));
        });
    }
    *velocity = velocity.round().clamp(1.0, 127.0);
    response.widget_info(|| WidgetInfo::slider(true, f64::from(*velocity), "Velocity"));
    let painter = ui.painter();
    let edge = if response.has_focus() {
        theme.glow
    } else if response.hovered() {
        theme.quiet
    } else {
        theme.line
    };
    painter.rect(
        rail,
        CornerRadius::same(4),
        theme.ground,
        Stroke::new(1.0, edge),
        StrokeKind::Outside,
    );
    let top = rail.bottom() - rail.height() * *velocity / 127.0;
    let lit = Rect::from_min_max(pos2(rail.left(), top), rail.max);
    painter.rect_filled(lit, CornerRadius::same(4), theme.glow.gamma_multiply(0.75));
    painter.hline(
        rail.expand2(vec2(2.0, 0.0)).x_range(),
        top,
        Stroke::new(2.0, theme.text),
    );
    painter.text(
        pos2(area.center().x, area.bottom() - 7.0),
        Align2::CENTER_CENTER,
        format!("vel {velocity:.0}"),
        small(),
        theme.quiet,
    );
    response
        .on_hover_and_drag_cursor(CursorIcon::ResizeVertical)
        .on_hover_text(
            "How hard clicks and computer keys strike. A drag across the bodies strikes harder the \
             faster it is.",
        );
}
