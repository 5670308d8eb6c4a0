//! Small signs, drawn with lines.

use egui::{Color32, Painter, Pos2, Rect, Shape, Stroke, Vec2, vec2};
use std::f32::consts::{PI, TAU};

/// What a button does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Icon {
    /// The one before.
    Back,
    /// The one after.
    On,
    /// Undo.
    Undo,
    /// Redo.
    Redo,
    /// Keep.
    Save,
    /// More to choose from.
    Menu,
    /// From one side to the other.
    Copy,
    /// Away with it.
    Close,
    /// Look for something.
    Find,
    /// Sound.
    Hear,
    /// A favourite.
    Star,
    /// No favourite.
    Hollow,
}

impl Icon {
    /// Draws it in the middle of `rect`.
    pub(super) fn paint(self, painter: &Painter, rect: Rect, colour: Color32) {
        let centre = rect.center();
        let stroke = Stroke::new(1.6, colour);
        let line = |points: &[(f32, f32)]| {
            let points = points.iter().map(|(x, y)| centre + vec2(*x, *y)).collect();
            painter.add(Shape::line(points, stroke));
        };
        match self {
            Self::Back => line(&[(2.5, -5.5), (-2.5, 0.0), (2.5, 5.5)]),
            Self::On => line(&[(-2.5, -5.5), (2.5, 0.0), (-2.5, 5.5)]),
            Self::Undo => turn(painter, centre, -1.0, stroke),
            Self::Redo => turn(painter, centre, 1.0, stroke),
            Self::Save => {
                line(&[(0.0, -6.0), (0.0, 2.0)]);
                line(&[(-3.5, -1.5), (0.0, 2.0), (3.5, -1.5)]);
                line(&[(-6.0, 2.5), (-6.0, 6.0), (6.0, 6.0), (6.0, 2.5)]);
            }
            Self::Menu => {
                for y in [-4.5, 0.0, 4.5] {
                    line(&[(-6.0, y), (6.0, y)]);
                }
            }
            Self::Copy => {
                line(&[(-5.5, 0.0), (5.5, 0.0)]);
                line(&[(2.0, -3.5), (5.5, 0.0), (2.0, 3.5)]);
            }
            Self::Close => {
                line(&[(-4.5, -4.5), (4.5, 4.5)]);
                line(&[(-4.5, 4.5), (4.5, -4.5)]);
            }
            Self::Find => {
                painter.circle_stroke(centre + vec2(-1.0, -1.0), 4.0, stroke);
                line(&[(2.0, 2.0), (5.5, 5.5)]);
            }
            Self::Hear => {
                line(&[
                    (-1.0, -5.0),
                    (-3.5, -2.0),
                    (-6.0, -2.0),
                    (-6.0, 2.0),
                    (-3.5, 2.0),
                    (-1.0, 5.0),
                    (-1.0, -5.0),
                ]);
                line(&[(2.0, -2.0), (2.8, 0.0), (2.0, 2.0)]);
                line(&[(4.2, -4.2), (6.0, 0.0), (4.2, 4.2)]);
            }
            Self::Star => star(painter, centre, colour, Stroke::NONE),
            Self::Hollow => star(
                painter,
                centre,
                Color32::TRANSPARENT,
                Stroke::new(1.2, colour),
            ),
        }
    }
}

/// An arrow that turns back to the left (−1) or on to the right (1).
fn turn(painter: &Painter, centre: Pos2, way: f32, stroke: Stroke) {
    let middle = centre + vec2(0.0, 1.0);
    // From the tip over the top, a little way round.
    let points = (0..=20u8)
        .map(|i| {
            let angle = -1.2 * PI * f32::from(i) / 20.0;
            let arm = 5.0 * Vec2::angled(angle);
            middle + vec2(way * arm.x, arm.y)
        })
        .collect();
    painter.add(Shape::line(points, stroke));
    let tip = middle + vec2(way * 5.0, 0.5);
    painter.add(Shape::line(
        vec![tip + vec2(-3.2, -3.0), tip, tip + vec2(3.2, -3.0)],
        stroke,
    ));
}

fn star(painter: &Painter, centre: Pos2, fill: Color32, edge: Stroke) {
    let tip =
        |i: u8, radius: f32| centre + radius * Vec2::angled(TAU * f32::from(i) / 10.0 - PI / 2.0);
    let outline: Vec<Pos2> = (0..10u8)
        .map(|i| tip(i, if i % 2 == 0 { 6.0 } else { 2.6 }))
        .collect();
    for i in (0..10usize).step_by(2) {
        let piece = vec![centre, outline[(i + 9) % 10], outline[i], outline[i + 1]];
        painter.add(Shape::convex_polygon(piece, fill, Stroke::NONE));
    }
    painter.add(Shape::closed_line(outline, edge));
}
