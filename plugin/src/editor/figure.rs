//! How a body is drawn: by its kind, from its strike line, and by its size.

use super::flat::is_flat;
use super::kind::Kind;
use super::outline::{Outline, Outlines};
use egui::{Color32, Pos2, Rect, Vec2, pos2, vec2};
use std::sync::Arc;

/// A body as it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// MIDI key.
    pub key: u8,
    /// What it is.
    pub kind: Kind,
    /// Where it is; a bowl fills it as a circle.
    pub rect: Rect,
    /// What it looks like within, if that is neither a circle nor all of it.
    pub outline: Option<Arc<Outline>>,
}

impl Figure {
    /// Whether a point is on the body, or within `slack` points of it.
    pub(super) fn holds(&self, at: Pos2, slack: f32) -> bool {
        match (self.kind, &self.outline) {
            (Kind::Bowl, _) => {
                (at - self.rect.center()).length() <= 0.5 * self.rect.width() + slack
            }
            (_, Some(outline)) => outline.holds(self.rect, at, slack),
            _ => self.rect.expand(slack).contains(at),
        }
    }

    /// Which place 0…1 on the body's line a point is, and where across if that counts.
    #[must_use]
    pub fn place(&self, at: Pos2) -> (f32, Option<f32>) {
        match &self.outline {
            Some(outline) => {
                let [position, across] = outline.place(self.rect, at);
                (position, Some(across))
            }
            None => (self.position(at), None),
        }
    }

    /// Which place 0…1 on the body's line a point is.
    #[must_use]
    pub fn position(&self, at: Pos2) -> f32 {
        if let Some(outline) = &self.outline {
            return outline.place(self.rect, at)[0];
        }
        let share = match self.kind {
            Kind::Bowl => {
                1.0 - (at - self.rect.center()).length() / (0.5 * self.rect.width()).max(1.0)
            }
            Kind::Bar | Kind::Other => {
                (at.y - self.rect.center().y).abs() / (0.5 * self.rect.height()).max(1.0)
            }
            Kind::Tube => (at.y - self.rect.top()) / self.rect.height().max(1.0),
        };
        share.clamp(0.0, 1.0)
    }

    /// Where a place 0…1 along and across is; on a bowl and a bar, towards the player.
    #[must_use]
    pub fn point(&self, [position, across]: [f32; 2]) -> Pos2 {
        if let Some(outline) = &self.outline {
            return outline.point(self.rect, [position, across]);
        }
        let centre = self.rect.center();
        match self.kind {
            Kind::Bowl => centre + vec2(0.0, 0.5 * self.rect.width() * (1.0 - position)),
            Kind::Bar | Kind::Other => centre + vec2(0.0, 0.5 * self.rect.height() * position),
            Kind::Tube => pos2(centre.x, self.rect.top() + position * self.rect.height()),
        }
    }
}

/// Whether a key is black on a piano.
pub(super) fn is_black(key: u8) -> bool {
    matches!(key % 12, 1 | 3 | 6 | 8 | 10)
}

/// Lays the bodies out as a vibraphone's are: black keys behind, white keys before, low ones on the left,
/// long ones beside short ones
/// as they are.
#[must_use]
pub fn lay_out(bank: &modes::Bank, area: Rect, outlines: &mut Outlines) -> Vec<Figure> {
    outlines.keep(&bank.bodies);
    let whites_to = |key: u8| (0..key).filter(|key| !is_black(*key)).count() as f32;
    let (Some(first), Some(last)) = (bank.bodies.first(), bank.bodies.last()) else {
        return Vec::new();
    };
    // Bowls and bodies of any shape are wider than their columns.
    let margin = match Kind::of(first) {
        Kind::Bowl | Kind::Other => 0.15,
        Kind::Bar | Kind::Tube => 0.0,
    };
    let from = whites_to(first.key) - margin - if is_black(first.key) { 0.5 } else { 0.0 };
    let to = whites_to(last.key) + margin + if is_black(last.key) { 0.5 } else { 1.0 };
    let column = area.width() / (to - from);
    let longest = bank
        .bodies
        .iter()
        .fold(f64::MIN_POSITIVE, |most, body| most.max(body.length_m));
    let rank = 0.5 * area.height();
    bank.bodies
        .iter()
        .map(|body| {
            let black = is_black(body.key);
            let kind = Kind::of(body);
            let whites = whites_to(body.key);
            let x = whites - from + if black { 0.0 } else { 0.5 };
            let share = (body.length_m / longest) as f32;
            let middle = area.top() + if black { 0.5 } else { 1.5 } * rank;
            let outline = outlines.of(body);
            let slender = outline.as_ref().filter(|own| own.is_slender());
            let (size, y) = match kind {
                Kind::Other if slender.is_some() => {
                    // As wide as they are, but wide enough to be hit.
                    let high = (rank - 8.0) * share.max(0.15);
                    let aspect = slender.map_or(0.0, |own| own.aspect());
                    let wide = (high * aspect).clamp(0.16 * column, 0.74 * column);
                    (vec2(wide, high), middle)
                }
                Kind::Bowl | Kind::Other => {
                    // Every other one stands farther back, so that there is room for larger ones; small
                    // ones are drawn larger than they are, so that they can be hit.
                    let back = if whites % 2.0 == 0.0 { 1.0 } else { -1.0 };
                    // A square's corners need more room than a circle.
                    let square = outline.is_some() && is_flat(body);
                    let room = if square { 0.4 } else { 0.54 };
                    let widest = (room * rank).min(1.25 * column);
                    let sides = outline.as_ref().map_or(Vec2::splat(1.0), |own| own.size());
                    let size = widest * share.powf(0.6).max(0.3) * sides;
                    (size, middle + 0.21 * rank * back)
                }
                Kind::Bar => {
                    let size = vec2(0.74 * column, (rank - 8.0) * share.max(0.15));
                    (size, middle)
                }
                Kind::Tube => {
                    let (room, share) = (rank - 10.0, share.max(0.15));
                    // Tubes hang from a rail.
                    let y = middle - 0.5 * room * (1.0 - share);
                    (vec2(0.6 * column, room * share), y)
                }
            };
            Figure {
                key: body.key,
                kind,
                rect: Rect::from_center_size(pos2(area.left() + x * column, y), size),
                outline,
            }
        })
        .collect()
}

/// The colour of a material, which its density and stiffness give away.
pub(super) fn tint(material: &modes::Material, dark: bool) -> Color32 {
    let density = material.density_kg_m3;
    let [r, g, b] = if density < 1500.0 {
        [0x9c, 0x6b, 0x43]
    } else if density < 2500.0 {
        [0xa9, 0xc4, 0xcf]
    } else if density < 4000.0 {
        [0xa4, 0xa9, 0xb5]
    } else if density < 8200.0 {
        [0x8f, 0x97, 0xa6]
    } else {
        [0xa8, 0x8a, 0x4e]
    };
    let scale = if dark { 0.62 } else { 1.0 };
    let [r, g, b] = [r, g, b].map(|x: i32| {
        #[expect(clippy::cast_sign_loss, reason = "colours are not negative")]
        let shade = (f64::from(x) * scale) as u8;
        shade
    });
    Color32::from_rgb(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factory;

    fn area() -> Rect {
        Rect::from_min_size(pos2(10.0, 20.0), vec2(900.0, 200.0))
    }

    #[test]
    fn every_body_is_within_the_area_and_on_no_other() {
        for index in 0..factory::BANKS.len() {
            let figures = lay_out(factory::bank(index), area(), &mut Outlines::default());
            for (number, figure) in figures.iter().enumerate() {
                assert!(area().expand(1e-3).contains_rect(figure.rect), "{figure:?}");
                for other in &figures[..number] {
                    let apart = (figure.rect.center() - other.rect.center()).length();
                    let touching = match figure.kind {
                        Kind::Bowl => apart < 0.5 * (figure.rect.width() + other.rect.width()),
                        _ => figure.rect.intersects(other.rect),
                    };
                    assert!(!touching, "{figure:?} {other:?}");
                }
            }
        }
    }

    #[test]
    fn positions_and_points_agree() {
        for index in [0, 1] {
            for figure in lay_out(factory::bank(index), area(), &mut Outlines::default()) {
                for i in 0..=10 {
                    let position = i as f32 / 10.0;
                    let point = figure.point([position, 0.0]);
                    assert!((figure.position(point) - position).abs() < 1e-4);
                    assert!(figure.holds(point, 0.1));
                }
            }
        }
    }
}
