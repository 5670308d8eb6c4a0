//! Shapes whose modes have closed forms.

/// How a bar's ends are held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BarEnds {
    /// Both held firmly: neither moves nor turns.
    Clamped,
    /// Neither held.
    Free,
    /// The first held firmly, the other free.
    Cantilever,
}

/// A thin body of 1998, §6. Instruments have it at many sizes, film and thickness included: all
/// frequencies go as the inverse of the lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ClosedShape {
    /// A round wire between a bridge and a firm end, heard through the board under the bridge.
    String {
        /// Length that swings, in m.
        length_m: f64,
        /// Radius of the wire, in m.
        radius_m: f64,
        /// Tension, in N.
        tension_n: f64,
        /// Velocity of the board for a force of 1 N, in s/kg.
        board_s_kg: f64,
    },
    /// A bar of rectangular section.
    Bar {
        /// Length, in m.
        length_m: f64,
        /// Thickness in the direction in which it is struck, in m.
        thickness_m: f64,
        /// Width, in m.
        width_m: f64,
        /// How its ends are held.
        ends: BarEnds,
        /// Velocity for a force of 1 N, in s/kg, of the board that the clamp of its first end stands
        /// on and through which it is heard; without, it is heard itself, in the open.
        board_s_kg: Option<f64>,
    },
    /// A rectangular film.
    RectangularMembrane {
        /// Lengths of the sides, in m.
        sides_m: [f64; 2],
        /// Thickness of the film, in m.
        thickness_m: f64,
        /// Tension, in N/m.
        tension_n_m: f64,
    },
    /// A round film.
    CircularMembrane {
        /// Radius, in m.
        radius_m: f64,
        /// Thickness of the film, in m.
        thickness_m: f64,
        /// Tension, in N/m.
        tension_n_m: f64,
    },
    /// A round plate, clamped at its rim.
    CircularPlate {
        /// Radius, in m.
        radius_m: f64,
        /// Thickness, in m.
        thickness_m: f64,
    },
    /// A film over three squares.
    LMembrane {
        /// Side of each square, in m.
        square_m: f64,
        /// Thickness of the film, in m.
        thickness_m: f64,
        /// Tension, in N/m.
        tension_n_m: f64,
    },
}
