//! How modes move a bar: as along the strike line, with what bending and twisting do off it.

use super::bar::Bar;
use super::{Vector, between, heard_modes};
use modes::Family;

/// The modes of a bar.
#[derive(Clone, Debug)]
pub(super) struct Beam {
    modes: Vec<Bent>,
    points: Vec<Spot>,
    aside_m: f32,
}

/// A mode along the line, from the middle to the end at positive x, in kg^(−1/2).
#[derive(Clone, Debug)]
struct Bent {
    family: Family,
    /// 1 if the motion across the bar is the same on both sides of its middle, −1 if it is opposite.
    mirrored: f32,
    shape: Vec<Vector>,
}

/// A point of the surface: where along, 0…1 from the middle, on which side, where across in m, and how
/// high, −1…1.
#[derive(Clone, Copy, Debug)]
struct Spot {
    place: f32,
    side: f32,
    y_m: f32,
    height: f32,
}

impl Beam {
    pub(super) fn of(body: &modes::Body, bar: &Bar, points_m: &[Vector]) -> Self {
        let half_m = bar.half_m() as f32;
        Self {
            modes: heard_modes(body)
                .iter()
                .map(|mode| {
                    let shape: Vec<Vector> = mode.shape.iter().collect();
                    Bent {
                        family: mode.label.family,
                        mirrored: mirrored(&shape),
                        shape,
                    }
                })
                .collect(),
            points: points_m
                .iter()
                .map(|point| Spot {
                    place: (point[0].abs() / half_m).min(1.0),
                    side: point[0].signum(),
                    y_m: point[1],
                    height: bar.height(*point),
                })
                .collect(),
            aside_m: bar.aside_m as f32,
        }
    }

    pub(super) fn motion(&self, mode: usize) -> Vec<Vector> {
        let Some(bent) = self.modes.get(mode) else {
            return vec![[0.0; 3]; self.points.len()];
        };
        self.points
            .iter()
            .map(|spot| self.move_spot(bent, spot))
            .collect()
    }

    fn move_spot(&self, bent: &Bent, spot: &Spot) -> Vector {
        let [along, aside, up] = sample(&bent.shape, spot.place);
        // On the other half everything across is as here or opposite, and what goes along the reverse.
        let sign = if spot.side < 0.0 { bent.mirrored } else { 1.0 };
        let [along, aside, up] = [sign * spot.side * along, sign * aside, sign * up];
        let across = if self.aside_m > 0.0 {
            spot.y_m / self.aside_m
        } else {
            1.0
        };
        match bent.family {
            // Sections turn: what is below the middle goes the other way.
            Family::Bending => [along * spot.height, aside, up],
            Family::Torsion => [
                along * spot.height * across,
                aside * spot.height,
                up * across,
            ],
            Family::Lateral => [along * across, aside, up * across],
            _ => [along, aside, up],
        }
    }
}

/// Whether both halves move alike across the bar: then the middle does not move along it.
fn mirrored(shape: &[Vector]) -> f32 {
    let Some([along, aside, up]) = shape.first() else {
        return 1.0;
    };
    if along * along < aside * aside + up * up {
        1.0
    } else {
        -1.0
    }
}

/// The shape at a place 0…1.
fn sample(shape: &[Vector], place: f32) -> Vector {
    let last = shape.len().saturating_sub(1);
    if last == 0 {
        return shape.first().copied().unwrap_or_default();
    }
    let x = place * last as f32;
    #[expect(clippy::cast_sign_loss, reason = "places are not negative")]
    let cell = (x as usize).min(last - 1);
    between(shape[cell], shape[cell + 1], x - cell as f32)
}
