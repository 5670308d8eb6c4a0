//! A canvas that the processor paints, where there is no OpenGL.

use super::super::raster::{Pixels, Raster};
use baseview::dpi::PhysicalSize;
use baseview::{HandlerError, WindowContext};
use egui::{ClippedPrimitive, TexturesDelta};
use softbuffer::Surface;
use std::num::NonZeroU32;

/// The canvas.
pub(super) struct Plain {
    raster: Raster,
    surface: Surface<WindowContext, WindowContext>,
}

impl Plain {
    pub(super) fn new(window: &WindowContext) -> Result<Self, HandlerError> {
        let display = softbuffer::Context::new(window.clone())?;
        Ok(Self {
            raster: Raster::default(),
            surface: Surface::new(&display, window.clone())?,
        })
    }

    /// Paints a frame.
    pub(super) fn paint(
        &mut self,
        primitives: &[ClippedPrimitive],
        textures: &mut TexturesDelta,
        size: PhysicalSize<u32>,
        pixels_per_point: f32,
    ) -> Result<(), HandlerError> {
        self.raster.load(textures);
        let pixels = [size.width as usize, size.height as usize];
        let picture = self.raster.draw(primitives, pixels, pixels_per_point);
        self.raster.free(textures);
        textures.clear();
        let sides = (NonZeroU32::new(size.width), NonZeroU32::new(size.height));
        let (Some(width), Some(height)) = sides else {
            return Ok(());
        };
        self.surface.resize(width, height)?;
        let mut buffer = self.surface.buffer_mut()?;
        fill(&mut buffer, &picture);
        buffer.present()?;
        Ok(())
    }
}

/// Writes a picture as screens want it.
fn fill(buffer: &mut [u32], picture: &Pixels) {
    for (pixel, [red, green, blue, _]) in buffer.iter_mut().zip(&picture.rgba) {
        // A screen that knows of transparency is to know of none here.
        *pixel = u32::from_be_bytes([u8::MAX, *red, *green, *blue]);
    }
}
