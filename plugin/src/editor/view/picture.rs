//! A body as triangles on the screen, the farthest first.

use super::super::solid::{Solid, Vector, add};
use super::camera::Lens;
use super::shade::Shade;
use egui::epaint::{Vertex, WHITE_UV};
use egui::{Color32, Mesh, Pos2, Vec2};

/// Width of soft edges, in pixels.
const SOFT: f32 = 1.2;
/// How much nearer than the surface lines on it are taken to be, in radii of the body.
const LIFTED: f32 = 0.012;

/// A body as it is seen: its points on the screen and what of it faces the eye.
#[derive(Default)]
pub(super) struct Picture {
    at: Vec<Pos2>,
    near_m: Vec<f32>,
    faces: Vec<bool>,
    order: Vec<(u32, Piece)>,
}

/// What is drawn: a triangle, the soft edge beside it, or a line on the surface.
#[derive(Clone, Copy)]
enum Piece {
    Triangle(u32),
    Edge(u32),
    Line(u32),
}

/// What is drawn along the edges of what is seen.
#[derive(Clone, Copy)]
pub(super) struct Rim {
    /// Points to a pixel.
    pub(super) pixel: f32,
    /// How far the colour goes on before it fades, in points.
    pub(super) beyond: f32,
}

/// A line on the surface, in m.
pub(super) type Segment = [Vector; 2];

/// Nearness as a number that grows with it.
fn rank(near_m: f32) -> u32 {
    let bits = near_m.to_bits();
    if near_m.is_sign_negative() {
        !bits
    } else {
        bits | 0x8000_0000
    }
}

impl Picture {
    /// Looks at `solid`, its points moved by `moved_m`.
    pub(super) fn look(&mut self, solid: &Solid, moved_m: &[Vector], lens: &Lens) {
        self.at.clear();
        self.near_m.clear();
        for (point, moved) in solid.points_m.iter().zip(moved_m) {
            let (at, near_m) = lens.place(add(*point, 1.0, *moved));
            self.at.push(at);
            self.near_m.push(near_m);
        }
        self.faces.clear();
        let corner = |i: u32| self.at[i as usize];
        self.faces.extend(solid.triangles.iter().map(|triangle| {
            let [a, b, c] = triangle.map(corner);
            // Counter-clockwise with y upwards.
            (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0.0
        }));
        self.order.clear();
        for (number, triangle) in (0..).zip(&solid.triangles) {
            if self.faces[number as usize] {
                let near_m: f32 = triangle.iter().map(|i| self.near_m[*i as usize]).sum();
                self.order
                    .push((rank(near_m / 3.0), Piece::Triangle(number)));
            }
        }
        for (number, [from, to, one, other]) in (0..).zip(&solid.edges) {
            if self.faces[*one as usize] != self.faces[*other as usize] {
                let near_m = self.near_m[*from as usize] + self.near_m[*to as usize];
                self.order.push((rank(0.5 * near_m), Piece::Edge(number)));
            }
        }
    }

    /// The triangles to draw, lines on the surface among them.
    pub(super) fn mesh(
        &mut self,
        solid: &Solid,
        colours: &[Color32],
        (lines, ink): (&[Segment], Color32),
        lens: &Lens,
        rim: Rim,
    ) -> Mesh {
        for (number, [from, to]) in (0..).zip(lines) {
            let near_m = 0.5 * (lens.place(*from).1 + lens.place(*to).1);
            let lifted = near_m + LIFTED * lens.radius_m;
            self.order.push((rank(lifted), Piece::Line(number)));
        }
        self.order.sort_unstable_by_key(|(rank, _)| *rank);
        let mut mesh = Mesh::default();
        mesh.vertices.reserve(solid.points_m.len() + 1024);
        mesh.vertices
            .extend(self.at.iter().zip(colours).map(|(pos, color)| Vertex {
                pos: *pos,
                uv: WHITE_UV,
                color: *color,
            }));
        mesh.indices.reserve(3 * self.order.len());
        for (_, piece) in &self.order {
            match *piece {
                Piece::Triangle(number) => {
                    mesh.indices.extend(solid.triangles[number as usize]);
                }
                Piece::Edge(number) => self.soften(solid, number, rim, &mut mesh),
                Piece::Line(number) => {
                    let ends = lines[number as usize].map(|end| lens.place(end).0);
                    stroke(ends, ink, rim.pixel, &mut mesh);
                }
            }
        }
        mesh
    }

    /// Lets the colour fade out beyond an edge of what is seen.
    fn soften(&self, solid: &Solid, number: u32, rim: Rim, mesh: &mut Mesh) {
        let [from, to, one, other] = solid.edges[number as usize];
        let seen = if self.faces[one as usize] { one } else { other };
        let triangle = solid.triangles[seen as usize];
        let [a, b] = [from, to].map(|i| self.at[i as usize]);
        let inside = triangle.map(|i| self.at[i as usize].to_vec2());
        let middle = (inside[0] + inside[1] + inside[2]) / 3.0;
        let along = b - a;
        let mut out = Vec2::new(along.y, -along.x).normalized();
        if out.dot(middle - a.to_vec2()) > 0.0 {
            out = -out;
        }
        let ends = [(from, a), (to, b)].map(|(i, pos)| (pos, mesh.vertices[i as usize].color));
        let bold = out * rim.beyond;
        if rim.beyond > 0.0 {
            band(ends, [Vec2::ZERO, bold], false, mesh);
        }
        band(ends, [bold, bold + out * SOFT * rim.pixel], true, mesh);
    }

    /// The triangle nearest to the eye at a place on the screen, and the shares of its corners.
    pub(super) fn pick(&self, solid: &Solid, place: Pos2) -> Option<(u32, [f32; 3])> {
        let mut best: Option<(f32, u32, [f32; 3])> = None;
        for (number, triangle) in (0..).zip(&solid.triangles) {
            if !self.faces.get(number as usize).copied().unwrap_or(false) {
                continue;
            }
            let corners = triangle.map(|i| self.at[i as usize]);
            let Some(shares) = shares(corners, place) else {
                continue;
            };
            let near_m: f32 = (0..3)
                .map(|k| shares[k] * self.near_m[triangle[k] as usize])
                .sum();
            if best.is_none_or(|(nearest_m, _, _)| near_m > nearest_m) {
                best = Some((near_m, number, shares));
            }
        }
        best.map(|(_, number, shares)| (number, shares))
    }
}

/// What lies beside a line from one way off it to another, in the colours of its ends, which may fade there.
fn band(ends: [(Pos2, Color32); 2], [near, far]: [Vec2; 2], fades: bool, mesh: &mut Mesh) {
    let first = mesh.vertices.len() as u32;
    for (pos, color) in ends {
        let last = if fades { Color32::TRANSPARENT } else { color };
        for (pos, color) in [(pos + near, color), (pos + far, last)] {
            mesh.vertices.push(Vertex {
                pos,
                uv: WHITE_UV,
                color,
            });
        }
    }
    mesh.indices
        .extend([0, 1, 2, 1, 3, 2].map(|i: u32| first + i));
}

/// The shares of a triangle's corners in a place within it.
fn shares([a, b, c]: [Pos2; 3], place: Pos2) -> Option<[f32; 3]> {
    let turn = |p: Pos2, q: Pos2, r: Pos2| (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    let area = turn(a, b, c);
    if area == 0.0 {
        return None;
    }
    let shares = [turn(b, c, place), turn(c, a, place), turn(a, b, place)].map(|x| x / area);
    shares.iter().all(|share| *share >= -1e-4).then_some(shares)
}

/// Colours of all points of a map under a light.
pub(super) fn mapped(solid: &Solid, shade: &Shade, map: &[Color32], lens: &Lens) -> Vec<Color32> {
    (solid.normals.iter().zip(map))
        .map(|(normal, own)| shade.mapped(lens.direction(*normal), *own))
        .collect()
}

/// Colours of all points under a light.
pub(super) fn colours(solid: &Solid, shade: &Shade, out: &[f32], lens: &Lens) -> Vec<Color32> {
    (solid.normals.iter().zip(out))
        .map(|(normal, out)| shade.colour(lens.direction(*normal), *out))
        .collect()
}

/// A line with soft sides.
fn stroke([a, b]: [Pos2; 2], ink: Color32, pixel: f32, mesh: &mut Mesh) {
    let along = (b - a).normalized();
    let side = Vec2::new(along.y, -along.x);
    let first = mesh.vertices.len() as u32;
    // Thick in points, however fine the screen, but soft by pixels.
    let [bold, soft] = [0.6, 0.6 + SOFT * pixel];
    let fade = Color32::TRANSPARENT;
    for (offset, color) in [(-soft, fade), (-bold, ink), (bold, ink), (soft, fade)] {
        for end in [a, b] {
            mesh.vertices.push(Vertex {
                pos: end + side * offset,
                uv: WHITE_UV,
                color,
            });
        }
    }
    for k in [0u32, 2, 4] {
        mesh.indices
            .extend([k, k + 1, k + 2, k + 1, k + 3, k + 2].map(|i| first + i));
    }
}
