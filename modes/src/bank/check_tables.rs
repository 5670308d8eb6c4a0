//! Whether a body's shapes are products as they must be.

use super::check::MAX_SHAPE;
use super::sheet::tables_of;
use super::{BankError, Body};
use crate::{Product, ShapeTables};
use std::sync::Arc;

/// Greatest value of a function in a table.
const MAX_TABLE: f32 = 16.0;

/// Whether all of the body's shapes are products of tables for its strike line, if one is.
pub(super) fn check_tables(body: &Body) -> Result<(), BankError> {
    let product = |i: usize| body.modes[i].shape.as_product();
    let Some(tables) = tables_of(body) else {
        let odd = (0..body.modes.len()).find(|i| product(*i).is_some());
        return odd.map_or(Ok(()), |i| Err(mixed(i)));
    };
    let same = |i: usize| {
        let other = product(i).map(|product| product.tables);
        other.is_some_and(|other| Arc::ptr_eq(other, tables) || other == tables)
    };
    if let Some(odd) = (0..body.modes.len()).find(|i| !same(*i)) {
        return Err(mixed(odd));
    }
    if tables.strike() != body.line.grid() {
        let allowed = "for as many rows and points as the strike line has";
        let grid = format!("for {:?}", tables.strike());
        return Err(BankError::inconsistent("tables", grid, allowed));
    }
    if body.line.normals.iter().any(|n| *n != [0.0, 0.0, 1.0]) {
        let allowed = "[0, 0, 1] everywhere on a body whose shapes are products";
        return Err(BankError::inconsistent("normals", "others", allowed));
    }
    check_values(tables)
}

fn check_values(tables: &ShapeTables) -> Result<(), BankError> {
    let mut values = tables.values().into_iter().flatten();
    let inside = |x: &f32| (-MAX_TABLE..=MAX_TABLE).contains(x);
    match values.find(|x| !inside(x)) {
        Some(x) => Err(BankError::inconsistent("tables", x, "-16 to 16")),
        None => Ok(()),
    }
}

fn mixed(mode: usize) -> BankError {
    let allowed = "of all modes products of the same tables, or of none";
    BankError::inconsistent("shape", "another kind", allowed).within(format!("mode {}", mode + 1))
}

/// Whether a shape is of a possible height.
pub(super) fn check_product(product: Product<'_>) -> Result<(), BankError> {
    if (-MAX_SHAPE..=MAX_SHAPE).contains(&product.height) {
        return Ok(());
    }
    Err(BankError::inconsistent(
        "shape",
        product.height,
        "-1e9 to 1e9",
    ))
}
