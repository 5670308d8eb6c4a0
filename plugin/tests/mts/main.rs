//! The MTS-ESP client against a library that the tests build and turn.

#![expect(clippy::unwrap_used, reason = "tests fail by panicking")]

mod fake;

use fake::{Fake, build};
use idiophone::tuning::{MtsClient, MtsError};
use nice_assert_no_alloc::assert_no_alloc;
use std::path::Path;

/// With the feature, the plug-in brings this allocator along.
#[cfg(not(feature = "assert_process_allocs"))]
#[global_allocator]
static ALLOCATOR: nice_assert_no_alloc::AllocDisabler = nice_assert_no_alloc::AllocDisabler;

#[test]
fn keys_follow_the_master_as_soon_as_it_speaks() {
    let Some(library) = build("follow", &[]) else {
        return;
    };
    let fake = Fake::of(&library);
    let client = MtsClient::open(&library).unwrap();
    for key in 0..128 {
        fake.tune(key, 100.0 + f64::from(key));
    }
    assert!(!client.has_master());
    assert_eq!(client.tuning(60), None);
    fake.master(true);
    assert!(client.has_master());
    for key in 0..128_u8 {
        assert_eq!(client.tuning(key), Some(100.0 + f64::from(key)));
    }
    fake.tune(60, 261.5);
    assert_eq!(client.tuning(60), Some(261.5));
    assert_eq!(client.tuning(128), None);
    assert_eq!(client.tuning(255), None);
    fake.master(false);
    assert_eq!(client.tuning(60), None);
}

#[test]
fn what_is_no_frequency_leaves_a_key_its_own() {
    let Some(library) = build("odd", &[]) else {
        return;
    };
    let fake = Fake::of(&library);
    let client = MtsClient::open(&library).unwrap();
    fake.master(true);
    let odd = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        -0.0,
        -440.0,
        5e-324,
    ];
    for hz in odd {
        fake.tune(69, hz);
        assert_eq!(client.tuning(69), None, "{hz}");
    }
    fake.tune(69, 432.0);
    assert_eq!(client.tuning(69), Some(432.0));
}

#[test]
fn the_master_says_which_keys_are_silent() {
    let Some(library) = build("silent", &[]) else {
        return;
    };
    let fake = Fake::of(&library);
    let client = MtsClient::open(&library).unwrap();
    assert!(!client.silences(61, None));
    fake.master(true);
    assert!(client.silences(61, None) && client.silences(61, Some(0)));
    assert!(client.silences(62, Some(9)));
    assert!(!client.silences(62, Some(8)) && !client.silences(62, None));
    assert!(client.silences(63, None) && !client.silences(63, Some(15)));
    assert!(!client.silences(60, None));
}

#[test]
fn asking_allocates_nothing() {
    let Some(library) = build("alloc", &[]) else {
        return;
    };
    let fake = Fake::of(&library);
    let client = MtsClient::open(&library).unwrap();
    fake.master(true);
    fake.tune(60, 261.5);
    // Aborts on the first allocation.
    let (hz, silent) = assert_no_alloc(|| (client.tuning(60), client.silences(60, Some(0))));
    assert_eq!((hz, silent), (Some(261.5), false));
}

#[test]
fn the_scale_has_the_masters_name() {
    let Some(library) = build("name", &[]) else {
        return;
    };
    let fake = Fake::of(&library);
    let client = MtsClient::open(&library).unwrap();
    assert_eq!(client.scale_name(), None);
    fake.master(true);
    assert_eq!(client.scale_name().as_deref(), Some("Eikosany"));
    fake.name(Some(c""));
    assert_eq!(client.scale_name().as_deref(), Some(""));
    let long = std::ffi::CString::new(vec![b'e'; 1000]).unwrap();
    fake.name(Some(&long));
    assert_eq!(client.scale_name(), Some("e".repeat(255)));
    fake.name(None);
    assert_eq!(client.scale_name(), None);
}

#[test]
fn clients_come_and_go() {
    let Some(library) = build("clients", &[]) else {
        return;
    };
    let fake = Fake::of(&library);
    let one = MtsClient::open(&library).unwrap();
    let two = MtsClient::open(&library).unwrap();
    assert_eq!(fake.clients(), 2);
    drop(one);
    assert_eq!(fake.clients(), 1);
    let elsewhere = std::thread::spawn(move || two.has_master());
    assert!(!elsewhere.join().unwrap());
    assert_eq!(fake.clients(), 0);
}

#[test]
fn what_is_no_such_library_is_refused_by_name() {
    let missing = Path::new("missing/libMTS.so");
    let error = MtsClient::open(missing).unwrap_err();
    assert!(matches!(error, MtsError::Load { .. }));
    assert!(error.to_string().starts_with("missing/libMTS.so: "));
    let Some(library) = build("incomplete", &["-DNO_TABLE_FUNCTION"]) else {
        return;
    };
    let error = MtsClient::open(&library).unwrap_err().to_string();
    assert!(error.contains("MTS_GetTuningTable"), "{error}");
    let library = build("no-table", &["-DNO_TABLE"]).unwrap();
    let error = MtsClient::open(&library).unwrap_err();
    assert!(matches!(error, MtsError::Table { .. }), "{error}");
    assert_eq!(Fake::of(&library).clients(), 0);
}

/// Whether or not this computer has the library.
#[test]
fn connecting_needs_no_library() {
    let connected = MtsClient::connect();
    assert!(connected.is_ok_and(|client| client.is_none_or(|client| client.tuning(128).is_none())));
}
