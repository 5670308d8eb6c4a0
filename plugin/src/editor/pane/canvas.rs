//! What frames are painted on.

use super::opengl::OpenGl;
use super::plain::Plain;
use baseview::dpi::PhysicalSize;
use baseview::gl::GlConfig;
use baseview::{HandlerError, WindowContext};
use egui::{Context, FullOutput};
use std::time::Duration;

/// Who draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in super::super) enum Means {
    /// The graphics card, or what stands in for one.
    OpenGl,
    /// The processor, without any help.
    Processor,
}

impl Means {
    /// What a window needs for it.
    pub(super) fn gl_config(self) -> Option<GlConfig> {
        (self == Self::OpenGl).then(GlConfig::default)
    }
}

/// A window's surface and its painter.
pub(super) enum Canvas {
    OpenGl(Box<OpenGl>),
    Plain(Box<Plain>),
}

impl Canvas {
    pub(super) fn new(means: Means, window: &WindowContext) -> Result<Self, HandlerError> {
        Ok(match means {
            Means::OpenGl => Self::OpenGl(Box::new(OpenGl::new(window)?)),
            Means::Processor => Self::Plain(Box::new(Plain::new(window)?)),
        })
    }

    /// Paints a frame, and lets go of what it needs no more.
    pub(super) fn paint(
        &mut self,
        context: &Context,
        out: &mut FullOutput,
        size: PhysicalSize<u32>,
    ) -> Result<(), HandlerError> {
        let shapes = std::mem::take(&mut out.shapes);
        let primitives = context.tessellate(shapes, out.pixels_per_point);
        let textures = &mut out.textures_delta;
        match self {
            Self::OpenGl(canvas) => canvas.paint(&primitives, textures, size, out.pixels_per_point),
            Self::Plain(canvas) => canvas.paint(&primitives, textures, size, out.pixels_per_point),
        }
    }

    /// Time between a frame and the next that it asks for.
    pub(super) fn rest(&self) -> Duration {
        match self {
            // The screen sets the pace.
            Self::OpenGl(_) => Duration::ZERO,
            // The processor has other things to do.
            Self::Plain(_) => Duration::from_millis(66),
        }
    }

    /// Most pixels along a side of a texture, if there is a bound.
    pub(super) fn most_texture_side(&self) -> Option<usize> {
        match self {
            Self::OpenGl(canvas) => Some(canvas.most_texture_side()),
            Self::Plain(_) => None,
        }
    }
}
