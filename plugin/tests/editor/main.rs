//! The editor without a window: what hands do to it, what it tells the audio thread and the host, and
//! how it looks.

#![expect(clippy::unwrap_used, reason = "tests fail by panicking")]
#![expect(clippy::cast_sign_loss, reason = "pixels and frames are not negative")]

mod bench;
mod bodies;
mod body;
mod browsing;
mod doors;
mod drawn;
mod focus;
mod host;
mod knobs;
mod looks;
mod map;
mod menus;
mod mesh;
mod own;
mod palette;
mod partials;
mod picture;
mod portraits;
mod presets;
mod shelves;
