//! What is in a window, whatever draws it.

use super::saved::Saved;
use super::ui::Ui;
use super::windows::{Open, Windows};
use baseview::WindowSize;
use egui::{Vec2, ViewportCommand, vec2};
use nice_plug::context::gui::GuiContext;
use std::sync::Arc;

/// Frames within which a host may give a new window the size that it asks for.
const SETTLING: u32 = 30;

/// One window.
pub(super) struct App {
    ui: Ui,
    saved: Arc<Saved>,
    /// Size in points that the window is to open with.
    wanted: [f32; 2],
    frames: u32,
    context: GuiContext,
    open: Open,
}

impl App {
    pub(super) fn new(
        ui: Ui,
        saved: Arc<Saved>,
        windows: &Arc<Windows>,
        context: GuiContext,
    ) -> Self {
        Self {
            ui,
            wanted: saved.size(),
            saved,
            frames: 0,
            context,
            open: Open::new(Arc::clone(windows)),
        }
    }

    /// Begins anew with an egui that knows nothing yet.
    pub(super) fn undress(&mut self) {
        self.ui.undress();
    }

    /// Draws a frame.
    pub(super) fn show(&mut self, ui: &mut egui::Ui) {
        self.ui.show(ui, &self.context.param_setter());
        // Hosts that asked for the size before the screen's scale was known have made the window too
        // small.
        if self.frames < SETTLING {
            self.frames += 1;
            let size = ui.ctx().content_rect().size();
            let wanted = Vec2::from(self.wanted);
            let small = (size + vec2(1.0, 1.0)).min(wanted) != wanted;
            if self.frames == 2 && small {
                ui.ctx()
                    .send_viewport_cmd(ViewportCommand::InnerSize(wanted));
            }
            ui.ctx().request_repaint();
        }
    }

    /// The window has another size.
    pub(super) fn size(&mut self, size: WindowSize) {
        self.open.see(size.scale_factor);
        if self.frames >= SETTLING {
            let logical = size.logical;
            self.saved
                .set_size([logical.width as f32, logical.height as f32]);
        }
    }
}
