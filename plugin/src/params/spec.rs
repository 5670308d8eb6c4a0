//! What a parameter is: the table that the plug-in, the command line and the manual share.

use super::choice::Choice;
use super::text::Text;
use super::{assign, body, bow, damping, hands, listener, mallet, motor, output, shape, strike};
use std::ops::RangeInclusive;

/// One parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spec {
    /// At most six ASCII characters; never changes, or songs lose their automation.
    pub id: &'static str,
    /// Name in the host.
    pub name: &'static str,
    /// Unit of `min`, `max` and `default`; empty for a switch and for a choice.
    pub unit: &'static str,
    /// Least value.
    pub min: f32,
    /// Greatest value.
    pub max: f32,
    /// Value of a new instance.
    pub default: f32,
    /// What it does to the sound.
    pub tooltip: &'static str,
    /// Exponent from the value's share of the range to the host's 0…1; below 1 small values get
    /// more room.
    pub(crate) skew: f32,
    pub(crate) text: Text,
}

/// Parameters that belong together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Group {
    /// Name in the host.
    pub name: &'static str,
    /// Its parameters, in the host's order.
    pub specs: &'static [Spec],
}

const fn group(name: &'static str, specs: &'static [Spec]) -> Group {
    Group { name, specs }
}

/// Every parameter, in the host's order.
pub const GROUPS: [Group; 18] = [
    group("Body", &body::SPECS),
    group("Shape", &shape::SPECS),
    group("Strike", &strike::SPECS),
    group("Mallet", &mallet::SPECS),
    group("Bow", &bow::SPECS),
    group("Damping", &damping::SPECS),
    group("Motor", &motor::SPECS),
    group("Listener", &listener::SPECS),
    group("Hands", &hands::SPECS),
    group("Assign 1", &assign::SPECS[0]),
    group("Assign 2", &assign::SPECS[1]),
    group("Assign 3", &assign::SPECS[2]),
    group("Assign 4", &assign::SPECS[3]),
    group("Assign 5", &assign::SPECS[4]),
    group("Assign 6", &assign::SPECS[5]),
    group("Assign 7", &assign::SPECS[6]),
    group("Assign 8", &assign::SPECS[7]),
    group("Output", &output::SPECS),
];

/// The parameters of all groups, in the host's order.
pub fn specs() -> impl Iterator<Item = &'static Spec> {
    GROUPS.iter().flat_map(|group| group.specs)
}

impl Spec {
    const BLANK: Self = Self {
        id: "",
        name: "",
        unit: "",
        min: 0.0,
        max: 1.0,
        default: 0.0,
        tooltip: "",
        skew: 1.0,
        text: Text::Switch { off: "", on: "" },
    };

    /// A number that is `scale` times one of the engine's, in its `range` and with its `default`.
    pub(super) const fn number(
        text: Text,
        scale: f64,
        range: &RangeInclusive<f64>,
        default: f64,
    ) -> Self {
        Self {
            unit: text.unit(),
            min: (scale * *range.start()) as f32,
            max: (scale * *range.end()) as f32,
            default: (scale * default) as f32,
            text,
            ..Self::BLANK
        }
    }

    /// A share of the engine's, in percent.
    pub(super) const fn percent(range: &RangeInclusive<f64>, default: f64) -> Self {
        Self::number(Text::Fixed("%"), 100.0, range, default)
    }

    /// One of two words.
    pub(super) const fn switch(off: &'static str, on: &'static str, default: bool) -> Self {
        Self {
            default: default as u8 as f32,
            text: Text::Switch { off, on },
            ..Self::BLANK
        }
    }

    /// One of some names.
    pub(super) const fn choice(choice: Choice, default: usize) -> Self {
        Self {
            max: (choice.count() - 1) as f32,
            default: default as f32,
            text: Text::Choice(choice),
            ..Self::BLANK
        }
    }

    /// The parameter called `name`, in any case.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        specs().find(|spec| spec.name.eq_ignore_ascii_case(name.trim()))
    }

    /// A value as the host shows it, unit included.
    #[must_use]
    pub fn format(&self, value: f32) -> String {
        self.text.format(value)
    }

    /// The value a text means, with or without its unit, in any case; none if the text is no such
    /// thing or out of range.
    #[must_use]
    pub fn parse(&self, text: &str) -> Option<f32> {
        let value = self.text.parse(text)? as f32;
        (self.min..=self.max).contains(&value).then_some(value)
    }

    /// The range in words, for messages: `0.00 % to 100.00 %`.
    #[must_use]
    pub fn allowed(&self) -> String {
        match self.text {
            Text::Switch { off, on } => format!("\"{off}\" or \"{on}\""),
            Text::Choice(choice) => choice.names().collect::<Vec<_>>().join(", "),
            _ => format!("{} to {}", self.format(self.min), self.format(self.max)),
        }
    }

    /// `value` inside the range; the default if it is not a number.
    #[must_use]
    pub fn sane(&self, value: f32) -> f32 {
        if value.is_nan() {
            return self.default;
        }
        value.clamp(self.min, self.max)
    }
}

#[cfg(test)]
mod tests {
    use super::super::damping::{ALPHA1, ALPHA2, NOTE_OFF};
    use super::super::mallet::{HARDNESS, MASS, RADIUS};
    use super::super::output::GAIN;
    use super::super::strike::POSITION;
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn ids_are_short_and_names_distinct() {
        let ids: HashSet<_> = specs().map(|spec| spec.id).collect();
        let names: HashSet<_> = specs().map(|spec| spec.name).collect();
        assert_eq!((ids.len(), names.len()), (specs().count(), specs().count()));
        for spec in specs() {
            assert!(spec.id.is_ascii() && (1..=6).contains(&spec.id.len()));
            assert!(spec.min < spec.max && !spec.tooltip.is_empty());
            assert_eq!(spec.sane(spec.default), spec.default, "{}", spec.name);
            assert_eq!(Spec::named(&spec.name.to_uppercase()), Some(spec));
        }
    }

    /// Songs find their values by these.
    #[test]
    fn the_first_ids_are_as_they_were() {
        let ids: HashSet<_> = specs().map(|spec| spec.id).collect();
        for id in [
            "instr", "pos", "vpos", "scat", "hard", "vrng", "alpha1", "alpha2", "own", "tanphi",
            "radia", "suppt", "noff", "mspeed", "mdepth", "mphase", "width", "gain",
        ] {
            assert!(ids.contains(id), "{id}");
        }
    }

    #[test]
    fn what_is_shown_parses_back_to_the_shown_digits() {
        for spec in specs() {
            for i in 0..=200 {
                let share = (i as f32 / 200.0).powf(1.0 / spec.skew);
                let value = spec.min + (spec.max - spec.min) * share;
                let shown = spec.format(value);
                let parsed = spec.parse(&shown).unwrap_or(f32::NAN);
                assert_eq!(spec.format(parsed), shown, "{}", spec.name);
                assert!(
                    (parsed - value).abs() <= 0.0051 * value.abs().max(1e-3 * spec.max).max(1e-9)
                        || spec.unit.is_empty(),
                    "{}: {value} shown as {shown}",
                    spec.name
                );
            }
        }
    }

    #[test]
    fn texts_are_read_in_any_case_with_or_without_units() {
        for (spec, text, value) in [
            (&POSITION, "12.34%", 12.34),
            (&POSITION, " 7 ", 7.0),
            (&HARDNESS, "1 GPa", 1e9),
            (&HARDNESS, "20mpa", 2e7),
            (&HARDNESS, "1500 kPa", 1.5e6),
            (&ALPHA1, "100 ns", 1e-7),
            (&ALPHA1, "0.1 us", 1e-7),
            (&ALPHA1, "0.1 \u{b5}s", 1e-7),
            (&ALPHA1, "0.1 \u{3bc}S", 1e-7),
            (&ALPHA1, "1.00E-7 S", 1e-7),
            (&ALPHA1, "8e-6", 8e-6),
            (&ALPHA2, "50 1/s", 50.0),
            (&ALPHA2, "51/s", 51.0),
            (&GAIN, "-6 dB", -6.0),
            (&MASS, "0.2 kg", 200.0),
            (&RADIUS, "1.5 CM", 15.0),
            (&RADIUS, "15", 15.0),
            (&NOTE_OFF, "Damps", 1.0),
            (&NOTE_OFF, "off", 0.0),
        ] {
            let parsed = spec.parse(text).unwrap_or(f32::NAN);
            assert!(
                (parsed / value - 1.0).abs() < 1e-6 || parsed == value,
                "{text}"
            );
        }
    }

    #[test]
    fn nonsense_and_what_is_out_of_range_is_refused() {
        for (spec, text) in [
            (&POSITION, "101 %"),
            (&POSITION, "-0.01"),
            (&POSITION, "3 dB"),
            (&HARDNESS, "1 kPa"),
            (&ALPHA1, "1 ms"),
            (&ALPHA1, "nan"),
            (&ALPHA2, "inf 1/s"),
            (&GAIN, ""),
            (&GAIN, "loud"),
            (&NOTE_OFF, "2"),
        ] {
            assert_eq!(spec.parse(text), None, "{}: {text}", spec.name);
        }
        assert_eq!(POSITION.allowed(), "0.00 % to 100.00 %");
        assert_eq!(ALPHA1.allowed(), "0 s to 2.00e-5 s");
    }
}
