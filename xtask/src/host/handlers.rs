//! What the host answers when the plug-in calls back.

use clack_extensions::latency::{HostLatency, HostLatencyImpl};
use clack_extensions::log::{HostLog, HostLogImpl, LogSeverity};
use clack_extensions::params::{
    HostParams, HostParamsImplMainThread, HostParamsImplShared, ParamClearFlags, ParamRescanFlags,
};
use clack_extensions::state::{HostState, HostStateImpl};
use clack_extensions::thread_check::{HostThreadCheck, HostThreadCheckImpl};
use clack_host::prelude::*;
use clack_host::utils::ClapId;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, ThreadId};

/// The kind of host this is.
pub(super) struct Handlers;

/// What the plug-in may call from any thread.
pub(super) struct Shared {
    main: ThreadId,
    callback: AtomicBool,
    log: Mutex<Vec<String>>,
}

/// What the plug-in may call from the main thread.
pub(super) struct MainThread;

impl Shared {
    /// A host whose main thread is the caller's.
    pub(super) fn new() -> Self {
        Self {
            main: thread::current().id(),
            callback: AtomicBool::new(false),
            log: Mutex::default(),
        }
    }

    /// Whether the plug-in asked to be called on the main thread since last asked.
    pub(super) fn take_callback(&self) -> bool {
        self.callback.swap(false, Ordering::SeqCst)
    }

    /// Warnings and errors that the plug-in has logged.
    pub(super) fn log(&self) -> Vec<String> {
        self.log
            .lock()
            .map(|lines| lines.clone())
            .unwrap_or_default()
    }
}

impl HostHandlers for Handlers {
    type Shared<'a> = Shared;
    type MainThread<'a> = MainThread;
    type AudioProcessor<'a> = ();

    fn declare_extensions(builder: &mut HostExtensions<Self>, _: &Self::Shared<'_>) {
        builder
            .register::<HostLatency>()
            .register::<HostLog>()
            .register::<HostParams>()
            .register::<HostState>()
            .register::<HostThreadCheck>();
    }
}

impl SharedHandler<'_> for Shared {
    fn request_restart(&self) {}
    fn request_process(&self) {}
    fn request_callback(&self) {
        self.callback.store(true, Ordering::SeqCst);
    }
}

impl MainThreadHandler<'_> for MainThread {}

impl HostThreadCheckImpl for Shared {
    fn is_main_thread(&self) -> bool {
        thread::current().id() == self.main
    }
    fn is_audio_thread(&self) -> bool {
        !self.is_main_thread()
    }
}

impl HostLogImpl for Shared {
    fn log(&self, severity: LogSeverity, message: &str) {
        if matches!(severity, LogSeverity::Debug | LogSeverity::Info) {
            return;
        }
        if let Ok(mut lines) = self.log.lock() {
            lines.push(format!("{severity}: {message}"));
        }
    }
}

impl HostParamsImplShared for Shared {
    fn request_flush(&self) {}
}

impl HostParamsImplMainThread for MainThread {
    fn rescan(&self, _: ParamRescanFlags) {}
    fn clear(&self, _: ClapId, _: ParamClearFlags) {}
}

impl HostStateImpl for MainThread {
    fn mark_dirty(&self) {}
}

impl HostLatencyImpl for MainThread {
    fn changed(&self) {}
}
