//! Banks of shapes that are products.

use super::sample::grid_bank;
use super::tests::{inconsistent_field, seal, with_header};
use super::{Bank, Enough};
use crate::{ModeShape, Motions, ShapeTables, StrikeGrid, StrikeLine};
use std::sync::Arc;

const STRIKE: StrikeGrid = StrikeGrid {
    columns: 7,
    rows: 5,
    closed: false,
};

fn tables(size: f32) -> Arc<ShapeTables> {
    let [along, across] = ShapeTables::samples_of(STRIKE, [2, 3]).unwrap();
    let values = [3 * along, 2 * across].map(|count| {
        let value = |i: usize| size * (i as f32).sin();
        (0..count).map(value).collect()
    });
    Arc::new(ShapeTables::new(STRIKE, [2, 3], values).unwrap())
}

/// The sample's body as a flat one whose modes are products.
fn sheet_bank() -> Bank {
    let mut bank = grid_bank();
    let body = &mut bank.bodies[0];
    body.line = StrikeLine {
        points_m: (0..35).map(|i| [f64::from(i), 0.0, 0.0]).collect(),
        normals: vec![[0.0, 0.0, 1.0]; 35],
        rows: 5,
        closed: false,
    };
    let tables = tables(1.0);
    for (i, mode) in body.modes.iter_mut().enumerate() {
        let which = [i as u32 % 3, i as u32 % 2];
        mode.shape = ModeShape::product(Arc::clone(&tables), which, 0.5 + i as f32);
    }
    bank
}

#[test]
fn products_come_back_as_they_were_and_take_a_few_bytes() {
    let bank = sheet_bank();
    bank.check().unwrap();
    let file = bank.write();
    let found = Bank::read(&file).unwrap();
    assert_eq!(found, bank);
    let shapes = |i: usize| found.bodies[0].modes[i].shape.as_product().unwrap();
    assert!(Arc::ptr_eq(shapes(0).tables, shapes(1).tables));
    let mut more = sheet_bank();
    let modes = &mut more.bodies[0].modes;
    for _ in 0..100 {
        modes.push(modes[modes.len() - 1].clone());
    }
    assert_eq!(more.write().len() - file.len(), 100 * (79 + 8) + 2);
}

/// A header's text as version 4 wrote it.
pub(super) fn before_5(text: String) -> String {
    let text = text.replace("; 128 alone: nothing is stored, the shape is a product", "");
    let first_new = text.find(",{\"name\":\"table along\"").unwrap();
    format!("{}]}}", &text[..first_new])
}

#[test]
fn files_of_version_4_are_read() {
    let mut file = with_header(&grid_bank(), before_5);
    file[8] = 4;
    assert_eq!(Bank::read(&seal(file)), Ok(grid_bank()));
}

#[test]
fn older_versions_have_neither_products_nor_enough() {
    let mut enough = grid_bank();
    let spread = enough.spread.as_mut().unwrap();
    spread.enough = Some(Enough {
        hz: 2000.0,
        modes: 2,
    });
    assert_eq!(Bank::read(&enough.write()).unwrap(), enough);
    for bank in [sheet_bank(), enough] {
        let mut file = with_header(&bank, before_5);
        file[8] = 4;
        assert_eq!(inconsistent_field(Bank::read(&seal(file))), "header");
    }
}

#[test]
fn impossible_products_are_refused() {
    type Change = fn(&mut Bank);
    let cases: [(&str, Change); 6] = [
        ("key 60: mode 2: shape", |b| {
            let points = b.bodies[0].modes[1].shape.iter().collect();
            b.bodies[0].modes[1].shape = points;
        }),
        ("key 60: mode 2: shape", |b| {
            b.bodies[0].modes[1].shape = ModeShape::product(tables(0.5), [0, 0], 1.0);
        }),
        ("key 60: mode 1: shape", |b| {
            let shape = &b.bodies[0].modes[0].shape;
            b.bodies[0].modes[0].shape = shape.scaled(f64::NAN);
        }),
        ("key 60: tables", |b| {
            for mode in &mut b.bodies[0].modes {
                mode.shape = ModeShape::product(tables(17.0), [0, 0], 1.0);
            }
        }),
        ("key 60: tables", |b| b.bodies[0].line.closed = true),
        ("key 60: normals", |b| {
            b.bodies[0].line.normals[3] = [0.0, 1.0, 0.0];
        }),
    ];
    for (field, change) in cases {
        let mut bad = sheet_bank();
        let key = bad.bodies[0].key;
        change(&mut bad);
        let field = field.replace("60", &key.to_string());
        assert_eq!(inconsistent_field(bad.check().map(|()| bad.clone())), field);
        assert!(Bank::read(&bad.write()).is_err(), "{field}");
    }
}

#[test]
fn a_function_that_is_not_there_is_refused() {
    let mut file = sheet_bank().write();
    // The last product's function across, before its height.
    let at = file.len() - 6;
    file[at..at + 2].copy_from_slice(&2u16.to_le_bytes());
    let field = inconsistent_field(Bank::read(&seal(file)));
    assert!(field.ends_with("product"), "{field}");
}

/// Keys have all modes up to the frequency, and at least so many.
#[test]
fn keys_have_what_is_enough_for_them() {
    let mut bank = sheet_bank();
    let keys_of = |bank: &Bank| bank.clone().spread_out().bodies;
    let spread = bank.spread.as_mut().unwrap();
    let hz = 5000.0;
    spread.enough = Some(Enough { hz, modes: 2 });
    let mut counts = Vec::new();
    for (body, whole) in keys_of(&bank).iter().zip(keys_of(&sheet_bank())) {
        let below = whole.modes.iter().filter(|mode| mode.hz <= hz).count();
        assert_eq!(body.modes[..], whole.modes[..below.max(2)], "{}", body.key);
        counts.push(body.modes.len());
    }
    counts.dedup();
    assert!(counts.len() > 1, "{counts:?}");
    bank.spread.as_mut().unwrap().enough = Some(Enough { hz: -1.0, modes: 2 });
    let refused = inconsistent_field(bank.check().map(|()| bank.clone()));
    assert_eq!(refused, "spread enough hz");
}

/// Whatever bytes are changed, the file is read or refused, and what is read can be struck.
#[test]
fn changed_bytes_do_not_panic() {
    let file = sheet_bank().write();
    let mut refused = 0;
    for at in 12..file.len() {
        for change in [1, 128] {
            let mut bad = file.clone();
            bad[at] ^= change;
            match Bank::read(&seal(bad)) {
                Ok(bank) => {
                    for body in &bank.spread_out().bodies {
                        let shapes = body.modes.iter().map(|mode| mode.shape.clone()).collect();
                        let motions = Motions::new(&body.line, shapes);
                        let mut scratch = vec![0.0; motions.scratch_len()];
                        motions.at([0.3, 0.7], &mut scratch, &mut [0.0; 4]);
                    }
                }
                Err(_) => refused += 1,
            }
        }
    }
    assert!(refused > 1000, "only {refused}");
}
