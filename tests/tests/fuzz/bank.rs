//! Banks in files.

use super::case::cases;
use super::mutate;
use idiophone::engine::{Engine, Vectors};
use idiophone::factory;
use idiophone_tests::Noise;
use modes::{Bank, Recipe};

/// Bytes up to the length of the header.
const PRELUDE: usize = 24;

/// Three bodies with few modes: one reads and plays it thousands of times a second.
pub(crate) fn small() -> Bank {
    let mut bank = factory::bank(1).clone();
    bank.bodies.retain(|body| [60, 64, 71].contains(&body.key));
    for body in &mut bank.bodies {
        body.modes.truncate(6);
    }
    bank
}

/// Length and checksum put right, so that what is wrong lies within.
fn seal(mut file: Vec<u8>) -> Vec<u8> {
    if file.len() >= PRELUDE {
        let len = file.len() as u64;
        file[12..20].copy_from_slice(&len.to_le_bytes());
        let rest = file[..20].iter().chain(&file[PRELUDE..]);
        let sum = crc32(rest.copied());
        file[20..PRELUDE].copy_from_slice(&sum.to_le_bytes());
    }
    file
}

/// CRC-32/ISO-HDLC, bit by bit.
fn crc32(bytes: impl Iterator<Item = u8>) -> u32 {
    !bytes.fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(byte), |crc, _| {
            (crc >> 1) ^ (0xEDB8_8320 & (crc & 1).wrapping_neg())
        })
    })
}

/// The file with its header's text changed.
fn with_header(noise: &mut Noise, file: &[u8]) -> Vec<u8> {
    let mut len = [0; 4];
    len.copy_from_slice(&file[PRELUDE..PRELUDE + 4]);
    let end = PRELUDE + 4 + u32::from_le_bytes(len) as usize;
    let header = std::str::from_utf8(&file[PRELUDE + 4..end]).unwrap();
    let header = mutate::text(noise, header);
    let len = u32::try_from(header.len()).unwrap().to_le_bytes();
    [&file[..PRELUDE], &len, header.as_bytes(), &file[end..]].concat()
}

/// A bank that is read must be one that can be played.
fn play(bank: &Bank) {
    bank.check().unwrap();
    let mut engine = Engine::with_vectors(bank, 48e3, Vectors::Plain);
    let (mut left, mut right) = ([0.0; 64], [0.0; 64]);
    for body in &bank.bodies {
        engine.strike(body.key, 1.0);
    }
    engine.process(&mut left, &mut right);
    let samples = left.iter().chain(&right);
    assert!(samples.clone().all(|sample| sample.is_finite()), "{left:?}");
}

#[test]
fn no_bank_panics() {
    let good = small().write();
    assert!(Bank::read(&seal(good.clone())) == Ok(small()));
    cases("bank", |noise| {
        let file = match noise.below(4) {
            0 => mutate::bytes(noise, &good),
            1 => seal(mutate::bytes(noise, &good)),
            _ => seal(with_header(noise, &good)),
        };
        let bank = Bank::read(&file);
        bank.iter().for_each(play);
        bank.is_ok()
    });
}

#[test]
fn no_recipe_panics() {
    cases("recipe", |noise| {
        let (_, good) = Recipe::FACTORY[noise.below(Recipe::FACTORY.len() as u64) as usize];
        let text = mutate::text(noise, good);
        match Recipe::parse(&text, "fuzz.toml") {
            Ok(_) => true,
            Err(error) => {
                assert!(error.to_string().contains("fuzz.toml"), "{error}");
                false
            }
        }
    });
}
