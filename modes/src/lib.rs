//! From a shape and a material to a bank of vibration modes.
//!
//! A recipe names a shape, a material and the keys to tune; finite elements
//! turn each into natural frequencies and mode shapes; a [`Bank`] carries
//! them to whoever makes them sound.

#[cfg(feature = "solve")]
pub mod analytic;
mod bank;
#[cfg(feature = "solve")]
pub mod bar;
#[cfg(feature = "solve")]
pub mod check;
mod code;
mod damping;
mod equal_temperament;
#[cfg(feature = "solve")]
pub mod factory;
#[cfg(feature = "solve")]
pub mod fem;
mod fnv;
#[cfg(feature = "solve")]
pub mod freeform;
mod hash;
mod label;
mod material;
mod materials;
#[cfg(feature = "solve")]
pub mod mesh;
mod mode_shape;
mod obrien_2002;
#[cfg(feature = "solve")]
pub mod radiation;
#[cfg(feature = "recipe")]
mod recipe;
#[cfg(feature = "solve")]
pub mod revolution;
pub mod shape;
#[cfg(feature = "solve")]
pub mod solid;
#[cfg(feature = "solve")]
pub mod solve;
#[cfg(feature = "solve")]
mod solved;
pub mod sound_map;
mod strike;
#[cfg(feature = "solve")]
pub mod tube;
pub mod tuning;

pub use bank::{
    Bank, BankError, BankFileError, Body, Ears, Enough, Matter, Mode, Provenance, Spread,
    SpreadRule, Surface, SurfaceMotion, Zone,
};
pub use code::CODE;
pub use damping::{Damping, Motion, Rayleigh, t60_s};
pub use equal_temperament::equal_temperament_hz;
pub use hash::fnv1a;
pub use label::{Family, Member, ModeLabel};
pub use material::{Material, MaterialError};
pub use materials::{NAMED_MATERIALS, NamedMaterial, UnknownMaterial};
pub use mode_shape::{ModeShape, Product};
pub use obrien_2002::{Print, TABLE_1, TABLE_2, Table1Row, Table2Row};
#[cfg(feature = "recipe")]
pub use recipe::{
    FreeFineness, FreeRecipe, FreeTuning, ImperfectionRecipe, ImperfectionSize, KeyRange, Knob,
    ListenerRecipe, LossRecipe, MeshOrder, MeshRecipe, MeshScale, MeshShape, Piece, PieceOrder,
    Recipe, RecipeError, RecipeFileError, ResonatorRecipe, ShapeRecipe, TunedMode, TuningRecipe,
    Up, Variation,
};
#[cfg(feature = "solve")]
pub use solve::SolveError;
#[cfg(feature = "solve")]
pub use solved::{SolvedBody, SolvedMode};
pub use strike::{Across, Motions, ShapeTables, Spot, Stencil, StrikeGrid, StrikeLine};
#[cfg(feature = "solve")]
pub use tube::TuneError;
