//! The instrument that is struck, and those before it that still ring.

mod handover;
mod patience;

use crate::engine::{Engine, GRID, Hit, Hold, Limiter, OUTPUTS, Outputs, Room, Settings, Trims};
use crate::workshop::Bench;
use handover::Handover;
use modes::Bank;
use patience::Patience;
use std::sync::Arc;

/// Instruments before the present one that may ring at the same time.
const RINGING: usize = 4;

/// An instrument, and the bodies whose last blow was its own, as bits.
struct Act {
    engine: Box<Engine>,
    struck: u128,
}

/// The instruments that sound.
///
/// Only [`Stage::new`] allocates.
pub(crate) struct Stage {
    /// Whether to wait for instruments and their drawings, as when rendering offline: then they enter at
    /// the sample where they were asked for.
    patient: bool,
    present: Act,
    number: usize,
    /// The last number asked for.
    wanted: usize,
    ringing: [Option<Act>; RINGING],
    settings: Settings,
    /// After the sum of all, output by output; instruments have none of their own.
    limiters: [Limiter; OUTPUTS],
    limits: bool,
    /// What hands do to each body, of whatever instrument.
    holds: [Hold; 128],
    trims: Trims,
    handover: Handover,
    patience: Patience,
    /// Who makes instruments, if they are waited for.
    bench: Option<Arc<Bench>>,
    rate_hz: f64,
}

impl Stage {
    /// The instrument of a number, at rest.
    pub(crate) fn new(number: usize, bank: &Bank, rate_hz: f64) -> Self {
        Self {
            patient: false,
            present: Act::new(Box::new(Engine::new(bank, rate_hz))),
            number,
            wanted: number,
            ringing: [const { None }; RINGING],
            settings: Settings::default(),
            limiters: [Limiter::new(1.0 / rate_hz); OUTPUTS],
            limits: true,
            holds: [Hold::FREE; 128],
            trims: Trims::NONE,
            handover: Handover::default(),
            patience: Patience::default(),
            bench: None,
            rate_hz,
        }
    }

    /// The same, but waiting for instruments, which is not for a real-time thread.
    pub(crate) fn patient(self) -> Self {
        Self {
            patient: true,
            ..self
        }
    }

    /// The instrument that is struck, and its number.
    #[cfg(feature = "gui")]
    pub(crate) fn present(&self) -> (usize, &Engine) {
        (self.number, &self.present.engine)
    }

    /// Brings the wanted instrument on as soon as the workshop has it.
    ///
    /// What rang goes on ringing. If too much does, the instrument that has rung longest is silenced
    /// by hand, and the new one comes when it is still.
    pub(crate) fn turn(&mut self, wanted: usize, bench: &Arc<Bench>) {
        if self.patient {
            self.bench.get_or_insert_with(|| Arc::clone(bench));
        }
        self.clear(bench);
        if wanted != self.wanted {
            self.wanted = wanted;
            if wanted != self.number {
                bench.ask(wanted);
            }
        }
        if self.is_due() {
            self.come(bench);
        }
    }

    /// Whether another instrument is to come now. The present one first becomes one again.
    fn is_due(&self) -> bool {
        self.wanted != self.number && !self.handover.is_fading()
    }

    /// Brings the wanted instrument on if the workshop has it and there is room.
    fn come(&mut self, bench: &Bench) {
        let Some(slot) = self.ringing.iter().position(Option::is_none) else {
            if let Some(oldest) = &mut self.ringing[0] {
                oldest.engine.choke_all();
                oldest.struck = 0;
            }
            return;
        };
        let ready = if self.patient {
            let ready = bench.wait(self.wanted);
            self.patient = ready.is_some();
            ready
        } else {
            bench.fetch()
        };
        match ready {
            Some((number, engine)) if number == self.wanted => self.enter(slot, number, engine),
            // Asked for before the last change of mind: it rings out at once, being silent.
            Some((_, engine)) => {
                self.ringing[slot] = Some(Act::new(engine));
                bench.ask(self.wanted);
            }
            None => {}
        }
    }

    fn enter(&mut self, slot: usize, number: usize, engine: Box<Engine>) {
        let mut act = Act::new(engine);
        act.engine.set(&self.settings);
        act.engine.set_trims(&self.trims);
        for (body, hold) in (0..).zip(&self.holds) {
            act.hold(body, hold);
        }
        self.ringing[slot] = Some(std::mem::replace(&mut self.present, act));
        self.number = number;
    }

    /// Hands over what has rung out; the others move up, the oldest first.
    fn clear(&mut self, bench: &Bench) {
        let discard = if self.patient {
            Bench::discard_surely
        } else {
            Bench::discard
        };
        for slot in &mut self.ringing {
            if slot.as_ref().is_some_and(|act| act.engine.awake() == 0) {
                let kept = |act: Act| discard(bench, act.engine).err();
                *slot = slot.take().and_then(kept).map(Act::new);
            }
        }
        for slot in 1..RINGING {
            if self.ringing[slot - 1].is_none() {
                self.ringing.swap(slot - 1, slot);
            }
        }
    }

    fn acts(&mut self) -> impl Iterator<Item = &mut Act> {
        let present = std::iter::once(&mut self.present);
        present.chain(self.ringing.iter_mut().flatten())
    }

    /// Calls `act` for every instrument that sounds.
    pub(crate) fn each(&mut self, act: impl Fn(&mut Engine)) {
        self.acts().for_each(|on| act(&mut on.engine));
    }

    /// New targets for all.
    pub(crate) fn set(&mut self, settings: &Settings) {
        self.limits = settings.limiter;
        let settings = Settings {
            limiter: false,
            ..*settings
        };
        self.settings = settings;
        self.each(|engine| engine.set(&settings));
    }

    /// What is made of single modes of all.
    pub(crate) fn trim(&mut self, trims: &Trims) {
        self.trims = *trims;
        self.each(|engine| engine.set_trims(trims));
    }

    /// The keys for which the present instrument has bodies, as bits.
    pub(crate) fn bodies(&self) -> u128 {
        self.present.engine.bodies()
    }

    /// Strikes a body of the present instrument.
    pub(crate) fn hit(&mut self, body: u8, hit: &Hit) {
        for act in self.ringing.iter_mut().flatten() {
            act.struck &= !(1 << body);
        }
        if self.present.engine.hit(body, hit) {
            self.present.struck |= 1 << body;
        }
    }

    /// What hands do to a body; a bow is only on the instrument that was struck there last.
    pub(crate) fn hold(&mut self, body: u8, hold: &Hold) {
        if let Some(held) = self.holds.get_mut(usize::from(body)) {
            *held = *hold;
            self.acts().for_each(|act| act.hold(body, hold));
        }
    }

    /// Silence, at once.
    pub(crate) fn reset(&mut self) {
        self.holds = [Hold::FREE; 128];
        self.limiters.iter_mut().for_each(Limiter::reset);
        self.handover.reset();
        for act in self.acts() {
            act.engine.reset();
            act.struck = 0;
        }
    }

    /// The bodies that sound, bit 0 for key 0.
    pub(crate) fn awake(&self) -> u128 {
        let rest = self.ringing.iter().flatten();
        rest.fold(self.present.engine.awake(), |bodies, act| {
            bodies | act.engine.awake()
        })
    }

    /// Time after which nothing is heard any longer, in s, if nothing changes.
    pub(crate) fn tail_s(&self) -> f64 {
        let rest = self.ringing.iter().flatten();
        rest.fold(self.present.engine.tail_s(), |tail_s, act| {
            tail_s.max(act.engine.tail_s())
        })
    }

    /// Renders all samples of the outputs. What is to happen to drawings on the way happens at samples that
    /// do not depend on where blocks end.
    pub(crate) fn render(&mut self, out: &mut Outputs<'_>) {
        let frames = out.frames();
        self.tune_ahead(frames);
        let mut done = 0;
        while done < frames {
            let run = self.until_news().map_or(frames, |run| done + run);
            let until = run.min(frames);
            self.sound(&mut out.part(done..until));
            self.patience.pass(until - done);
            done = until;
            if self.is_due()
                && let Some(bench) = self.bench.clone()
            {
                self.come(&bench);
                self.redraw();
            }
            self.wait();
            if self.until_handover() == Some(0) {
                self.hand_over();
            }
        }
    }

    /// The same, with the instruments as they are.
    fn sound(&mut self, out: &mut Outputs<'_>) {
        self.present.engine.render(out);
        self.handover.mix(out);
        for act in self.ringing.iter_mut().flatten() {
            add(&mut act.engine, out);
        }
        if self.limits {
            for (output, sides) in out.each() {
                limit(&mut self.limiters[output], sides);
            }
        }
    }
}

impl Act {
    fn new(engine: Box<Engine>) -> Self {
        Self { engine, struck: 0 }
    }

    fn hold(&mut self, body: u8, hold: &Hold) {
        let mut hold = *hold;
        if self.struck >> (body & 127) & 1 == 0 {
            hold.bow_pressure = 0.0;
        }
        self.engine.hold(body, &hold);
    }
}

/// Adds what an instrument sounds like.
fn add(engine: &mut Engine, out: &mut Outputs<'_>) {
    let frames = out.frames();
    for done in (0..frames).step_by(GRID) {
        let mut part = out.part(done..frames.min(done + GRID));
        let mut more = Room::<GRID>::new();
        engine.render(&mut more.like(&part));
        for (output, sides) in part.each() {
            for (sum, more) in sides.into_iter().zip(more.pair(output)) {
                for (sum, more) in sum.iter_mut().zip(more) {
                    *sum += more;
                }
            }
        }
    }
}

/// Holds an output below full scale.
fn limit(limiter: &mut Limiter, [left, right]: [&mut [f32]; 2]) {
    for (left, right) in left.iter_mut().zip(right) {
        let limited = limiter.limit([*left, *right].map(f64::from));
        [*left, *right] = limited.map(|sample| sample as f32);
    }
}

#[cfg(test)]
mod tests;
