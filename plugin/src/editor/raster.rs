//! egui's triangles to pixels, without a graphics card.

use egui::epaint::{ImageData, Primitive, Vertex};
use egui::{ClippedPrimitive, TextureId, TexturesDelta};
use std::collections::HashMap;

/// Pixels from the top left, premultiplied.
#[derive(Clone, Debug, PartialEq)]
pub struct Pixels {
    /// Pixels to a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Red, green, blue and how much they cover, row by row.
    pub rgba: Vec<[u8; 4]>,
}

/// The textures that egui has handed over.
#[derive(Default)]
pub struct Raster {
    textures: HashMap<TextureId, Pixels>,
}

impl Raster {
    /// Takes up new textures and patches.
    pub fn load(&mut self, deltas: &TexturesDelta) {
        for (id, deltas) in &deltas.set {
            for delta in deltas {
                let ImageData::Color(image) = &delta.image;
                let [width, height] = image.size;
                let rgba = image.pixels.iter().map(egui::Color32::to_array);
                let Some([x, y]) = delta.pos else {
                    let rgba = rgba.collect();
                    self.textures.insert(
                        *id,
                        Pixels {
                            width,
                            height,
                            rgba,
                        },
                    );
                    continue;
                };
                let Some(whole) = self.textures.get_mut(id) else {
                    continue;
                };
                for (i, pixel) in rgba.enumerate() {
                    let at = (y + i / width) * whole.width + x + i % width;
                    whole.rgba[at] = pixel;
                }
            }
        }
    }

    /// Forgets textures that egui needs no more.
    pub fn free(&mut self, deltas: &TexturesDelta) {
        for id in &deltas.free {
            self.textures.remove(id);
        }
    }

    /// Draws primitives on black, `size` pixels wide and high.
    #[must_use]
    pub fn draw(
        &self,
        primitives: &[ClippedPrimitive],
        size: [usize; 2],
        pixels_per_point: f32,
    ) -> Pixels {
        let [width, height] = size;
        let mut out = vec![[0.0, 0.0, 0.0, 255.0]; width * height];
        for ClippedPrimitive {
            clip_rect,
            primitive,
        } in primitives
        {
            let Primitive::Mesh(mesh) = primitive else {
                continue;
            };
            let Some(texture) = self.textures.get(&mesh.texture_id) else {
                continue;
            };
            let clip = *clip_rect * pixels_per_point;
            let low = [clip.min.x.round().max(0.0), clip.min.y.round().max(0.0)];
            let high = [
                clip.max.x.round().min(width as f32),
                clip.max.y.round().min(height as f32),
            ];
            for corners in mesh.indices.chunks_exact(3) {
                let corners = [0, 1, 2].map(|k| mesh.vertices[corners[k] as usize]);
                triangle(
                    &mut out,
                    width,
                    corners,
                    pixels_per_point,
                    [low, high],
                    texture,
                );
            }
        }
        let rgba = out.iter().map(|pixel| pixel.map(byte));
        Pixels {
            width,
            height,
            rgba: rgba.collect(),
        }
    }
}

/// The number of a pixel that begins there; the first for what lies before it.
fn pixel(at: f32) -> usize {
    #[expect(clippy::cast_sign_loss, reason = "what is below 0 saturates")]
    let pixel = at as usize;
    pixel
}

/// A colour as it is shown.
fn byte(colour: f32) -> u8 {
    #[expect(clippy::cast_sign_loss, reason = "what is below 0 saturates")]
    let byte = colour.round() as u8;
    byte
}

fn triangle(
    out: &mut [[f32; 4]],
    width: usize,
    corners: [Vertex; 3],
    scale: f32,
    [low, high]: [[f32; 2]; 2],
    texture: &Pixels,
) {
    let at = corners.map(|corner| [corner.pos.x * scale, corner.pos.y * scale]);
    let cross = |a: [f32; 2], b: [f32; 2], c: [f32; 2]| {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    };
    let area = cross(at[0], at[1], at[2]);
    if area == 0.0 {
        return;
    }
    let range = |k: usize| {
        let values = at.map(|point| point[k]);
        let least = values.iter().fold(f32::MAX, |a, b| a.min(*b)).floor();
        let most = values.iter().fold(f32::MIN, |a, b| a.max(*b)).ceil();
        pixel(least.max(low[k]))..pixel(most.min(high[k]))
    };
    // On an edge between two triangles a pixel belongs to the one whose edge goes down or left.
    let owns = |a: [f32; 2], b: [f32; 2]| {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let (dx, dy) = if area > 0.0 { (dx, dy) } else { (-dx, -dy) };
        dy > 0.0 || (dy == 0.0 && dx < 0.0)
    };
    for y in range(1) {
        for x in range(0) {
            let centre = [x as f32 + 0.5, y as f32 + 0.5];
            let mut weights = [0.0; 3];
            let inside = (0..3).all(|k| {
                let (a, b) = (at[(k + 1) % 3], at[(k + 2) % 3]);
                let weight = cross(a, b, centre) / area;
                weights[k] = weight;
                weight > 0.0 || (weight == 0.0 && owns(a, b))
            });
            if !inside {
                continue;
            }
            let mix = |value: fn(&Vertex) -> f32| {
                (0..3).map(|k| weights[k] * value(&corners[k])).sum::<f32>()
            };
            let texel = sample(texture, mix(|v| v.uv.x), mix(|v| v.uv.y));
            let colour = [
                mix(|v| f32::from(v.color.r())),
                mix(|v| f32::from(v.color.g())),
                mix(|v| f32::from(v.color.b())),
                mix(|v| f32::from(v.color.a())),
            ];
            let pixel = &mut out[y * width + x];
            let alpha = colour[3] * texel[3] / 255.0;
            for k in 0..4 {
                pixel[k] = colour[k] * texel[k] / 255.0 + pixel[k] * (1.0 - alpha / 255.0);
            }
        }
    }
}

/// The texture at a place 0…1, between its texels.
fn sample(texture: &Pixels, u: f32, v: f32) -> [f32; 4] {
    let axis = |share: f32, size: usize| {
        let at = (share * size as f32 - 0.5).clamp(0.0, size as f32 - 1.0);
        let first = at.floor();
        (pixel(first), (pixel(first) + 1).min(size - 1), at - first)
    };
    let (x0, x1, fx) = axis(u, texture.width);
    let (y0, y1, fy) = axis(v, texture.height);
    let get = |x: usize, y: usize| texture.rgba[y * texture.width + x].map(f32::from);
    let corners = [get(x0, y0), get(x1, y0), get(x0, y1), get(x1, y1)];
    std::array::from_fn(|k| {
        let [a, b, c, d] = corners.map(|corner| corner[k]);
        let (top, bottom) = (a + (b - a) * fx, c + (d - c) * fx);
        top + (bottom - top) * fy
    })
}
