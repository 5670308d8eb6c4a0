//! Readers of what people bring, fed with good files gone wrong: none may panic.
//!
//! `IDIOPHONE_FUZZ_MINUTES=60 cargo test -p idiophone-tests --test fuzz -- --nocapture` feeds them for an hour;
//! without it, for a minute. `IDIOPHONE_FUZZ_SEED` makes other cases.

#![expect(clippy::unwrap_used, reason = "tests fail by panicking")]

mod bank;
mod case;
mod mesh;
mod mutate;
mod preset;
mod state;
mod text;
