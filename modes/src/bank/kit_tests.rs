//! Bodies of several materials and rules in one bank.

use super::sample::{bank, grid_bank};
use super::sheet_tests::before_5;
use super::tests::{inconsistent_field, seal, with_header};
use super::{Bank, Body, Matter, SpreadRule, Zone};
use crate::{Damping, Material, Rayleigh};

fn glass() -> Matter {
    Matter {
        material: Material {
            lambda_pa: 2.3e10,
            mu_pa: 2.6e10,
            density_kg_m3: 2500.0,
        },
        damping: Damping {
            rayleigh: Rayleigh {
                alpha1_s: 2e-8,
                alpha2_per_s: 0.5,
            },
            loss_factor: 1e-3,
        },
    }
}

/// The grid bank's body, and the same of glass for the keys from 85 up, by the rule of its zone.
fn kit(rule: SpreadRule) -> Bank {
    let mut bank = grid_bank();
    bank.bodies.push(Body {
        key: 90,
        matter: Some(glass()),
        ..bank.bodies[0].clone()
    });
    bank.spread.as_mut().unwrap().zones.push(Zone {
        low: 85,
        high: 96,
        tuned: 0,
        rule: Some(rule),
    });
    assert_eq!(bank.check(), Ok(()));
    bank
}

#[test]
fn matter_and_rules_come_back_as_they_were() {
    let kit = kit(SpreadRule::Density);
    let file = kit.write();
    assert_eq!(Bank::read(&file), Ok(kit));
    assert_eq!(Bank::read(&file).unwrap().write(), file);
}

/// The layout of version 3 is that of banks without either.
#[test]
fn files_of_version_3_are_read_and_have_neither() {
    let as_3 = |bank: &Bank| {
        let mut file = with_header(bank, before_5);
        file[8] = 3;
        Bank::read(&seal(file))
    };
    assert_eq!(as_3(&grid_bank()), Ok(grid_bank()));
    let mut of_glass = bank();
    of_glass.bodies[0].matter = Some(glass());
    let mut ruled = grid_bank();
    ruled.spread.as_mut().unwrap().zones[0].rule = Some(SpreadRule::Fixed);
    for newer in [of_glass, ruled] {
        assert_eq!(newer.check(), Ok(()));
        assert_eq!(inconsistent_field(as_3(&newer)), "header");
    }
}

#[test]
fn each_zone_goes_by_its_own_rule() {
    for rule in [
        SpreadRule::Size,
        SpreadRule::Density,
        SpreadRule::Stiffness,
        SpreadRule::Fixed,
    ] {
        let kit = kit(rule);
        let mut alone = kit.clone();
        let (body, zone) = (
            alone.bodies.remove(1),
            alone.spread.as_mut().unwrap().zones.remove(1),
        );
        let first = alone.spread_out().bodies;
        let second = Bank {
            material: glass().material,
            damping: glass().damping,
            bodies: vec![Body {
                matter: None,
                ..body
            }],
            spread: Some(super::Spread {
                rule,
                a4_hz: 442.0,
                zones: vec![Zone { rule: None, ..zone }],
                enough: None,
            }),
            ..bank()
        };
        let whole = kit.spread_out();
        assert_eq!(whole.bodies.len(), 37 + 12);
        assert_eq!(whole.bodies[..37], first);
        let spread = second.spread_out();
        for (found, expected) in whole.bodies[37..].iter().zip(&spread.bodies) {
            assert_eq!(whole.matter_of(found), spread.matter_of(expected));
            let matter = expected.matter;
            assert_eq!(
                Body {
                    matter,
                    ..found.clone()
                },
                *expected
            );
        }
    }
}

/// Young's modulus goes with the square of the frequency, or density with its inverse; all else stays
/// (O'Brien 2002 §3.3).
#[test]
fn what_changes_from_key_to_key_is_told() {
    for rule in [SpreadRule::Density, SpreadRule::Stiffness] {
        let kit = kit(rule).spread_out();
        let body = &kit.bodies[40];
        let found = kit.matter_of(body);
        let square = (body.modes[0].hz / grid_bank().bodies[0].modes[0].hz).powi(2);
        let [stiffer, denser] = [
            found.material.young_pa() / glass().material.young_pa(),
            found.material.density_kg_m3 / glass().material.density_kg_m3,
        ];
        let expected = match rule {
            SpreadRule::Density => [1.0, square.recip()],
            _ => [square, 1.0],
        };
        assert!((stiffer / expected[0] - 1.0).abs() < 1e-12, "{stiffer}");
        assert!((denser / expected[1] - 1.0).abs() < 1e-12, "{denser}");
        assert_eq!(found.damping, glass().damping);
    }
}

#[test]
fn impossible_matter_is_refused() {
    type Change = fn(&mut Matter);
    let cases: [(&str, Change); 3] = [
        ("material", |m| m.material.density_kg_m3 = 0.0),
        ("alpha1_s", |m| m.damping.rayleigh.alpha1_s = -1.0),
        ("loss_factor", |m| m.damping.loss_factor = -1.0),
    ];
    for (field, change) in cases {
        let mut bad = bank();
        let mut matter = glass();
        change(&mut matter);
        bad.bodies[1].matter = Some(matter);
        let field = format!("key 74: {field}");
        assert_eq!(inconsistent_field(bad.check().map(|()| bad.clone())), field);
        assert_eq!(inconsistent_field(Bank::read(&bad.write())), field);
    }
}
