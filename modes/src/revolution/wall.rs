//! A meridian with what the outside world sees of it.

use crate::Family;
use crate::fem::Meridian;

/// Layers of cells through a wall: one is too stiff in shear, by tens of cents for the high modes of a
/// thick wall.
pub const LAYERS: usize = 2;

/// A body of revolution: its meridian, where it is struck and held, and how it radiates.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// The meridian.
    pub meridian: Meridian,
    /// Length that a catalogue would give, in m.
    pub length_m: f64,
    /// Nodes along the strike line, a node every half cell, from its position 0 on.
    pub line: Vec<u32>,
    /// Outward unit normal (r, z) at each of them.
    pub line_normals: Vec<[f64; 2]>,
    /// Whether the upper half mirrors the lower one.
    pub mirrors: bool,
    /// Nodes where the body is held, averaged around the axis.
    pub held: Vec<u32>,
    /// Nodes where the damper's felt touches, averaged around the axis.
    pub felt: Vec<u32>,
    /// Sides of the meridian that radiate to the outside.
    pub heard: Vec<[u32; 3]>,
    /// Radius and height (r, z) in m of its mouth, if it is open above.
    pub mouth_m: Option<[f64; 2]>,
    /// What motions of two and more waves around the axis are called.
    pub family: Family,
}
