//! What rings freely, a cell of the grid at a time.

use super::GRID;
use super::body::{Body, Moved};
use super::oscillators::{Buses, Kernel, LANES, Pack, Room, SILENT};
use std::ops::Range;

/// The sum of all bodies of an output that nothing pushes, over one cell.
///
/// Modes whose gains move are heard twice, with the old gains and with the new ones, and faded over from
/// the one to the other.
pub(super) struct Cell {
    mix: Buses,
    /// Whether the cell has been rendered and is not yet over.
    open: bool,
    /// Packs as they were heard, as they are heard now, and those for which both are the same.
    old: Vec<Range<usize>>,
    new: Vec<Range<usize>>,
    same: Vec<Range<usize>>,
    left: Buses,
}

/// What the cells of all outputs need while they are worked on.
pub(super) struct Bench {
    room: Box<Room>,
    /// State of a body while its rest of a cell is taken out.
    kept: Vec<[[f64; LANES]; 2]>,
}

impl Bench {
    /// For an instrument of so many packs of modes.
    pub(super) fn new(packs: usize) -> Self {
        Self {
            room: Room::new(),
            kept: vec![[[0.0; LANES]; 2]; packs],
        }
    }
}

impl Cell {
    /// With nothing in it.
    pub(super) fn new() -> Self {
        Self {
            mix: SILENT,
            open: false,
            old: Vec::with_capacity(128),
            new: Vec::with_capacity(128),
            same: Vec::with_capacity(128),
            left: SILENT,
        }
    }

    /// A new cell, with nothing in it.
    pub(super) fn begin(&mut self) {
        self.old.clear();
        self.new.clear();
        self.same.clear();
        self.left = SILENT;
        self.open = true;
    }

    /// A new cell, with the same in it as in the last.
    pub(super) fn again(&mut self) {
        self.open = true;
    }

    /// The cell is over, or does not count.
    pub(super) fn close(&mut self) {
        self.open = false;
        self.mix = SILENT;
    }

    /// What of a body is to be heard otherwise from now on.
    pub(super) fn leave(&mut self, body: &Body, moved: Moved) {
        join(&mut self.old, split(body, moved).0);
    }

    /// A body sounds in this cell, its gains being those at its end.
    pub(super) fn enter(&mut self, body: &Body, moved: Moved) {
        let (new, same) = split(body, moved);
        join(&mut self.new, new);
        join(&mut self.same, same);
    }

    /// Renders what has left.
    pub(super) fn ring_left(&mut self, kernel: Kernel, bench: &mut Bench, packs: &mut [Pack]) {
        if !self.old.is_empty() {
            kernel.ring(packs, &self.old, false, &mut bench.room, &mut self.left);
        }
    }

    /// Renders what has entered, and moves it on.
    pub(super) fn ring_entered(&mut self, kernel: Kernel, bench: &mut Bench, packs: &mut [Pack]) {
        kernel.ring(packs, &self.same, true, &mut bench.room, &mut self.mix);
        if self.new.is_empty() && self.old.is_empty() {
            return;
        }
        let mut entered = SILENT;
        kernel.ring(packs, &self.new, true, &mut bench.room, &mut entered);
        for (mix, (left, entered)) in self.mix.iter_mut().zip(self.left.iter().zip(&entered)) {
            for (n, mix) in mix.iter_mut().enumerate() {
                *mix += left[n] + (entered[n] - left[n]) * (n as f64 / GRID as f64);
            }
        }
    }

    /// Writes the next `run` samples, which begin `phase` samples into the cell, to `buses`.
    pub(super) fn hear(&self, phase: usize, run: usize, buses: &mut Buses) {
        for (bus, mix) in buses.iter_mut().zip(&self.mix) {
            if self.open {
                bus[..run].copy_from_slice(&mix[phase..phase + run]);
            } else {
                bus[..run].fill(0.0);
            }
        }
    }

    /// Takes a body out that rings freely, to be pushed from `phase` samples into the cell on: what it
    /// would have sounded like until the end of the cell is taken off the sum.
    pub(super) fn take_out(
        &mut self,
        kernel: Kernel,
        bench: &mut Bench,
        (body, packs): (&mut Body, &mut [Pack]),
        phase: usize,
        step_s: f64,
    ) {
        if !self.open {
            return;
        }
        body.rewind(kernel, packs, step_s);
        let mut past = SILENT;
        let [left, right] = &mut past;
        let out = [&mut left[..phase], &mut right[..phase]];
        body.drive(kernel, packs, 0, step_s, out);
        let ringing = body.ringing();
        for (kept, pack) in bench.kept.iter_mut().zip(&packs[ringing.clone()]) {
            *kept = [pack.x, pack.y];
        }
        let mut rest = SILENT;
        let [left, right] = &mut rest;
        let out = [&mut left[phase..], &mut right[phase..]];
        body.drive(kernel, packs, phase, step_s, out);
        for (kept, pack) in bench.kept.iter().zip(&mut packs[ringing]) {
            [pack.x, pack.y] = *kept;
        }
        for (mix, rest) in self.mix.iter_mut().zip(&rest) {
            for (mix, rest) in mix[phase..].iter_mut().zip(&rest[phase..]) {
                *mix -= rest;
            }
        }
    }
}

/// The ringing packs of a body: those to be heard otherwise, and the rest.
fn split(body: &Body, Moved(moved): Moved) -> (Range<usize>, Range<usize>) {
    let Range { start, end } = body.ringing();
    let middle = (start + moved).min(end);
    (start..middle, middle..end)
}

/// Lists a range of packs, in one with the last if it goes on where that ends.
fn join(list: &mut Vec<Range<usize>>, next: Range<usize>) {
    match list.last_mut() {
        _ if next.is_empty() => {}
        Some(last) if last.end == next.start => last.end = next.end,
        _ => list.push(next),
    }
}
