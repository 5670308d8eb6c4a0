//! Values to texts and back.

use super::choice::Choice;

/// How a parameter is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Text {
    /// Two decimals and a unit: `22.50 %`.
    Fixed(&'static str),
    /// Three digits and a unit: `0.500 x`; for what is not negative.
    Digits(&'static str),
    /// Three digits, a power of ten and a unit: `2.00e-4 tan`; for what is not negative.
    Power(&'static str),
    /// `1.00 GPa`
    Pascals,
    /// One of some names.
    Choice(Choice),
    /// One of two words.
    Switch {
        /// For 0.
        off: &'static str,
        /// For 1.
        on: &'static str,
    },
}

/// Three significant digits of a value from 0.001 to 999, fewer below.
fn three_digits(value: f32) -> String {
    // Where rounding would give a digit more, the value counts as the rounded one.
    let decimals = [99.95, 9.995, 0.9995, 0.099_95, 0.009_995, 0.000_999_5]
        .iter()
        .position(|least| value >= *least)
        .unwrap_or(6);
    format!("{value:.decimals$}")
}

impl Text {
    pub(crate) fn format(self, value: f32) -> String {
        match self {
            Self::Fixed(unit) => {
                // Adding 0 turns −0 into 0, which would be shown with its sign.
                let rounded = (value * 100.0).round() / 100.0 + 0.0;
                format!("{rounded:.2} {unit}")
            }
            Self::Digits(unit) if value < 1e-6 => format!("0 {unit}"),
            Self::Power(unit) if value == 0.0 => format!("0 {unit}"),
            Self::Digits(unit) => format!("{} {unit}", three_digits(value)),
            Self::Power(unit) => format!("{value:.2e} {unit}"),
            Self::Pascals if value >= 0.9995e9 => format!("{} GPa", three_digits(value / 1e9)),
            Self::Pascals if value >= 0.9995e6 => format!("{} MPa", three_digits(value / 1e6)),
            Self::Pascals => format!("{} kPa", three_digits(value / 1e3)),
            Self::Choice(choice) => choice.name(index(value)).into(),
            Self::Switch { off, on } => if value < 0.5 { off } else { on }.into(),
        }
    }

    /// Other ways to write the unit, in small letters, and their factors.
    fn units(self) -> &'static [(&'static str, f64)] {
        match self {
            Self::Pascals => &[("gpa", 1e9), ("mpa", 1e6), ("kpa", 1e3), ("pa", 1.0)],
            Self::Power("s") => &[
                ("ns", 1e-9),
                ("us", 1e-6),
                ("\u{b5}s", 1e-6),
                ("\u{3bc}s", 1e-6),
                ("ms", 1e-3),
            ],
            Self::Digits("1/s") => &[("/s", 1.0)],
            Self::Digits("g") => &[("kg", 1e3)],
            Self::Digits("mm") => &[("cm", 10.0)],
            Self::Fixed("deg") => &[("\u{b0}", 1.0)],
            _ => &[],
        }
    }

    /// The unit as it is written.
    pub(super) const fn unit(self) -> &'static str {
        match self {
            Self::Fixed(unit) | Self::Digits(unit) | Self::Power(unit) => unit,
            Self::Pascals | Self::Choice(_) | Self::Switch { .. } => "",
        }
    }

    pub(crate) fn parse(self, text: &str) -> Option<f64> {
        let text = text.trim().to_lowercase();
        if let Self::Choice(choice) = self {
            return choice.parse(&text).map(|index| index as f64);
        }
        if let Self::Switch { off, on } = self {
            return match text.as_str() {
                word if word == off => Some(0.0),
                word if word == on => Some(1.0),
                "0" | "off" | "false" | "no" => Some(0.0),
                "1" | "on" | "true" | "yes" => Some(1.0),
                _ => None,
            };
        }
        let number = |unit: &str| -> Option<f64> {
            let bare = text.strip_suffix(unit)?;
            bare.trim_end().parse().ok()
        };
        // The longest units first: each may end like a shorter one.
        let others = self.units().iter().copied();
        let (number, factor) = others
            .chain([(self.unit().to_lowercase().as_str(), 1.0), ("", 1.0)])
            .find_map(|(unit, factor)| Some((number(unit)?, factor)))?;
        number.is_finite().then_some(number * factor)
    }
}

/// The number of a choice.
fn index(value: f32) -> usize {
    #[expect(clippy::cast_sign_loss, reason = "what is below 0 saturates")]
    let index = value.round() as usize;
    index
}

#[cfg(test)]
mod tests {
    use super::three_digits;

    #[test]
    fn three_digits_are_shown() {
        for (value, shown) in [
            (999.0, "999"),
            (99.96, "100"),
            (99.94, "99.9"),
            (9.996, "10.0"),
            (0.9996, "1.00"),
            (0.999, "0.999"),
            (0.099_96, "0.100"),
            (0.012_34, "0.0123"),
            (0.001_234, "0.00123"),
            (0.000_1, "0.000100"),
        ] {
            assert_eq!(three_digits(value), shown);
        }
    }
}
