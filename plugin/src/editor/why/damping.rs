//! Why the sound ends: decay rates over frequency as the sum of their causes, with handles on three of them.

use super::super::axis::Axis;
use super::super::hold::Hold;
use super::super::param::Param;
use super::super::plot::Scene;
use super::super::ringing::{Ringing, hertz, seconds};
use super::super::theme::{Cause, Theme};
use super::losses::{Board, HZ, PER_S, heap, legend, material, scales, stem};
use egui::{
    Color32, CursorIcon, EventFilter, Id, Key, Painter, Pos2, Rangef, Rect, Sense, Stroke, Ui,
    WidgetInfo, pos2, vec2,
};
use modes::t60_s;
use nice_plug::prelude::ParamSetter;
use std::f64::consts::TAU;

/// The parameters with handles, their causes and where the handles are, in Hz.
const HANDLES: [(&str, Cause, f64); 3] = [
    ("alpha2", Cause::Alpha2, 80.0),
    ("tanphi", Cause::LossFactor, 900.0),
    ("alpha1", Cause::Alpha1, 8000.0),
];
/// What Shift leaves of a key's step, and that step as a share of the range.
const FINE: f32 = 0.1;
const STEP: f32 = 0.02;

/// What a parameter must be in its unit for its cause to take `per_s` at `hz`, the material's own included.
fn wanted(cause: Cause, scene: &Scene<'_>, hz: f64, per_s: f64) -> f64 {
    let own = scene.settings.losses.own;
    let omega = TAU * hz;
    let (whole, bank) = match cause {
        Cause::Alpha1 => (2.0 * per_s / (omega * omega), scene.own.rayleigh.alpha1_s),
        Cause::Alpha2 => (2.0 * per_s, scene.own.rayleigh.alpha2_per_s),
        _ => (2.0 * per_s / omega, scene.own.loss_factor),
    };
    (whole - own * bank).max(0.0)
}

/// Draws it in `area` and lets hands move the three parameters; what the pointer is on, in words.
pub(in super::super) fn damping(
    ui: &Ui,
    area: Rect,
    scene: &Scene<'_>,
    params: &[Param],
    hold: &mut Hold,
    setter: &ParamSetter<'_>,
) -> Option<String> {
    let plot = Rect::from_min_max(
        pos2(area.left() + 40.0, area.top() + 4.0),
        pos2(area.right() - 42.0, area.bottom() - 34.0),
    );
    let board = Board {
        hz: Axis::log(HZ, plot.x_range()),
        per_s: Axis::log(PER_S, Rangef::new(plot.bottom(), plot.top())),
        area: plot,
        scene,
    };
    let painter = ui.painter().with_clip_rect(area);
    scales(&painter, &board);
    heap(&painter, &board);
    let inside = painter.with_clip_rect(plot);
    let trims = scene.trims.get();
    for partial in &scene.shown.partials {
        let trim = trims.get(&partial.label);
        let ringing = Ringing::of(
            partial,
            &scene.settings.losses,
            scene.own,
            &scene.frame.held,
        )
        .trimmed(trim.ringing.into());
        stem(&inside, &board, &ringing);
    }
    legend(&painter, area, scene.theme);
    let mut hint = None;
    for (id, cause, hz) in HANDLES {
        let Some(param) = params.iter().find(|param| param.spec.id == id) else {
            continue;
        };
        hint = handle(ui, &board, param, (cause, hz), hold, setter).or(hint);
    }
    hint
}

/// The line of one cause and the handle on it.
fn handle(
    ui: &Ui,
    board: &Board<'_>,
    param: &Param,
    (cause, hz): (Cause, f64),
    hold: &mut Hold,
    setter: &ParamSetter<'_>,
) -> Option<String> {
    let theme = board.scene.theme;
    let number = cause as usize;
    let taken = |hz: f64| material(board.scene, hz)[number];
    let point = |hz: f64| pos2(board.hz.place(hz), board.per_s.place(taken(hz).max(1e-9)));
    let area = board.area;
    let painter = ui.painter().with_clip_rect(area);
    let line = [point(HZ[0]), point(HZ[1])];
    let y = point(hz).y.clamp(area.top() + 7.0, area.bottom() - 7.0);
    let at = pos2(board.hz.place(hz), y);
    let grip = Rect::from_center_size(at, vec2(22.0, 22.0));
    let id = Id::unique(("handle", param.spec.id));
    let response = ui.interact(grip, id, Sense::click_and_drag());
    response.widget_info(|| {
        let name = format!("{} handle", param.spec.name);
        WidgetInfo::slider(true, f64::from(param.value()), name)
    });
    if response.double_clicked() || response.triple_clicked() {
        hold.let_go(setter);
        param.put(setter, param.default());
    } else {
        if response.drag_started() {
            response.request_focus();
            hold.take(param, setter);
        }
        if response.dragged()
            && hold.holds(param)
            && let Some(to) = response.interact_pointer_pos()
        {
            let below = to.y >= area.bottom() - 2.0;
            let per_s = if below { 0.0 } else { board.per_s.value(to.y) };
            let plain = wanted(cause, board.scene, hz, per_s);
            hold.put(param.place(plain as f32), setter);
        }
        if response.drag_stopped() {
            hold.let_go(setter);
        }
    }
    if response.has_focus() {
        keys(ui, id, param, setter);
    }
    let lit = response.hovered() || response.dragged() || response.has_focus();
    let colour = theme.cause(cause);
    painter.line_segment(line, Stroke::new(if lit { 2.5 } else { 1.5 }, colour));
    knob(&painter, at, colour, lit, theme);
    let text = format!(
        "{}: takes {:.2} 1/s at {} (alone {}); {}",
        cause.name(),
        taken(hz),
        hertz(hz),
        seconds(t60_s(taken(hz))),
        param.text()
    );
    let hint = lit.then_some(text);
    response
        .on_hover_and_drag_cursor(CursorIcon::ResizeVertical)
        .on_hover_text(param.spec.tooltip);
    hint
}

fn keys(ui: &Ui, id: Id, param: &Param, setter: &ParamSetter<'_>) {
    let filter = EventFilter {
        vertical_arrows: true,
        ..EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, filter));
    let pressed = |key| f32::from(u8::from(ui.input(|input| input.key_pressed(key))));
    let fine = if ui.input(|input| input.modifiers.shift) {
        FINE
    } else {
        1.0
    };
    let step = STEP * fine * (pressed(Key::ArrowUp) - pressed(Key::ArrowDown));
    if step != 0.0 {
        param.put(setter, param.value() + step);
    }
}

fn knob(painter: &Painter, at: Pos2, colour: Color32, lit: bool, theme: &Theme) {
    let radius = if lit { 7.0 } else { 5.5 };
    painter.circle(at, radius, colour, Stroke::new(2.0, theme.ground));
    if lit {
        painter.circle_stroke(at, radius + 2.0, Stroke::new(1.5, theme.text));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::editor::frame::Frame;
    use crate::editor::shown::Shown;
    use crate::engine::Settings;
    use crate::factory;
    use crate::params::TrimTable;
    use crate::shelf::Shelved;

    #[test]
    fn a_handle_asks_for_what_then_is_taken() {
        let bank = factory::bank(1);
        let mut settings = Settings::default();
        let shown = Shown::new(1, Shelved::factory(1), None);
        let (frame, trims) = (Frame::default(), TrimTable::default());
        for (cause, hz) in [
            (Cause::Alpha1, 8000.0),
            (Cause::Alpha2, 80.0),
            (Cause::LossFactor, 900.0),
        ] {
            let set = |settings: &Settings| {
                let scene = Scene {
                    shown: &shown,
                    frame: &frame,
                    settings,
                    own: &bank.damping,
                    contact_s: 1e-3,
                    trims: &trims,
                    theme: &Theme::DARK,
                };
                (
                    wanted(cause, &scene, hz, 7.0),
                    material(&scene, hz)[cause as usize],
                )
            };
            let value = set(&settings).0;
            let added = &mut settings.losses.added;
            match cause {
                Cause::Alpha1 => added.rayleigh.alpha1_s = value,
                Cause::Alpha2 => added.rayleigh.alpha2_per_s = value,
                _ => added.loss_factor = value,
            }
            let taken = set(&settings).1;
            assert!((taken - 7.0).abs() < 1e-9, "{}: {taken}", cause.name());
        }
    }
}
