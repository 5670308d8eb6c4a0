//! What of the editor is kept in the state: the window's size and its theme.

use nice_plug::params::persist::PersistentField;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

/// Size of a new window, and the least, in logical points.
pub const USUAL_SIZE: [f32; 2] = [1000.0, 680.0];
/// See [`USUAL_SIZE`].
pub const LEAST_SIZE: [f32; 2] = [640.0, 400.0];
/// 4K, with room.
const MOST: f32 = 8192.0;

/// Window and theme of an instance; hosts read and write it from any thread.
pub struct Saved {
    width: AtomicU32,
    height: AtomicU32,
    bright: AtomicBool,
}

impl Default for Saved {
    fn default() -> Self {
        let [width, height] = USUAL_SIZE.map(|side| AtomicU32::new(side.to_bits()));
        Self {
            width,
            height,
            bright: AtomicBool::new(false),
        }
    }
}

/// As it is written: width and height in logical points, and whether the window is dark.
type Words = (f32, f32, bool);

impl Saved {
    /// Size of the window in logical points.
    #[must_use]
    pub fn size(&self) -> [f32; 2] {
        [&self.width, &self.height].map(|side| f32::from_bits(side.load(Ordering::Relaxed)))
    }

    /// The window has another size; what no window can have becomes what it can.
    pub fn set_size(&self, size: [f32; 2]) {
        let sides = [&self.width, &self.height];
        for ((side, new), least) in sides.into_iter().zip(size).zip(LEAST_SIZE) {
            // `max` and `min` rather than `clamp`, because they turn NaN into the least.
            side.store(new.max(least).min(MOST).to_bits(), Ordering::Relaxed);
        }
    }

    /// Whether the window is dark.
    #[must_use]
    pub fn dark(&self) -> bool {
        !self.bright.load(Ordering::Relaxed)
    }

    /// Makes the window dark, or light.
    pub fn set_dark(&self, dark: bool) {
        self.bright.store(!dark, Ordering::Relaxed);
    }
}

/// [`Saved`] as a field of the state.
pub(super) struct SavedField(pub(super) Arc<Saved>);

impl PersistentField<'_, Words> for SavedField {
    fn set(&self, (width, height, dark): Words) {
        self.0.set_size([width, height]);
        self.0.set_dark(dark);
    }

    fn map<F, R>(&self, f: F) -> R
    where
        F: Fn(&Words) -> R,
    {
        let [width, height] = self.0.size();
        f(&(width, height, self.0.dark()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_state_makes_a_window_that_cannot_be() {
        let field = SavedField(Arc::default());
        field.set((f32::NAN, 1e9, false));
        assert_eq!(field.0.size(), [LEAST_SIZE[0], MOST]);
        assert!(!field.0.dark());
        field.set((900.0, 500.0, true));
        assert_eq!(field.map(|words| *words), (900.0, 500.0, true));
    }
}
