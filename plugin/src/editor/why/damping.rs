//! Why the sound ends: decay rates over frequency as the sum of their causes, with handles on three of them.

use super::super::axis::{Axis, notch};
use super::super::hold::Hold;
use super::super::param::Param;
use super::super::plot::Scene;
use super::super::ringing::{Ringing, hertz, seconds};
use super::super::theme::{Cause, NEAR, SIDE, Theme, small};
use egui::epaint::{Mesh, Vertex, WHITE_UV};
use egui::{
    Align2, Color32, CornerRadius, CursorIcon, EventFilter, Id, Key, Painter, Pos2, Rangef, Rect,
    Sense, Shape, Stroke, Ui, WidgetInfo, pos2, vec2,
};
use modes::t60_s;
use nice_plug::prelude::ParamSetter;
use std::f64::consts::TAU;

/// Frequencies in Hz and decay rates in 1/s that are drawn.
const HZ: [f64; 2] = [40.0, 20e3];
const PER_S: [f64; 2] = [0.05, 5000.0];
/// The parameters with handles, their causes and where the handles are, in Hz.
const HANDLES: [(&str, Cause, f64); 3] = [
    ("alpha2", Cause::Alpha2, 80.0),
    ("tanphi", Cause::LossFactor, 900.0),
    ("alpha1", Cause::Alpha1, 8000.0),
];
/// Columns of the area under the sum.
const COLUMNS: usize = 96;
/// What Shift leaves of a key's step, and that step as a share of the range.
const FINE: f32 = 0.1;
const STEP: f32 = 0.02;

/// What the drawing needs.
struct Board<'a> {
    hz: Axis,
    per_s: Axis,
    area: Rect,
    scene: &'a Scene<'a>,
}

/// What α1, α2 and tan φ take at a frequency, in 1/s, in the order of [`Cause::ALL`].
fn material(scene: &Scene<'_>, hz: f64) -> [f64; 3] {
    let drain = scene.settings.losses.drain(scene.own);
    let omega = TAU * hz;
    [
        0.5 * drain.alpha1_s * omega * omega,
        0.5 * drain.alpha2_per_s,
        0.5 * drain.loss_factor * omega,
    ]
}

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

fn scales(painter: &Painter, board: &Board<'_>) {
    let (theme, area) = (board.scene.theme, board.area);
    painter.rect_filled(area, CornerRadius::same(3), theme.ground);
    let fine = Stroke::new(1.0, theme.line.gamma_multiply(0.55));
    for (hz, text) in [(100.0, "100"), (1e3, "1k"), (10e3, "10k")] {
        let x = board.hz.place(hz);
        painter.vline(x, area.y_range(), fine);
        let at = pos2(x, area.bottom() + 8.0);
        painter.text(at, Align2::CENTER_CENTER, text, small(), theme.quiet);
    }
    let corner = area.left_bottom() + vec2(-NEAR, 8.0);
    notch(painter, corner, "Hz", theme);
    for (per_s, text) in [
        (0.1, "0.1/s"),
        (1.0, "1/s"),
        (10.0, "10/s"),
        (100.0, "100/s"),
        (1000.0, "1k/s"),
    ] {
        let y = board.per_s.place(per_s);
        painter.hline(area.x_range(), y, fine);
        notch(painter, pos2(area.left() - NEAR, y), text, theme);
        let at = pos2(area.right() + NEAR, y);
        let time = seconds(t60_s(per_s));
        painter.text(at, Align2::LEFT_CENTER, time, small(), theme.quiet);
    }
}

/// The material's causes as a heap whose height is their sum and whose layers are their shares.
fn heap(painter: &Painter, board: &Board<'_>) {
    let Board { area, scene, .. } = board;
    let mut mesh = Mesh::default();
    let layers: [Color32; 3] =
        [0, 1, 2].map(|k| scene.theme.cause(Cause::ALL[k]).gamma_multiply(0.30));
    for column in 0..=COLUMNS {
        let share = column as f32 / COLUMNS as f32;
        let hz = HZ[0] * (HZ[1] / HZ[0]).powf(share.into());
        let parts = material(scene, hz);
        let sum: f64 = parts.iter().sum();
        let top = board
            .per_s
            .place(sum.max(PER_S[0]))
            .clamp(area.top(), area.bottom());
        let x = board.hz.place(hz);
        let mut y = area.bottom();
        for (part, color) in parts.iter().zip(layers) {
            let to = y + (top - area.bottom()) * (part / sum.max(f64::MIN_POSITIVE)) as f32;
            for y in [y, to] {
                let (pos, uv) = (pos2(x, y), WHITE_UV);
                mesh.vertices.push(Vertex { pos, uv, color });
            }
            y = to;
        }
    }
    for column in 0..COLUMNS as u32 {
        for layer in 0..3 {
            let here = 6 * column + 2 * layer;
            let next = here + 6;
            mesh.indices
                .extend([here, here + 1, next, here + 1, next + 1, next]);
        }
    }
    painter.add(Shape::mesh(mesh));
}

/// A partial: as high as its decay rate, its colours the shares of the causes.
fn stem(painter: &Painter, board: &Board<'_>, ringing: &Ringing) {
    let sum: f64 = ringing.per_s.iter().sum();
    if !board.hz.holds(ringing.hz) || sum <= PER_S[0] {
        return;
    }
    let x = board.hz.place(ringing.hz);
    let (bottom, top) = (board.area.bottom(), board.per_s.place(sum));
    let mut y = bottom;
    for (cause, share) in Cause::ALL.into_iter().zip(ringing.shares()) {
        let to = y + (top - bottom) * share as f32;
        let colour = board.scene.theme.cause(cause);
        painter.vline(
            x,
            Rangef::new(to, y),
            Stroke::new(1.5, colour.gamma_multiply(0.9)),
        );
        y = to;
    }
}

/// The causes and their colours.
fn legend(painter: &Painter, area: Rect, theme: &Theme) {
    let mut at = pos2(area.left() + 2.0, area.bottom() - 8.0);
    for cause in Cause::ALL {
        let text = painter.layout_no_wrap(cause.name().to_owned(), small(), theme.quiet);
        let size = text.size();
        if at.x + 12.0 + size.x > area.right() {
            return;
        }
        let dot = Rect::from_center_size(at + vec2(4.0, 0.0), vec2(8.0, 8.0));
        painter.rect_filled(dot, CornerRadius::same(2), theme.cause(cause));
        painter.galley(at + vec2(12.0, -0.5 * size.y), text, theme.quiet);
        at.x += 12.0 + size.x + SIDE;
    }
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

    #[test]
    fn a_handle_asks_for_what_then_is_taken() {
        let bank = factory::bank(1);
        let mut settings = Settings::default();
        let shown = Shown::new(1, None);
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
