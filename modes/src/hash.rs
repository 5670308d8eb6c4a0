//! A number that tells files apart.

use crate::fnv;

/// Fowler, Noll and Vo's hash 1a of `bytes`, 64 bits.
#[must_use]
pub fn fnv1a(bytes: &[u8]) -> u64 {
    fnv::extend(fnv::START, bytes)
}
