//! Time and memory, as the kernel counts them.

use anyhow::{Context, Result};
use std::fs;

/// Time that the kernel has run this thread for, in s.
pub(super) fn cpu_s() -> Result<f64> {
    const PATH: &str = "/proc/thread-self/schedstat";
    let text = fs::read_to_string(PATH)
        .with_context(|| format!("{PATH}: cannot read; CPU time is told on Linux only"))?;
    let nanoseconds = text.split_whitespace().next().unwrap_or_default();
    let nanoseconds: f64 = nanoseconds
        .parse()
        .with_context(|| format!("{PATH}: {text}"))?;
    Ok(1e-9 * nanoseconds)
}

/// Has the kernel measure the peak of this process's memory from here on.
pub(super) fn forget_peak() -> Result<()> {
    const PATH: &str = "/proc/self/clear_refs";
    const PEAK: &str = "5";
    fs::write(PATH, PEAK)
        .with_context(|| format!("{PATH}: cannot write; memory is told on Linux only"))
}

/// The most memory that this process has had since, in MiB.
pub(super) fn peak_mib() -> Result<f64> {
    const PATH: &str = "/proc/self/status";
    let text = fs::read_to_string(PATH)
        .with_context(|| format!("{PATH}: cannot read; memory is told on Linux only"))?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kib = line.and_then(|line| line.split_whitespace().next());
    let kib = kib.with_context(|| format!("{PATH}: no line of VmHWM"))?;
    let kib: f64 = kib.parse().with_context(|| format!("{PATH}: {kib}"))?;
    Ok(kib / 1024.0)
}
