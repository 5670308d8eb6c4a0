//! From fractions to counts.

/// The whole part of `x`; 0 for what is negative or no number.
#[expect(clippy::cast_sign_loss, reason = "`as` turns what is below 0 into 0")]
pub(crate) fn whole(x: f64) -> usize {
    x as usize
}
