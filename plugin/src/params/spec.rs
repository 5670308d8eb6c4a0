//! The parameters: one table that the plug-in, the command line and the manual share.

use super::text::Text;
use crate::engine::{Settings, range};

/// One parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spec {
    /// At most six ASCII characters; never changes, or songs lose their automation.
    pub id: &'static str,
    /// Name in the host.
    pub name: &'static str,
    /// Unit of `min`, `max` and `default`; empty for a switch.
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

const NORMAL: Settings = Settings::DEFAULT;

const fn percent(fraction: f64) -> f32 {
    (fraction * 100.0) as f32
}

/// Where a strike lands.
pub const STRIKE_POSITION: Spec = Spec {
    id: "pos",
    name: "Strike position",
    unit: "%",
    min: percent(*range::STRIKE_POSITION.start()),
    max: percent(*range::STRIKE_POSITION.end()),
    default: percent(NORMAL.strike_position),
    tooltip: "Where along its length a body is struck (a bowl from its rim, 0 %, to the middle of its base). Near an end all partials sound and the tone \
              is bright; in the middle every second one is missing; at 22 % the lowest is silent.",
    skew: 1.0,
    text: Text::Percent,
};

/// How velocity moves the strike.
pub const VELOCITY_TO_POSITION: Spec = Spec {
    id: "vpos",
    name: "Velocity to position",
    unit: "%",
    min: percent(*range::VELOCITY_TO_POSITION.start()),
    max: percent(*range::VELOCITY_TO_POSITION.end()),
    default: percent(NORMAL.velocity_to_position),
    tooltip: "How far a hard strike lands from a soft one, in halves of the length, so that loudness \
              changes the mixture of partials too.",
    skew: 1.0,
    text: Text::Percent,
};

/// How chance moves the strike.
pub const POSITION_SCATTER: Spec = Spec {
    id: "scat",
    name: "Position scatter",
    unit: "%",
    min: percent(*range::POSITION_SCATTER.start()),
    max: percent(*range::POSITION_SCATTER.end()),
    default: percent(NORMAL.position_scatter),
    tooltip: "How far chance moves each strike, in halves of the length, so that repeated notes \
              differ as a player's do. The same song always scatters alike.",
    skew: 1.0,
    text: Text::Percent,
};

/// How hard the mallet is.
pub const MALLET_HARDNESS: Spec = Spec {
    id: "hard",
    name: "Mallet hardness",
    unit: "Pa",
    min: *range::HARDNESS_PA.start() as f32,
    max: *range::HARDNESS_PA.end() as f32,
    default: NORMAL.mallet.hardness_pa as f32,
    tooltip: "Stiffness of the mallet's head: 1 MPa is soft yarn, 1 GPa rawhide, 100 GPa brass. \
              Harder heads leave sooner and sound brighter, up to what the body itself withstands.",
    skew: 0.15,
    text: Text::Pascals,
};

/// Dynamics.
pub const VELOCITY_RANGE: Spec = Spec {
    id: "vrng",
    name: "Velocity range",
    unit: "dB",
    min: *range::VELOCITY_RANGE_DB.start() as f32,
    max: *range::VELOCITY_RANGE_DB.end() as f32,
    default: NORMAL.velocity_range_db as f32,
    tooltip: "How much softer the softest strike is than the hardest. Soft strikes are also duller.",
    skew: 1.0,
    text: Text::Decibels,
};

/// Stiffness-proportional damping.
pub const ALPHA1: Spec = Spec {
    id: "alpha1",
    name: "Alpha 1",
    unit: "s",
    min: *range::ALPHA1_S.start() as f32,
    max: *range::ALPHA1_S.end() as f32,
    default: NORMAL.losses.added.rayleigh.alpha1_s as f32,
    tooltip: "Adds damping to the material's own that takes high partials first: 1e-7 s rings like \
              metal, 1e-6 s like ceramic, 8e-6 s like wood. Changes what is already ringing.",
    skew: 0.25,
    text: Text::Seconds,
};

/// Mass-proportional damping.
pub const ALPHA2: Spec = Spec {
    id: "alpha2",
    name: "Alpha 2",
    unit: "1/s",
    min: *range::ALPHA2_PER_S.start() as f32,
    max: *range::ALPHA2_PER_S.end() as f32,
    default: NORMAL.losses.added.rayleigh.alpha2_per_s as f32,
    tooltip: "Adds damping that shortens all partials alike: 0 leaves them as they are, 50 1/s is a \
              dull knock. Changes what is already ringing.",
    skew: 0.35,
    text: Text::PerSecond,
};

/// Factor on the material's own damping.
pub const OWN_DAMPING: Spec = Spec {
    id: "own",
    name: "Own damping",
    unit: "x",
    min: *range::CAUSE.start() as f32,
    max: *range::CAUSE.end() as f32,
    default: NORMAL.losses.own as f32,
    tooltip: "How much of the material's own damping counts: 1 x is the instrument as built, 0 x a \
              material that never tires. Changes what is already ringing.",
    skew: 0.3,
    text: Text::Factor,
};

/// Added loss factor.
pub const LOSS_FACTOR: Spec = Spec {
    id: "tanphi",
    name: "Loss factor",
    unit: "tan",
    min: *range::LOSS_FACTOR.start() as f32,
    max: *range::LOSS_FACTOR.end() as f32,
    default: NORMAL.losses.added.loss_factor as f32,
    tooltip: "Adds internal friction (tan phi) that takes the same share of every swing: 1e-4 is bell \
              metal, 1e-3 hard plastic, 1e-2 wood. Changes what is already ringing.",
    skew: 0.25,
    text: Text::Tangent,
};

/// Factor on what radiation takes.
pub const RADIATION: Spec = Spec {
    id: "radia",
    name: "Radiation damping",
    unit: "x",
    min: *range::CAUSE.start() as f32,
    max: *range::CAUSE.end() as f32,
    default: NORMAL.losses.radiation as f32,
    tooltip: "How much the air shortens what it carries away: 1 x is real, 0 x lets the high partials \
              of large bodies ring on as in a vacuum. Changes what is already ringing.",
    skew: 0.3,
    text: Text::Factor,
};

/// Factor on what the supports take.
pub const SUPPORTS: Spec = Spec {
    id: "suppt",
    name: "Supports",
    unit: "x",
    min: *range::CAUSE.start() as f32,
    max: *range::CAUSE.end() as f32,
    default: NORMAL.losses.supports as f32,
    tooltip: "How firmly cords and cushions hold: more shortens the partials that move where the body \
              is held. Changes what is already ringing.",
    skew: 0.3,
    text: Text::Factor,
};

/// Which bodies are struck.
pub const INSTRUMENT: Spec = Spec {
    id: "instr",
    name: "Instrument",
    unit: "",
    min: 0.0,
    max: (crate::factory::BANKS.len() - 1) as f32,
    default: 0.0,
    tooltip: "Which bodies are struck. The next notes strike the new ones; what rings, rings out.",
    skew: 1.0,
    text: Text::Instrument,
};

/// What a released key does.
pub const NOTE_OFF: Spec = Spec {
    id: "noff",
    name: "Note-off",
    unit: "",
    min: 0.0,
    max: 1.0,
    default: NORMAL.note_off_damps as u8 as f32,
    tooltip: "Whether a released key leaves its body ringing or lays a felt damper on it; the sustain \
              pedal keeps the dampers off.",
    skew: 1.0,
    text: Text::Switch {
        off: "rings on",
        on: "damps",
    },
};

/// Speed of the resonators' discs.
pub const MOTOR_SPEED: Spec = Spec {
    id: "mspeed",
    name: "Motor speed",
    unit: "Hz",
    min: *range::MOTOR_HZ.start() as f32,
    max: *range::MOTOR_HZ.end() as f32,
    default: NORMAL.motor.speed_hz as f32,
    tooltip: "How often a second the motor's discs shut the tubes under the bars: the vibraphone's \
              vibrato. 0 Hz stops them. Bodies without tubes do not change.",
    skew: 1.0,
    text: Text::Hertz,
};

/// Depth of the resonators' discs.
pub const MOTOR_DEPTH: Spec = Spec {
    id: "mdepth",
    name: "Motor depth",
    unit: "%",
    min: percent(*range::MOTOR_DEPTH.start()),
    max: percent(*range::MOTOR_DEPTH.end()),
    default: percent(NORMAL.motor.depth),
    tooltip: "How much of the tubes' mouths the discs cover when they lie across them: 100 % shuts them, \
              so that the fundamental comes and goes; 0 % leaves them open.",
    skew: 1.0,
    text: Text::Percent,
};

/// Phase of the resonators' discs.
pub const MOTOR_PHASE: Spec = Spec {
    id: "mphase",
    name: "Motor phase",
    unit: "deg",
    min: *range::MOTOR_DEG.start() as f32,
    max: *range::MOTOR_DEG.end() as f32,
    default: NORMAL.motor.phase_deg as f32,
    tooltip: "Angle of the discs ahead of the motor. With the motor stopped, 90 deg leaves the tubes open \
              (louder and shorter fundamentals) and 0 deg shuts them (softer and longer).",
    skew: 1.0,
    text: Text::Degrees,
};

/// Stereo width.
pub const WIDTH: Spec = Spec {
    id: "width",
    name: "Width",
    unit: "%",
    min: percent(*range::WIDTH.start()),
    max: percent(*range::WIDTH.end()),
    default: percent(NORMAL.width),
    tooltip: "How far apart the two ears hear: 100 % as a listener before the instrument does, with \
              the low bodies on the left; 0 % is mono.",
    skew: 1.0,
    text: Text::Percent,
};

/// Output gain.
pub const OUTPUT_GAIN: Spec = Spec {
    id: "gain",
    name: "Output gain",
    unit: "dB",
    min: *range::GAIN_DB.start() as f32,
    max: *range::GAIN_DB.end() as f32,
    default: NORMAL.gain_db as f32,
    tooltip: "Level of the whole. At 0 dB no single strike peaks above -15 dB full scale, so that chords fit.",
    skew: 1.0,
    text: Text::Decibels,
};

/// Every parameter, in the host's order.
pub const SPECS: [Spec; 18] = [
    INSTRUMENT,
    STRIKE_POSITION,
    VELOCITY_TO_POSITION,
    POSITION_SCATTER,
    MALLET_HARDNESS,
    VELOCITY_RANGE,
    ALPHA1,
    ALPHA2,
    OWN_DAMPING,
    LOSS_FACTOR,
    RADIATION,
    SUPPORTS,
    NOTE_OFF,
    MOTOR_SPEED,
    MOTOR_DEPTH,
    MOTOR_PHASE,
    WIDTH,
    OUTPUT_GAIN,
];

impl Spec {
    /// The parameter called `name`, in any case.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        SPECS
            .iter()
            .find(|spec| spec.name.eq_ignore_ascii_case(name.trim()))
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
            Text::Switch { off, on } => return format!("\"{off}\" or \"{on}\""),
            Text::Instrument => return crate::factory::titles().collect::<Vec<_>>().join(", "),
            _ => {}
        }
        format!("{} to {}", self.format(self.min), self.format(self.max))
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
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn ids_are_short_and_names_distinct() {
        let ids: HashSet<_> = SPECS.iter().map(|spec| spec.id).collect();
        let names: HashSet<_> = SPECS.iter().map(|spec| spec.name).collect();
        assert_eq!((ids.len(), names.len()), (SPECS.len(), SPECS.len()));
        for spec in &SPECS {
            assert!(spec.id.is_ascii() && spec.id.len() <= 6, "{}", spec.id);
            assert!(spec.min < spec.max && !spec.tooltip.is_empty());
            assert_eq!(spec.sane(spec.default), spec.default);
            assert_eq!(Spec::named(&spec.name.to_uppercase()), Some(spec));
        }
    }

    #[test]
    fn what_is_shown_parses_back_to_the_shown_digits() {
        for spec in &SPECS {
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
            (&STRIKE_POSITION, "12.34%", 12.34),
            (&STRIKE_POSITION, " 7 ", 7.0),
            (&MALLET_HARDNESS, "1 GPa", 1e9),
            (&MALLET_HARDNESS, "20mpa", 2e7),
            (&MALLET_HARDNESS, "1500 kPa", 1.5e6),
            (&ALPHA1, "100 ns", 1e-7),
            (&ALPHA1, "0.1 us", 1e-7),
            (&ALPHA1, "0.1 \u{b5}s", 1e-7),
            (&ALPHA1, "0.1 \u{3bc}S", 1e-7),
            (&ALPHA1, "1.00E-7 S", 1e-7),
            (&ALPHA1, "8e-6", 8e-6),
            (&ALPHA2, "50 1/s", 50.0),
            (&ALPHA2, "51/s", 51.0),
            (&OUTPUT_GAIN, "-6 dB", -6.0),
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
            (&STRIKE_POSITION, "101 %"),
            (&STRIKE_POSITION, "-0.01"),
            (&STRIKE_POSITION, "3 dB"),
            (&MALLET_HARDNESS, "1 kPa"),
            (&ALPHA1, "1 ms"),
            (&ALPHA1, "nan"),
            (&ALPHA2, "inf 1/s"),
            (&OUTPUT_GAIN, ""),
            (&OUTPUT_GAIN, "loud"),
            (&NOTE_OFF, "2"),
        ] {
            assert_eq!(spec.parse(text), None, "{}: {text}", spec.name);
        }
        assert_eq!(STRIKE_POSITION.allowed(), "0.00 % to 100.00 %");
        assert_eq!(ALPHA1.allowed(), "0 s to 2.00e-5 s");
    }
}
