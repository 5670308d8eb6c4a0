//! The layout of a bank file.
//!
//! | bytes | content |
//! |---|---|
//! | 0…7 | [`MAGIC`] |
//! | 8…11 | format version, u32 |
//! | 12…19 | length of the file, u64 |
//! | 20…23 | CRC-32 of all other bytes, u32 |
//! | 24…27 | length of the header, u32 |
//! | 28… | [`Header`] as JSON |
//! | then | a section for each body, holding [`ARRAYS`] one after the other |
//!
//! Version 4 is the same without shapes that are products of tables and what is enough for a key, version
//! 3 also without bodies of their own matter and zones of their own rule, version 2 also without rows,
//! surfaces and spread.
//!
//! Numbers are little-endian. The first 24 bytes stay as they are in every version.

use super::{Matter, Provenance, Spread};
use crate::{Damping, Family, Material, Member};
use serde::{Deserialize, Serialize};

/// Starts every bank. The bytes around the letters show a file that was mangled as text.
pub(super) const MAGIC: [u8; 8] = *b"\x89IDBK\r\n\x1a";
/// The version written, and the newest read.
pub(super) const VERSION: u32 = 5;
/// The oldest version read.
pub(super) const OLDEST: u32 = 2;
/// Bytes up to and with the checksum.
pub(super) const PRELUDE_LEN: usize = 24;
/// Where the checksum stands.
pub(super) const CHECKSUM_AT: usize = 20;
/// Longest file that is read: a hundred times a large bank.
pub(super) const MAX_LEN: u64 = 1 << 30;

/// The JSON header.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Header {
    pub(super) format: String,
    pub(super) name: String,
    pub(super) title: String,
    pub(super) material: Material,
    pub(super) damping: Damping,
    pub(super) ears_m: [[f64; 3]; 2],
    pub(super) provenance: Provenance,
    #[serde(default)]
    pub(super) spread: Option<Spread>,
    pub(super) bodies: Vec<BodyEntry>,
    pub(super) arrays: Vec<ArrayEntry>,
}

/// What [`Header::format`] says.
pub(super) const FORMAT: &str = "Idiophone bank: SI units, little-endian, offsets from the end \
                                 of this header";

/// A body in the header.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BodyEntry {
    pub(super) key: u8,
    pub(super) pitch_hz: f64,
    pub(super) length_m: f64,
    pub(super) mass_kg: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) matter: Option<Matter>,
    pub(super) modes: u64,
    pub(super) points: u64,
    #[serde(default = "one")]
    pub(super) rows: u64,
    #[serde(default)]
    pub(super) closed: bool,
    #[serde(default)]
    pub(super) surface: Option<SurfaceEntry>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) tables: Option<TablesEntry>,
    pub(super) offset: u64,
}

fn one() -> u64 {
    1
}

/// A body's surface in the header.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SurfaceEntry {
    pub(super) length_m: f64,
    pub(super) points: u64,
    pub(super) triangles: u64,
    pub(super) motions: u64,
}

/// A body's tables in the header.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TablesEntry {
    /// Samples to a step of the strike grid along and across.
    pub(super) finer: [u64; 2],
    /// Functions along and across.
    pub(super) functions: [u64; 2],
}

impl Header {
    /// The oldest version that has all that is in it.
    pub(super) fn needs(&self) -> u32 {
        let enough = |spread: &Spread| spread.enough.is_some();
        if self.spread.as_ref().is_some_and(enough)
            || self.bodies.iter().any(|body| body.tables.is_some())
        {
            return 5;
        }
        let ruled = |spread: &Spread| spread.zones.iter().any(|zone| zone.rule.is_some());
        if self.spread.as_ref().is_some_and(ruled)
            || self.bodies.iter().any(|body| body.matter.is_some())
        {
            return 4;
        }
        let grid = |body: &BodyEntry| body.rows != 1 || body.closed || body.surface.is_some();
        if self.spread.is_some() || self.bodies.iter().any(grid) {
            return 3;
        }
        OLDEST
    }
}

/// An array of a body's section, described in the header.
#[derive(PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ArrayEntry {
    pub(super) name: String,
    pub(super) elements: String,
    pub(super) unit: String,
}

/// Name, elements and unit of the arrays of a section, in their order.
pub(super) const ARRAYS: [[&str; 3]; 16] = [
    ["points", "f64[points][3]", "m"],
    ["normals", "f64[points][3]", "1"],
    ["hz", "f64[modes]", "Hz"],
    ["coupling", "f64[modes]", "m^2 kg^(-1/2)/s"],
    ["residual", "f64[modes]", "1"],
    [
        "air",
        "[modes]{ears f32[left, right][re, im] Pa kg^(-1/2)/m, pipe ears the same, radiation, \
         support, felt and pipe decay rate f32[4] 1/s}",
        "as said",
    ],
    [
        "label",
        "[modes]{family u8 (0 bending, 1 torsion, 2 longitudinal, 3 wall, 4 other, \
         5 lateral, 6 shell, 7 membrane, 8 plate), \
         member u8 (0 single, 1 a, 2 b), order u16, index u16}",
        "1",
    ],
    [
        "components",
        "u8[modes], bits 1 x, 2 y, 4 z: those of the shape that are not zero at every point; bit 8: \
         only the first half of the points is stored, middle included, the rest mirrors it with \
         the signs of bits 16 x, 32 y, 64 z (set: opposite); 128 alone: nothing is stored, the shape \
         is a product",
        "1",
    ],
    [
        "shape",
        "[modes][stored components] f32[stored points]",
        "kg^(-1/2)",
    ],
    ["surface points", "f32[surface points][3]", "m"],
    ["surface triangles", "u32[triangles][3]", "1"],
    ["surface step", "f32[motions]", "kg^(-1/2)"],
    [
        "surface motion",
        "i8[motions][surface points][3]",
        "surface step",
    ],
    [
        "table along",
        "f32[(points of a row - 1) finer + 1][functions]",
        "1",
    ],
    [
        "table across",
        "f32[(rows - 1) finer + 1, or rows finer where they are closed][functions]",
        "1",
    ],
    [
        "product",
        "[modes of a body with tables]{function along u16, function across u16, height f32}: the \
         shape is height times both, along the normals",
        "kg^(-1/2)",
    ],
];

/// Bytes of a point with its normal.
pub(super) const POINT_LEN: u64 = 48;
/// Bytes of a mode without its shape.
pub(super) const MODE_LEN: u64 = 79;
/// Bytes of a mode's ears and rates.
pub(super) const AIR_LEN: usize = 48;
/// Bytes of a surface's point, of its triangle and of a motion without its points.
pub(super) const SURFACE_LENS: [u64; 3] = [12, 12, 4];
/// Bytes of a surface's point in motion.
pub(super) const MOTION_LEN: u64 = 3;

/// Bytes of a mode's product.
pub(super) const PRODUCT_LEN: u64 = 8;

/// Where versions before 5 describe an array otherwise: its number, and its elements in them.
const COMPONENTS_BEFORE_5: (usize, &str) = (
    7,
    "u8[modes], bits 1 x, 2 y, 4 z: those of the shape that are not zero at every point; bit 8: \
     only the first half of the points is stored, middle included, the rest mirrors it with \
     the signs of bits 16 x, 32 y, 64 z (set: opposite)",
);

/// The arrays of a section in a file of `version`.
pub(super) fn described_arrays(version: u32) -> Vec<ArrayEntry> {
    let count = match version {
        ..3 => 9,
        3 | 4 => 13,
        _ => ARRAYS.len(),
    };
    let mut arrays = ARRAYS;
    if version < 5 {
        let (number, elements) = COMPONENTS_BEFORE_5;
        arrays[number][1] = elements;
    }
    let entry = |[name, elements, unit]: [&str; 3]| ArrayEntry {
        name: name.to_owned(),
        elements: elements.to_owned(),
        unit: unit.to_owned(),
    };
    arrays.into_iter().take(count).map(entry).collect()
}

/// CRC-32 of a file but for the checksum itself.
pub(super) fn checksum(file: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&file[..CHECKSUM_AT]);
    hasher.update(&file[PRELUDE_LEN..]);
    hasher.finalize()
}

/// Families by their number in a file.
pub(super) const FAMILIES: [Family; 9] = [
    Family::Bending,
    Family::Torsion,
    Family::Longitudinal,
    Family::Wall,
    Family::Other,
    Family::Lateral,
    Family::Shell,
    Family::Membrane,
    Family::Plate,
];

/// Members by their number in a file.
pub(super) const MEMBERS: [Member; 3] = [Member::Single, Member::A, Member::B];

pub(super) const fn family_number(family: Family) -> u8 {
    match family {
        Family::Bending => 0,
        Family::Torsion => 1,
        Family::Longitudinal => 2,
        Family::Wall => 3,
        Family::Other => 4,
        Family::Lateral => 5,
        Family::Shell => 6,
        Family::Membrane => 7,
        Family::Plate => 8,
    }
}

pub(super) const fn member_number(member: Member) -> u8 {
    match member {
        Member::Single => 0,
        Member::A => 1,
        Member::B => 2,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_names_go_both_ways() {
        for (number, &family) in FAMILIES.iter().enumerate() {
            assert_eq!(usize::from(family_number(family)), number);
        }
        for (number, &member) in MEMBERS.iter().enumerate() {
            assert_eq!(usize::from(member_number(member)), number);
        }
    }

    /// The check value of CRC-32/ISO-HDLC: that of the nine digits is CBF43926.
    #[test]
    fn the_checksum_is_crc_32_and_leaves_itself_out() {
        let mut file = [0; PRELUDE_LEN + 9];
        file[PRELUDE_LEN..].copy_from_slice(b"123456789");
        let mut shorter = [0; CHECKSUM_AT + 9];
        shorter[CHECKSUM_AT..].copy_from_slice(b"123456789");
        assert_eq!(checksum(&file), crc32fast::hash(&shorter));
        assert_eq!(crc32fast::hash(b"123456789"), 0xcbf4_3926);
        file[CHECKSUM_AT] = 7;
        assert_eq!(checksum(&file), crc32fast::hash(&shorter));
    }
}
