//! One body: its shape and material, how much it rings, and where it was struck.

use super::figure::{Figure, is_black, tint};
use super::kind::Kind;
use super::theme::Theme;
use egui::epaint::RectShape;
use egui::{Color32, CornerRadius, Painter, Rect, Shape, Stroke, StrokeKind, pos2, vec2};
use modes::Bank;

/// How a body is to look.
pub(super) struct Look {
    /// How much it rings, 0…1.
    pub(super) glow: f32,
    pub(super) hovered: bool,
    /// Where it was struck last, if it is the body struck last.
    pub(super) mark: Option<[f32; 2]>,
    /// Where notes strike it, along and across.
    pub(super) set: [f32; 2],
    /// Where a click would strike it.
    pub(super) pointed: Option<[f32; 2]>,
}

/// Draws it.
pub(super) fn paint_body(
    painter: &Painter,
    figure: &Figure,
    bank: &Bank,
    theme: &Theme,
    look: &Look,
) {
    let body = bank.bodies.iter().find(|body| body.key == figure.key);
    let matter = body.map_or_else(|| bank.matter(), |body| bank.matter_of(body));
    let own = tint(&matter.material, theme.dark);
    let own = if is_black(figure.key) {
        Theme::mix(own, theme.ground, if theme.dark { 0.35 } else { 0.2 })
    } else {
        own
    };
    let fill = Theme::mix(own, theme.glow, 0.9 * look.glow);
    let edge = if look.hovered {
        theme.text
    } else {
        Theme::mix(fill, theme.ground, 0.35)
    };
    halo(painter, figure, theme.glow, look.glow);
    match figure.kind {
        Kind::Bowl => bowl(painter, figure, fill, edge),
        Kind::Bar => bar(painter, figure, fill, edge),
        Kind::Tube => tube(painter, figure, fill, edge, theme),
        Kind::Other => other(painter, figure, fill, edge),
    }
    tick(
        painter,
        figure,
        look.set,
        Stroke::new(1.0, theme.ground.gamma_multiply(0.6)),
    );
    if let Some(pointed) = look.pointed {
        tick(painter, figure, pointed, Stroke::new(1.5, theme.text));
    }
    if let Some(mark) = look.mark {
        let at = figure.point(mark);
        painter.circle(at, 4.0, theme.glow, Stroke::new(1.5, theme.ground));
    }
}

/// A line across the body at a place on its line; on a bowl, a circle; on a body struck anywhere, a ring.
fn tick(painter: &Painter, figure: &Figure, place: [f32; 2], stroke: Stroke) {
    let [position, _] = place;
    match figure.kind {
        Kind::Other => {
            painter.circle_stroke(figure.point(place), 2.5, stroke);
        }
        Kind::Bowl => {
            let radius = 0.5 * figure.rect.width() * (1.0 - position);
            painter.circle_stroke(figure.rect.center(), radius, stroke);
        }
        Kind::Bar | Kind::Tube => {
            let y = figure.point(place).y;
            painter.hline(figure.rect.x_range(), y, stroke);
        }
    }
}

/// Light around what rings.
fn halo(painter: &Painter, figure: &Figure, colour: Color32, glow: f32) {
    if glow < 0.02 {
        return;
    }
    let radius = match figure.kind {
        Kind::Bowl => 0.5 * figure.rect.width(),
        Kind::Bar | Kind::Tube => 5.0,
        Kind::Other => 0.4 * figure.rect.size().min_elem(),
    };
    #[expect(clippy::cast_sign_loss, reason = "a radius is not negative")]
    let corner = CornerRadius::same(radius.min(120.0) as u8);
    let blur = 6.0 + 14.0 * glow;
    let shape = RectShape::filled(
        figure.rect.expand(0.25 * blur),
        corner,
        colour.gamma_multiply(0.55 * glow),
    );
    painter.add(shape.with_blur_width(blur));
}

fn other(painter: &Painter, figure: &Figure, fill: Color32, edge: Color32) {
    if let Some(outline) = &figure.outline {
        for piece in outline.pieces(figure.rect) {
            painter.add(Shape::convex_polygon(piece, fill, Stroke::NONE));
        }
        let corners = outline.corners(figure.rect);
        painter.add(Shape::closed_line(corners, Stroke::new(1.0, edge)));
    }
}

fn bowl(painter: &Painter, figure: &Figure, fill: Color32, edge: Color32) {
    let (centre, radius) = (figure.rect.center(), 0.5 * figure.rect.width());
    painter.circle(centre, radius, fill, Stroke::new(1.0, edge));
    // The hollow, deeper towards the middle.
    for (share, shade) in [(0.84, 0.18), (0.58, 0.28), (0.32, 0.36)] {
        painter.circle_filled(
            centre,
            share * radius,
            Theme::mix(fill, Color32::BLACK, shade),
        );
    }
}

fn bar(painter: &Painter, figure: &Figure, fill: Color32, edge: Color32) {
    let rect = figure.rect;
    painter.rect(
        rect,
        CornerRadius::same(3),
        fill,
        Stroke::new(1.0, edge),
        StrokeKind::Inside,
    );
    let light = Rect::from_min_max(
        rect.min + vec2(2.0, 3.0),
        pos2(rect.left() + 0.3 * rect.width(), rect.bottom() - 3.0),
    );
    painter.rect_filled(light, 2.0, Color32::from_white_alpha(22));
    // Cords run through a free bar's nodes.
    for share in [0.224, 0.776] {
        let at = pos2(rect.center().x, rect.top() + share * rect.height());
        painter.circle_filled(at, 1.4, Theme::mix(fill, Color32::BLACK, 0.55));
    }
}

fn tube(painter: &Painter, figure: &Figure, fill: Color32, edge: Color32, theme: &Theme) {
    let rect = figure.rect;
    let x = rect.center().x;
    painter.add(Shape::line_segment(
        [pos2(x, rect.top() - 4.0), pos2(x, rect.top() + 3.0)],
        Stroke::new(1.0, theme.quiet),
    ));
    painter.rect(
        rect,
        CornerRadius::same(2),
        fill,
        Stroke::new(1.0, edge),
        StrokeKind::Inside,
    );
    let band = |from: f32, to: f32| {
        Rect::from_min_max(
            pos2(rect.left() + from * rect.width(), rect.top() + 1.0),
            pos2(rect.left() + to * rect.width(), rect.bottom() - 1.0),
        )
    };
    painter.rect_filled(band(0.2, 0.42), 1.0, Color32::from_white_alpha(40));
    painter.rect_filled(band(0.72, 0.95), 1.0, Color32::from_black_alpha(45));
}
