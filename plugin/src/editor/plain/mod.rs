//! A window that the processor draws, where there is no OpenGL.

mod input;

use super::app::App;
use super::raster::{Pixels, Raster};
use super::saved::LEAST_SIZE;
use super::windows::Windows;
use egui::{Context, FullOutput, ViewportCommand, ViewportId};
use input::Input;
use nice_plug::editor::ParentWindowHandle;
use nice_plug::editor::dpi::{LogicalSize, Size};
use nice_plug_egui::baseview::{
    Error, Event, EventStatus, HandlerError, TimerHandle, Window, WindowContext, WindowHandler,
    WindowSettings, WindowSize,
};
use softbuffer::Surface;
use std::cell::RefCell;
use std::num::NonZeroU32;
use std::sync::Arc;
use std::time::Duration;

/// Least time between two frames: the processor has other things to do.
const FRAME: Duration = Duration::from_millis(66);

/// How a host wants a window.
pub(super) struct Wanted {
    pub(super) parent: Option<ParentWindowHandle>,
    pub(super) wait_for_parent: bool,
    /// Pixels to a point, if the system does not know.
    pub(super) scale: Option<f64>,
    pub(super) size: Size,
}

/// The window.
pub(super) struct Plain {
    window: WindowContext,
    windows: Arc<Windows>,
    timer: TimerHandle,
    inner: RefCell<Inner>,
}

struct Inner {
    app: App,
    context: Context,
    input: Input,
    raster: Raster,
    surface: Surface<WindowContext, WindowContext>,
}

impl Plain {
    /// Opens one.
    pub(super) fn open(wanted: Wanted, app: App, windows: &Arc<Windows>) -> Result<Window, Error> {
        let [width, height] = LEAST_SIZE;
        let settings = WindowSettings::new()
            .with_title("Idiophone")
            .with_size(wanted.size)
            .with_min_size::<Size>(Size::Logical(LogicalSize::new(width.into(), height.into())))
            .with_resizable(true)
            .with_parent(wanted.parent.as_ref())
            .with_wait_for_parent(wanted.wait_for_parent)
            .with_fallback_scale_factor(wanted.scale);
        let windows = Arc::clone(windows);
        Window::create(settings, move |window| Self::new(window, app, windows))
    }

    fn new(
        window: WindowContext,
        mut app: App,
        windows: Arc<Windows>,
    ) -> Result<Self, HandlerError> {
        app.undress();
        let display = softbuffer::Context::new(window.clone())?;
        let surface = Surface::new(&display, window.clone())?;
        Ok(Self {
            timer: window.create_timer(FRAME)?,
            windows,
            inner: RefCell::new(Inner {
                app,
                context: Context::default(),
                input: Input::new(),
                raster: Raster::default(),
                surface,
            }),
            window,
        })
    }

    /// Does what the picture asks of its window.
    fn heed(&self, out: &FullOutput) -> Result<(), HandlerError> {
        let Some(viewport) = out.viewport_output.get(&ViewportId::ROOT) else {
            return Ok(());
        };
        for command in &viewport.commands {
            if let ViewportCommand::InnerSize(size) = command {
                let size = LogicalSize::new(f64::from(size.x), f64::from(size.y));
                self.window.resize(Size::Logical(size))?;
            }
        }
        if viewport.repaint_delay < Duration::MAX {
            self.window
                .request_redraw_after(viewport.repaint_delay.max(FRAME));
        }
        Ok(())
    }
}

impl Inner {
    /// Runs the editor for a frame.
    fn run(&mut self, size: WindowSize) -> FullOutput {
        let input = self.input.take(size);
        let app = &mut self.app;
        self.context.run_ui(input, |ui| app.show(ui))
    }

    /// Draws what it shows.
    fn paint(&mut self, out: &mut FullOutput, size: WindowSize) -> Result<(), HandlerError> {
        self.raster.load(&out.textures_delta);
        let shapes = std::mem::take(&mut out.shapes);
        let primitives = self.context.tessellate(shapes, out.pixels_per_point);
        let (width, height) = (size.physical.width, size.physical.height);
        let pixels = [width as usize, height as usize];
        let picture = self.raster.draw(&primitives, pixels, out.pixels_per_point);
        self.raster.free(&out.textures_delta);
        out.textures_delta.clear();
        let sides = (NonZeroU32::new(width), NonZeroU32::new(height));
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

impl WindowHandler for Plain {
    fn draw(&self) -> Result<(), HandlerError> {
        let size = self.window.size();
        let mut inner = self.inner.borrow_mut();
        let mut out = inner.run(size);
        let painted = inner.paint(&mut out, size);
        drop(inner);
        self.heed(&out)?;
        painted
    }

    fn resized(&self, size: WindowSize) -> Result<(), HandlerError> {
        self.inner.borrow_mut().app.size(size);
        self.window.request_redraw();
        Ok(())
    }

    fn on_event(&self, event: Event) -> EventStatus {
        let mut inner = self.inner.borrow_mut();
        inner.input.take_up(&event, self.window.scale_factor());
        self.window.request_redraw();
        let wanted = match event {
            Event::Mouse(_) => inner.context.egui_wants_pointer_input(),
            Event::Keyboard(_) => inner.context.egui_wants_keyboard_input(),
            _ => true,
        };
        if wanted {
            EventStatus::Captured
        } else {
            EventStatus::Ignored
        }
    }

    fn on_timer(&self, timer: &TimerHandle) {
        if *timer == self.timer && self.windows.news() {
            self.window.request_redraw();
        }
    }
}
