//! From which side a body is looked at.

use super::super::kind::Kind;
use super::super::solid::{Solid, Vector, add, dot};
use egui::{Pos2, Rect, Vec2, pos2};

/// Greatest turn up or down, in rad.
const STEEPEST: f32 = 1.5;
/// How far away the eye is, in radii of the body: less would bend what is near.
const EYE: f32 = 5.0;
/// Share of the panel that a body fills.
const FILL: f32 = 0.92;
/// Share of it that the nearest corner may reach over, so that it stays inside when it moves.
const WHOLE: f32 = 0.95;
/// Least and greatest zoom.
const ZOOM: [f32; 2] = [0.5, 12.0];
/// Turn in rad for a point of drag.
const TURN: f32 = 0.009;

/// Turns and zoom beside how the kind of body is looked at by default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Camera {
    kind: Kind,
    yaw: f32,
    pitch: f32,
    zoom: f32,
}

impl Camera {
    /// How a body of that kind is looked at at first.
    #[must_use]
    pub(super) fn on(kind: Kind) -> Self {
        let (yaw, pitch) = match kind {
            Kind::Bar => (-0.42, 0.62),
            Kind::Tube => (0.38, 0.30),
            Kind::Bowl => (0.0, 0.62),
            Kind::Other => (-0.5, 0.5),
        };
        Self {
            kind,
            yaw,
            pitch,
            zoom: 1.0,
        }
    }

    /// The kind of body that it looks at.
    #[must_use]
    pub(super) fn kind(&self) -> Kind {
        self.kind
    }

    /// A drag by so many points.
    pub(super) fn turn(&mut self, by: Vec2) {
        self.yaw += TURN * by.x;
        self.pitch = (self.pitch + TURN * by.y).clamp(-STEEPEST, STEEPEST);
    }

    /// Nearer by a factor.
    pub(super) fn approach(&mut self, factor: f32) {
        self.zoom = (self.zoom * factor).clamp(ZOOM[0], ZOOM[1]);
    }

    /// Right, up and towards the eye, as directions of the body.
    pub(super) fn axes(&self) -> [Vector; 3] {
        // The body's axes that lie right, up and towards the eye before any turn.
        let [right, up, near]: [Vector; 3] = match self.kind {
            // Struck from above by someone who stands before it.
            Kind::Bar | Kind::Other => [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]],
            // Laid down with the upper end on the left, the struck side towards the eye.
            Kind::Tube => [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
            Kind::Bowl => [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]],
        };
        let (sin, cos) = self.yaw.sin_cos();
        let turned = |a: f32, b: f32| add(right.map(|x| a * x), b, near);
        let (x, z) = (turned(cos, sin), turned(-sin, cos));
        let (sin, cos) = self.pitch.sin_cos();
        let tilted = |a: f32, b: f32| add(up.map(|x| a * x), b, z);
        [x, tilted(cos, -sin), tilted(sin, cos)]
    }

    /// Everything that it takes to draw `solid` in `area`.
    pub(super) fn lens(&self, solid: &Solid, area: Rect) -> Lens {
        let axes = self.axes();
        let first = Self::on(self.kind).axes();
        let mut low = [f32::MAX; 3];
        let mut high = [f32::MIN; 3];
        let mut reach = [[f32::MAX, f32::MIN]; 2];
        for point in &solid.points_m {
            for k in 0..3 {
                low[k] = low[k].min(point[k]);
                high[k] = high[k].max(point[k]);
            }
            for (reach, axis) in reach.iter_mut().zip(&first) {
                let at = dot(*point, *axis);
                *reach = [reach[0].min(at), reach[1].max(at)];
            }
        }
        let centre_m = [0, 1, 2].map(|k| 0.5 * (low[k] + high[k]));
        let half = [0, 1, 2].map(|k| 0.5 * (high[k] - low[k]));
        let radius_m = dot(half, half).sqrt().max(1e-6);
        let [wide, high] = reach.map(|[low, high]| (high - low).max(1e-6));
        let fit = |wide: f32, high: f32| (area.width() / wide).min(area.height() / high);
        let lens = Lens {
            axes: first,
            centre_m,
            radius_m,
            scale: 1.0,
            middle: Pos2::ZERO,
        };
        // What is near looks larger, and may reach beyond the body's own width.
        let near = solid.points_m.iter().map(|point| lens.place(*point).0);
        let near = near.fold([1e-6f32; 2], |most, at| {
            [most[0].max(at.x.abs()), most[1].max(at.y.abs())]
        });
        let whole = fit(2.0 * near[0], 2.0 * near[1]);
        Lens {
            axes,
            scale: self.zoom * (FILL * fit(wide, high)).min(WHOLE * whole),
            middle: area.center(),
            ..lens
        }
    }
}

/// From the body to the screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lens {
    axes: [Vector; 3],
    centre_m: Vector,
    pub(super) radius_m: f32,
    /// Points to a metre in the middle of the body.
    scale: f32,
    middle: Pos2,
}

impl Lens {
    /// A direction as the eye sees it: right, up, near.
    pub(super) fn direction(&self, of: Vector) -> Vector {
        self.axes.map(|axis| dot(axis, of))
    }

    /// Where a point is on the screen, and how near in m.
    pub(super) fn place(&self, point_m: Vector) -> (Pos2, f32) {
        let [x, y, z] = self.direction(add(point_m, -1.0, self.centre_m));
        let away = EYE * self.radius_m;
        let scale = self.scale * away / (away - z).max(0.1 * away);
        (
            pos2(self.middle.x + scale * x, self.middle.y - scale * y),
            z,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_stay_square_however_it_is_turned() {
        for kind in [Kind::Bar, Kind::Tube, Kind::Bowl, Kind::Other] {
            let mut camera = Camera::on(kind);
            for _ in 0..50 {
                camera.turn(egui::vec2(31.0, -17.0));
                camera.approach(1.3);
                let axes = camera.axes();
                for i in 0..3 {
                    for j in 0..3 {
                        let expected = if i == j { 1.0 } else { 0.0 };
                        assert!((dot(axes[i], axes[j]) - expected).abs() < 1e-4);
                    }
                }
                let out = crate::editor::solid::cross(axes[0], axes[1]);
                assert!(dot(out, axes[2]) > 0.99, "right-handed");
            }
            assert!(camera.pitch >= -STEEPEST && camera.zoom <= ZOOM[1]);
        }
    }
}
