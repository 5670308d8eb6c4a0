//! Presets in the window: the bar at the top, the browser, undoing and comparing.

mod bar;
mod browser;
mod button;
mod card;
mod form;
mod hearing;
mod keeping;
mod list;
mod session;
mod shelves;
mod steps;
mod tools;

pub(super) use bar::bar;
pub(super) use browser::Browser;
pub(super) use session::Session;
pub(super) use tools::tools;
