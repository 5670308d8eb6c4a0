//! Bytes to a bank, whatever the bytes.

use super::check_surface::check_motions;
use super::format::{
    AIR_LEN, BodyEntry, CHECKSUM_AT, FAMILIES, FORMAT, Header, MAGIC, MAX_LEN, MEMBERS, MODE_LEN,
    MOTION_LEN, OLDEST, POINT_LEN, PRELUDE_LEN, PRODUCT_LEN, SURFACE_LENS, SurfaceEntry,
    TablesEntry, VERSION, checksum, described_arrays,
};
use super::mirror::Stored;
use super::sheet;
use super::{Bank, BankError, Body, Mode, Surface, SurfaceMotion};
use crate::{ModeLabel, ModeShape, StrikeLine};
use std::sync::Arc;

impl Bank {
    /// The bank that `file` is the content of.
    ///
    /// Takes no more memory than a few times the bytes given, whatever they say.
    ///
    /// # Errors
    ///
    /// If the bytes are not a whole, undamaged and possible bank of a known version.
    pub fn read(file: &[u8]) -> Result<Self, BankError> {
        let expected = stated_len(file)?;
        let found = file.len() as u64;
        if found < expected {
            return Err(BankError::Truncated { expected, found });
        }
        if found > expected || checksum(file) != u32_at(file, CHECKSUM_AT) {
            return Err(BankError::Corrupted);
        }
        let version = u32_at(file, MAGIC.len());
        match version {
            OLDEST..=VERSION => {}
            0 => return Err(BankError::inconsistent("format version", 0, "at least 1")),
            1..OLDEST => return Err(BankError::PastVersion { found: version }),
            found => {
                return Err(BankError::FutureVersion {
                    found,
                    newest: VERSION,
                });
            }
        }
        let mut content = Reader(&file[PRELUDE_LEN..]);
        let header_len = u32::from_le_bytes(content.take("header")?);
        let header = content.slice("header", u64::from(header_len))?;
        let header: Header = serde_json::from_slice(header).map_err(|error| {
            // What the error quotes from the file is cut to one line.
            let quoted = error.to_string();
            let line: String = quoted
                .chars()
                .filter(|c| !c.is_control())
                .take(200)
                .collect();
            BankError::inconsistent("header", line, "as this version writes it")
        })?;
        if version < header.needs()
            || header.format != FORMAT
            || header.arrays != described_arrays(version)
        {
            return Err(BankError::inconsistent(
                "header",
                "a description of another layout",
                "as this version writes it",
            ));
        }
        let bank = Self {
            name: header.name,
            title: header.title,
            material: header.material,
            damping: header.damping,
            ears_m: header.ears_m,
            provenance: header.provenance,
            bodies: read_bodies(&header.bodies, content)?,
            spread: header.spread,
        };
        bank.check()?;
        Ok(bank)
    }
}

/// Length in bytes that a file states in its first bytes.
pub(super) fn stated_len(start: &[u8]) -> Result<u64, BankError> {
    let shown = start.len().min(MAGIC.len());
    if start[..shown] != MAGIC[..shown] {
        return Err(BankError::Foreign);
    }
    let Some(bytes) = start[..start.len().min(PRELUDE_LEN)].get(12..PRELUDE_LEN) else {
        return Err(BankError::Truncated {
            expected: PRELUDE_LEN as u64,
            found: start.len() as u64,
        });
    };
    let mut len = [0; 8];
    len.copy_from_slice(&bytes[..8]);
    let len = u64::from_le_bytes(len);
    // A length that no bank has was not written as such.
    if !(PRELUDE_LEN as u64..=MAX_LEN).contains(&len) {
        return Err(BankError::Corrupted);
    }
    Ok(len)
}

fn u32_at(file: &[u8], at: usize) -> u32 {
    let mut bytes = [0; 4];
    bytes.copy_from_slice(&file[at..at + 4]);
    u32::from_le_bytes(bytes)
}

fn read_bodies(entries: &[BodyEntry], mut sections: Reader) -> Result<Vec<Body>, BankError> {
    let all = sections.0.len();
    let mut bodies = Vec::with_capacity(entries.len());
    for entry in entries {
        let place = format!("key {}", entry.key);
        let offset = (all - sections.0.len()) as u64;
        if entry.offset != offset {
            let allowed = "the end of the section before";
            return Err(BankError::inconsistent("offset", entry.offset, allowed).within(place));
        }
        bodies.push(read_body(entry, &mut sections).map_err(|error| error.within(place))?);
    }
    if !sections.0.is_empty() {
        let left = format!("{} bytes longer than the bodies", sections.0.len());
        return Err(BankError::inconsistent(
            "length",
            left,
            "that of the bodies",
        ));
    }
    Ok(bodies)
}

fn read_body(entry: &BodyEntry, sections: &mut Reader) -> Result<Body, BankError> {
    let mut arrays = sections.counted("points", entry.points, POINT_LEN)?;
    let points = arrays.0.len() / POINT_LEN as usize;
    let line = StrikeLine {
        points_m: arrays.vectors(points),
        normals: arrays.vectors(points),
        rows: usize::try_from(entry.rows).unwrap_or(usize::MAX),
        closed: entry.closed,
    };
    let mut arrays = sections.counted("modes", entry.modes, MODE_LEN)?;
    let count = arrays.0.len() / MODE_LEN as usize;
    let mut modes: Vec<Mode> = Vec::with_capacity(count);
    let [hz, coupling, residual] = [(); 3].map(|()| arrays.f64s(count));
    let (air, rest) = arrays.0.split_at(AIR_LEN * count);
    let (labels, components) = rest.split_at(6 * count);
    for i in 0..count {
        let [l0, l1, r0, r1, pl0, pl1, pr0, pr1, rates @ ..] = air_at(air, i);
        let label = label(&labels[6 * i..6 * i + 6]);
        modes.push(Mode {
            hz: hz[i],
            coupling: coupling[i],
            ears: [[l0, l1], [r0, r1]],
            pipe_ears: [[pl0, pl1], [pr0, pr1]],
            radiation_per_s: rates[0],
            support_per_s: rates[1],
            felt_per_s: rates[2],
            pipe_per_s: rates[3],
            residual: residual[i],
            label: label.map_err(|error| error.within(format!("mode {}", i + 1)))?,
            shape: ModeShape::from(Vec::new()),
        });
    }
    for (i, (mode, &bits)) in modes.iter_mut().zip(components).enumerate() {
        if sheet::is_product(entry, bits) {
            continue;
        }
        mode.shape = shape(bits, line.len(), sections)
            .map_err(|error| error.within(format!("mode {}", i + 1)))?;
    }
    let surface = entry.surface.as_ref();
    let surface = surface.map(|entry| surface_of(entry, sections).map(Arc::new));
    let surface = surface.transpose()?;
    if let Some(tables) = &entry.tables {
        read_products(tables, &line, &mut modes, sections)?;
    }
    Ok(Body {
        key: entry.key,
        pitch_hz: entry.pitch_hz,
        length_m: entry.length_m,
        mass_kg: entry.mass_kg,
        matter: entry.matter,
        line,
        surface,
        modes,
    })
}

/// Gives `modes` the products that follow their body's tables.
fn read_products(
    entry: &TablesEntry,
    line: &StrikeLine,
    modes: &mut [Mode],
    sections: &mut Reader,
) -> Result<(), BankError> {
    let [along, across] = sheet::table_lens(entry, line)?;
    let along = sections.slice("table along", along)?;
    let across = sections.slice("table across", across)?;
    let tables = sheet::tables(entry, line, [along, across])?;
    let products = sections.slice("product", PRODUCT_LEN * modes.len() as u64)?;
    for (mode, bytes) in modes.iter_mut().zip(products.as_chunks().0) {
        mode.shape = sheet::shape(&tables, bytes)?;
    }
    Ok(())
}

fn label(bytes: &[u8]) -> Result<ModeLabel, BankError> {
    let u16_at = |at: usize| u16::from_le_bytes([bytes[at], bytes[at + 1]]);
    let [family, member] = [bytes[0], bytes[1]];
    Ok(ModeLabel {
        family: *FAMILIES
            .get(usize::from(family))
            .ok_or_else(|| BankError::inconsistent("family", family, "0 to 8"))?,
        order: u16_at(2),
        index: u16_at(4),
        member: *MEMBERS
            .get(usize::from(member))
            .ok_or_else(|| BankError::inconsistent("member", member, "0 to 2"))?,
    })
}

fn shape(bits: u8, points: usize, sections: &mut Reader) -> Result<ModeShape, BankError> {
    let stored = Stored::from_bits(bits, points)?;
    let mut values = Reader(sections.slice("shape", stored.len())?);
    let mut shape = vec![[0.0; 3]; points];
    for c in stored.components() {
        let bytes = values
            .0
            .split_off(..4 * stored.points())
            .unwrap_or_default();
        for (phi, value) in shape.iter_mut().zip(bytes.as_chunks().0) {
            phi[c] = f32::from_le_bytes(*value);
        }
    }
    stored.complete(&mut shape);
    Ok(shape.into())
}

fn surface_of(entry: &SurfaceEntry, sections: &mut Reader) -> Result<Surface, BankError> {
    let [point, triangle, motion] = SURFACE_LENS;
    let points = sections.counted("surface points", entry.points, point)?;
    let triangles = sections.counted("surface triangles", entry.triangles, triangle)?;
    let steps = sections.counted("surface motions", entry.motions, motion)?;
    check_motions(steps.0.len() / motion as usize)?;
    let points_m: Vec<[f32; 3]> = points.words(f32::from_le_bytes).as_chunks().0.to_vec();
    let moving = MOTION_LEN * points_m.len() as u64;
    let motions = steps.words(f32::from_le_bytes).into_iter().map(|step| {
        let bytes = sections.slice("surface motion", moving)?;
        let points = bytes.as_chunks().0.iter();
        Ok(SurfaceMotion {
            step,
            points: points.map(|u: &[u8; 3]| u.map(u8::cast_signed)).collect(),
        })
    });
    Ok(Surface {
        length_m: entry.length_m,
        motions: motions.collect::<Result<_, BankError>>()?,
        points_m,
        triangles: triangles.words(u32::from_le_bytes).as_chunks().0.to_vec(),
    })
}

/// Ears and rates of mode `i`.
fn air_at(air: &[u8], i: usize) -> [f32; AIR_LEN / 4] {
    let mut numbers = [0.0; AIR_LEN / 4];
    for (number, bytes) in numbers.iter_mut().zip(air[AIR_LEN * i..].as_chunks().0) {
        *number = f32::from_le_bytes(*bytes);
    }
    numbers
}

/// The bytes not yet read.
struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    /// The next `len` bytes, which hold `field`.
    fn slice(&mut self, field: &str, len: u64) -> Result<&'a [u8], BankError> {
        let slice = usize::try_from(len)
            .ok()
            .and_then(|len| self.0.split_off(..len));
        slice.ok_or_else(|| {
            BankError::inconsistent(field, format!("{len} bytes"), "no more than the file holds")
        })
    }

    fn take<const N: usize>(&mut self, field: &str) -> Result<[u8; N], BankError> {
        let mut bytes = [0; N];
        bytes.copy_from_slice(self.slice(field, N as u64)?);
        Ok(bytes)
    }

    /// The next `count` elements of `len` bytes each, once it is known that they are there.
    fn counted(&mut self, field: &str, count: u64, len: u64) -> Result<Self, BankError> {
        match count.checked_mul(len) {
            Some(bytes) => self.slice(field, bytes).map(Self),
            None => Err(BankError::inconsistent(
                field,
                count,
                "no more than the file holds",
            )),
        }
    }

    /// The next `count` numbers, of which as many are read as are there.
    fn f64s(&mut self, count: usize) -> Vec<f64> {
        let bytes = self.0.split_off(..8 * count).unwrap_or_default();
        let numbers = bytes.as_chunks().0.iter();
        numbers.map(|&bytes| f64::from_le_bytes(bytes)).collect()
    }

    /// All that is left, four bytes at a time.
    fn words<T>(&self, word: impl Fn([u8; 4]) -> T) -> Vec<T> {
        self.0
            .as_chunks()
            .0
            .iter()
            .map(|&bytes| word(bytes))
            .collect()
    }

    fn vectors(&mut self, count: usize) -> Vec<[f64; 3]> {
        self.f64s(3 * count).as_chunks().0.to_vec()
    }
}
