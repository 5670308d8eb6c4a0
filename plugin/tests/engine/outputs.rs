//! Bodies on outputs of their own.

use crate::support::chimes;
use idiophone::engine::{Engine, Hit, OUTPUTS, Outputs, Settings, Split};
use nice_assert_no_alloc::assert_no_alloc;

const RATE_HZ: f64 = 48_000.0;

/// What sounds on left and right of each output.
type Sound = Vec<[Vec<f32>; 2]>;

fn silence(frames: usize) -> Sound {
    vec![[vec![f32::NAN; frames], vec![f32::NAN; frames]]; OUTPUTS]
}

/// Renders to all outputs, from sample `from` on.
fn render(engine: &mut Engine, sound: &mut Sound, from: usize, to: usize) {
    let mut pairs = sound.iter_mut().map(|[left, right]| {
        let (left, right) = (&mut left[from..to], &mut right[from..to]);
        (left, right)
    });
    let (left, right) = pairs.next().expect("there is a main output");
    let mut outputs = Outputs::main(left, right);
    for (number, (left, right)) in (1..).zip(pairs) {
        outputs.connect(number, left, right);
    }
    engine.render(&mut outputs);
}

fn settings(split: Split) -> Settings {
    Settings {
        split,
        limiter: false,
        ..Settings::default()
    }
}

fn engine(split: Split) -> Engine {
    let mut engine = Engine::new(&chimes((48..=90).step_by(3)), RATE_HZ);
    engine.set(&settings(split));
    engine
}

fn on(channel: u8) -> Hit {
    Hit {
        channel,
        ..Hit::plain(0.7)
    }
}

/// What happens before the block of that number.
fn play(engine: &mut Engine, block: usize) {
    let key = 48 + 3 * (block * 7 % 15) as u8;
    match block % 5 {
        0 | 1 => {
            engine.hit(key, &on((block % 16) as u8));
        }
        2 => engine.choke(key),
        _ => engine.release(key),
    }
}

fn peak(sound: &[f32]) -> f32 {
    sound.iter().fold(0.0, |most, x| x.abs().max(most))
}

/// A passage in blocks of odd lengths, in which the outputs are dealt out anew now and then if `changes`.
fn passage(split: Split, changes: bool, mut block: impl FnMut(&mut Engine, usize, usize)) {
    let mut engine = engine(split);
    let mut done = 0;
    for number in 0..200 {
        if changes && number % 40 == 39 {
            engine.set(&settings(Split::ALL[number / 40 % 4]));
        }
        play(&mut engine, number);
        let next = done + 37 * (number % 9) + 1;
        block(&mut engine, done, next);
        done = next;
    }
}

const PASSAGE: usize = 29_666;

/// The passage on all outputs.
fn on_all(split: Split, changes: bool) -> Sound {
    let mut sound = silence(PASSAGE);
    let mut end = 0;
    passage(split, changes, |engine, from, to| {
        render(engine, &mut sound, from, to);
        end = to;
    });
    for side in sound.iter_mut().flatten() {
        side.truncate(end);
    }
    sound
}

/// The passage on one output.
fn on_one(split: Split, changes: bool) -> [Vec<f32>; 2] {
    let mut sound = [vec![f32::NAN; PASSAGE], vec![f32::NAN; PASSAGE]];
    let mut end = 0;
    passage(split, changes, |engine, from, to| {
        let [left, right] = &mut sound;
        engine.process(&mut left[from..to], &mut right[from..to]);
        end = to;
    });
    sound.map(|side| side[..end].to_vec())
}

#[test]
fn all_in_main_is_the_plain_output_to_the_bit() {
    let (all, one) = (on_all(Split::Main, false), on_one(Split::Main, false));
    assert!(peak(&one[0]) > 0.01);
    assert_eq!(all[0], one);
    for side in all[1..].iter().flatten() {
        assert!(side.iter().all(|x| x.to_bits() == 0));
    }
}

#[test]
fn outputs_that_are_not_connected_are_in_main() {
    let plain = on_one(Split::Main, false);
    for split in [Split::Octave, Split::Body, Split::Channel] {
        let split = on_one(split, false);
        for (plain, split) in plain.iter().flatten().zip(split.iter().flatten()) {
            assert!((plain - split).abs() < 1e-6, "{plain} {split}");
        }
    }
}

#[test]
fn the_outputs_add_up_to_the_plain_one_while_bodies_move_too() {
    for (split, changes) in [
        (Split::Octave, false),
        (Split::Body, false),
        (Split::Channel, false),
        (Split::Main, true),
    ] {
        let (all, plain) = (on_all(split, changes), on_one(Split::Main, false));
        let mut heard = 0;
        for output in &all {
            heard += usize::from(peak(&output[0]) > 1e-3);
        }
        assert!(heard >= 4, "{split:?}: {heard} outputs are heard");
        for (side, plain) in plain.iter().enumerate() {
            for (n, plain) in plain.iter().enumerate() {
                let sum: f32 = all.iter().map(|output| output[side][n]).sum();
                assert!((sum - plain).abs() < 2e-6, "{split:?} {n}: {sum} {plain}");
            }
        }
    }
}

#[test]
fn each_body_is_where_it_belongs_and_nowhere_else() {
    for (split, key, channel, output) in [
        (Split::Main, 60, 5, 0),
        (Split::Octave, 48, 0, 2),
        (Split::Octave, 60, 5, 3),
        (Split::Octave, 90, 5, 5),
        (Split::Body, 48, 5, 0),
        (Split::Body, 51, 5, 1),
        (Split::Body, 75, 5, 1),
        (Split::Channel, 60, 0, 0),
        (Split::Channel, 60, 7, 7),
        (Split::Channel, 60, 9, 0),
    ] {
        let mut engine = engine(split);
        engine.hit(key, &on(channel));
        let mut sound = silence(4800);
        render(&mut engine, &mut sound, 0, 4800);
        for (number, [left, right]) in sound.iter().enumerate() {
            let heard = peak(left).max(peak(right));
            assert_eq!(heard > 0.0, number == output, "{split:?} {key} {channel}");
        }
    }
}

#[test]
fn a_body_that_sounds_moves_without_a_step() {
    let mut engine = engine(Split::Main);
    engine.hit(60, &on(0));
    let mut sound = silence(9600);
    render(&mut engine, &mut sound, 0, 4801);
    engine.set(&settings(Split::Octave));
    render(&mut engine, &mut sound, 4801, 9600);
    let steps = |sound: &[f32]| {
        let steps = sound.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        steps.fold(0.0, f32::max)
    };
    let around = 4700..5200;
    let whole: Vec<f32> = around
        .clone()
        .map(|n| sound[0][0][n] + sound[3][0][n])
        .collect();
    // The way takes 5 ms: 240 samples.
    let most = steps(&whole) + peak(&whole) / 240.0 + 1e-6;
    for output in [0, 3] {
        let step = steps(&sound[output][0][around.clone()]);
        assert!(step <= most, "output {output}: {step} over {most}");
    }
    assert!(peak(&whole) / 240.0 < 0.5 * peak(&whole[..100]));
    assert_eq!(peak(&sound[3][0][..4801]), 0.0);
    assert_eq!(peak(&sound[0][0][4801 + 32 + 240..]), 0.0);
    assert!(peak(&sound[3][0][4801 + 32 + 240..]) > 0.01);
}

#[test]
fn the_sound_does_not_depend_on_the_blocks() {
    let whole = |cut: usize| {
        let mut engine = engine(Split::Body);
        let mut sound = silence(9600);
        let mut now = 0;
        for (at, key, split) in [
            (0, 48, Split::Body),
            (999, 60, Split::Channel),
            (2048, 51, Split::Channel),
            (5001, 60, Split::Octave),
            (9600, 60, Split::Octave),
        ] {
            while now < at {
                let next = at.min(now + cut);
                render(&mut engine, &mut sound, now, next);
                now = next;
            }
            engine.set(&settings(split));
            engine.hit(key, &on((at % 16) as u8));
        }
        sound
    };
    let expected = whole(9600);
    for cut in [1, 31, 64, 511] {
        assert!(whole(cut) == expected, "blocks of {cut}");
    }
}

#[test]
fn each_output_has_a_limiter_of_its_own() {
    let loud = Settings {
        gain_db: 12.0,
        limiter: true,
        ..settings(Split::Channel)
    };
    let mut engine = engine(Split::Channel);
    engine.set(&loud);
    engine.hit(60, &on(1));
    let mut soft = silence(4800);
    render(&mut engine, &mut soft, 0, 4800);
    engine.reset();
    engine.hit(60, &on(1));
    for _ in 0..24 {
        for key in [72, 75, 78, 81, 84, 87] {
            engine.hit(
                key,
                &Hit {
                    channel: 2,
                    ..Hit::plain(1.0)
                },
            );
        }
    }
    let mut both = silence(4800);
    render(&mut engine, &mut both, 0, 4800);
    assert!(peak(&both[2][0]) > 0.99 && peak(&both[2][0]) <= 1.0);
    assert_eq!(soft[1], both[1]);
}

#[test]
fn dealing_bodies_out_allocates_nothing() {
    let mut engine = engine(Split::Body);
    let mut sound = silence(2000);
    let settings = Split::ALL.map(settings);
    let mut buffers = sound.iter_mut().map(|[left, right]| (left, right));
    let (left, right) = buffers.next().expect("there is a main output");
    let mut outputs = Outputs::main(left, right);
    for (number, (left, right)) in (1..).zip(buffers) {
        outputs.connect(number, left, right);
    }
    // Aborts on the first allocation.
    assert_no_alloc(|| {
        for block in 0..200 {
            engine.set(&settings[block / 25 % 4]);
            play(&mut engine, block);
            engine.render(&mut outputs.part(10 * block..10 * block + 10));
        }
    });
}
