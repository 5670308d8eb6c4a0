//! What this process takes of memory, where the system says so.

/// What is allocated and not given back, in MiB, of whatever library: a store that only grows shows here,
/// and what the allocator keeps for later does not.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[expect(unsafe_code, reason = "the C library is asked")]
pub(crate) fn alive_mib() -> Option<f64> {
    // SAFETY: it takes nothing, and returns plain data.
    let said = unsafe { libc::mallinfo2() };
    Some((said.uordblks + said.hblkhd) as f64 / f64::from(1 << 20))
}

/// What is resident once the allocator has given back what it only keeps, in MiB.
#[cfg(all(target_os = "linux", target_env = "gnu"))]
#[expect(unsafe_code, reason = "the C library is asked")]
pub(crate) fn trimmed_mib() -> Option<f64> {
    // SAFETY: what is allocated stays.
    unsafe { libc::malloc_trim(0) };
    resident_mib()
}

/// As above, where no library tells.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
pub(crate) fn alive_mib() -> Option<f64> {
    None
}

/// As above, where no library tells.
#[cfg(not(all(target_os = "linux", target_env = "gnu")))]
pub(crate) fn trimmed_mib() -> Option<f64> {
    None
}

/// What of memory is this process's own, in MiB.
pub(crate) fn resident_mib() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/statm").ok()?;
    let pages: f64 = text.split(' ').nth(1)?.parse().ok()?;
    Some(pages * 4096.0 / f64::from(1 << 20))
}
