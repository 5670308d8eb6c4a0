//! Everything a host can automate, subject by subject.

pub mod assign;
pub mod body;
pub mod bow;
mod build;
mod choice;
mod controls;
pub mod damping;
pub mod hands;
pub mod listener;
pub mod mallet;
mod mallets;
pub mod motor;
pub mod output;
mod poly;
pub mod shape;
mod spec;
mod state;
pub mod strike;
mod text;
mod trims;

pub use controls::Controls;
pub use spec::{GROUPS, Group, Spec, specs};
pub use state::heal;
pub(crate) use text::Text;
pub use trims::{TrimField, TrimTable};
