//! Damped complex oscillators: one multiplication per mode and step (O'Brien 2002, §3.4).

mod between;
mod drive;
mod heavy;
mod pack;
mod plain;
mod points;
mod ring;
#[cfg(test)]
mod tests;
mod tone;
mod tune;

use super::GRID;
pub(crate) use drive::{Drive, Step, TuneSteps};
pub(crate) use pack::{LANES, Pack};
use pulp::{Arch, WithSimd};
pub(crate) use ring::Room;
use std::ops::Range;
pub(crate) use tone::{CAUSES, Tone, turned};
pub(crate) use tune::Tune;

/// Left and right, sample by sample.
pub(crate) type Buses = [[f64; GRID]; 2];

/// Nothing on both buses.
pub(crate) const SILENT: Buses = [[0.0; GRID]; 2];

/// Which vectors to compute with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Vectors {
    /// The widest that the machine has.
    #[default]
    Widest,
    /// No wider than 256 bits (AVX2).
    Avx2,
    /// None but what the compiler makes of plain code.
    Plain,
}

/// The instructions to compute with, chosen once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kernel {
    wide: Arch,
    /// No wider than 256 bits: what is summed up across lanes at every step gains nothing from more.
    narrow: Arch,
}

impl Kernel {
    /// The widest that the machine has within `vectors`.
    pub(crate) fn new(vectors: Vectors) -> Self {
        #[cfg(target_arch = "x86_64")]
        let narrow = pulp::x86::V3::try_new().map_or(Arch::Scalar, Arch::V3);
        #[cfg(not(target_arch = "x86_64"))]
        let narrow = Arch::new();
        let [wide, narrow] = match vectors {
            Vectors::Widest => [Arch::new(), narrow],
            Vectors::Avx2 => [narrow; 2],
            Vectors::Plain => [Arch::Scalar; 2],
        };
        Self { wide, narrow }
    }

    /// Runs a task on all modes of a body.
    pub(crate) fn run(self, task: impl WithSimd<Output = ()>) {
        self.wide.dispatch(task);
    }

    /// The next samples of a body that something pushes.
    pub(crate) fn drive(self, task: Drive<'_>) {
        self.narrow.dispatch(task);
    }

    /// Writes what is heard of a cell of the packs in `ranges` to `out`, and moves them on by it if
    /// they are to `advance`. `hops` is room to work in.
    pub(crate) fn ring(
        self,
        packs: &mut [Pack],
        ranges: &[Range<usize>],
        advance: bool,
        room: &mut Room,
        out: &mut Buses,
    ) {
        self.wide.dispatch(ring::Ring {
            packs,
            ranges,
            advance,
            room,
            out,
        });
    }
}
