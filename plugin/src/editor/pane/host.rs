//! What a window asks of its host.

use baseview::host::{Host, HostCallbacks, HostMainThreadCaller};
use baseview::{HandlerError, WindowSize};
use nice_plug::editor::{
    HostCallbacks as TheirCallbacks, HostMainThreadCaller as TheirCaller, HostMethods,
};
use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::{Arc, Mutex, PoisonError};

/// A host's methods, for each window that is tried until one opens.
pub(in super::super) struct Hosted {
    callbacks: Rc<RefCell<Box<dyn TheirCallbacks>>>,
    caller: Arc<Mutex<Box<dyn TheirCaller>>>,
    /// Whether there is a window; the host need not know of those that were only tried.
    open: Rc<Cell<bool>>,
}

impl Hosted {
    pub(in super::super) fn new(methods: HostMethods) -> Self {
        Self {
            callbacks: Rc::new(RefCell::new(methods.callbacks)),
            caller: Arc::new(Mutex::new(methods.main_thread_caller)),
            open: Rc::default(),
        }
    }

    /// The window has opened.
    pub(in super::super) fn opened(&self) {
        self.open.set(true);
    }

    /// For a window to hold.
    pub(super) fn host(&self) -> Host {
        Host::new()
            .with_callbacks(Callbacks {
                theirs: Rc::clone(&self.callbacks),
                open: Rc::clone(&self.open),
            })
            .with_main_thread(Caller(Arc::clone(&self.caller)))
    }
}

struct Callbacks {
    theirs: Rc<RefCell<Box<dyn TheirCallbacks>>>,
    open: Rc<Cell<bool>>,
}

impl HostCallbacks for Callbacks {
    fn request_resize(&mut self, size: WindowSize) -> Result<(), HandlerError> {
        let Ok(mut theirs) = self.theirs.try_borrow_mut() else {
            return Ok(());
        };
        theirs
            .request_resize(size.physical.into(), size.scale_factor)
            .map_err(HandlerError::from_boxed)
    }

    fn destroyed(&mut self) {
        if self.open.get()
            && let Ok(mut theirs) = self.theirs.try_borrow_mut()
        {
            theirs.destroyed();
        }
    }
}

struct Caller(Arc<Mutex<Box<dyn TheirCaller>>>);

impl HostMainThreadCaller for Caller {
    fn call_main_thread(&mut self) {
        let mut theirs = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        theirs.call_main_thread();
    }
}
