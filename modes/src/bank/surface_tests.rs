//! Grids and surfaces in files.

use super::sample::{bank, grid_bank};
use super::tests::{inconsistent_field, seal, with_header};
use super::{Bank, BankError, Surface, SurfaceMotion};
use std::sync::Arc;

#[test]
fn grids_and_surfaces_come_back_as_they_were() {
    let bank = grid_bank();
    assert_eq!(bank.check(), Ok(()));
    let file = bank.write();
    assert_eq!(file.capacity(), file.len(), "it is no longer than it says");
    assert_eq!(Bank::read(&file), Ok(bank));
    assert_eq!(Bank::read(&file).unwrap().write(), file);
}

/// What version 2 wrote: the same without rows, surfaces and spread.
#[test]
fn files_of_version_2_are_read() {
    let old = |text: String| {
        let text = text
            .replace("\"spread\":null,", "")
            .replace("\"rows\":1,\"closed\":false,\"surface\":null,", "")
            .replace("; 128 alone: nothing is stored, the shape is a product", "");
        let first_new = text.find(",{\"name\":\"surface points\"").unwrap();
        format!("{}]}}", &text[..first_new])
    };
    let mut file = with_header(&bank(), old);
    file[8] = 2;
    assert_eq!(Bank::read(&seal(file)), Ok(bank()));
}

#[test]
fn what_version_2_had_not_is_refused_in_it() {
    let arrays = |text: String| {
        let first_new = text.find(",{\"name\":\"surface points\"").unwrap();
        format!("{}]}}", &text[..first_new])
    };
    let mut file = with_header(&grid_bank(), arrays);
    file[8] = 2;
    assert_eq!(inconsistent_field(Bank::read(&seal(file))), "header");
    let mut newer = bank().write();
    newer[8] = 2;
    assert_eq!(inconsistent_field(Bank::read(&seal(newer))), "header");
}

#[test]
fn impossible_grids_and_surfaces_are_refused() {
    type Change = fn(&mut Surface);
    let cases: [(&str, Change); 7] = [
        ("surface length_m", |s| s.length_m = 0.0),
        ("surface points", |s| s.points_m[1][2] = f32::INFINITY),
        ("surface triangles", |s| s.triangles[0][1] = 4),
        ("surface step", |s| s.motions[0].step = f32::NAN),
        ("surface step", |s| s.motions[0].step = -1.0),
        ("surface motion", |s| {
            s.motions[0].points.pop();
        }),
        ("surface motions", |s| {
            let motion = s.motions[0].clone();
            s.motions = vec![motion; Surface::MOST_MODES + 1];
        }),
    ];
    for (field, change) in cases {
        let mut bad = grid_bank();
        let surface = bad.bodies[0].surface.as_mut().map(Arc::make_mut);
        change(surface.unwrap());
        let field = format!("key 60: {field}");
        assert_eq!(inconsistent_field(bad.check().map(|()| bad.clone())), field);
        assert!(Bank::read(&bad.write()).is_err(), "{field}");
    }
    for rows in [0, 5, 3, usize::MAX] {
        let mut bad = grid_bank();
        bad.bodies[0].line.rows = rows;
        let field = inconsistent_field(bad.check().map(|()| bad.clone()));
        let expected = if rows == 3 { "points" } else { "rows" };
        assert_eq!(field, format!("key 60: {expected}"), "{rows}");
        assert_eq!(inconsistent_field(Bank::read(&bad.write())), field);
    }
}

#[test]
fn more_surface_than_there_is_is_refused() {
    for (from, field) in [
        ("\"points\":4,", "surface points"),
        ("\"triangles\":4,", "surface triangles"),
        ("\"motions\":2}", "surface motions"),
    ] {
        for count in [u64::MAX, 1 << 60, 1 << 30] {
            let (name, end) = (from.split_once('4'), from.split_once('2'));
            let (name, end) = name.or(end).unwrap();
            let to = format!("{name}{count}{end}");
            let file = with_header(&grid_bank(), |text| text.replace(from, &to));
            let found = inconsistent_field(Bank::read(&file));
            assert_eq!(found, format!("key 60: {field}"), "{count}");
        }
    }
}

/// Bytes under a correct checksum, each wrong in one place: nothing but an error or a bank, and what
/// the bank's keys are given is one too.
#[test]
fn changed_bytes_do_not_panic() {
    let file = grid_bank().write();
    let mut refused = 0;
    for at in 24..file.len() {
        for value in [0, 1, b'9', 0x7f, 0xff] {
            let mut changed = file.clone();
            changed[at] = value;
            match Bank::read(&seal(changed)) {
                Ok(read) => {
                    assert_eq!(read.check(), Ok(()));
                    assert_eq!(read.spread_out().check(), Ok(()));
                }
                Err(error) => {
                    assert!(matches!(error, BankError::Inconsistent { .. }));
                    refused += 1;
                }
            }
        }
    }
    assert!(refused > 1000, "only {refused}");
}

#[test]
fn surfaces_are_of_their_body_s_size() {
    let mut bank = grid_bank();
    let body = &mut bank.bodies[0];
    assert_eq!(body.surface_scale(), 1.0);
    body.length_m *= 2.0;
    assert_eq!(body.surface_scale(), 2.0);
    body.surface = None;
    assert_eq!(body.surface_scale(), 1.0);
    let still = SurfaceMotion::of(&[[0.0; 3]; 2]);
    assert_eq!(still.step, 0.0);
}
