//! Shapes of our own making, as triangles.

mod extrude;
mod objects;
mod round;
mod scenes;
mod vessel;
mod word;

pub use extrude::{cuboid, prism};
pub use objects::{key, star};
pub use round::{cylinder, revolve, sphere, torus};
pub use scenes::{shelf, stack};
pub use vessel::{bell, cup, wok};
pub use word::the_end;
