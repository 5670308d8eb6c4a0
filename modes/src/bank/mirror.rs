//! Which part of a mode's shape a file holds: components that vanish and mirrored halves are left out.

use super::{BankError, Mode};

/// Bit for a shape of which only the first half is stored.
const HALF: u8 = 8;

/// What is stored of one shape.
#[derive(Clone, Copy)]
pub(super) struct Stored {
    bits: u8,
    /// Points of the whole shape.
    whole: usize,
}

impl Stored {
    /// A shape that has not one value for each of the line's `points` is stored as it is, for the
    /// reader to refuse.
    pub(super) fn of(mode: &Mode, points: usize) -> Self {
        let shape: Vec<[f32; 3]> = mode.shape.iter().collect();
        let whole = shape.len();
        let moves = |c: usize| shape.iter().any(|phi| phi[c] != 0.0);
        let components = (0..3).fold(0, |bits, c| bits | u8::from(moves(c)) << c);
        // At least one, so that the bytes of a file bound what reading it takes.
        let mut bits = components.max(1);
        let mirrors =
            |c: usize, sign: f32| (0..whole).all(|i| shape[i][c] == sign * shape[whole - 1 - i][c]);
        let even: Vec<bool> = (0..3).map(|c| mirrors(c, 1.0)).collect();
        if whole == points && (0..3).all(|c| even[c] || mirrors(c, -1.0)) {
            bits |= HALF;
            for (c, even) in even.iter().enumerate() {
                bits |= u8::from(!even) << (4 + c);
            }
        }
        Self { bits, whole }
    }

    /// What `bits` of a file say of a shape of `whole` points.
    pub(super) fn from_bits(bits: u8, whole: usize) -> Result<Self, BankError> {
        if bits & 7 == 0 || bits & 128 != 0 {
            return Err(BankError::inconsistent(
                "components",
                bits,
                "1 to 127, with at least one component",
            ));
        }
        Ok(Self { bits, whole })
    }

    pub(super) fn bits(&self) -> u8 {
        self.bits
    }

    /// The stored components, 0 x to 2 z.
    pub(super) fn components(&self) -> impl Iterator<Item = usize> + use<> {
        let bits = self.bits;
        (0..3).filter(move |c| bits & (1 << c) != 0)
    }

    /// The stored points, from the first.
    pub(super) fn points(&self) -> usize {
        if self.bits & HALF == 0 {
            self.whole
        } else {
            self.whole.div_ceil(2)
        }
    }

    /// Bytes of the stored numbers.
    pub(super) fn len(&self) -> u64 {
        4 * self.points() as u64 * u64::from((self.bits & 7).count_ones())
    }

    /// The whole shape, when its first half has been read.
    pub(super) fn complete(&self, shape: &mut [[f32; 3]]) {
        for i in self.points()..self.whole {
            let twin = shape[self.whole - 1 - i];
            for c in self.components() {
                let opposite = self.bits & (16 << c) != 0;
                // 0 rather than −0, which no file holds.
                shape[i][c] = if opposite { 0.0 - twin[c] } else { twin[c] };
            }
        }
    }
}
