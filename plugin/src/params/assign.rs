//! Who moves what.

use super::Spec;
use super::build::{choice, float, index, share};
use super::choice::Choice;
use crate::hands::{Assignment, SLOTS, Source, Target};
use nice_plug::prelude::{FloatParam, IntParam, Params};
use std::ops::RangeInclusive;

const EITHER_WAY: RangeInclusive<f64> = -1.0..=1.0;

/// The four parameters of an assignment.
macro_rules! specs {
    ($number:literal) => {{
        const NORMAL: Assignment = Assignment::DEFAULT[$number - 1];
        [
            Spec {
                id: concat!("src_", $number),
                name: concat!("Assign ", $number, " source"),
                tooltip: "What the hands do that moves the target: a wheel, a pedal, pressure, how a key \
                          was struck or let go, where it is, or chance. At rest it moves nothing.",
                ..Spec::choice(Choice::Source, NORMAL.source as usize)
            },
            Spec {
                id: concat!("tgt_", $number),
                name: concat!("Assign ", $number, " target"),
                tooltip: "What the source moves: what rings (level, bend, pan, hand damping, dampers, bow), \
                          the next strikes (position, hardness, mass), or the whole (motor, distance).",
                ..Spec::choice(Choice::Target, NORMAL.target as usize)
            },
            Spec {
                id: concat!("dep_", $number),
                name: concat!("Assign ", $number, " depth"),
                tooltip: "How far the source moves the target, as a share of the target's span; below 0 the \
                          other way.",
                ..Spec::percent(&EITHER_WAY, NORMAL.depth)
            },
            Spec {
                id: concat!("crv_", $number),
                name: concat!("Assign ", $number, " curve"),
                tooltip: "How the source's middle counts: above 0 its small values already move much, below \
                          0 only its great ones do.",
                ..Spec::percent(&EITHER_WAY, NORMAL.curve)
            },
        ]
    }};
}

/// Source, target, depth and curve of each assignment.
pub const SPECS: [[Spec; 4]; SLOTS] = [
    specs!(1),
    specs!(2),
    specs!(3),
    specs!(4),
    specs!(5),
    specs!(6),
    specs!(7),
    specs!(8),
];

/// One assignment; see [`SPECS`].
#[derive(Params)]
pub struct Assign {
    /// What moves.
    #[id = "src"]
    pub source: IntParam,
    /// What is moved.
    #[id = "tgt"]
    pub target: IntParam,
    /// How far.
    #[id = "dep"]
    pub depth: FloatParam,
    /// How evenly.
    #[id = "crv"]
    pub curve: FloatParam,
}

impl Assign {
    /// All of them.
    pub(super) fn all() -> [Self; SLOTS] {
        static ROWS: [[Spec; 4]; SLOTS] = SPECS;
        ROWS.each_ref().map(|[source, target, depth, curve]| Self {
            source: choice(source),
            target: choice(target),
            depth: float(depth),
            curve: float(curve),
        })
    }

    pub(super) fn assignment(&self) -> Assignment {
        Assignment {
            source: Source::from_index(index(&self.source)),
            target: Target::from_index(index(&self.target)),
            depth: share(&self.depth),
            curve: share(&self.curve),
        }
    }
}
