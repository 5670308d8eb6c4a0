//! Sounds as small readable files: the factory's, and those that a user keeps.

mod audition;
mod broken;
mod card;
mod entry;
mod factory;
mod favourites;
mod files;
mod folder;
mod library;
mod line;
mod preset;
mod read;
mod search;
mod sound;
mod write;

pub use audition::{Note, audition};
pub use broken::Broken;
pub use card::Card;
pub use entry::{Entry, Origin};
pub use factory::factory;
pub use folder::Folder;
pub use library::Library;
pub use preset::{FORMAT, Notice, Preset};
pub use search::{Kind, Search};
pub use sound::{Scala, Sound};
