//! A small CLAP host: loads a plug-in, sets its parameters, plays events into it.

mod audio;
mod event;
mod handlers;
mod library;
mod param;
mod plugin;
mod port;
mod raw;
mod tuning;

pub use audio::{Audio, Block, Take};
pub use event::{Event, TimedEvent};
pub use library::{Descriptor, Library};
pub use param::{Param, ParamId};
pub use plugin::Plugin;
pub use port::Port;
pub use raw::Raw;

pub use clack_host::events::event_types::NoteExpressionType;
pub use clack_host::process::ProcessStatus;
