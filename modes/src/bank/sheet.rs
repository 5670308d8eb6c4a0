//! Shapes that are products of tables, in a file.

use super::format::{BodyEntry, PRODUCT_LEN, TablesEntry};
use super::{BankError, Body};
use crate::{ModeShape, ShapeTables, StrikeLine};
use std::sync::Arc;

/// Stands among the components of a mode whose shape is a product.
pub(super) const PRODUCT: u8 = 128;

/// The tables of a body whose shapes are products: those of its first mode.
pub(super) fn tables_of(body: &Body) -> Option<&Arc<ShapeTables>> {
    let product = body.modes.first()?.shape.as_product()?;
    Some(product.tables)
}

/// What a header says of `tables`.
pub(super) fn entry(tables: &ShapeTables) -> TablesEntry {
    TablesEntry {
        finer: tables.finer().map(|steps| steps as u64),
        functions: tables.counts().map(|count| count as u64),
    }
}

/// Bytes of `tables` and of the products of so many modes.
pub(super) fn len(tables: &ShapeTables, modes: usize) -> u64 {
    let [along, across] = tables.values();
    4 * (along.len() + across.len()) as u64 + PRODUCT_LEN * modes as u64
}

/// Adds `tables` and which of them make up the body's shapes; shapes that are no products of them are
/// left out, for the reader to refuse.
pub(super) fn write(body: &Body, tables: &Arc<ShapeTables>, file: &mut Vec<u8>) {
    for value in tables.values().into_iter().flatten() {
        file.extend((value + 0.0).to_le_bytes());
    }
    for product in body.modes.iter().filter_map(|mode| mode.shape.as_product()) {
        if !Arc::ptr_eq(product.tables, tables) && product.tables != tables {
            continue;
        }
        for number in product.which {
            file.extend(u16::try_from(number).unwrap_or(u16::MAX).to_le_bytes());
        }
        file.extend((product.height + 0.0).to_le_bytes());
    }
}

/// Bytes of the tables along and across of a body that is struck on `line`.
pub(super) fn table_lens(entry: &TablesEntry, line: &StrikeLine) -> Result<[u64; 2], BankError> {
    let wrong = || {
        let allowed =
            "such that every step of the strike grid has a sample, and no more than can be";
        BankError::inconsistent("tables", format!("{:?}", entry.finer), allowed)
    };
    let samples = ShapeTables::samples_of(line.grid(), finer(entry)).ok_or_else(wrong)?;
    let len = |axis: usize| {
        let values = (samples[axis] as u64).checked_mul(entry.functions[axis])?;
        values.checked_mul(4)
    };
    Ok([len(0).ok_or_else(wrong)?, len(1).ok_or_else(wrong)?])
}

fn finer(entry: &TablesEntry) -> [usize; 2] {
    entry
        .finer
        .map(|steps| usize::try_from(steps).unwrap_or(usize::MAX))
}

/// The tables of a body in a header with these bytes along and across.
pub(super) fn tables(
    entry: &TablesEntry,
    line: &StrikeLine,
    bytes: [&[u8]; 2],
) -> Result<Arc<ShapeTables>, BankError> {
    let values = bytes.map(|bytes| {
        let words = bytes.as_chunks().0.iter();
        words.map(|word| f32::from_le_bytes(*word)).collect()
    });
    let tables = ShapeTables::new(line.grid(), finer(entry), values);
    let none = || BankError::inconsistent("tables", "of no functions", "of at least one each way");
    tables.map(Arc::new).ok_or_else(none)
}

/// The shape that `bytes` say is made up of `tables`.
pub(super) fn shape(
    tables: &Arc<ShapeTables>,
    bytes: &[u8; PRODUCT_LEN as usize],
) -> Result<ModeShape, BankError> {
    let [a0, a1, b0, b1, height @ ..] = *bytes;
    let which = [[a0, a1], [b0, b1]].map(u16::from_le_bytes);
    let counts = tables.counts();
    if (0..2).any(|axis| usize::from(which[axis]) >= counts[axis]) {
        let found = format!("{which:?} of {counts:?}");
        return Err(BankError::inconsistent(
            "product",
            found,
            "below the numbers of functions",
        ));
    }
    let height = f32::from_le_bytes(height);
    Ok(ModeShape::product(
        Arc::clone(tables),
        which.map(u32::from),
        height,
    ))
}

/// Whether `bits` and the header say that a mode of `entry` is a product.
pub(super) fn is_product(entry: &BodyEntry, bits: u8) -> bool {
    entry.tables.is_some() && bits == PRODUCT
}
