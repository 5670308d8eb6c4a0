//! What to call a mode.

use serde::{Deserialize, Serialize};
use std::fmt;

/// The kind of motion of a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Family {
    /// The body bends as a beam.
    Bending,
    /// The body twists about its axis.
    Torsion,
    /// The body stretches along its axis (and breathes, by Poisson's ratio).
    Longitudinal,
    /// The wall flexes with `order` waves around the axis.
    Wall,
    /// The body bends sideways, across the direction in which it is struck.
    Lateral,
    /// A shell flexes with `order` waves around its axis.
    Shell,
    /// A membrane moves, with `order` nodal diameters or half-waves along its first side.
    Membrane,
    /// A plate flexes with `order` nodal diameters.
    Plate,
    /// No kind was made out.
    Other,
}

/// Which of a degenerate pair of a body of revolution, or neither.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Member {
    /// The mode has no partner.
    Single,
    /// The partner whose radial motion is greatest at the strike line.
    A,
    /// The partner whose radial motion vanishes at the strike line.
    B,
}

/// A mode's name: `bending 2 a`, `torsion 1`, `wall (2,3) b`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct ModeLabel {
    /// The kind of motion.
    pub family: Family,
    /// Number of waves around the axis (0 torsion and stretching, 1 bending, 2… walls).
    pub order: u16,
    /// Counted from 1 by frequency within family and order.
    pub index: u16,
    /// Partner of a degenerate pair.
    pub member: Member,
}

impl fmt::Display for ModeLabel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.family {
            Family::Bending => write!(f, "bending {}", self.index)?,
            Family::Torsion => write!(f, "torsion {}", self.index)?,
            Family::Longitudinal => write!(f, "longitudinal {}", self.index)?,
            Family::Wall => write!(f, "wall ({},{})", self.order, self.index)?,
            Family::Lateral => write!(f, "lateral {}", self.index)?,
            // Bell founders count the nodal circles, from none.
            Family::Shell => write!(f, "shell ({},{})", self.order, self.index - 1)?,
            Family::Membrane => write!(f, "membrane ({},{})", self.order, self.index)?,
            Family::Plate => write!(f, "plate ({},{})", self.order, self.index)?,
            Family::Other => write!(f, "mode {}", self.index)?,
        }
        match self.member {
            Member::Single => Ok(()),
            Member::A => write!(f, " a"),
            Member::B => write!(f, " b"),
        }
    }
}
