//! What of the editor is kept in the state: the window's size, its theme, whether the body carries its map, and
//! which preset was chosen.

use super::chosen::Chosen;
use super::history::Past;
use nice_plug::params::persist::PersistentField;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

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
    map: AtomicBool,
    chosen: Mutex<Chosen>,
    /// While no window is open: what can be undone in the next. No part of the state.
    past: Mutex<Past>,
}

impl Default for Saved {
    fn default() -> Self {
        let [width, height] = USUAL_SIZE.map(|side| AtomicU32::new(side.to_bits()));
        Self {
            width,
            height,
            bright: AtomicBool::new(false),
            map: AtomicBool::new(false),
            chosen: Mutex::default(),
            past: Mutex::default(),
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

    /// Whether the map of timbre lies on the body.
    #[must_use]
    pub fn map(&self) -> bool {
        self.map.load(Ordering::Relaxed)
    }

    /// Lays the map of timbre on the body, or takes it off.
    pub fn set_map(&self, map: bool) {
        self.map.store(map, Ordering::Relaxed);
    }

    /// The preset that was chosen last.
    #[must_use]
    pub fn chosen(&self) -> Chosen {
        let chosen = self.chosen.lock();
        chosen.unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Another preset is chosen, or it is changed.
    pub fn choose(&self, chosen: Chosen) {
        *self.chosen.lock().unwrap_or_else(PoisonError::into_inner) = chosen;
    }

    /// Takes what can be undone, or leaves it for the next window.
    pub(super) fn past(&self) -> std::sync::MutexGuard<'_, Past> {
        self.past.lock().unwrap_or_else(PoisonError::into_inner)
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

/// Whether the body carries its map, as a field of the state.
pub(super) struct MapField(pub(super) Arc<Saved>);

impl PersistentField<'_, bool> for MapField {
    fn set(&self, map: bool) {
        self.0.set_map(map);
    }

    fn map<F, R>(&self, f: F) -> R
    where
        F: Fn(&bool) -> R,
    {
        f(&self.0.map())
    }
}

/// The chosen preset as it is written: its key, whether it is changed, and whether it brought the tuning.
type ChosenWords = (String, bool, bool);

/// The chosen preset as a field of the state.
pub(super) struct ChosenField(pub(super) Arc<Saved>);

impl PersistentField<'_, ChosenWords> for ChosenField {
    fn set(&self, (key, changed, tuned): ChosenWords) {
        self.0.choose(Chosen {
            key,
            changed,
            tuned,
        });
    }

    fn map<F, R>(&self, f: F) -> R
    where
        F: Fn(&ChosenWords) -> R,
    {
        let Chosen {
            key,
            changed,
            tuned,
        } = self.0.chosen();
        f(&(key, changed, tuned))
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

    #[test]
    fn the_map_stays_on_the_body() {
        let (old, new) = (MapField(Arc::default()), MapField(Arc::default()));
        assert!(!old.0.map());
        old.0.set_map(true);
        new.set(old.map(|map| *map));
        assert!(new.0.map());
    }

    #[test]
    fn the_chosen_preset_is_kept() {
        let (old, new) = (ChosenField(Arc::default()), ChosenField(Arc::default()));
        old.0.choose(Chosen {
            key: "user/A.toml".to_owned(),
            changed: true,
            tuned: false,
        });
        new.set(old.map(Clone::clone));
        assert_eq!(new.0.chosen(), old.0.chosen());
    }
}
