//! The window: the row of bodies to strike, the partials of the body struck last, and every parameter.
//!
//! [`Ui`] draws and plays without a window; [`Link`] joins it to the audio thread without locks.

mod axis;
mod card;
mod choice;
mod desk;
mod figure;
mod frame;
mod grid;
mod hands;
mod header;
mod hold;
mod instruments;
mod keys;
mod knob;
mod link;
mod meter;
mod notice;
mod pages;
mod paint_body;
mod param;
mod plot;
mod reporter;
mod ringing;
mod row;
mod saved;
mod shown;
mod strip;
mod theme;
mod typing;
mod ui;
mod window;

pub(crate) use desk::Desk;
pub use figure::{Figure, Kind, lay_out};
pub use frame::{Frame, MOST_MODES};
pub use instruments::Instruments;
pub use link::{Link, Touch};
pub use ringing::Ringing;
pub use saved::{LEAST_SIZE, Saved, USUAL_SIZE};
pub use theme::Cause;
pub use ui::Ui;
pub use window::Window;
