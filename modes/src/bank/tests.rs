//! Banks come back as they were, and nothing else comes back at all.

use super::format::{CHECKSUM_AT, PRELUDE_LEN, VERSION, checksum};
use super::sample::bank;
use super::{Bank, BankError};
use crate::Rayleigh;

/// Puts the length and the checksum right, as one does who means the rest.
pub(super) fn seal(mut file: Vec<u8>) -> Vec<u8> {
    let len = file.len() as u64;
    file[12..CHECKSUM_AT].copy_from_slice(&len.to_le_bytes());
    let checksum = checksum(&file);
    file[CHECKSUM_AT..PRELUDE_LEN].copy_from_slice(&checksum.to_le_bytes());
    file
}

/// `bank` as a file with its header's text changed.
pub(super) fn with_header(bank: &Bank, change: impl Fn(String) -> String) -> Vec<u8> {
    let file = bank.write();
    let (front, rest) = file.split_at(PRELUDE_LEN);
    let len = u32::from_le_bytes([rest[0], rest[1], rest[2], rest[3]]) as usize;
    let (header, sections) = rest[4..].split_at(len);
    let changed = change(String::from_utf8(header.to_vec()).unwrap());
    assert_ne!(
        changed.as_bytes(),
        header,
        "the change must change something"
    );
    let len = u32::try_from(changed.len()).unwrap().to_le_bytes();
    seal([front, &len, changed.as_bytes(), sections].concat())
}

pub(super) fn inconsistent_field(result: Result<Bank, BankError>) -> String {
    match result {
        Err(BankError::Inconsistent { field, .. }) => field,
        other => panic!("not inconsistent: {other:?}"),
    }
}

#[test]
fn a_bank_comes_back_as_it_was() {
    let file = bank().write();
    assert_eq!(Bank::read(&file), Ok(bank()));
    assert_eq!(Bank::read(&file).unwrap().write(), file);
}

#[test]
fn a_bank_without_bodies_comes_back() {
    let empty = Bank {
        bodies: vec![],
        ..bank()
    };
    assert_eq!(Bank::read(&empty.write()), Ok(empty));
}

#[test]
fn equal_banks_give_equal_bytes() {
    let mut negative = bank();
    negative.damping.rayleigh.alpha2_per_s = -0.0;
    negative.bodies[1].line.points_m[0][1] = -0.0;
    for phi in negative.bodies[1]
        .modes
        .iter_mut()
        .flat_map(|m| m.shape.make_mut())
    {
        for x in phi.iter_mut().filter(|x| **x == 0.0) {
            *x = -0.0;
        }
    }
    assert_eq!(negative, bank());
    assert_eq!(negative.write(), bank().write());
}

#[test]
fn vanishing_components_take_no_room() {
    let mut full = bank();
    for (i, phi) in full.bodies[1].modes[1]
        .shape
        .make_mut()
        .iter_mut()
        .enumerate()
    {
        *phi = [1.0, 2.0, 3.0].map(|x| x * i as f32);
    }
    let two_components_of_six_points = 2 * 6 * 4;
    assert_eq!(
        full.write().len() - bank().write().len(),
        two_components_of_six_points
    );
}

#[test]
fn mirrored_shapes_are_stored_by_half() {
    let mut mirrored = bank();
    for (i, phi) in mirrored.bodies[1].modes[1]
        .shape
        .make_mut()
        .iter_mut()
        .enumerate()
    {
        *phi = [i as f32 - 2.5, 0.0, 0.0];
    }
    let three_points = 3 * 4;
    assert_eq!(bank().write().len() - mirrored.write().len(), three_points);
    assert_eq!(Bank::read(&mirrored.write()), Ok(mirrored));
}

#[test]
fn every_truncation_is_seen() {
    let file = bank().write();
    for len in 0..file.len() {
        let expected = if len < PRELUDE_LEN {
            PRELUDE_LEN as u64
        } else {
            file.len() as u64
        };
        let found = len as u64;
        assert_eq!(
            Bank::read(&file[..len]),
            Err(BankError::Truncated { expected, found })
        );
    }
}

#[test]
fn every_flipped_bit_is_seen() {
    let mut file = bank().write();
    for at in 0..file.len() {
        for bit in 0..8 {
            file[at] ^= 1 << bit;
            let error = Bank::read(&file).unwrap_err();
            match at {
                0..8 => assert_eq!(error, BankError::Foreign),
                12..20 => assert!(matches!(
                    error,
                    BankError::Truncated { .. } | BankError::Corrupted
                )),
                _ => assert_eq!(error, BankError::Corrupted, "byte {at}"),
            }
            file[at] ^= 1 << bit;
        }
    }
}

#[test]
fn garbage_is_refused() {
    let mut state = 1_u64;
    let mut random = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 56) as u8
    };
    for len in 0..2000 {
        let mut file: Vec<u8> = (0..len).map(|_| random()).collect();
        if len > 0 {
            assert_eq!(Bank::read(&file), Err(BankError::Foreign));
        }
        if len >= PRELUDE_LEN {
            file[..12].copy_from_slice(&bank().write()[..12]);
            assert!(matches!(
                Bank::read(&seal(file)),
                Err(BankError::Inconsistent { .. })
            ));
        }
    }
}

/// Bytes under a correct checksum, each wrong in one place: nothing but an error or a bank.
#[test]
fn changed_bytes_under_a_good_checksum_do_not_panic() {
    let file = bank().write();
    let mut refused = 0;
    for at in PRELUDE_LEN..file.len() {
        for value in [0, 1, b'9', 0x7f, 0xff] {
            let mut changed = file.clone();
            changed[at] = value;
            match Bank::read(&seal(changed)) {
                Ok(read) => assert_eq!(read.check(), Ok(())),
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
fn versions_to_come_are_told_from_damage() {
    let mut file = bank().write();
    let newer = VERSION + 1;
    file[8..12].copy_from_slice(&newer.to_le_bytes());
    assert_eq!(Bank::read(&file).err(), Some(BankError::Corrupted));
    assert_eq!(
        Bank::read(&seal(file.clone())).err(),
        Some(BankError::FutureVersion {
            found: newer,
            newest: VERSION
        })
    );
    file[8] = 1;
    assert_eq!(
        Bank::read(&seal(file.clone())).err(),
        Some(BankError::PastVersion { found: 1 })
    );
    file[8] = 0;
    assert_eq!(
        inconsistent_field(Bank::read(&seal(file))),
        "format version"
    );
}

#[test]
fn more_than_there_is_is_refused() {
    for (from, count) in [
        ("\"modes\":3", 1_u64 << 60),
        ("\"modes\":3", u64::MAX),
        ("\"modes\":3", 1 << 20),
        ("\"modes\":3", 4),
        ("\"modes\":3", 2),
    ] {
        let file = with_header(&bank(), |h| h.replace(from, &format!("\"modes\":{count}")));
        assert!(
            inconsistent_field(Bank::read(&file)).starts_with("key 74: "),
            "{count}"
        );
    }
    for count in [1_u64 << 60, u64::MAX, 1 << 20, 7, 0] {
        let file = with_header(&bank(), |h| {
            h.replace("\"points\":6", &format!("\"points\":{count}"))
        });
        assert!(
            inconsistent_field(Bank::read(&file)).starts_with("key "),
            "{count}"
        );
    }
    let file = with_header(&bank(), |h| {
        h.replace("\"offset\":0", "\"offset\":9223372036854775807")
    });
    assert_eq!(inconsistent_field(Bank::read(&file)), "key 36: offset");
    let longer = seal([bank().write(), vec![0; 8]].concat());
    assert_eq!(inconsistent_field(Bank::read(&longer)), "length");
}

/// What a bank takes in memory is bounded by its bytes: every point and every mode is there in
/// at least one stored component, and each stored f32 makes at most three.
#[test]
fn memory_is_bounded_by_the_bytes() {
    let mut many = bank();
    let mode = many.bodies[1].modes[2].clone();
    many.bodies[1].modes.extend(vec![mode; 5000]);
    let file = many.write();
    let read = Bank::read(&file).unwrap();
    let mut bytes = read.bodies.capacity() * size_of::<super::Body>();
    for body in &read.bodies {
        bytes += body.line.points_m.capacity() * 24 + body.line.normals.capacity() * 24;
        bytes += body.modes.capacity() * size_of::<super::Mode>();
        let shapes = body.modes.iter().map(|mode| mode.shape.len() * 12);
        bytes += shapes.sum::<usize>();
    }
    assert!(bytes < 3 * file.len(), "{bytes} bytes of {}", file.len());
}

/// A mode of no stored component would make memory of nothing.
#[test]
fn a_mode_without_components_is_refused() {
    let mut file = bank().write();
    // Three components in full, then the first half of one that does not move.
    let shapes = 3 * 6 * 4 + 3 * 4;
    let last_components = file.len() - shapes - 1;
    assert_eq!(file[last_components - 2..=last_components], [6, 1, 9]);
    file[last_components] = 0;
    file.truncate(file.len() - 3 * 4);
    let field = inconsistent_field(Bank::read(&seal(file)));
    assert_eq!(field, "key 74: mode 3: components");
}

#[test]
fn headers_of_another_layout_are_refused() {
    for (from, to) in [
        ("\"name\":\"hz\"", "\"name\":\"rad_per_s\""),
        ("little-endian", "big-endian"),
        ("\"mass_kg\":", "\"mass_g\":"),
        ("{\"format\"", "{\"more\":1,\"format\""),
        ("{\"format\"", "{\"two\\nlines\":1,\"format\""),
        ("\"lambda_pa\":49800000000.0", "\"lambda_pa\":null"),
    ] {
        let file = with_header(&bank(), |h| h.replace(from, to));
        let error = Bank::read(&file).unwrap_err().to_string();
        assert!(!error.contains('\n'));
        assert!(error.starts_with("the bank's header is "), "{error}");
    }
}

#[test]
fn impossible_banks_are_refused() {
    type Change = fn(&mut Bank);
    let cases: [(&str, Change); 21] = [
        ("material", |b| b.material.mu_pa = -1.0),
        ("alpha2_per_s", |b| {
            b.damping.rayleigh = Rayleigh {
                alpha1_s: 0.0,
                alpha2_per_s: -1.0,
            }
        }),
        ("max_residual", |b| b.provenance.max_residual = -1.0),
        ("key", |b| b.bodies[1].key = 128),
        ("key", |b| b.bodies[1].key = 36),
        ("key", |b| b.bodies.swap(0, 1)),
        ("key 74: pitch_hz", |b| b.bodies[1].pitch_hz = 0.0),
        ("key 74: length_m", |b| b.bodies[1].length_m = -0.5),
        ("key 36: mass_kg", |b| b.bodies[0].mass_kg = -1.0),
        ("key 36: point 3", |b| {
            b.bodies[0].line.points_m[2][1] = f64::NAN;
        }),
        ("key 36: length of normal 6", |b| {
            b.bodies[0].line.normals[5] = [0.0; 3];
        }),
        ("key 74: mode 1: hz", |b| b.bodies[1].modes[0].hz = f64::NAN),
        ("key 74: mode 2: hz", |b| b.bodies[1].modes[1].hz = 100.0),
        ("key 74: mode 3: hz", |b| b.bodies[1].modes[2].hz = 2e6),
        ("key 74: mode 1: coupling", |b| {
            b.bodies[1].modes[0].coupling = -1.0;
        }),
        ("key 74: mode 1: coupling", |b| {
            b.bodies[1].modes[0].coupling = f64::INFINITY;
        }),
        ("key 74: mode 1: residual", |b| {
            b.bodies[1].modes[0].residual = f64::NAN;
        }),
        ("key 74: mode 2: shape", |b| {
            b.bodies[1].modes[1].shape.make_mut()[0][0] = f32::NAN;
        }),
        ("key 74: mode 2: shape", |b| {
            b.bodies[1].modes[1].shape.make_mut()[0][2] = 1e10;
        }),
        ("key 36: points", |b| {
            b.bodies[0].line =
                crate::StrikeLine::single(vec![[0.0; 3]; 5], vec![[0.0, 0.0, 1.0]; 5]);
        }),
        ("key 74: mode 1: residual", |b| {
            b.bodies[1].modes[0].residual = -1e-9;
        }),
    ];
    for (field, change) in cases {
        let mut bad = bank();
        change(&mut bad);
        let checked = bad.check().map(|()| bad.clone());
        assert_eq!(inconsistent_field(checked), field);
        assert_eq!(inconsistent_field(Bank::read(&bad.write())), field);
    }
}

/// What only a bank in memory can get wrong is found before it is written.
#[test]
fn ragged_banks_are_refused() {
    let mut short = bank();
    short.bodies[1].modes[2].shape = vec![[0.0; 3]; 5].into();
    assert_eq!(short.check().map_err(|e| e.to_string()), Err("the bank's key 74: mode 3: shape is of 5 points, but must be one for each point of the strike line; build it anew".to_owned()));
    let mut bald = bank();
    bald.bodies[0].line.normals.pop();
    assert!(bald.check().is_err());
    assert!(Bank::read(&short.write()).is_err());
    assert!(Bank::read(&bald.write()).is_err());
}

#[test]
fn numbers_that_json_lacks_are_refused() {
    let mut bad = bank();
    bad.bodies[0].mass_kg = f64::NAN;
    assert_eq!(inconsistent_field(Bank::read(&bad.write())), "header");
}
