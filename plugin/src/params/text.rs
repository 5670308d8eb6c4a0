//! Values to texts and back.

/// How a parameter is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Text {
    /// `22.50 %`
    Percent,
    /// `-6.00 dB`
    Decibels,
    /// `1.00 GPa`
    Pascals,
    /// `1.00e-7 s`
    Seconds,
    /// `0.500 1/s`
    PerSecond,
    /// `1.00 x`
    Factor,
    /// `2.00e-4 tan`
    Tangent,
    /// `5.50 Hz`
    Hertz,
    /// `90.00 deg`
    Degrees,
    /// The title of a factory instrument.
    Instrument,
    /// One of two words.
    Switch {
        /// For 0.
        off: &'static str,
        /// For 1.
        on: &'static str,
    },
}

/// Three significant digits of a value from 1 to 999.
fn three_digits(value: f32) -> String {
    if value < 9.995 {
        format!("{value:.2}")
    } else if value < 99.95 {
        format!("{value:.1}")
    } else {
        format!("{value:.0}")
    }
}

impl Text {
    pub(crate) fn format(self, value: f32) -> String {
        // Adding 0 turns −0 into 0, which would be shown with its sign.
        let rounded = (value * 100.0).round() / 100.0 + 0.0;
        match self {
            Self::Percent => format!("{rounded:.2} %"),
            Self::Decibels => format!("{rounded:.2} dB"),
            Self::Pascals if value >= 0.9995e9 => format!("{} GPa", three_digits(value / 1e9)),
            Self::Pascals if value >= 0.9995e6 => format!("{} MPa", three_digits(value / 1e6)),
            Self::Pascals => format!("{} kPa", three_digits(value / 1e3)),
            Self::Seconds if value == 0.0 => "0 s".into(),
            Self::Seconds => format!("{value:.2e} s"),
            Self::PerSecond if value < 0.9995 => format!("{value:.3} 1/s"),
            Self::PerSecond => format!("{} 1/s", three_digits(value)),
            Self::Factor if value < 0.995 => format!("{value:.4} x"),
            Self::Factor => format!("{} x", three_digits(value)),
            Self::Tangent if value == 0.0 => "0 tan".into(),
            Self::Tangent => format!("{value:.2e} tan"),
            Self::Hertz => format!("{rounded:.2} Hz"),
            Self::Degrees => format!("{rounded:.2} deg"),
            Self::Instrument => crate::factory::title(value).into(),
            Self::Switch { off, on } => if value < 0.5 { off } else { on }.into(),
        }
    }

    /// Units in small letters and their factors.
    fn units(self) -> &'static [(&'static str, f64)] {
        match self {
            Self::Percent => &[("%", 1.0)],
            Self::Decibels => &[("db", 1.0)],
            Self::Pascals => &[("gpa", 1e9), ("mpa", 1e6), ("kpa", 1e3), ("pa", 1.0)],
            Self::Seconds => &[
                ("ns", 1e-9),
                ("us", 1e-6),
                ("\u{b5}s", 1e-6),
                ("\u{3bc}s", 1e-6),
                ("ms", 1e-3),
                ("s", 1.0),
            ],
            Self::PerSecond => &[("/s", 1.0), ("1/s", 1.0)],
            Self::Factor => &[("x", 1.0)],
            Self::Tangent => &[("tan", 1.0)],
            Self::Hertz => &[("hz", 1.0)],
            Self::Degrees => &[("deg", 1.0), ("\u{b0}", 1.0)],
            Self::Instrument | Self::Switch { .. } => &[],
        }
    }

    pub(crate) fn parse(self, text: &str) -> Option<f64> {
        let text = text.trim().to_lowercase();
        if matches!(self, Self::Instrument) {
            let found = crate::factory::titles().position(|title| title.to_lowercase() == text);
            let number = || {
                text.parse()
                    .ok()
                    .filter(|number: &f64| number.fract() == 0.0)
            };
            return found.map(|index| index as f64).or_else(number);
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
        let bare = std::iter::once(("", 1.0));
        let (number, factor) =
            bare.chain(self.units().iter().copied())
                .find_map(|(unit, factor)| {
                    let number: f64 = text.strip_suffix(unit)?.trim_end().parse().ok()?;
                    Some((number, factor))
                })?;
        number.is_finite().then_some(number * factor)
    }
}
