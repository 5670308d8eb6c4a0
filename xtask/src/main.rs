//! Commands over the two crates.

fn main() {}
