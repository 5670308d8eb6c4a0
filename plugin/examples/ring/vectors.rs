//! Which vector instructions the engine is held to.

use idiophone::engine::{Engine, Vectors as Limit};
use modes::Bank;

/// What a vector register is called where it is sold, and how the engine is held to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Vectors(&'static str, Limit);

impl Vectors {
    /// The widest that the engine uses on this machine.
    fn widest() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::is_x86_feature_detected as has;
            if has!("avx512f") && has!("avx512bw") && has!("avx512dq") && has!("avx512vl") {
                return Self("avx512", Limit::Widest);
            }
            if has!("avx2") && has!("fma") {
                return Self("avx2", Limit::Widest);
            }
        }
        if cfg!(target_arch = "aarch64") {
            Self("neon", Limit::Widest)
        } else {
            Self("scalar", Limit::Widest)
        }
    }

    /// Those named, or the widest there are.
    pub(crate) fn choose(name: Option<&str>) -> Result<Self, String> {
        let widest = Self::widest();
        match name {
            None => Ok(widest),
            Some(name) if name == widest.0 => Ok(widest),
            Some("avx2") if widest.0 == "avx512" => Ok(Self("avx2", Limit::Avx2)),
            Some("scalar") => Ok(Self("scalar", Limit::Plain)),
            Some(name) => Err(format!(
                "{name}: this machine has no such vectors; the widest here are {}",
                widest.0
            )),
        }
    }

    /// Their name.
    pub(crate) fn name(self) -> &'static str {
        self.0
    }

    /// An engine that uses them.
    pub(crate) fn engine(self, bank: &Bank, rate_hz: f64) -> Engine {
        Engine::with_vectors(bank, rate_hz, self.1)
    }
}
