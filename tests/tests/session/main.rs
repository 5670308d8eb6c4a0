//! A long session: whatever a musician and a host may do to one instance, for as long as one likes.
//!
//! `IDIOPHONE_SESSION_MINUTES=20 cargo test -p idiophone-tests --test session -- --nocapture` plays
//! the long ones. Any allocation in `process` aborts it. It has a process to itself, whose memory it measures.

#![expect(clippy::unwrap_used, reason = "tests fail by panicking")]

mod memory;

use idiophone_tests::{BOUND, Noise, peak, plugin, random};
use memory::{alive_mib, resident_mib, trimmed_mib};
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};
use tempfile::TempDir;
use xtask::host::{Event, Param, ParamId, Plugin};

/// Length unless the environment says otherwise, in s.
const SHORT_S: f64 = 60.0;
/// The same where each drawing is waited for.
const SHORT_OFFLINE_S: f64 = 30.0;
/// Rates that hosts run at, and two that they hardly do, in Hz.
const RATES_HZ: [u32; 8] = [
    44_100, 48_000, 48_000, 48_000, 88_200, 96_000, 8_000, 192_000,
];
/// Ten fingers and a mod wheel.
const EVENTS_PER_S: f64 = 60.0;
const BLOCKS: [u32; 6] = [16, 64, 128, 256, 480, 2048];
/// What all factory banks take, which stay once they are read.
const FACTORY_MIB: f64 = 32.0;
/// What those and one instance take.
const MOST_MIB: f64 = 128.0;

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
    /// Most that was alive when it was looked at, in MiB.
    most_alive_mib: f64,
    /// What was resident at half time and at the end, in MiB.
    resident_mib: [Option<f64>; 2],
}

/// The length of a session that is so short unless the environment says otherwise, in s.
fn wanted_s(short_s: f64) -> f64 {
    let minutes = std::env::var("IDIOPHONE_SESSION_MINUTES").ok();
    minutes.map_or(short_s, |text| 60.0 * text.parse::<f64>().unwrap())
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

/// States of some time before, where they are no memory of this process.
struct States {
    folder: TempDir,
    kept: u64,
}

impl States {
    fn file(&self, number: u64) -> PathBuf {
        self.folder.path().join(number.to_string())
    }

    /// Loads one, with a tuning now and then, good or bad.
    fn load(&mut self, plugin: &mut Plugin, noise: &mut Noise) {
        if self.kept < 16 {
            std::fs::write(self.file(self.kept), plugin.save().unwrap()).unwrap();
            self.kept += 1;
        }
        match noise.below(4) {
            0 => plugin.tune("thirds\n3\n400.0\n800.\n2/1\n", "").unwrap(),
            1 => plugin.tune("bad\n1\n", "7").unwrap(),
            _ => {
                let file = self.file(noise.below(self.kept));
                plugin.load(&std::fs::read(file).unwrap()).unwrap();
            }
        }
    }
}

/// A session of so many seconds.
fn session(plugin: &mut Plugin, wanted_s: f64) -> Report {
    let params = plugin.params();
    let instrument = params[0].id;
    assert_eq!(params[0].name, "Instrument");
    let mut noise = Noise::new(20);
    let mut report = Report::default();
    let mut states = States {
        folder: tempfile::tempdir().unwrap(),
        kept: 0,
    };
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
            play(plugin, &mut noise, now, &mut report);
            if noise.below(4) == 0 {
                states.load(plugin, &mut noise);
                report.states += 1;
            }
        }
        report.most_alive_mib = alive_mib().unwrap_or(0.0).max(report.most_alive_mib);
        plugin.deactivate();
        // By then every bank has been read, and every state kept.
        if report.seconds > 0.5 * wanted_s {
            report.resident_mib[0] = report.resident_mib[0].or(resident_mib());
        }
    }
    // All is silent after all sound off: nothing that is no number is left over.
    plugin.activate(48_000.0, 512).unwrap();
    let hush = [Event::controller(120, 0).at(0)];
    plugin.play(&hush, 48_000, 512).unwrap();
    let after = plugin.play(&[], 4800, 512).unwrap();
    assert_eq!(peak(&after.left), 0.0);
    report.resident_mib[1] = resident_mib();
    let busy = report.busy.as_secs_f64();
    println!(
        "{report:#?}\n{:.1} % of real time in the plug-in, {:.0} s in all",
        100.0 * busy / report.seconds,
        started.elapsed().as_secs_f64()
    );
    assert!(report.peak > 0.0 && report.peak < BOUND, "{}", report.peak);
    report
}

/// Sessions are one after the other: all of them measure the memory of one process.
static ALONE: Mutex<()> = Mutex::new(());

#[test]
fn a_long_session_stays_finite_and_allocates_nothing() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut plugin = plugin().unwrap();
    // Shapes that are automated would all be waited for.
    plugin.go_live().unwrap();
    let report = session(&mut plugin, wanted_s(SHORT_S));
    // Threads come and go, and each leaves the allocator a little to keep.
    if let [Some(early), Some(late)] = report.resident_mib {
        assert!(late < early + 64.0, "{early} MiB became {late} MiB");
    }
}

#[test]
fn a_long_render_keeps_no_more_than_it_plays() {
    let _alone = ALONE.lock().unwrap_or_else(PoisonError::into_inner);
    let before = alive_mib();
    let mut plugin = plugin().unwrap();
    let report = session(&mut plugin, wanted_s(SHORT_OFFLINE_S));
    drop(plugin);
    if let (Some(before), Some(after)) = (before, alive_mib()) {
        // Arenas of threads that have gone keep several times what is alive.
        let trimmed = trimmed_mib().unwrap_or(0.0);
        println!(
            "{before:.0} MiB alive before, {after:.0} MiB after; {trimmed:.0} MiB resident when trimmed"
        );
        let most = report.most_alive_mib - before;
        assert!(most < MOST_MIB, "{most:.0} MiB of one instance");
        assert!(after < before + FACTORY_MIB, "{before} MiB became {after}");
    }
}
