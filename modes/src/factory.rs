//! From a recipe to a bank, all keys at once, and the folder where built banks are kept.

mod build;
mod cache;
mod progress;

pub use build::{BuildError, build};
pub use cache::{Built, CacheError, cached};
pub use progress::{Progress, Silent};
