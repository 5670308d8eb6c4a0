//! Single modes are made louder, longer or alone, on whatever key they are.

use idiophone::engine::{Engine, Partial, Trim, Trims, Vectors};
use idiophone::factory;
use nice_assert_no_alloc::assert_no_alloc;

const KEY: u8 = 60;

/// Levels of the modes of the struck chime so many samples after the blow.
fn levels(trims: &Trims, frames: usize) -> Vec<f32> {
    let mut engine = Engine::with_vectors(factory::bank(0), 48e3, Vectors::Plain);
    engine.set_trims(trims);
    engine.strike(KEY, 0.8);
    engine.process(&mut vec![0.0; frames], &mut vec![0.0; frames]);
    let mut levels = vec![0.0; 4096];
    let count = engine.levels(KEY, &mut levels);
    levels.truncate(count);
    levels
}

fn partials() -> Vec<Partial> {
    let bank = factory::bank(0);
    let body = bank.bodies.iter().find(|body| body.key == KEY);
    Partial::all(body.expect("there is a chime"))
}

fn trimmed(number: usize, trim: Trim) -> Trims {
    let mut trims = Trims::NONE;
    assert!(trims.set(&partials()[number].label, trim));
    trims
}

#[test]
fn a_level_is_what_is_set_and_the_others_stay() {
    let louder = Trim {
        level_db: -20.0,
        ..Trim::NONE
    };
    let (plain, told) = (
        levels(&Trims::NONE, 2400),
        levels(&trimmed(2, louder), 2400),
    );
    for (number, (plain, told)) in plain.iter().zip(&told).enumerate().take(12) {
        let expected = if number == 2 { 0.1 } else { 1.0 };
        assert!(
            (told / plain - expected).abs() < 1e-4,
            "{number}: {told} of {plain}"
        );
    }
}

#[test]
fn a_mode_rings_as_many_times_as_long_as_is_set() {
    for ringing in [0.5, 2.0] {
        let longer = Trim {
            ringing,
            ..Trim::NONE
        };
        let trims = trimmed(0, longer);
        // Nepers lost between two looks, once the mallet has left.
        let lost = |trims: &Trims, number: usize| {
            let [early, late] = [4800, 28_800].map(|frames| levels(trims, frames)[number]);
            (early / late).ln()
        };
        let ratio = lost(&Trims::NONE, 0) / lost(&trims, 0);
        assert!(
            (ratio / ringing - 1.0).abs() < 0.01,
            "{ratio}, not {ringing}"
        );
        let other = lost(&Trims::NONE, 2) / lost(&trims, 2);
        assert!((other - 1.0).abs() < 1e-3, "{other}");
    }
}

#[test]
fn one_mode_is_heard_alone_where_it_is_and_all_where_it_is_not() {
    let mut trims = Trims::NONE;
    trims.set_solo(Some(partials()[1].label));
    let alone = levels(&trims, 2400);
    assert!(alone[1] > 1e-4);
    assert!(
        alone
            .iter()
            .enumerate()
            .all(|(i, level)| i == 1 || *level == 0.0)
    );
    let mut elsewhere = Engine::with_vectors(factory::bank(3), 48e3, Vectors::Plain);
    elsewhere.set_trims(&trims);
    elsewhere.strike(KEY, 0.8);
    let mut sound = [0.0; 480];
    elsewhere.process(&mut sound, &mut [0.0; 480]);
    assert!(
        sound.iter().any(|x| x.abs() > 1e-4),
        "a bowl does not bend so"
    );
}

#[test]
fn changes_do_not_click_nor_allocate() {
    let mut engine = Engine::with_vectors(factory::bank(0), 48e3, Vectors::Plain);
    engine.strike(KEY, 0.8);
    let mut left = vec![0.0; 9600];
    let mut right = left.clone();
    engine.process(&mut left, &mut right);
    let step = |sound: &[f32]| {
        let steps = sound.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        steps.fold(0.0f32, f32::max)
    };
    let before = step(&left[4800..]);
    let mut trims = Trims::NONE;
    trims.set_solo(Some(partials()[0].label));
    assert_no_alloc(|| {
        engine.set_trims(&trims);
        engine.process(&mut left, &mut right);
    });
    assert!(
        step(&left) <= 1.2 * before,
        "{} after {before}",
        step(&left)
    );
}
