//! A long session: whatever a musician and a host may do to one instance, for as long as one likes.
//!
//! `IDIOPHONE_SESSION_MINUTES=20 cargo test -p idiophone-tests --test session -- --nocapture` plays
//! the long one. Any allocation in `process` aborts it. It has a process to itself, whose memory it measures.

#![expect(clippy::unwrap_used, reason = "tests fail by panicking")]

use idiophone_tests::{BOUND, Noise, peak, plugin, random};
use std::time::{Duration, Instant};
use xtask::host::{Event, Param, ParamId, Plugin};

/// Length unless the environment says otherwise, in s.
const SHORT_S: f64 = 60.0;
/// Rates that hosts run at, and two that they hardly do, in Hz.
const RATES_HZ: [u32; 8] = [
    44_100, 48_000, 48_000, 48_000, 88_200, 96_000, 8_000, 192_000,
];
/// Ten fingers and a mod wheel.
const EVENTS_PER_S: f64 = 60.0;
const BLOCKS: [u32; 6] = [16, 64, 128, 256, 480, 2048];

/// What has come of a session.
#[derive(Debug, Default)]
struct Report {
    /// Sound that was made, in s.
    seconds: f64,
    blocks: u64,
    events: u64,
    notes_ended: u64,
    activations: u32,
    states: u32,
    resets: u32,
    peak: f32,
    /// Time in the plug-in.
    busy: Duration,
}

fn minutes() -> f64 {
    let minutes = std::env::var("IDIOPHONE_SESSION_MINUTES").ok();
    minutes.map_or(SHORT_S / 60.0, |text| text.parse().unwrap())
}

/// Events of a busy player in some time: mostly notes and pedals, now and then anything at all.
fn events(noise: &mut Noise, now: Now<'_>, time_s: f64) -> Vec<Event> {
    let Now {
        params, instrument, ..
    } = now;
    let anything = |noise: &mut Noise| {
        // Instruments change as a musician changes them.
        let event = random(noise, params);
        let changes = matches!(event, Event::Param { id, .. } if id == instrument);
        (!changes || noise.below(4) == 0).then_some(event)
    };
    let left = EVENTS_PER_S * time_s + noise.unit();
    let left = std::iter::successors(Some(left), |left| Some(left - 1.0));
    left.take_while(|left| *left >= 1.0)
        .filter_map(|_| {
            let key = 36 + noise.below(61) as u8;
            match noise.below(8) {
                0..4 => Some(Event::NoteOn {
                    channel: noise.below(2) as u8,
                    key,
                    note_id: u32::from(key),
                    velocity: noise.unit(),
                }),
                4 => Some(Event::NoteOff {
                    channel: noise.below(2) as u8,
                    key,
                    note_id: u32::from(key),
                    velocity: noise.unit(),
                }),
                5 => Some(Event::controller(64, noise.data_byte())),
                _ => anything(noise),
            }
        })
        .collect()
}

/// Plays for up to two seconds of sound.
fn play(plugin: &mut Plugin, noise: &mut Noise, now: Now<'_>, report: &mut Report) {
    let Now { rate_hz, block, .. } = now;
    let blocks = 1 + noise.below(u64::from(2 * rate_hz / block));
    let (resets, quiet) = (noise.below(20) == 0, noise.below(5) == 0);
    plugin
        .on_audio_thread(|audio| {
            if resets {
                audio.reset();
                report.resets += 1;
            }
            for _ in 0..blocks {
                let frames = 1 + noise.below(u64::from(block)) as usize;
                let mut events: Vec<_> = if quiet {
                    Vec::new()
                } else {
                    let time_s = frames as f64 / f64::from(rate_hz);
                    let events = events(noise, now, time_s).into_iter();
                    events
                        .map(|event| event.at(noise.below(frames as u64)))
                        .collect()
                };
                events.sort_by_key(|event| event.frame);
                let (mut left, mut right) = (vec![0.0; frames], vec![0.0; frames]);
                let start = Instant::now();
                let said = audio.process(&events, &mut left, &mut right).unwrap();
                let took = start.elapsed();
                let sound = left.iter().chain(&right);
                assert!(sound.clone().all(|sample| sample.is_finite()));
                report.peak = report.peak.max(peak(&left)).max(peak(&right));
                report.busy += took;
                let time_s = frames as f64 / f64::from(rate_hz);
                report.seconds += time_s;
                report.blocks += 1;
                report.events += events.len() as u64;
                report.notes_ended += said.ended.len() as u64;
            }
        })
        .unwrap();
}

/// How an instance runs now.
#[derive(Clone, Copy)]
struct Now<'a> {
    rate_hz: u32,
    block: u32,
    params: &'a [Param],
    instrument: ParamId,
}

/// A state of some time before, with a tuning now and then, good or bad.
fn load(plugin: &mut Plugin, noise: &mut Noise, states: &mut Vec<Vec<u8>>) {
    if states.len() < 16 {
        states.push(plugin.save().unwrap());
    }
    match noise.below(4) {
        0 => plugin.tune("thirds\n3\n400.0\n800.\n2/1\n", "").unwrap(),
        1 => plugin.tune("bad\n1\n", "7").unwrap(),
        _ => {
            let at = noise.below(states.len() as u64) as usize;
            plugin.load(&states[at]).unwrap();
        }
    }
}

/// Memory of this process that is its own, in MiB; none where the system does not say.
fn resident_mib() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/statm").ok()?;
    let pages: f64 = text.split(' ').nth(1)?.parse().ok()?;
    Some(pages * 4096.0 / f64::from(1 << 20))
}

#[test]
fn a_long_session_stays_finite_and_allocates_nothing() {
    let wanted_s = 60.0 * minutes();
    let mut plugin = plugin().unwrap();
    // Shapes that are automated would all be waited for.
    plugin.go_live().unwrap();
    let params = plugin.params();
    let instrument = params[0].id;
    assert_eq!(params[0].name, "Instrument");
    let mut noise = Noise::new(20);
    let mut report = Report::default();
    let mut states = Vec::new();
    let mut early = None;
    let started = Instant::now();
    while report.seconds < wanted_s {
        let rate_hz = RATES_HZ[noise.below(8) as usize];
        let block = BLOCKS[noise.below(6) as usize];
        plugin.activate(f64::from(rate_hz), block).unwrap();
        report.activations += 1;
        for _ in 0..=noise.below(12) {
            let now = Now {
                rate_hz,
                block,
                params: &params,
                instrument,
            };
            play(&mut plugin, &mut noise, now, &mut report);
            if noise.below(4) == 0 {
                load(&mut plugin, &mut noise, &mut states);
                report.states += 1;
            }
        }
        plugin.deactivate();
        // By then every bank has been read, and every state kept.
        if report.seconds > 0.5 * wanted_s {
            early = early.or(resident_mib());
        }
    }
    // All is silent after all sound off: nothing that is no number is left over.
    plugin.activate(48_000.0, 512).unwrap();
    let hush = [Event::controller(120, 0).at(0)];
    plugin.play(&hush, 48_000, 512).unwrap();
    let after = plugin.play(&[], 4800, 512).unwrap();
    assert_eq!(peak(&after.left), 0.0);
    let busy = report.busy.as_secs_f64();
    println!(
        "{report:#?}\n{:.1} % of real time in the plug-in, {:.0} s in all",
        100.0 * busy / report.seconds,
        started.elapsed().as_secs_f64()
    );
    // Threads come and go, and each leaves the allocator a little to keep.
    if let (Some(early), Some(late)) = (early, resident_mib()) {
        println!("{early:.0} MiB at half time, {late:.0} MiB at the end");
        assert!(late < early + 64.0, "{early} MiB became {late} MiB");
    }
    assert!(report.peak > 0.0 && report.peak < BOUND, "{}", report.peak);
}
