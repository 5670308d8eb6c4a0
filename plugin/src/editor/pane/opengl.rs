//! A canvas that OpenGL paints.

use baseview::dpi::PhysicalSize;
use baseview::gl::GlContext;
use baseview::{Error, HandlerError, WindowContext};
use egui::{ClippedPrimitive, TexturesDelta};
use egui_glow::Painter;
use egui_glow::glow::{self, HasContext as _};
use std::sync::Arc;

/// The canvas.
pub(super) struct OpenGl {
    context: GlContext,
    gl: Arc<glow::Context>,
    painter: Painter,
}

impl OpenGl {
    pub(super) fn new(window: &WindowContext) -> Result<Self, HandlerError> {
        let context = window
            .gl_context()
            .ok_or_else(|| HandlerError::from_boxed("the window has no OpenGL".into()))?;
        let (gl, painter) = within(&context, || {
            // SAFETY: the context is current, and its functions are those of its own loader.
            #[expect(unsafe_code, reason = "functions of a C library")]
            let gl = unsafe {
                glow::Context::from_loader_function_cstr(|name| context.get_proc_address(name))
            };
            let gl = Arc::new(gl);
            let painter = Painter::new(Arc::clone(&gl), "", None, true)?;
            Ok::<_, HandlerError>((gl, painter))
        })??;
        Ok(Self {
            context,
            gl,
            painter,
        })
    }

    /// Most pixels along a side of a texture.
    pub(super) fn most_texture_side(&self) -> usize {
        self.painter.max_texture_side()
    }

    /// Paints a frame.
    pub(super) fn paint(
        &mut self,
        primitives: &[ClippedPrimitive],
        textures: &mut TexturesDelta,
        size: PhysicalSize<u32>,
        pixels_per_point: f32,
    ) -> Result<(), HandlerError> {
        let Self {
            context,
            gl,
            painter,
        } = self;
        within(context, || {
            // SAFETY: the context is current.
            #[expect(unsafe_code, reason = "functions of a C library")]
            unsafe {
                gl.clear_color(0.0, 0.0, 0.0, 1.0);
                gl.clear(glow::COLOR_BUFFER_BIT);
            }
            for (id, deltas) in &textures.set {
                for delta in deltas {
                    painter.set_texture(*id, delta);
                }
            }
            let pixels = [size.width, size.height];
            painter.paint_primitives(pixels, pixels_per_point, primitives);
            for id in &textures.free {
                painter.free_texture(*id);
            }
            textures.clear();
            context.swap_buffers()
        })??;
        Ok(())
    }
}

impl Drop for OpenGl {
    fn drop(&mut self) {
        // What cannot be freed any more has gone with the window.
        let _ = within(&self.context, || self.painter.destroy());
    }
}

/// Does something while a context is current on this thread, and no longer: a host may draw here too.
fn within<T>(context: &GlContext, deed: impl FnOnce() -> T) -> Result<T, Error> {
    // SAFETY: nothing else on this thread has a context current while the window's handler runs.
    #[expect(unsafe_code, reason = "functions of a C library")]
    unsafe {
        context.make_current()?;
    }
    let done = deed();
    // SAFETY: as above.
    #[expect(unsafe_code, reason = "functions of a C library")]
    unsafe {
        context.make_not_current()?;
    }
    Ok(done)
}
