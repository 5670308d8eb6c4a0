//! The instrument that is struck, and those before it that still ring.

use crate::engine::{Engine, GRID, Hit, Hold, Limiter, Settings};
use crate::workshop::Bench;
use modes::Bank;

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
    /// Whether to wait for an instrument, as when rendering offline: then it enters at the sample
    /// where it was asked for.
    patient: bool,
    present: Act,
    number: usize,
    /// The last number asked for.
    wanted: usize,
    ringing: [Option<Act>; RINGING],
    settings: Settings,
    /// After the sum of all; instruments have none of their own.
    limiter: Limiter,
    limits: bool,
    /// What hands do to each body, of whatever instrument.
    holds: [Hold; 128],
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
            limiter: Limiter::new(1.0 / rate_hz),
            limits: true,
            holds: [Hold::FREE; 128],
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
    pub(crate) fn turn(&mut self, wanted: usize, bench: &Bench) {
        self.clear(bench);
        if wanted != self.wanted {
            self.wanted = wanted;
            if wanted != self.number {
                bench.ask(wanted);
            }
        }
        if self.wanted == self.number {
            return;
        }
        let Some(slot) = self.ringing.iter().position(Option::is_none) else {
            if let Some(oldest) = &mut self.ringing[0] {
                oldest.engine.choke_all();
                oldest.struck = 0;
            }
            return;
        };
        let ready = if self.patient {
            let ready = bench.wait(wanted);
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
        self.limiter.reset();
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

    /// Renders as many samples as the shorter of the two slices holds.
    pub(crate) fn process(&mut self, left: &mut [f32], right: &mut [f32]) {
        self.present.engine.process(left, right);
        let mut more = [[0.0; GRID]; 2];
        for act in self.ringing.iter_mut().flatten() {
            for (left, right) in left.chunks_mut(GRID).zip(right.chunks_mut(GRID)) {
                let [a, b] = &mut more;
                act.engine
                    .process(&mut a[..left.len()], &mut b[..right.len()]);
                add(left, a);
                add(right, b);
            }
        }
        if self.limits {
            for (left, right) in left.iter_mut().zip(right) {
                let limited = self.limiter.limit([*left, *right].map(f64::from));
                [*left, *right] = limited.map(|sample| sample as f32);
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

fn add(sum: &mut [f32], more: &[f32]) {
    for (sum, more) in sum.iter_mut().zip(more) {
        *sum += more;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factory;
    use crate::workshop::Workshop;
    use std::sync::Arc;

    fn stage(index: usize) -> Stage {
        Stage::new(index, factory::bank(index), 48_000.0)
    }

    fn render(stage: &mut Stage, frames: usize) -> Vec<f32> {
        let (mut left, mut right) = (vec![0.0; frames], vec![0.0; frames]);
        stage.process(&mut left, &mut right);
        left
    }

    /// Greatest step from sample to sample.
    fn step(signal: &[f32]) -> f32 {
        signal
            .windows(2)
            .fold(0.0, |most, pair| most.max((pair[1] - pair[0]).abs()))
    }

    #[test]
    fn what_rings_rings_out_when_the_instrument_changes() {
        let bench = Bench::new(Arc::default(), 48_000.0);
        let (mut stage, mut twin) = (stage(0), stage(0));
        for stage in [&mut stage, &mut twin] {
            stage.hit(60, &Hit::plain(0.8));
            render(stage, 1000);
        }
        stage.turn(1, &bench);
        assert!(bench.work(), "asked for");
        stage.turn(1, &bench);
        assert!(!bench.work(), "once");
        assert_eq!(stage.number, 1);
        assert_eq!(render(&mut stage, 1000), render(&mut twin, 1000));
        stage.hit(60, &Hit::plain(0.5));
        let both = render(&mut stage, 4800);
        assert!(step(&both) < 0.05, "{}", step(&both));
        stage.each(Engine::choke_all);
        render(&mut stage, 48_000);
        assert_eq!(stage.awake(), 0);
        stage.turn(1, &bench);
        assert!(stage.ringing.iter().all(Option::is_none));
        assert!(bench.work(), "taken apart");
    }

    #[test]
    fn all_instruments_together_stay_below_full_scale() {
        let bench = Bench::new(Arc::default(), 48_000.0);
        let loud = |limiter| {
            let mut stage = stage(0);
            stage.set(&Settings {
                gain_db: 12.0,
                limiter,
                ..Settings::default()
            });
            let mut most = 0.0;
            for wanted in [1, 0] {
                for key in 60..72 {
                    stage.hit(key, &Hit::plain(1.0));
                }
                stage.turn(wanted, &bench);
                bench.work();
                stage.turn(wanted, &bench);
                let sound = render(&mut stage, 4800);
                most = sound.iter().fold(most, |most: f32, x| most.max(x.abs()));
            }
            most
        };
        assert!(loud(false) > 1.0, "{}", loud(false));
        assert!(loud(true) <= 1.0, "{}", loud(true));
    }

    #[test]
    fn a_bow_stays_on_the_instrument_that_it_was_laid_on() {
        let bench = Bench::new(Arc::default(), 48_000.0);
        let mut stage = stage(3);
        let pressed = Hold {
            bow_pressure: 1.0,
            ..Hold::FREE
        };
        stage.hold(60, &pressed);
        render(&mut stage, 4800);
        assert_eq!(stage.awake(), 0, "not struck yet");
        stage.hit(60, &Hit::plain(0.1));
        stage.hold(60, &pressed);
        stage.turn(4, &bench);
        bench.work();
        stage.turn(4, &bench);
        assert_eq!(stage.number, 4);
        stage.hold(60, &pressed);
        render(&mut stage, 4800);
        assert_eq!(stage.present.engine.awake(), 0);
        assert_eq!(stage.awake(), 1 << 60);
    }

    #[test]
    fn a_patient_stage_turns_at_once() {
        let workshop = Workshop::open(Arc::default(), 48_000.0);
        let mut stage = stage(0).patient();
        for wanted in [1, 2, 0] {
            stage.turn(wanted, &workshop);
            assert_eq!(stage.number, wanted);
        }
    }

    #[test]
    fn hasty_turns_sound_the_same_every_time() {
        let render = || {
            let workshop = Workshop::open(Arc::default(), 48_000.0);
            let mut stage = stage(0).patient();
            (0u8..60)
                .flat_map(|turn| {
                    stage.turn(usize::from(turn) * 5 % 7, &workshop);
                    stage.hit(60 + turn % 12, &Hit::plain(0.9));
                    if turn % 9 == 0 {
                        stage.each(Engine::choke_all);
                    }
                    render(&mut stage, 480)
                })
                .collect::<Vec<_>>()
        };
        let first = render();
        assert!((0..4).all(|_| render() == first));
    }

    #[test]
    fn a_change_of_mind_gets_the_last_wish_and_many_changes_wait_for_silence() {
        let bench = Bench::new(Arc::default(), 48_000.0);
        let mut stage = stage(0);
        stage.turn(1, &bench);
        bench.work();
        stage.turn(2, &bench);
        assert_eq!(stage.number, 0, "the first is no longer wanted");
        for _ in 0..2 {
            bench.work();
            stage.turn(2, &bench);
        }
        assert_eq!(stage.number, 2);
        for turn in 0..10 {
            let wanted = if turn % 2 == 0 { 3 } else { 4 };
            stage.hit(60, &Hit::plain(1.0));
            render(&mut stage, 64);
            let mut patience = 0;
            while stage.number != wanted && patience < 100 {
                stage.turn(wanted, &bench);
                bench.work();
                render(&mut stage, 4800);
                patience += 1;
            }
        }
        assert_eq!(stage.number, 4);
    }
}
