//! The switch of the map of timbre, and what its colours mean.

use super::super::ramp::Ramp;
use super::super::theme::{NEAR, SIDE, Theme, small};
use super::timbre::FARTHEST_DB;
use egui::epaint::{Vertex, WHITE_UV};
use egui::{
    Align2, CornerRadius, CursorIcon, Id, Mesh, Rect, Role, Sense, Shape, Stroke, StrokeKind, Ui,
    WidgetInfo, pos2, vec2,
};

/// Height of the legend.
pub(super) const LEGEND: f32 = 18.0;
/// Width of its colours, and pieces of one run of colour.
const WIDE: f32 = 112.0;
const PIECES: u32 = 32;
/// Space between the legend and what the pointer is on.
const APART_WORDS: f32 = NEAR + SIDE;

/// The switch in the upper right corner of `area`; whether it is turned over.
pub(super) fn switch(ui: &Ui, area: Rect, on: bool, theme: &Theme) -> bool {
    let slot = Rect::from_min_size(
        pos2(area.right() - 60.0, area.top() - 1.0),
        vec2(58.0, 18.0),
    );
    let response = ui.interact(slot, Id::unique("map"), Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, on, "Map"));
    let lit = response.hovered() || response.has_focus();
    let painter = ui.painter();
    painter.text(
        slot.left_center(),
        Align2::LEFT_CENTER,
        "Map",
        small(),
        if lit || on { theme.text } else { theme.quiet },
    );
    let pill = Rect::from_center_size(pos2(slot.right() - 13.0, slot.center().y), vec2(26.0, 14.0));
    let fill = if on { theme.glow } else { theme.line };
    let edge = if lit { theme.quiet } else { fill };
    painter.rect(
        pill,
        CornerRadius::same(7),
        fill,
        Stroke::new(1.0, edge),
        StrokeKind::Inside,
    );
    let x = if on {
        pill.right() - 7.0
    } else {
        pill.left() + 7.0
    };
    painter.circle_filled(pos2(x, pill.center().y), 4.5, theme.text);
    let clicked = response.clicked();
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_text(
            "Colours the body by how different a blow there would sound from one where notes strike it: by how \
             much its partials are louder or softer. The sound does not change; a click strikes there and shows \
             the map from there.",
        );
    clicked
}

/// What the colours mean, in the lower left of `area`, with the place on them of what the pointer is on.
pub(super) fn legend(ui: &Ui, area: Rect, pointed_db: Option<f32>, theme: &Theme) {
    let painter = ui.painter();
    let middle = area.bottom() - 0.5 * LEGEND;
    let word = |x: f32, text: String, colour| {
        painter.text(pos2(x, middle), Align2::LEFT_CENTER, text, small(), colour)
    };
    let same = word(area.left() + 2.0, "same".to_owned(), theme.quiet);
    let left = same.right() + SIDE;
    let bar = Rect::from_min_max(pos2(left, middle - 4.0), pos2(left + WIDE, middle + 4.0));
    painter.add(Shape::mesh(colours(bar, Ramp::of(theme))));
    let different = word(bar.right() + SIDE, "different".to_owned(), theme.quiet);
    if let Some(db) = pointed_db {
        let x = bar.left() + bar.width() * (db / FARTHEST_DB).clamp(0.0, 1.0);
        let tick = Rect::from_center_size(pos2(x, middle), vec2(4.0, 14.0));
        painter.rect(
            tick,
            CornerRadius::same(2),
            theme.text,
            Stroke::new(1.0, theme.panel),
            StrokeKind::Outside,
        );
        let x = different.right() + APART_WORDS;
        word(x, format!("here {db:.1} dB"), theme.text);
    }
}

/// A run of all colours.
fn colours(bar: Rect, ramp: &Ramp) -> Mesh {
    let mut mesh = Mesh::default();
    for piece in 0..=PIECES {
        let share = piece as f32 / PIECES as f32;
        let x = bar.left() + share * bar.width();
        for y in [bar.top(), bar.bottom()] {
            mesh.vertices.push(Vertex {
                pos: pos2(x, y),
                uv: WHITE_UV,
                color: ramp.colour(share),
            });
        }
    }
    for piece in 0..PIECES {
        let first = 2 * piece;
        mesh.indices.extend([0, 1, 2, 1, 3, 2].map(|i| first + i));
    }
    mesh
}
