//! Instruments come on and ring out.

use super::*;
use crate::factory;
use crate::workshop::Workshop;
use std::sync::Arc;

fn stage(index: usize) -> Stage {
    Stage::new(index, factory::bank(index), 48_000.0)
}

fn render(stage: &mut Stage, frames: usize) -> Vec<f32> {
    let (mut left, mut right) = (vec![0.0; frames], vec![0.0; frames]);
    stage.render(&mut Outputs::main(&mut left, &mut right));
    left
}

/// Greatest step from sample to sample.
fn step(signal: &[f32]) -> f32 {
    signal
        .windows(2)
        .fold(0.0, |most, pair| most.max((pair[1] - pair[0]).abs()))
}

#[test]
fn what_rings_rings_out_when_the_instrument_changes() {
    let bench = Arc::new(Bench::new(Arc::default(), 48_000.0));
    let (mut stage, mut twin) = (stage(0), stage(0));
    for stage in [&mut stage, &mut twin] {
        stage.hit(60, &Hit::plain(0.8));
        render(stage, 1000);
    }
    stage.turn(1, &bench);
    assert!(bench.work(), "asked for");
    stage.turn(1, &bench);
    assert!(!bench.work(), "once");
    assert_eq!(stage.number, 1);
    assert_eq!(render(&mut stage, 1000), render(&mut twin, 1000));
    stage.hit(60, &Hit::plain(0.5));
    let both = render(&mut stage, 4800);
    assert!(step(&both) < 0.05, "{}", step(&both));
    stage.each(Engine::choke_all);
    render(&mut stage, 48_000);
    assert_eq!(stage.awake(), 0);
    stage.turn(1, &bench);
    assert!(stage.ringing.iter().all(Option::is_none));
    assert!(bench.work(), "taken apart");
}

#[test]
fn all_instruments_together_stay_below_full_scale() {
    let bench = Arc::new(Bench::new(Arc::default(), 48_000.0));
    let loud = |limiter| {
        let mut stage = stage(0);
        stage.set(&Settings {
            gain_db: 12.0,
            limiter,
            ..Settings::default()
        });
        let mut most = 0.0;
        for wanted in [1, 0] {
            for key in 60..72 {
                stage.hit(key, &Hit::plain(1.0));
            }
            stage.turn(wanted, &bench);
            bench.work();
            stage.turn(wanted, &bench);
            let sound = render(&mut stage, 4800);
            most = sound.iter().fold(most, |most: f32, x| most.max(x.abs()));
        }
        most
    };
    assert!(loud(false) > 1.0, "{}", loud(false));
    assert!(loud(true) <= 1.0, "{}", loud(true));
}

#[test]
fn a_bow_stays_on_the_instrument_that_it_was_laid_on() {
    let bench = Arc::new(Bench::new(Arc::default(), 48_000.0));
    let mut stage = stage(3);
    let pressed = Hold {
        bow_pressure: 1.0,
        ..Hold::FREE
    };
    stage.hold(60, &pressed);
    render(&mut stage, 4800);
    assert_eq!(stage.awake(), 0, "not struck yet");
    stage.hit(60, &Hit::plain(0.1));
    stage.hold(60, &pressed);
    stage.turn(4, &bench);
    bench.work();
    stage.turn(4, &bench);
    assert_eq!(stage.number, 4);
    stage.hold(60, &pressed);
    render(&mut stage, 4800);
    assert_eq!(stage.present.engine.awake(), 0);
    assert_eq!(stage.awake(), 1 << 60);
}

#[test]
fn a_patient_stage_turns_at_once() {
    let workshop = Workshop::open(Arc::default(), 48_000.0);
    let mut stage = stage(0).patient();
    for wanted in [1, 2, 0] {
        stage.turn(wanted, &workshop);
        assert_eq!(stage.number, wanted);
    }
}

#[test]
fn hasty_turns_sound_the_same_every_time() {
    let render = || {
        let workshop = Workshop::open(Arc::default(), 48_000.0);
        let mut stage = stage(0).patient();
        (0u8..60)
            .flat_map(|turn| {
                stage.turn(usize::from(turn) * 5 % 7, &workshop);
                stage.hit(60 + turn % 12, &Hit::plain(0.9));
                if turn % 9 == 0 {
                    stage.each(Engine::choke_all);
                }
                render(&mut stage, 480)
            })
            .collect::<Vec<_>>()
    };
    let first = render();
    assert!((0..4).all(|_| render() == first));
}

#[test]
fn a_change_of_mind_gets_the_last_wish_and_many_changes_wait_for_silence() {
    let bench = Arc::new(Bench::new(Arc::default(), 48_000.0));
    let mut stage = stage(0);
    stage.turn(1, &bench);
    bench.work();
    stage.turn(2, &bench);
    assert_eq!(stage.number, 0, "the first is no longer wanted");
    for _ in 0..2 {
        bench.work();
        stage.turn(2, &bench);
    }
    assert_eq!(stage.number, 2);
    for turn in 0..10 {
        let wanted = if turn % 2 == 0 { 3 } else { 4 };
        stage.hit(60, &Hit::plain(1.0));
        render(&mut stage, 64);
        let mut patience = 0;
        while stage.number != wanted && patience < 100 {
            stage.turn(wanted, &bench);
            bench.work();
            render(&mut stage, 4800);
            patience += 1;
        }
    }
    assert_eq!(stage.number, 4);
}
