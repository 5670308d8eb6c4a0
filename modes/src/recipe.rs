//! What to build, as a text that people read and edit.

mod check;
mod closed;
mod dimensions;
mod error;
mod free;
#[cfg(test)]
mod free_tests;
#[cfg(test)]
mod kit_tests;
mod knob;
mod material;
mod order;
mod raw;
mod together;
mod vary;

pub use error::{RecipeError, RecipeFileError};
pub use free::{FreeFineness, FreeRecipe, FreeTuning, MeshScale, MeshShape, Piece, TunedMode, Up};
pub use knob::Knob;
pub use order::{MeshOrder, PieceOrder};
pub use vary::Variation;

use crate::shape::{Bowl, ClosedShape};
use crate::{Damping, Material};
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// An instrument to be built. Every number is within its range.
#[derive(Clone, Debug, PartialEq)]
pub struct Recipe {
    /// Name of the instrument, fit for a file.
    pub name: String,
    /// Name of the instrument for people.
    pub title: String,
    /// The keys to build a body for.
    pub keys: KeyRange,
    /// How each body gets its pitch.
    pub tuning: TuningRecipe,
    /// The bodies' shape.
    pub shape: ShapeRecipe,
    /// What the bodies are made of.
    pub material: Material,
    /// Inner damping of the material.
    pub damping: Damping,
    /// What supports and felt take.
    pub losses: LossRecipe,
    /// What splits the pairs of modes of a body of revolution.
    pub imperfection: Option<ImperfectionRecipe>,
    /// The tubes under the bodies, if there are any.
    pub resonator: Option<ResonatorRecipe>,
    /// Where the listener is.
    pub listener: ListenerRecipe,
    /// How finely the bodies are divided.
    pub mesh: MeshRecipe,
    /// The recipe word for word.
    pub text: String,
}

/// MIDI keys from `low` to `high`, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KeyRange {
    /// Lowest key.
    pub low: u8,
    /// Highest key, no less than `low`.
    pub high: u8,
}

/// How bodies get their pitch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TuningRecipe {
    /// Pitch of key 69, in Hz.
    pub a4_hz: f64,
    /// The bending mode that carries the pitch, counted from 1.
    pub partial: u16,
    /// Octaves by which the note that is heard lies below that mode.
    pub octaves_below: u8,
    /// How far a body may be off its key, in cents.
    pub tolerance_cents: f64,
}

/// A shape but for its length, which the pitch decides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShapeRecipe {
    /// A tube, hung from a cord.
    Tube {
        /// Half the outer diameter, in m.
        outer_radius_m: f64,
        /// Thickness of the wall, in m, less than the radius.
        wall_m: f64,
        /// Length of the plug in its upper end, in m; 0 for none.
        plug_m: f64,
        /// Where it hangs, as a share of the length from the top.
        hung_at: f64,
        /// Where the felt touches, as a share of the length from the top.
        felt_at: f64,
    },
    /// A bar hollowed from below, its length and section those of a vibraphone's.
    Bar {
        /// The second and the third bending mode as multiples of the first; a vibraphone's own
        /// without.
        ratios: Option<[f64; 2]>,
        /// Thickness of the stock over a vibraphone's.
        thickness: f64,
        /// Width of the stock over a vibraphone's.
        width: f64,
        /// How far the undercut stretches the ratios, −1 (shallow) to 1 (deep).
        undercut: f64,
    },
    /// A bowl: its proportions, scaled to each pitch.
    Bowl(Bowl),
    /// A thin body of closed form: its proportions, scaled to each pitch.
    Closed(ClosedShape),
}

/// What takes energy out of the bodies where they are touched.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LossRecipe {
    /// Resistance of the supports to motion, in kg/s.
    pub support_kg_s: f64,
    /// Resistance of the damper's felt to motion, in kg/s.
    pub felt_kg_s: f64,
}

/// A quarter-wave tube under each body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResonatorRecipe {
    /// Inner radius, in m.
    pub radius_m: f64,
    /// Thickness of the layer of air that the body takes along over the mouth, in m.
    pub layer_m: f64,
}

/// A small mass on the rim (or the top end).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImperfectionRecipe {
    /// How large it is.
    pub size: ImperfectionSize,
    /// Its angle from the strike line, in degrees.
    pub angle_deg: f64,
}

/// How large an imperfection is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ImperfectionSize {
    /// Its share of the body's mass, the same for all keys.
    MassShare(f64),
    /// Enough to make the lowest pair of modes beat so often a second, in Hz, at all keys.
    BeatHz(f64),
}

/// Where the listener's head is, ears 20 cm apart, before the middle of the row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ListenerRecipe {
    /// Distance of the head from the row, in m.
    pub distance_m: f64,
    /// Height of the head above the bodies' middle, in m.
    pub above_m: f64,
    /// Width of the row from the lowest key's body to the highest's, in m.
    pub row_m: f64,
}

/// How finely bodies are divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshRecipe {
    /// Elements around the axis of the whole mesh, an even number.
    pub around: u16,
    /// Longest element along the axis, in m.
    pub max_element_m: f64,
    /// Highest frequency of the modes, in Hz.
    pub highest_hz: f64,
    /// Of films and plates of closed form, modes that each key has however high they are; without, all
    /// keys have at most 70.
    pub fewest_modes: Option<u16>,
}

impl KeyRange {
    /// The keys, rising.
    pub fn iter(self) -> impl ExactSizeIterator<Item = u8> + DoubleEndedIterator {
        // Inclusive ranges do not know their length.
        (u16::from(self.low)..u16::from(self.high) + 1).map(|key| key as u8)
    }
}

impl Recipe {
    /// The recipes that come with the crate: name and text.
    pub const FACTORY: [(&str, &str); 15] = [
        ("chimes", include_str!("../../recipes/chimes.toml")),
        ("vibraphone", include_str!("../../recipes/vibraphone.toml")),
        (
            "tubular-bells",
            include_str!("../../recipes/tubular-bells.toml"),
        ),
        (
            "singing-bowls",
            include_str!("../../recipes/singing-bowls.toml"),
        ),
        (
            "crystal-bowls",
            include_str!("../../recipes/crystal-bowls.toml"),
        ),
        (
            "metal-bowls",
            include_str!("../../recipes/metal-bowls.toml"),
        ),
        ("oak-bowls", include_str!("../../recipes/oak-bowls.toml")),
        ("strings", include_str!("../../recipes/strings.toml")),
        (
            "clamped-bars",
            include_str!("../../recipes/clamped-bars.toml"),
        ),
        ("free-bars", include_str!("../../recipes/free-bars.toml")),
        ("tines", include_str!("../../recipes/tines.toml")),
        (
            "square-drums",
            include_str!("../../recipes/square-drums.toml"),
        ),
        (
            "round-drums",
            include_str!("../../recipes/round-drums.toml"),
        ),
        (
            "round-plates",
            include_str!("../../recipes/round-plates.toml"),
        ),
        ("l-drums", include_str!("../../recipes/l-drums.toml")),
    ];

    /// The recipe that `text` gives. `file_name` is what errors call it.
    ///
    /// # Errors
    ///
    /// If the text is no TOML, has wrong fields, or a value is out of its range.
    pub fn parse(text: &str, file_name: &str) -> Result<Self, RecipeError> {
        raw::Raw::parse(text)
            .and_then(|raw| raw.check(text))
            .map_err(|fault| fault.into_error(file_name))
    }

    /// The recipe in the file at `path`.
    ///
    /// # Errors
    ///
    /// If the file cannot be read as UTF-8 text or [`Self::parse`] refuses it.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, RecipeFileError> {
        let path = path.as_ref();
        let text = read_text(path).map_err(|error| RecipeFileError::Read {
            path: path.to_path_buf(),
            error,
        })?;
        Ok(Self::parse(&text, &path.display().to_string())?)
    }
}

/// Longest recipe, in bytes: whatever is longer was not written by hand.
const MAX_LEN: u64 = 1 << 20;

fn read_text(path: &Path) -> io::Result<String> {
    let mut text = String::new();
    let mut file = File::open(path)?.take(MAX_LEN + 1);
    file.read_to_string(&mut text)?;
    if file.limit() == 0 {
        let message = "longer than 1 MiB; choose a recipe, a short TOML file";
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, message));
    }
    Ok(text)
}

#[cfg(test)]
mod tests;
