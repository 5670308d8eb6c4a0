//! Sixteen modes side by side, in the order in which the kernels read them.

use crate::engine::GRID;

/// Modes of a pack: the widest vector of single floats.
pub(crate) const LANES: usize = 16;

/// Samples that one step of the state leaps over.
pub(crate) const HOP: usize = 8;

/// Steps of the state in a cell of the grid.
pub(super) const HOPS: usize = GRID / HOP;

/// What the points of a cell's first hop hear of a mode's x at the cell's start (half 0), and of its y (half
/// 1): left, then right.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(crate) struct Heard(pub(super) [[f32; 2 * HOP]; 2]);

impl Heard {
    /// Nothing.
    pub(super) const NONE: Self = Self([[0.0; 2 * HOP]; 2]);
}

/// Modes that ring freely: what one cell of the grid needs of them.
///
/// A mode's state is z = x + iy with x its velocity and y its displacement times Ω, both times the
/// root of its modal mass, in √(2 J): |z|²/2 is its energy. Over a sample z turns to zw,
/// w = exp((−d + iΩ)T). z and what it does over a cell are kept in f64: a step in f32 is up to 5 % off
/// in a T60 of a minute. Within a cell f32 is enough.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Pack {
    /// Velocity, in √(2 J).
    pub(crate) x: [f64; LANES],
    /// Ω times displacement, in √(2 J).
    pub(crate) y: [f64; LANES],
    /// Real part of w to the power of [`GRID`].
    pub(crate) cell_re: [f64; LANES],
    /// Imaginary part of it.
    pub(crate) cell_im: [f64; LANES],
    /// Real part of w to the power of a hop's samples.
    pub(super) hop_re: [f32; LANES],
    /// Imaginary part of it.
    pub(super) hop_im: [f32; LANES],
    /// At which of [`POINTS`] it is heard.
    ///
    /// [`POINTS`]: super::points::POINTS
    pub(super) points: usize,
    /// What is heard of each mode.
    pub(super) heard: [Heard; LANES],
}

impl Pack {
    /// Modes that neither move nor are heard.
    pub(crate) const STILL: Self = Self {
        x: [0.0; LANES],
        y: [0.0; LANES],
        cell_re: [0.0; LANES],
        cell_im: [0.0; LANES],
        hop_re: [0.0; LANES],
        hop_im: [0.0; LANES],
        points: 0,
        heard: [Heard::NONE; LANES],
    };

    /// Stops every mode.
    pub(crate) fn hush(&mut self) {
        self.x = [0.0; LANES];
        self.y = [0.0; LANES];
    }

    /// Takes the modes back from the end of a cell to its start; those that have died within it stay
    /// dead.
    pub(crate) fn rewind(&mut self) {
        for i in 0..LANES {
            let (re, im) = (self.cell_re[i], self.cell_im[i]);
            let square = re * re + im * im;
            let (x, y) = (self.x[i], self.y[i]);
            if square > 1e-20 {
                self.x[i] = (x * re + y * im) / square;
                self.y[i] = (y * re - x * im) / square;
            } else {
                (self.x[i], self.y[i]) = (0.0, 0.0);
            }
        }
    }
}
