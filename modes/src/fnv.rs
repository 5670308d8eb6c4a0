//! Fowler, Noll and Vo's hash 1a, 64 bits: tells sources and recipes apart.

/// Hash of nothing.
pub(crate) const START: u64 = 0xcbf2_9ce4_8422_2325;

/// `hash` continued over `bytes`.
pub(crate) fn extend(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Test vectors of draft-eastlake-fnv, appendix C.
    #[test]
    fn it_is_the_published_one() {
        assert_eq!(extend(START, b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(extend(START, b"a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(extend(START, b"foobar"), 0x8594_4171_f739_67e8);
    }
}
