//! The window itself: what its system tells goes to the editor, and the editor's frames onto the screen.

mod canvas;
mod clipboard;
mod desktop;
mod files;
mod host;
mod input;
mod keys;
mod opengl;
mod plain;
mod pointer;

pub(super) use canvas::Means;
pub(super) use host::Hosted;

use super::app::App;
use super::saved::LEAST_SIZE;
use super::ware::Ware;
use super::windows::Windows;
use baseview::{
    DropEffect, Error, Event, EventStatus, HandlerError, MouseEvent, TimerHandle, Window,
    WindowContext, WindowHandler, WindowSettings, WindowSize,
};
use canvas::Canvas;
use desktop::Desktop;
use egui::{Context, FullOutput, ViewportCommand, ViewportId};
use input::Input;
use nice_plug::editor::ParentWindowHandle;
use nice_plug::editor::dpi::{LogicalSize, Size};
use std::cell::RefCell;
use std::sync::Arc;
use std::time::Duration;

/// How often is looked for something new to draw, at most.
const NEWS: Duration = Duration::from_millis(15);

/// How a host wants a window.
#[derive(Clone)]
pub(super) struct Wanted {
    pub(super) parent: Option<ParentWindowHandle>,
    pub(super) wait_for_parent: bool,
    /// Pixels to a point, if the system does not know.
    pub(super) scale: Option<f64>,
    pub(super) size: Size,
}

/// The window.
pub(super) struct Pane {
    window: WindowContext,
    windows: Arc<Windows>,
    timer: TimerHandle,
    inner: RefCell<Inner>,
    desktop: RefCell<Desktop>,
}

struct Inner {
    app: App,
    context: Context,
    input: Input,
    canvas: Canvas,
}

impl Pane {
    /// Opens one that is drawn by some means.
    pub(super) fn open(
        wanted: Wanted,
        means: Means,
        app: App,
        windows: &Arc<Windows>,
        host: Option<&Hosted>,
    ) -> Result<Window, Error> {
        let [width, height] = LEAST_SIZE;
        let settings = WindowSettings::new()
            .with_title("Idiophone")
            .with_size(wanted.size)
            .with_min_size::<Size>(Size::Logical(LogicalSize::new(width.into(), height.into())))
            .with_resizable(true)
            .with_parent(wanted.parent.as_ref())
            .with_wait_for_parent(wanted.wait_for_parent)
            .with_fallback_scale_factor(wanted.scale)
            .with_gl_config(means.gl_config());
        let windows = Arc::clone(windows);
        let build = move |window| Self::new(window, means, app, windows);
        Window::create_with_host(settings, build, host.map(Hosted::host))
    }

    fn new(
        window: WindowContext,
        means: Means,
        mut app: App,
        windows: Arc<Windows>,
    ) -> Result<Self, HandlerError> {
        app.undress();
        let canvas = Canvas::new(means, &window)?;
        Ok(Self {
            timer: window.create_timer(NEWS.max(canvas.rest()))?,
            windows,
            inner: RefCell::new(Inner {
                app,
                context: Context::default(),
                input: Input::new(canvas.most_texture_side()),
                canvas,
            }),
            desktop: RefCell::default(),
            window,
        })
    }

    /// Does what the picture asks of its window; `zoom` is how much larger than usual things are drawn, before
    /// this frame and from now on.
    fn heed(&self, out: &FullOutput, zoom: [f64; 2], rest: Duration) {
        let Some(viewport) = out.viewport_output.get(&ViewportId::ROOT) else {
            return;
        };
        let asked = viewport.commands.iter().find_map(|command| match command {
            ViewportCommand::InnerSize(size) => Some(*size),
            _ => None,
        });
        let now = self.window.size().logical;
        let [before, after] = zoom;
        let grown = |width: f64, height: f64, by: f64| LogicalSize::new(width * by, height * by);
        let size = match asked {
            Some(points) => Some(grown(points.x.into(), points.y.into(), after)),
            // What is drawn larger takes a larger window.
            None => (before != after).then(|| grown(now.width, now.height, after / before)),
        };
        if let Some(Err(error)) = size.map(|size| self.window.resize(Size::Logical(size))) {
            nice_plug::nice_warn!("the window keeps its size: {error}");
        }
        if viewport.repaint_delay < Duration::MAX {
            self.window
                .request_redraw_after(viewport.repaint_delay.max(rest));
        }
    }

    /// What the window's system is to know of an event that has been taken up.
    fn status(&self, event: &Event) -> EventStatus {
        let inner = self.inner.borrow();
        let wanted = match event {
            Event::Mouse(
                MouseEvent::DragEntered { .. }
                | MouseEvent::DragMoved { .. }
                | MouseEvent::DragDropped { .. },
            ) => {
                return if inner.input.drags(|path| Ware::of(path).is_some()) {
                    EventStatus::AcceptDrop(DropEffect::Copy)
                } else {
                    EventStatus::Ignored
                };
            }
            Event::Mouse(_) => {
                inner.context.egui_is_using_pointer() || inner.context.egui_wants_pointer_input()
            }
            Event::Keyboard(_) => inner.context.egui_wants_keyboard_input(),
            _ => true,
        };
        if wanted {
            EventStatus::Captured
        } else {
            EventStatus::Ignored
        }
    }
}

impl Inner {
    /// Runs the editor for a frame.
    fn run(&mut self, size: WindowSize) -> FullOutput {
        let input = self.input.take(size, self.context.zoom_factor());
        let app = &mut self.app;
        self.context.run_ui(input, |ui| app.show(ui))
    }
}

impl WindowHandler for Pane {
    fn draw(&self) -> Result<(), HandlerError> {
        let size = self.window.size();
        let mut held = self.inner.borrow_mut();
        let inner = &mut *held;
        let before = inner.context.zoom_factor();
        let mut out = inner.run(size);
        let painted = inner.canvas.paint(&inner.context, &mut out, size.physical);
        let zoom = [before, inner.context.zoom_factor()].map(f64::from);
        let rest = inner.canvas.rest();
        // A window that takes another size tells so at once.
        drop(held);
        let asked = std::mem::take(&mut out.platform_output);
        self.desktop.borrow_mut().serve(asked, &self.window);
        self.heed(&out, zoom, rest);
        painted
    }

    fn resized(&self, size: WindowSize) -> Result<(), HandlerError> {
        self.inner.borrow_mut().app.size(size);
        self.window.request_redraw();
        Ok(())
    }

    fn on_event(&self, event: Event) -> EventStatus {
        // A window in another is not given the keyboard by a click; it comes back here, so nothing is held.
        if matches!(event, Event::Mouse(MouseEvent::ButtonPressed { .. }))
            && !self.window.has_focus()
            && let Err(error) = self.window.focus()
        {
            nice_plug::nice_warn!("the window has no keyboard: {error}");
        }
        let mut inner = self.inner.borrow_mut();
        let scale = self.window.scale_factor() * f64::from(inner.context.zoom_factor());
        let pasted = || self.desktop.borrow_mut().clipboard.get();
        inner.input.take_up(&event, scale, pasted);
        drop(inner);
        self.window.request_redraw();
        self.status(&event)
    }

    fn on_timer(&self, timer: &TimerHandle) {
        if *timer == self.timer && self.windows.news() {
            self.window.request_redraw();
        }
    }
}
