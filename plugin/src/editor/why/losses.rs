//! Decay rates over frequency: the material's as a heap, each partial's as a stem, in the colours of their causes.

use super::super::axis::{Axis, notch};
use super::super::plot::Scene;
use super::super::ringing::{Ringing, seconds};
use super::super::theme::{Cause, NEAR, SIDE, Theme, small};
use egui::epaint::{Mesh, Vertex, WHITE_UV};
use egui::{Align2, Color32, CornerRadius, Painter, Rangef, Rect, Shape, Stroke, pos2, vec2};
use modes::t60_s;
use std::f64::consts::TAU;

/// Frequencies in Hz and decay rates in 1/s that are drawn.
pub(super) const HZ: [f64; 2] = [40.0, 20e3];
pub(super) const PER_S: [f64; 2] = [0.05, 5000.0];
/// Columns of the area under the sum.
const COLUMNS: usize = 96;

/// What the drawing needs.
pub(super) struct Board<'a> {
    pub(super) hz: Axis,
    pub(super) per_s: Axis,
    pub(super) area: Rect,
    pub(super) scene: &'a Scene<'a>,
}

/// What α1, α2 and tan φ take at a frequency, in 1/s, in the order of [`Cause::ALL`].
pub(super) fn material(scene: &Scene<'_>, hz: f64) -> [f64; 3] {
    let drain = scene.settings.losses.drain(scene.own);
    let omega = TAU * hz;
    [
        0.5 * drain.alpha1_s * omega * omega,
        0.5 * drain.alpha2_per_s,
        0.5 * drain.loss_factor * omega,
    ]
}

pub(super) fn scales(painter: &Painter, board: &Board<'_>) {
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
pub(super) fn heap(painter: &Painter, board: &Board<'_>) {
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
pub(super) fn stem(painter: &Painter, board: &Board<'_>, ringing: &Ringing) {
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
pub(super) fn legend(painter: &Painter, area: Rect, theme: &Theme) {
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
