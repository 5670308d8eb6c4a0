//! From a recipe to a bank, all keys at once, and the folder where built banks are kept.

mod bars;
mod body;
mod bowls;
mod build;
mod builder;
mod cache;
mod closed;
mod progress;
mod sound;

pub(crate) use body::halved;
pub use build::{BuildError, build};
pub use builder::{Builder, Finished, coarse};
pub use cache::{Built, CacheError, cached};
pub use progress::{Progress, Silent};
pub(crate) use sound::{ears_m, sounding};
