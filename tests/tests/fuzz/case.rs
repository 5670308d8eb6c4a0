//! Cases one after the other, for as long as they are to last.

use idiophone_tests::Noise;
use std::fmt::Debug;
use std::str::FromStr;
use std::time::{Duration, Instant};

/// Readers that share the time.
const READERS: f64 = 7.0;

fn number<T: FromStr<Err: Debug>>(name: &str, usual: T) -> T {
    let text = std::env::var(name).ok();
    text.map_or(usual, |text| text.parse().unwrap())
}

/// Says which case it was that failed.
struct Told(&'static str, u64);

impl Drop for Told {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("{}: case of seed {}", self.0, self.1);
        }
    }
}

/// Hands a new chance to each case of a reader, and tells how many there were and how many of these were
/// accepted.
pub(crate) fn cases(reader: &'static str, mut case: impl FnMut(&mut Noise) -> bool) {
    let time = Duration::from_secs_f64(60.0 * number("IDIOPHONE_FUZZ_MINUTES", 1.0_f64) / READERS);
    let first = number("IDIOPHONE_FUZZ_SEED", 0_u64);
    let start = Instant::now();
    let (mut count, mut accepted) = (0_u64, 0_u64);
    while start.elapsed() < time {
        let seed = first.wrapping_mul(1 << 40) + count;
        let told = Told(reader, seed);
        accepted += u64::from(case(&mut Noise::new(seed + 1)));
        drop(told);
        count += 1;
    }
    println!("{reader}: {count} cases, {accepted} of them accepted");
    assert!(accepted > 0, "some change nothing that matters");
    assert!(accepted < count, "some are refused");
}
