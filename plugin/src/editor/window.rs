//! The window in a host.

use super::app::App;
use super::handle::Handle;
use super::link::Link;
use super::pane::{Hosted, Means, Pane, Wanted};
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
        let wanted = Wanted {
            parent,
            wait_for_parent,
            scale: fallback_scale_factor,
            size: self.logical(),
        };
        let host = host.map(Hosted::new);
        let open = |means| {
            let app = self.app(gui_context.clone());
            Pane::open(wanted.clone(), means, app, &self.windows, host.as_ref())
        };
        let opengl = open(Means::OpenGl);
        self.tell(opengl.is_ok());
        let window = match opengl {
            Ok(window) => window,
            Err(error) => {
                nice_plug::nice_warn!("{NO_OPENGL} ({error})");
                open(Means::Processor)?
            }
        };
        if let Some(host) = &host {
            host.opened();
        }
        // Hosts ask for the size next; where the system tells no scale the window goes by theirs.
        let system = window.size().scale_factor;
        let told = fallback_scale_factor.filter(|_| system == 1.0);
        self.windows.see(told.unwrap_or(system));
        Ok(SpawnedEditor {
            handle: Handle::new(&self.windows, hint()),
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
