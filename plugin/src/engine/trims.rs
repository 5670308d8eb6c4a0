//! What the player makes of single modes: louder or softer, longer or shorter, or one alone.

use super::range;
use super::settings::within;
use modes::{Family, Member, ModeLabel};

/// What is done to the modes of one name, on every key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trim {
    /// Level over that as built, in dB.
    pub level_db: f32,
    /// How long it rings over how long it would, as a ratio.
    pub ringing: f32,
}

impl Trim {
    /// As built.
    pub const NONE: Self = Self {
        level_db: 0.0,
        ringing: 1.0,
    };

    /// The same with every value in its range, and what is not a number as built.
    fn sane(self) -> Self {
        let within = |value: f32, range, normal| within(f64::from(value), range, normal) as f32;
        Self {
            level_db: within(self.level_db, range::TRIM_DB, 0.0),
            ringing: within(self.ringing, range::TRIM_RINGING, 1.0),
        }
    }

    /// Factor on the sound.
    #[must_use]
    pub fn gain(&self) -> f32 {
        10f32.powf(self.level_db / 20.0)
    }
}

/// Modes that can be trimmed at the same time.
pub const MOST_TRIMS: usize = 64;

/// A name as a number to order by.
fn rank(label: &ModeLabel) -> u64 {
    let family: u64 = match label.family {
        Family::Bending => 0,
        Family::Torsion => 1,
        Family::Longitudinal => 2,
        Family::Wall => 3,
        Family::Lateral => 4,
        Family::Shell => 5,
        Family::Other => 6,
    };
    let member: u64 = match label.member {
        Member::Single => 0,
        Member::A => 1,
        Member::B => 2,
    };
    family << 34 | member << 32 | u64::from(label.order) << 16 | u64::from(label.index)
}

/// A table of trims of a fixed size, which the audio thread copies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trims {
    /// By rising rank of the label, as many as `count`.
    entries: [(u64, ModeLabel, Trim); MOST_TRIMS],
    count: usize,
    solo: Option<ModeLabel>,
}

impl Default for Trims {
    fn default() -> Self {
        Self::NONE
    }
}

impl Trims {
    /// All modes as built.
    pub const NONE: Self = {
        let nobody = ModeLabel {
            family: Family::Other,
            order: 0,
            index: 0,
            member: Member::Single,
        };
        Self {
            entries: [(0, nobody, Trim::NONE); MOST_TRIMS],
            count: 0,
            solo: None,
        }
    };

    fn known(&self) -> &[(u64, ModeLabel, Trim)] {
        &self.entries[..self.count]
    }

    fn find(&self, label: &ModeLabel) -> Result<usize, usize> {
        let wanted = rank(label);
        self.known().binary_search_by_key(&wanted, |entry| entry.0)
    }

    /// What is done to the modes of that name.
    #[must_use]
    pub fn get(&self, label: &ModeLabel) -> Trim {
        self.find(label).map_or(Trim::NONE, |at| self.entries[at].2)
    }

    /// From now on this is done to them; whether there was room for one more.
    pub fn set(&mut self, label: &ModeLabel, trim: Trim) -> bool {
        let trim = trim.sane();
        match self.find(label) {
            Ok(at) if trim == Trim::NONE => {
                self.entries.copy_within(at + 1..self.count, at);
                self.count -= 1;
                // What lies beyond is as in a new table, so that equal tables are equal.
                self.entries[self.count] = Self::NONE.entries[0];
            }
            Ok(at) => self.entries[at].2 = trim,
            Err(_) if trim == Trim::NONE => {}
            Err(_) if self.count == MOST_TRIMS => return false,
            Err(at) => {
                self.entries.copy_within(at..self.count, at + 1);
                self.entries[at] = (rank(label), *label, trim);
                self.count += 1;
            }
        }
        true
    }

    /// Every mode that is not as built.
    pub fn all(&self) -> impl Iterator<Item = (ModeLabel, Trim)> {
        self.known().iter().map(|(_, label, trim)| (*label, *trim))
    }

    /// The mode that is heard alone on every body that has it.
    #[must_use]
    pub fn solo(&self) -> Option<ModeLabel> {
        self.solo
    }

    /// Lets one mode be heard alone, or all again.
    pub fn set_solo(&mut self, solo: Option<ModeLabel>) {
        self.solo = solo;
    }

    /// Whether nothing is done to any mode.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.count == 0 && self.solo.is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bending(index: u16) -> ModeLabel {
        ModeLabel {
            family: Family::Bending,
            order: 1,
            index,
            member: Member::A,
        }
    }

    fn louder(level_db: f32) -> Trim {
        Trim {
            level_db,
            ..Trim::NONE
        }
    }

    #[test]
    fn a_table_gives_back_what_was_put_in_and_no_more_than_fits() {
        let mut trims = Trims::NONE;
        for index in [5, 2, 9, 1] {
            assert!(trims.set(&bending(index), louder(f32::from(index) - 20.0)));
        }
        assert_eq!(trims.get(&bending(9)).level_db, -11.0);
        assert_eq!(trims.get(&bending(3)), Trim::NONE);
        assert!(trims.set(&bending(9), Trim::NONE));
        assert_eq!(trims.all().count(), 3);
        for index in 100..200 {
            trims.set(&bending(index), louder(-1.0));
        }
        assert_eq!(trims.all().count(), MOST_TRIMS);
        assert!(!trims.set(&bending(300), louder(-1.0)));
        for (label, _) in trims.clone().all() {
            assert!(trims.set(&label, Trim::NONE));
        }
        assert_eq!(trims, Trims::NONE);
    }

    #[test]
    fn nonsense_becomes_allowed_values() {
        let mut trims = Trims::NONE;
        let wild = Trim {
            level_db: f32::INFINITY,
            ringing: f32::NAN,
        };
        trims.set(&bending(1), wild);
        let trim = trims.get(&bending(1));
        assert_eq!(trim.level_db, *range::TRIM_DB.end() as f32);
        assert_eq!(trim.ringing, 1.0);
    }
}
