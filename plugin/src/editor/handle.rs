//! What a host does with a window.

use super::windows::Windows;
use baseview::Error;
use nice_plug::editor::dpi::NativeSize;
use nice_plug::editor::{EditorHandle, ParentWindowHandle, ResizeHint};
use std::sync::Arc;

/// A window that OpenGL draws, or the processor.
pub struct Handle {
    windows: Arc<Windows>,
    hint: ResizeHint,
}

impl Handle {
    pub(super) fn new(windows: &Arc<Windows>, hint: ResizeHint) -> Self {
        Self {
            windows: Arc::clone(windows),
            hint,
        }
    }
}

impl EditorHandle for Handle {
    type Window = baseview::Window;
    type Error = Error;

    fn run_until_closed(window: Self::Window) -> Result<(), Error> {
        window.run_until_closed()
    }

    fn set_parent(&self, parent: ParentWindowHandle, window: &Self::Window) -> Result<(), Error> {
        window.set_parent(&parent)
    }

    fn show(&self, window: &Self::Window) -> Result<(), Error> {
        let shown = window.show();
        self.windows.repaint();
        shown
    }

    fn hide(&self, window: &Self::Window) -> Result<(), Error> {
        window.hide()
    }

    fn set_size(&self, size: NativeSize<u32>, window: &Self::Window) -> Result<(), Error> {
        window.resize(size)
    }

    fn host_main_thread_callback(&self, window: &Self::Window) {
        window.host_main_thread_callback();
    }

    fn adjust_size(&self, size: NativeSize<u32>, window: &Self::Window) -> Option<NativeSize<u32>> {
        let now = window.size();
        let native = NativeSize::from_logical_or_physical(now.logical, now.physical);
        Some(self.hint.adjust_size(size, native, now.scale_factor))
    }

    fn set_fallback_scale_factor(&self, scale: f64, window: &Self::Window) -> Result<(), Error> {
        window.suggest_fallback_scale_factor(scale)
    }

    fn state_changed(&self) {
        self.windows.repaint();
    }

    fn param_value_changed(&self, _id: &str, _value: f32) {
        self.windows.repaint();
    }

    fn param_modulation_changed(&self, _id: &str, _offset: f32) {
        self.windows.repaint();
    }
}
