//! The window: the row of bodies to strike, the partials of the body struck last, and every parameter.
//!
//! [`Ui`] draws and plays without a window; [`Link`] joins it to the audio thread without locks.

mod axis;
mod caption;
mod card;
mod choice;
mod chosen;
mod desk;
mod figure;
mod frame;
mod grid;
mod hands;
mod header;
mod history;
mod hold;
mod icon;
mod keys;
mod knob;
mod link;
mod log;
mod menu;
mod meter;
mod pages;
mod paint_body;
mod param;
mod places;
mod plot;
mod presets;
mod reporter;
mod ringing;
mod row;
mod samples;
mod saved;
mod shown;
mod solid;
mod strip;
mod tabs;
mod theme;
mod trimming;
mod typing;
mod ui;
mod view;
mod why;
mod window;

pub use chosen::Chosen;
pub(crate) use desk::Desk;
pub use figure::{Figure, Kind, lay_out};
pub use frame::{Frame, MOST_MODES};
pub use link::{Link, Touch};
pub use ringing::Ringing;
pub use saved::{LEAST_SIZE, Saved, USUAL_SIZE};
pub use solid::{Drawing, Solid, Vector};
pub use theme::Cause;
pub use ui::Ui;
pub use view::{Paint, Portrait, Swinging};
pub use window::Window;
