//! The window in a host.

use super::link::Link;
use super::saved::{LEAST_SIZE, Saved};
use super::ui::Ui;
use crate::params::Controls;
use egui::ViewportCommand;
use nice_plug::context::gui::GuiContext;
use nice_plug::editor::dpi::{LogicalSize, NativeSize, Size};
use nice_plug::editor::{
    Editor, HostMethods, ParentWindowHandle, ResizeHint, SizeConstraints, SpawnedEditor,
};
use nice_plug_egui::baseview::{HandlerError, WindowSize};
use nice_plug_egui::{
    EguiEditorHandle, EguiEditorState, EguiNiceSettings, NiceEguiApp, RepaintNotifier,
    create_egui_editor,
};
use std::error::Error;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering};

/// Frames within which a host may give a new window the size that it asks for.
const SETTLING: u32 = 30;

/// What is known of an instance's windows.
pub(crate) struct Windows {
    open: AtomicUsize,
    notifier: RepaintNotifier,
    /// Pixels to a point when a window was last seen.
    scale: AtomicU32,
}

impl Default for Windows {
    fn default() -> Self {
        Self {
            open: AtomicUsize::new(0),
            notifier: RepaintNotifier::new(),
            scale: AtomicU32::new(1f32.to_bits()),
        }
    }
}

impl Windows {
    /// Whether there is any.
    pub(crate) fn is_open(&self) -> bool {
        self.open.load(Ordering::Relaxed) != 0
    }

    /// There is something new to draw; for any thread.
    pub(crate) fn repaint(&self) {
        self.notifier.request_repaint();
    }
}

/// Opens windows, each anew: what one remembers beyond [`Saved`] ends with it.
pub struct Window {
    controls: Arc<Controls>,
    saved: Arc<Saved>,
    link: Arc<Link>,
    windows: Arc<Windows>,
}

impl Window {
    pub(super) fn new(
        controls: Arc<Controls>,
        saved: Arc<Saved>,
        link: Arc<Link>,
        windows: Arc<Windows>,
    ) -> Self {
        Self {
            controls,
            saved,
            link,
            windows,
        }
    }

    fn logical(&self) -> Size {
        let [width, height] = self.saved.size().map(f64::from);
        Size::Logical(LogicalSize::new(width, height))
    }
}

fn hint() -> ResizeHint {
    let [width, height] = LEAST_SIZE;
    ResizeHint {
        can_resize: true,
        can_resize_horizontally: true,
        can_resize_vertically: true,
        size_constraints: SizeConstraints::Logical {
            min_size: Some(LogicalSize::new(width, height)),
            max_size: None,
        },
        ..ResizeHint::default()
    }
}

impl Editor for Window {
    type Handle = EguiEditorHandle;

    fn spawn(
        &self,
        parent: Option<ParentWindowHandle>,
        wait_for_parent: bool,
        fallback_scale_factor: Option<f64>,
        gui_context: GuiContext,
        host: Option<HostMethods>,
    ) -> Result<SpawnedEditor<Self::Handle>, Box<dyn Error>> {
        let mut ui = Ui::new(
            Arc::clone(&self.controls),
            Arc::clone(&self.saved),
            Arc::clone(&self.link),
        );
        let windows = Arc::clone(&self.windows);
        ui.instruments().watch(move || windows.repaint());
        let app = App {
            ui,
            saved: Arc::clone(&self.saved),
            wanted: self.saved.size(),
            frames: 0,
            context: None,
            open: Open::new(Arc::clone(&self.windows)),
        };
        create_egui_editor(
            EguiEditorState::from_size(self.logical(), 1.0),
            self.windows.notifier.clone(),
            EguiNiceSettings::new()
                .with_tile("Idiophone")
                .with_resize_hint(hint()),
            app,
        )
        .ok_or("no editor")?
        .spawn(
            parent,
            wait_for_parent,
            fallback_scale_factor,
            gui_context,
            host,
        )
    }

    fn size(&self) -> NativeSize<u32> {
        let scale = f32::from_bits(self.windows.scale.load(Ordering::Relaxed));
        NativeSize::from_size(self.logical(), f64::from(scale))
    }

    fn resize_hint(&self) -> ResizeHint {
        hint()
    }
}

/// Counts a window for as long as it is there.
struct Open(Arc<Windows>);

impl Open {
    fn new(windows: Arc<Windows>) -> Self {
        windows.open.fetch_add(1, Ordering::Relaxed);
        Self(windows)
    }
}

impl Drop for Open {
    fn drop(&mut self) {
        self.0.open.fetch_sub(1, Ordering::Relaxed);
    }
}

/// One window.
struct App {
    ui: Ui,
    saved: Arc<Saved>,
    /// Size in points that the window is to open with.
    wanted: [f32; 2],
    frames: u32,
    context: Option<GuiContext>,
    open: Open,
}

impl NiceEguiApp for App {
    fn build(
        &mut self,
        _egui_ctx: egui::Context,
        context: GuiContext,
        _frame: &mut nice_plug_egui::Frame,
    ) -> Result<(), HandlerError> {
        self.context = Some(context);
        self.ui.undress();
        Ok(())
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut nice_plug_egui::Frame) {
        let Some(context) = &self.context else {
            return;
        };
        self.ui.show(ui, &context.param_setter());
        // Hosts that asked for the size before the screen's scale was known have made the window too
        // small.
        if self.frames < SETTLING {
            self.frames += 1;
            let size = ui.ctx().content_rect().size();
            let [width, height] = self.wanted;
            if self.frames == 2 && (size.x + 1.0 < width || size.y + 1.0 < height) {
                let wanted = ViewportCommand::InnerSize(egui::vec2(width, height));
                ui.ctx().send_viewport_cmd(wanted);
            }
            ui.ctx().request_repaint();
        }
    }

    fn resized(&mut self, size: WindowSize) {
        let scale = size.scale_factor as f32;
        self.open.0.scale.store(scale.to_bits(), Ordering::Relaxed);
        if self.frames >= SETTLING {
            let LogicalSize { width, height } = size.logical;
            self.saved.set_size([width as f32, height as f32]);
        }
    }
}
