//! Registered parameters: numbers that controllers spell out over several messages.

use super::tame::seven_bit;

/// What a data entry says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Entry {
    /// RPN 0, first byte: the pitch bend's range in whole semitones.
    BendSemitones(u8),
    /// RPN 0, second byte: cents on top.
    BendCents(u8),
    /// RPN 6: an MPE zone of that many member channels.
    Zone(u8),
}

/// The parameter that a channel's data entries are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Rpn {
    msb: u8,
    lsb: u8,
    /// Not one of a manufacturer's own.
    registered: bool,
}

impl Rpn {
    /// None (the null number, 127 127).
    pub(super) const NULL: Self = Self {
        msb: 127,
        lsb: 127,
        registered: false,
    };

    /// Takes in CC 6, 38 and 98 to 101, with their values as shares of 127.
    pub(super) fn hear(&mut self, cc: u8, value: f64) -> Option<Entry> {
        let byte = seven_bit(value);
        match cc {
            99 | 101 => self.msb = byte,
            98 | 100 => self.lsb = byte,
            _ => {}
        }
        match (cc, self.registered, self.msb, self.lsb) {
            (98 | 99, ..) => self.registered = false,
            (100 | 101, ..) => self.registered = true,
            (6, true, 0, 0) => return Some(Entry::BendSemitones(byte)),
            (38, true, 0, 0) => return Some(Entry::BendCents(byte)),
            (6, true, 0, 6) => return Some(Entry::Zone(byte)),
            _ => {}
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{Entry, Rpn};

    fn hear(rpn: &mut Rpn, messages: &[(u8, u8)]) -> Vec<Entry> {
        messages
            .iter()
            .filter_map(|(cc, byte)| rpn.hear(*cc, f64::from(*byte) / 127.0))
            .collect()
    }

    #[test]
    fn numbers_are_spelled_in_any_order() {
        let mut rpn = Rpn::NULL;
        let entries = hear(&mut rpn, &[(101, 0), (100, 0), (6, 12), (38, 50)]);
        assert_eq!(entries, [Entry::BendSemitones(12), Entry::BendCents(50)]);
        let entries = hear(&mut rpn, &[(100, 6), (6, 15), (38, 3)]);
        assert_eq!(entries, [Entry::Zone(15)]);
        let entries = hear(&mut Rpn::NULL.clone(), &[(100, 6), (101, 0), (6, 3)]);
        assert_eq!(entries, [Entry::Zone(3)]);
    }

    #[test]
    fn data_for_nothing_or_for_others_is_not_ours() {
        for prelude in [
            &[][..],
            &[(101, 0), (100, 0), (101, 127), (100, 127)],
            &[(101, 0), (100, 0), (99, 0), (98, 0)],
            &[(99, 0), (98, 6)],
            &[(101, 0), (100, 1)],
            &[(101, 0)],
        ] {
            let mut rpn = Rpn::NULL;
            hear(&mut rpn, prelude);
            assert_eq!(hear(&mut rpn, &[(6, 5), (38, 5)]), [], "{prelude:?}");
        }
    }
}
