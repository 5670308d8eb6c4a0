//! What stands between a CLAP host and the framework, and makes good what the framework does not.
//!
//! nice-plug 0.4.2 trusts the event list of a `process` call: a time beyond the block makes it write
//! outside the host's buffers, one that goes back underflows, a velocity that is no number reaches
//! the sound, a key above 127 stands for all keys, and notes in a block of no frames are lost. It
//! reads beyond the outputs that a host passes if they are fewer than those of the layout, writes to
//! null channels, and panics where a list has no functions. The [`entry`] is therefore ours: the
//! [`plugin`] it makes is the framework's, but sees only [`block`]s that are in order. A list that is
//! in order already passes as it came, any other is mended on a [`Desk`]; outputs that a host leaves
//! out are made up from [`channels`] that nobody hears.
//!
//! [`extensions`] is where an extension goes that the framework lacks. VST3 has no such door, so
//! [`put_right`] cures the rest where events arrive.

mod block;
mod channels;
mod desk;
mod entry;
mod event;
mod extensions;
mod list;
mod mend;
mod note;
mod plugin;
mod source;
mod span;

use desk::Desk;
use event::Event;
use list::List;
use mend::Fate;
pub(crate) use note::put_right;
use source::Source;
use span::Span;
