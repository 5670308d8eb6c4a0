//! One body, many keys.

use super::sample::grid_bank;
use super::tests::inconsistent_field;
use super::{Bank, Body, Spread, SpreadRule, Zone};
use crate::equal_temperament_hz;
use std::sync::Arc;

fn ruled(rule: SpreadRule) -> Bank {
    let mut bank = grid_bank();
    bank.spread.as_mut().unwrap().rule = rule;
    bank
}

/// The body that `rule` gives to `key`.
fn at(rule: SpreadRule, key: u8) -> Body {
    let bank = ruled(rule).spread_out();
    assert_eq!(bank.check(), Ok(()));
    let found = bank.bodies.iter().find(|body| body.key == key);
    found.unwrap().clone()
}

fn near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
}

#[test]
fn every_key_has_its_pitch_on_the_tuned_mode() {
    for rule in [SpreadRule::Size, SpreadRule::Density, SpreadRule::Stiffness] {
        let bank = ruled(rule).spread_out();
        let keys: Vec<u8> = bank.bodies.iter().map(|body| body.key).collect();
        assert_eq!(keys, (48..=84).collect::<Vec<u8>>());
        for body in &bank.bodies {
            near(body.pitch_hz, equal_temperament_hz(body.key, 442.0));
            near(body.modes[1].hz, body.pitch_hz);
        }
        assert!(bank.spread.is_none());
        assert_eq!(bank.clone().spread_out(), bank);
    }
}

#[test]
fn modes_out_of_hearing_are_left_out() {
    let of = |key| at(SpreadRule::Size, key).modes.len();
    assert_eq!((of(48), of(84)), (3, 2));
    assert_eq!(at(SpreadRule::Fixed, 84).modes.len(), 3);
}

#[test]
fn a_fixed_body_is_itself_on_every_key() {
    let given = &grid_bank().bodies[0];
    let body = at(SpreadRule::Fixed, 84);
    assert_eq!(
        Body {
            key: given.key,
            ..body
        },
        *given
    );
}

#[test]
fn keys_share_what_is_large() {
    let (low, high) = (at(SpreadRule::Size, 48), at(SpreadRule::Size, 84));
    assert_ne!(low.modes[0].shape, high.modes[0].shape);
    let bank = ruled(SpreadRule::Size).spread_out();
    let [first, last] = [&bank.bodies[0], &bank.bodies[36]];
    assert!(first.modes[0].shape.shares_with(&last.modes[0].shape));
    let surfaces = [first, last].map(|body| body.surface.clone().unwrap());
    assert!(Arc::ptr_eq(&surfaces[0], &surfaces[1]));
    near(last.surface_scale() / first.surface_scale(), 0.125);
}

/// What an engine with dimensions would say: energy ½ω² of a unit modal displacement, mass ρL³, and
/// φ = 1/√kg.
#[test]
fn sizes_keep_the_physics() {
    let given = &grid_bank().bodies[0];
    let body = at(SpreadRule::Size, 72);
    let ratio = equal_temperament_hz(72, 442.0) / given.modes[1].hz;
    near(body.length_m, given.length_m / ratio);
    near(
        body.mass_kg / body.length_m.powi(3),
        given.mass_kg / given.length_m.powi(3),
    );
    for (found, mode) in body.modes.iter().zip(&given.modes) {
        let shape =
            |body: &Body, mode: &super::Mode| f64::from(mode.shape.at(4)[0]) * body.mass_kg.sqrt();
        near(shape(&body, found), shape(given, mode));
        let cycles = |mode: &super::Mode| f64::from(mode.radiation_per_s) / mode.hz;
        near(cycles(found), cycles(mode));
        // Pressure is the root of the power ω²d at the same distance.
        let heard = |mode: &super::Mode| {
            f64::from(mode.ears[1][1]) / (mode.hz * f64::from(mode.radiation_per_s).sqrt())
        };
        near(heard(found), heard(mode));
        let area = |body: &Body, mode: &super::Mode| {
            mode.coupling / (mode.hz * shape(body, mode)) * body.mass_kg.sqrt()
                / body.length_m.powi(2)
        };
        near(area(&body, found), area(given, mode));
    }
    for (p, q) in body.line.points_m.iter().zip(&given.line.points_m) {
        near(p[2] + 1.0, q[2] / ratio + 1.0);
    }
    assert_eq!(body.line.normals, given.line.normals);
}

#[test]
fn densities_and_stiffnesses_keep_the_size() {
    let given = &grid_bank().bodies[0];
    for rule in [SpreadRule::Density, SpreadRule::Stiffness] {
        let body = at(rule, 72);
        let ratio = equal_temperament_hz(72, 442.0) / given.modes[1].hz;
        assert_eq!((body.length_m, &body.line), (given.length_m, &given.line));
        // Stiffness is mass times the square of the frequency.
        let stiffer = body.mass_kg / given.mass_kg * ratio * ratio;
        near(
            stiffer,
            if rule == SpreadRule::Density {
                1.0
            } else {
                ratio * ratio
            },
        );
        let shape = |body: &Body| f64::from(body.modes[0].shape.at(4)[0]) * body.mass_kg.sqrt();
        near(shape(&body), shape(given));
        let heard = |body: &Body| f64::from(body.modes[0].ears[1][1]) / body.modes[0].coupling;
        near(heard(&body), heard(given));
    }
}

#[test]
fn impossible_spreads_are_refused() {
    type Change = fn(&mut Spread);
    let zone = |field: &str| format!("zone of key 60: {field}");
    let cases: [(String, Change); 8] = [
        ("spread a4_hz".into(), |s| s.a4_hz = f64::NAN),
        ("spread zones".into(), |s| s.zones.clear()),
        ("spread zones".into(), |s| s.zones.push(s.zones[0])),
        (zone("low"), |s| s.zones[0].low = 61),
        (zone("high"), |s| s.zones[0].high = 59),
        (zone("high"), |s| s.zones[0].high = 128),
        (zone("tuned"), |s| s.zones[0].tuned = 3),
        ("key 48: mass_kg".into(), |s| s.a4_hz = f64::MAX),
    ];
    for (field, change) in cases {
        let mut bad = grid_bank();
        change(bad.spread.as_mut().unwrap());
        assert_eq!(inconsistent_field(bad.check().map(|()| bad.clone())), field);
        assert!(Bank::read(&bad.write()).is_err(), "{field}");
    }
    let mut piped = grid_bank();
    piped.bodies[0].modes[0].pipe_per_s = 1.0;
    let field = inconsistent_field(piped.check().map(|()| piped.clone()));
    assert_eq!(field, zone("pipe_per_s"));
}

#[test]
fn zones_follow_each_other() {
    let mut bank = grid_bank();
    let second = Body {
        key: 90,
        ..bank.bodies[0].clone()
    };
    bank.bodies.push(second);
    let zone = |low| Zone {
        low,
        high: 96,
        tuned: 0,
        rule: None,
    };
    bank.spread.as_mut().unwrap().zones.push(zone(85));
    assert_eq!(bank.check(), Ok(()));
    let keys = bank.clone().spread_out().bodies.len();
    assert_eq!(keys, 49);
    bank.spread.as_mut().unwrap().zones[1] = zone(84);
    let field = inconsistent_field(bank.check().map(|()| bank.clone()));
    assert_eq!(field, "zone of key 90: low");
}
