//! Bodies that are struck on a grid.

use crate::support::{chimes, left};
use idiophone::engine::{Engine, Hit, Settings};
use modes::Bank;
use std::f64::consts::TAU;

const RATE_HZ: f64 = 48_000.0;

/// Rows around the chime.
const ROWS: usize = 8;

/// A chime whose modes go with the cosine of the angle around it.
fn around() -> Bank {
    let mut bank = chimes([74]);
    let body = &mut bank.bodies[0];
    let line = body.line.clone();
    for _ in 1..ROWS {
        body.line.points_m.extend(&line.points_m);
        body.line.normals.extend(&line.normals);
    }
    (body.line.rows, body.line.closed) = (ROWS, true);
    for mode in &mut body.modes {
        let row: Vec<[f32; 3]> = mode.shape.iter().collect();
        mode.shape = (0..ROWS)
            .flat_map(|i| {
                let share = (TAU * i as f64 / ROWS as f64).cos() as f32;
                row.iter().map(move |u| u.map(|x| share * x))
            })
            .collect();
    }
    bank
}

/// What is heard of a blow `across` a body of that bank, `moved` off by the hand.
fn struck(bank: &Bank, across: f64, moved: f64) -> Vec<f64> {
    let mut engine = Engine::new(bank, RATE_HZ);
    engine.set(&Settings {
        strike_across: across,
        ..Settings::default()
    });
    let hit = Hit {
        across: moved,
        ..Hit::plain(0.5)
    };
    engine.hit(74, &hit);
    left(&mut engine, 4800)
}

fn loudest(signal: &[f64]) -> f64 {
    signal.iter().fold(0.0, |most, x| x.abs().max(most))
}

#[test]
fn blows_across_reach_what_moves_there() {
    let bank = around();
    let crest = loudest(&struck(&bank, 0.0, 0.0));
    let node = loudest(&struck(&bank, 0.25, 0.0));
    assert!(crest > 1e-3 && node < 1e-5 * crest, "{node} {crest}");
    // The far side moves the other way: the same blow from there sounds the same, upside down.
    let far = struck(&bank, 0.5, 0.0);
    assert!((loudest(&far) / crest - 1.0).abs() < 1e-5);
}

#[test]
fn hands_move_a_blow_around() {
    let bank = around();
    assert_eq!(struck(&bank, 0.75, 0.375), struck(&bank, 0.125, 0.0));
    assert_ne!(struck(&bank, 0.125, 0.0), struck(&bank, 0.0, 0.0));
}

#[test]
fn a_line_is_struck_alike_all_across() {
    let bank = chimes([74]);
    assert_eq!(struck(&bank, 0.7, 0.0), struck(&bank, 0.0, 0.0));
}
