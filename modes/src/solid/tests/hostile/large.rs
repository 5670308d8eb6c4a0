//! A million triangles, and the memory that the worst of what people bring takes.

use super::fate;
use super::files::apart;
use super::random::Random;
use crate::solid::{Soup, gallery, write_obj};
use std::time::{Duration, Instant};

/// How long any of these may take a processor of its own.
const BOUND: Duration = Duration::from_secs(60);

/// What all of it may take, in KiB of addresses, which are more than are ever used.
#[cfg(target_os = "linux")]
const MOST_KIB: usize = 4 << 20;

/// A ball of 20 · 4⁸ = 1,310,720 triangles.
fn ball() -> Soup {
    gallery::sphere(0.5, 8)
}

/// A ball's triangles, each with points of its own, to five digits: a file of more than half the bytes that are read.
fn loose() -> String {
    let mut ball = ball();
    for x in ball.points.iter_mut().flatten() {
        *x = (1e5 * *x).round() / 1e5;
    }
    apart(&ball)
}

/// A ball whose points were all moved by up to a twentieth of its radius: its skin goes through itself everywhere.
fn crumpled() -> Soup {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut ball = ball();
    for x in ball.points.iter_mut().flatten() {
        *x += 0.05 * (random.below(1001) as f64 / 1000.0 - 0.5);
    }
    ball
}

/// A million triangles between points anywhere in a cube.
fn thrown() -> Soup {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let points = (0..500_000).map(|_| [0; 3].map(|_| random.below(1001) as f64));
    let points: Vec<[f64; 3]> = points.collect();
    let corner = |random: &mut Random| random.below(points.len()) as u32;
    let triangles = (0..1_000_000).map(|_| [0; 3].map(|_| corner(&mut random)));
    let triangles = triangles.collect();
    Soup::single(points, triangles)
}

/// The most memory that this process has used, in MiB, where the system tells it.
fn peak_mib() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kib: usize = line.split_whitespace().next()?.parse().ok()?;
    Some(kib >> 10)
}

/// The time that the system has run this thread for, where it tells that: other work is none of its own.
fn ran() -> Option<Duration> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds = text.split_whitespace().next()?.parse().ok()?;
    Some(Duration::from_nanos(nanoseconds))
}

/// Does some work on one thread, and tells how long that took it.
fn timed<T: Send>(work: impl FnOnce() -> T + Send) -> (T, Duration) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.unwrap().install(|| {
        let (start, before) = (Instant::now(), ran());
        let done = work();
        let own = before.zip(ran()).map(|(before, after)| after - before);
        (done, own.unwrap_or_else(|| start.elapsed()))
    })
}

#[test]
#[ignore = "run under a limit of memory by what_people_bring_takes_less_than_4_gib"]
fn a_million_triangles_are_repaired_or_refused_in_time() {
    let volume = 4.0 / 3.0 * std::f64::consts::PI / 8.0;
    for (name, text, expected) in [
        ("a ball", write_obj(&ball()), Some(volume)),
        ("points apart", loose(), Some(volume)),
        ("crumpled", write_obj(&crumpled()), None),
        ("thrown", write_obj(&thrown()), None),
    ] {
        let (found, passed) = timed(|| fate(text.as_bytes()));
        println!(
            "{name}: {} MB, {found:?}, {passed:.1?}, at most {:?} MiB so far",
            text.len() / 1_000_000,
            peak_mib()
        );
        assert!(passed < BOUND, "{name}: {passed:?}");
        if let Some(volume) = expected {
            let (found, _) = found.unwrap();
            assert!((found / volume - 1.0).abs() < 0.03, "{name}: {found}");
        }
    }
}

/// In a process that gets no more from the system.
#[cfg(target_os = "linux")]
#[test]
fn what_people_bring_takes_less_than_4_gib() {
    let limited = format!("ulimit -v {MOST_KIB} && exec \"$0\" \"$@\"");
    let tests = std::env::current_exe().unwrap();
    let done = std::process::Command::new("sh")
        .args(["-c", &limited])
        .arg(tests)
        .args(["solid::tests::hostile", "--include-ignored", "--nocapture"])
        .args(["--skip", "what_people_bring", "--test-threads", "1"])
        .output()
        .unwrap();
    let [told, errors] = [&done.stdout, &done.stderr].map(|text| String::from_utf8_lossy(text));
    println!("{told}");
    assert!(done.status.success(), "{errors}");
    assert!(told.contains("4 passed"), "{told}");
}
