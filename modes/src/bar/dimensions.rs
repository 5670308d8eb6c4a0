//! What the searches for a bar turn, and how far.

use super::tuning::BarStock;
use crate::shape::{Bar, Undercut};

/// The centre in thicknesses, half the arch in lengths, the exponent, and the length in stock lengths;
/// searches turn the logarithms.
pub(super) type Dimensions = [f64; 4];

/// Ranges that make a bar, in the order of [`Dimensions`].
pub(super) const CENTRE: [f64; 2] = [0.15, 0.95];
pub(super) const ARCH: [f64; 2] = [0.1, 0.48];
pub(super) const EXPONENTS: [f64; 2] = [1.5, 8.0];
pub(super) const LENGTHS: [f64; 2] = [0.6, 1.6];

/// The exponent of the arch where it is fixed, and where searches begin.
pub(super) const EXPONENT: f64 = 2.5;

/// Largest step in the logarithm of a dimension: the partials are only nearly linear in it.
pub(super) const LARGEST_STEP: f64 = 0.3;

/// The bar of `stock` with these dimensions.
pub(super) fn bar_of(stock: &BarStock, [centre, arch, exponent, length]: Dimensions) -> Bar {
    let length_m = stock.length_m * length;
    Bar {
        length_m,
        width_m: stock.width_m,
        thickness_m: stock.thickness_m,
        undercut: Undercut {
            centre_thickness_m: centre * stock.thickness_m,
            half_length_m: arch * length_m,
            exponent,
        },
    }
}
