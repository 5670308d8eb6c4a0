//! A body drawn: from its surface and how its modes swing to triangles on the screen.

use super::super::kind::Kind;
use super::super::solid::{Place, Solid, Vector, add};
use super::camera::{Camera, Lens};
use super::nodal::nodal_lines;
use super::picture::{Picture, Rim, colours, mapped};
use super::shade::Shade;
use super::sway::Sway;
use egui::{Color32, Mesh, Pos2, Rect};

/// How the modes of a body swing, in the order of [`Partial::all`](crate::engine::Partial::all).
#[derive(Clone, Copy, Debug)]
pub struct Swinging<'a> {
    /// Frequencies, in Hz.
    pub hz: &'a [f64],
    /// Amplitudes, in m·kg^(1/2).
    pub swings: &'a [f32],
    /// The mode that is shown alone, if one is.
    pub alone: Option<usize>,
    /// How many times as far as usual the picture shows them swing.
    pub times: f32,
}

/// The colours of a picture.
#[derive(Clone, Copy, Debug)]
pub struct Paint<'a> {
    /// Of the body at rest.
    pub own: Color32,
    /// Of what moves outwards, and of what moves inwards.
    pub moving: [Color32; 2],
    /// A map over it, if there is one, in place of the former two.
    pub map: Option<Laid<'a>>,
    /// Of nodal lines.
    pub ink: Color32,
    /// Whether it shines as metals do.
    pub metal: bool,
    /// Points to a pixel.
    pub pixel: f32,
}

/// A map that lies on a body.
#[derive(Clone, Copy, Debug)]
pub struct Laid<'a> {
    /// The colour of each point of the surface.
    pub colours: &'a [Color32],
    /// How far beyond the sides of the body it is drawn, in points, so that a thread's is seen.
    pub beyond: f32,
}

/// What drawing one body after the other remembers.
pub struct Portrait {
    pub(super) camera: Camera,
    sway: Sway,
    picture: Picture,
    pub(super) lens: Option<Lens>,
}

impl Default for Portrait {
    /// Of nobody yet.
    fn default() -> Self {
        Self {
            camera: Camera::on(Kind::Bar),
            sway: Sway::default(),
            picture: Picture::default(),
            lens: None,
        }
    }
}

impl Portrait {
    /// Another body, of another instrument or of the same: it is looked at as its kind is at first.
    pub fn turn_to(&mut self, solid: &Solid, instrument: bool) {
        self.sway.forget(instrument);
        if self.camera.kind() != solid.kind {
            self.camera = Camera::on(solid.kind);
        }
    }

    /// Moves the surface on by `passed_s`, as it is to be drawn in `area`; whether anything moves.
    pub fn swing(
        &mut self,
        solid: &Solid,
        area: Rect,
        swinging: &Swinging<'_>,
        passed_s: f32,
    ) -> bool {
        let lens = self.camera.lens(solid, area);
        self.sway.pass(passed_s);
        let moves = match swinging.alone {
            Some(mode) => {
                self.sway.alone(solid, mode, lens.radius_m, swinging.times);
                true
            }
            None => self.sway.live(solid, swinging, lens.radius_m),
        };
        self.picture.look(solid, &self.sway.moved_m, &lens);
        self.lens = Some(lens);
        moves
    }

    /// The triangles of the body as it last swung, the farthest first.
    #[must_use]
    pub fn mesh(&mut self, solid: &Solid, swinging: &Swinging<'_>, paint: &Paint<'_>) -> Mesh {
        let Some(lens) = self.lens else {
            return Mesh::default();
        };
        let shade = Shade::new(paint.own, paint.moving, paint.metal);
        let colours = match paint.map {
            Some(map) => mapped(solid, &shade, map.colours, &lens),
            None => colours(solid, &shade, &self.sway.out, &lens),
        };
        let lines = match swinging.alone {
            Some(mode) => {
                let motion = self.sway.motion(solid, mode).0.clone();
                nodal_lines(solid, &motion, &self.sway.moved_m)
            }
            None => Vec::new(),
        };
        let lines = (&lines[..], paint.ink);
        let rim = Rim {
            pixel: paint.pixel,
            beyond: paint.map.map_or(0.0, |map| map.beyond),
        };
        self.picture.mesh(solid, &colours, lines, &lens, rim)
    }

    /// The point of the surface in m at a place on the screen, and what a blow there counts as.
    #[must_use]
    pub fn struck_at(&self, solid: &Solid, at: Pos2) -> Option<(Vector, Place)> {
        let (number, shares) = self.picture.pick(solid, at)?;
        let corners = solid.triangles[number as usize];
        let point = (corners.into_iter().zip(shares)).fold([0.0; 3], |sum, (i, share)| {
            add(sum, share, solid.points_m[i as usize])
        });
        Some((point, solid.struck_as(point, number as usize, shares)))
    }
}
