//! What is chosen for one body of the sheet.

use crate::mesher::{Facts, guessed_size_m};
use modes::{PieceOrder, Up};
use std::sync::Arc;

/// Material of a new body.
const USUAL: &str = "bell bronze";
/// Wall of a new body as a share of the size.
const WALL: f64 = 0.02;

/// What changes from key to key, as recipes have it, and as people do.
pub(super) const RULES: [(&str, &str); 4] = [
    ("size", "its size"),
    ("density", "its density"),
    ("stiffness", "its stiffness"),
    ("nothing", "nothing: its own pitch"),
];

/// Which mode is tuned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tuned {
    Lowest,
    Loudest,
    Number,
}

impl Tuned {
    pub(super) const ALL: [Self; 3] = [Self::Lowest, Self::Loudest, Self::Number];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Lowest => "lowest",
            Self::Loudest => "loudest",
            Self::Number => "number",
        }
    }
}

/// One body.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub(super) facts: Arc<Facts>,
    /// Names of the objects that are meant; all if none is named.
    pub(super) objects: Vec<String>,
    pub(super) material: &'static str,
    /// Longest side of the bounding box, in mm.
    pub(super) size_mm: f64,
    pub(super) hollow: bool,
    pub(super) wall_mm: f64,
    pub(super) up: Up,
    /// The place in [`RULES`] of what changes.
    pub(super) rule: usize,
    pub(super) tuned: Tuned,
    /// The mode that is tuned by its number, from 1.
    pub(super) number: u32,
    pub(super) keys: [u8; 2],
}

impl Piece {
    pub(super) fn of(facts: Arc<Facts>, keys: [u8; 2]) -> Self {
        let size_mm = 1e3 * guessed_size_m(facts.longest(&[]));
        Self {
            objects: Vec::new(),
            material: USUAL,
            size_mm,
            hollow: false,
            wall_mm: usual_wall_mm(size_mm),
            up: facts.up.unwrap_or_default(),
            rule: 0,
            tuned: Tuned::Lowest,
            number: 1,
            keys,
            facts,
        }
    }

    /// Means these objects from now on, as large beside each other as in the file.
    pub(super) fn choose(&mut self, objects: Vec<String>) {
        let unit_mm = self.size_mm / self.facts.longest(&self.objects).max(f64::MIN_POSITIVE);
        self.objects = objects;
        self.size_mm = (unit_mm * self.facts.longest(&self.objects)).clamp(1.0, 10_000.0);
    }

    /// Sounds at its own pitch from now on, on one key.
    pub(super) fn stand_alone(&mut self, key: u8) {
        let nothing = RULES.iter().position(|(by, _)| *by == "nothing");
        self.rule = nothing.unwrap_or_default();
        self.keys = [key, key];
    }

    /// Is as large from now on as units of its file make it that are so long.
    pub(super) fn measure(&mut self, unit_mm: f64) {
        let longest = self.facts.longest(&self.objects);
        self.size_mm = (unit_mm * longest).clamp(1.0, 10_000.0);
        self.wall_mm = usual_wall_mm(self.size_mm);
    }

    /// Which objects are meant, in words; none of a file with but one.
    pub(super) fn chosen(&self) -> Option<String> {
        match (&self.objects[..], self.facts.names().len()) {
            ([], 0 | 1) => None,
            ([], count) => Some(format!("all {count} in one")),
            (some, _) => Some(some.join(", ")),
        }
    }

    /// Whether each key is tuned.
    pub(super) fn is_tuned(&self) -> bool {
        RULES[self.rule].0 != "nothing"
    }

    /// What it is called in the list of bodies.
    pub(super) fn title(&self) -> String {
        let stem = self.facts.stem();
        match &self.objects[..] {
            [] => stem,
            some => format!("{stem}: {}", some.join(", ")),
        }
    }

    /// The order; none if the file's name is not in Unicode.
    pub(super) fn order(&self) -> Option<PieceOrder> {
        Some(PieceOrder {
            file: self.facts.path.to_str()?.to_owned(),
            objects: self.objects.clone(),
            material: self.material.to_owned(),
            size_m: Some(1e-3 * self.size_mm),
            unit_m: None,
            wall_m: self.hollow.then_some(1e-3 * self.wall_mm),
            up: self.up,
            keys: self.keys,
            by: RULES[self.rule].0.to_owned(),
            tuned: match self.tuned {
                Tuned::Number => self.number.to_string(),
                named => named.name().to_owned(),
            },
        })
    }
}

/// The wall of a new body of that size, in mm.
fn usual_wall_mm(size_mm: f64) -> f64 {
    (WALL * size_mm).max(0.5)
}
