//! The window in a host.

use super::app::App;
use super::handle::Handle;
use super::link::Link;
use super::plain::{Plain, Wanted};
use super::saved::{LEAST_SIZE, Saved};
use super::ui::Ui;
use super::windows::Windows;
use crate::notices::{Notice, Subject};
use crate::params::Controls;
use nice_plug::context::gui::GuiContext;
use nice_plug::editor::dpi::{LogicalSize, NativeSize, Size};
use nice_plug::editor::{
    Editor, HostMethods, ParentWindowHandle, ResizeHint, SizeConstraints, SpawnedEditor,
};
use nice_plug_egui::{EguiEditorState, EguiNiceSettings, create_egui_editor};
use std::error::Error;
use std::sync::Arc;

/// What a window without OpenGL says, and what brings it.
const NO_OPENGL: &str = if cfg!(target_os = "linux") {
    "There is no OpenGL, so that this window is drawn slowly; libegl1 and libgl1-mesa-dri bring it."
} else {
    "There is no OpenGL, so that this window is drawn slowly; the graphics card's driver brings it."
};

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

    fn app(&self, context: GuiContext) -> App {
        let mut ui = Ui::new(
            Arc::clone(&self.controls),
            Arc::clone(&self.saved),
            Arc::clone(&self.link),
        );
        let windows = Arc::clone(&self.windows);
        ui.instruments().watch(move || windows.repaint());
        App::new(ui, Arc::clone(&self.saved), &self.windows, context)
    }

    /// What is to be known of a window without OpenGL.
    fn tell(&self, opengl: bool) {
        let notices = self.controls.notices();
        notices.clear(Subject::Window);
        if !opengl {
            notices.post(Notice {
                subject: Subject::Window,
                text: NO_OPENGL.to_owned(),
                cure: None,
            });
        }
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
    type Handle = Handle;

    fn spawn(
        &self,
        parent: Option<ParentWindowHandle>,
        wait_for_parent: bool,
        fallback_scale_factor: Option<f64>,
        gui_context: GuiContext,
        host: Option<HostMethods>,
    ) -> Result<SpawnedEditor<Self::Handle>, Box<dyn Error>> {
        let opengl = create_egui_editor(
            EguiEditorState::from_size(self.logical(), 1.0),
            self.windows.notifier(),
            EguiNiceSettings::new()
                .with_tile("Idiophone")
                .with_resize_hint(hint()),
            self.app(gui_context.clone()),
        )
        .ok_or("no editor")?
        .spawn(
            parent,
            wait_for_parent,
            fallback_scale_factor,
            gui_context.clone(),
            host,
        );
        self.tell(opengl.is_ok());
        let (handle, window) = match opengl {
            Ok(editor) => (Some(editor.handle), editor.window),
            Err(error) => {
                nice_plug::nice_warn!("{NO_OPENGL} ({error})");
                let wanted = Wanted {
                    parent,
                    wait_for_parent,
                    scale: fallback_scale_factor,
                    size: self.logical(),
                };
                let app = self.app(gui_context);
                (None, Plain::open(wanted, app, &self.windows)?)
            }
        };
        // Hosts ask for the size next; where the system tells no scale the window goes by theirs.
        let system = window.size().scale_factor;
        let host = fallback_scale_factor.filter(|_| system == 1.0);
        self.windows.see(host.unwrap_or(system));
        Ok(SpawnedEditor {
            handle: Handle::new(&self.windows, hint(), handle),
            window,
        })
    }

    fn size(&self) -> NativeSize<u32> {
        NativeSize::from_size(self.logical(), self.windows.scale())
    }

    fn resize_hint(&self) -> ResizeHint {
        hint()
    }
}
