//! Which vector instructions the engine is held to.

use idiophone::engine::Engine;
use modes::Bank;

/// What a vector register is called where it is sold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Vectors(&'static str);

impl Vectors {
    /// The widest that the engine uses on this machine.
    fn widest() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::is_x86_feature_detected as has;
            if has!("avx512f") && has!("avx512bw") && has!("avx512dq") && has!("avx512vl") {
                return Self("avx512");
            }
            if has!("avx2") && has!("fma") {
                return Self("avx2");
            }
        }
        Self(if cfg!(target_arch = "aarch64") {
            "neon"
        } else {
            "scalar"
        })
    }

    /// Those named, or the widest there are.
    pub(crate) fn choose(name: Option<&str>) -> Result<Self, String> {
        let widest = Self::widest();
        match name {
            Some(name) if name != widest.0 => Err(format!(
                "{name}: the engine takes the widest vectors there are, here {}",
                widest.0
            )),
            _ => Ok(widest),
        }
    }

    /// Their name.
    pub(crate) fn name(self) -> &'static str {
        self.0
    }

    /// An engine that uses them.
    pub(crate) fn engine(self, bank: &Bank, rate_hz: f64) -> Engine {
        Engine::new(bank, rate_hz)
    }
}
