//! A body for each key, and their mix.

mod cells;
mod glance;
mod heir;
mod playing;
mod ready;
mod render;
mod routing;

pub use glance::{Held, Struck};
pub use render::OUTPUT_BOUND;

use super::body::Body;
use super::cell::{Bench, Cell};
use super::glides::Glides;
use super::level::full_scales;
use super::limiter::Limiter;
use super::motor::Motor;
use super::oscillators::{Buses, Kernel, Pack, SILENT, Vectors};
use super::outputs::OUTPUTS;
use super::routes::Routes;
use super::source::Way;
use super::swing::{Swing, SwingStep};
use super::trims::Trims;
use super::{GRID, Settings};
use modes::{Bank, Stencil};
use playing::Hand;

/// Sample rates there are coefficients for, in Hz.
const RATES_HZ: (f64, f64) = (1e3, 768e3);

/// An instrument that rings: strikes in, sound out.
///
/// Nothing but [`Engine::new`] allocates, and the output does not depend on how calls of
/// [`Engine::render`] cut the time.
pub struct Engine {
    bodies: Vec<Option<Body>>,
    /// The modes of all bodies.
    packs: Vec<Pack>,
    /// Where the bank has the listener's ears, and how far the middle between them is, in m.
    ears_m: [[f64; 3]; 2],
    distance_m: f64,
    awake: u128,
    /// Bodies that something pushes.
    driven: u128,
    /// Bodies that a hand silences.
    choked: u128,
    /// What hands do to each key's body.
    hands: [Hand; 128],
    /// Bodies on which a bow is, or is to be.
    bowed: u128,
    /// Bodies that swing.
    swinging: u128,
    /// Bodies whose tuning may have to change, and those of them of which the same is true of what is
    /// heard.
    stale: u128,
    unheard: u128,
    swings: [Swing; 128],
    swing_step: SwingStep,
    settings: Settings,
    glides: Glides,
    motor: Motor,
    /// Ways to the ears and their width at the end of this cell, and frequencies over those as built.
    ways: [Way; 2],
    width: f64,
    pitch: f64,
    /// What rings freely in this cell of the grid, output by output.
    cells: [Cell; OUTPUTS],
    bench: Bench,
    /// Which body is on which output, and the outputs on which any is in this cell, as bits.
    routes: Routes,
    used: u8,
    /// What is being rendered.
    buses: Box<[Buses; OUTPUTS]>,
    /// The bodies that sounded, and those pushed, when the cell's packs were listed; none if these have
    /// to be listed anew.
    arranged: Option<(u128, u128)>,
    /// Output gain at the start of the cell and at its end.
    gain: [f64; 2],
    limiters: [Limiter; OUTPUTS],
    kernel: Kernel,
    step_s: f64,
    position: u64,
    /// What is made of single modes, and how many tables there were before.
    trims: Trims,
    trims_number: u32,
    /// The last blow.
    struck: Option<Struck>,
}

/// The keys whose bits are set, from the lowest.
fn keys(mut bits: u128) -> impl Iterator<Item = u8> {
    std::iter::from_fn(move || {
        let key = u8::try_from(bits.trailing_zeros())
            .ok()
            .filter(|k| *k < 128)?;
        bits &= bits - 1;
        Some(key)
    })
}

/// The keys that have bodies, as bits.
fn there(bodies: &[Option<Body>]) -> u128 {
    let there = |(key, body): (usize, &Option<Body>)| u128::from(body.is_some()) << key;
    bodies.iter().enumerate().map(there).sum()
}

/// From the middle between the ears to the instrument, in m.
fn distance_m(ears_m: &[[f64; 3]; 2]) -> f64 {
    let middle = |a: usize| 0.5 * (ears_m[0][a] + ears_m[1][a]);
    middle(0).hypot(middle(1)).hypot(middle(2)).max(0.1)
}

impl Engine {
    /// An instrument from a bank, at rest, with default settings.
    ///
    /// A rate outside 1 kHz…768 kHz is taken as the nearer of the two. Bodies without a strike line
    /// of at least [`Stencil::POINTS`] points, or for no MIDI key, are left out.
    #[must_use]
    pub fn new(bank: &Bank, sample_rate_hz: f64) -> Self {
        Self::with_vectors(bank, sample_rate_hz, Vectors::Widest)
    }

    /// The same, computed with no wider vectors than `vectors`.
    #[must_use]
    pub fn with_vectors(bank: &Bank, sample_rate_hz: f64, vectors: Vectors) -> Self {
        let step_s = 1.0 / sample_rate_hz.max(RATES_HZ.0).min(RATES_HZ.1);
        let kernel = Kernel::new(vectors);
        let mut bodies: Vec<Option<Body>> = vec![None; 128];
        let usable: Vec<&modes::Body> = bank
            .bodies
            .iter()
            .filter(|body| {
                body.key < 128
                    && body.line.grid().columns >= Stencil::POINTS
                    && body.line.normals.len() == body.line.len()
                    && body.mass_kg > 0.0
            })
            .collect();
        let mut packs = 0;
        let mut before = None;
        for (body, scale) in usable.iter().zip(full_scales(bank, &usable)) {
            let before = before.replace(usize::from(body.key));
            let before = before.and_then(|key: usize| bodies[key].as_ref());
            let made = Body::new((body, &bank.matter_of(body)), scale, packs, before);
            packs = made.place.end;
            bodies[usize::from(body.key)] = Some(made);
        }
        let settings = Settings::default();
        let glides = Glides::new(&settings, step_s);
        let mut engine = Self {
            packs: vec![Pack::STILL; packs],
            ears_m: bank.ears_m,
            distance_m: distance_m(&bank.ears_m),
            awake: 0,
            driven: 0,
            choked: 0,
            hands: [Hand::FREE; 128],
            bowed: 0,
            swinging: 0,
            stale: u128::MAX,
            unheard: u128::MAX,
            swings: [Swing::default(); 128],
            swing_step: SwingStep::new(step_s * GRID as f64),
            gain: [glides.gain(); 2],
            motor: Motor::new(),
            ways: settings.listener.ways(&bank.ears_m),
            width: settings.listener.width,
            pitch: 1.0,
            cells: std::array::from_fn(|_| Cell::new()),
            bench: Bench::new(packs),
            routes: Routes::new(there(&bodies), step_s),
            bodies,
            used: 1,
            buses: Box::new([SILENT; OUTPUTS]),
            arranged: None,
            limiters: [Limiter::new(step_s); OUTPUTS],
            glides,
            settings,
            kernel,
            step_s,
            position: 0,
            trims: Trims::NONE,
            trims_number: 0,
            struck: None,
        };
        engine.prepare(usize::MAX);
        engine
    }

    /// Back to silence and to the start of the song; settings stay.
    pub fn reset(&mut self) {
        for body in self.bodies.iter_mut().flatten() {
            body.hush(&mut self.packs);
        }
        self.awake = 0;
        self.driven = 0;
        self.choked = 0;
        self.hands = [Hand::FREE; 128];
        self.bowed = 0;
        self.swinging = 0;
        (self.stale, self.unheard) = (u128::MAX, u128::MAX);
        self.swings = [Swing::default(); 128];
        self.limiters.iter_mut().for_each(Limiter::reset);
        self.position = 0;
        self.motor = Motor::new();
        self.cells.iter_mut().for_each(Cell::close);
        self.routes.reset();
        self.used = 1;
        self.arranged = None;
        self.arrive();
    }

    /// New targets. What acts on strikes counts from the next one, the rest moves there in 15 ms.
    pub fn set(&mut self, settings: &Settings) {
        let settings = settings.sane();
        if settings != self.settings {
            if settings.split != self.settings.split {
                self.routes.pending = u128::MAX;
            }
            self.settings = settings;
            self.glides.aim(&self.settings);
            self.stale = u128::MAX;
        }
    }

    /// Makes single modes louder, longer or alone, from the next grid point on.
    pub fn set_trims(&mut self, trims: &Trims) {
        if *trims != self.trims {
            self.trims = *trims;
            self.trims_number = self.trims_number.wrapping_add(1).max(1);
            (self.stale, self.unheard) = (u128::MAX, u128::MAX);
        }
    }

    /// Samples of a second.
    #[must_use]
    pub fn sample_rate_hz(&self) -> f64 {
        self.step_s.recip()
    }

    /// The keys whose bodies sound, bit 0 for key 0.
    #[must_use]
    pub fn awake(&self) -> u128 {
        self.awake
    }

    /// The keys that have bodies, bit 0 for key 0.
    #[must_use]
    pub fn bodies(&self) -> u128 {
        there(&self.bodies)
    }

    /// Time after which nothing that sounds now is louder than −100 dB of full scale, in s, if nothing
    /// changes; infinite if something never tires.
    #[must_use]
    pub fn tail_s(&self) -> f64 {
        const FLOOR: f64 = 1e-5;
        let bodies = keys(self.awake).filter_map(|key| self.body(key));
        bodies
            .flat_map(|body| body.sounds(&self.packs))
            .filter(|sound| sound.power > FLOOR * FLOOR)
            .map(|sound| 0.5 * (sound.power.ln() - 2.0 * FLOOR.ln()) / sound.decay_per_s)
            .fold(0.0, f64::max)
    }

    fn body(&self, key: u8) -> Option<&Body> {
        self.bodies.get(usize::from(key))?.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::super::damper::bit;
    use super::*;

    #[test]
    fn keys_come_from_low_to_high() {
        assert_eq!(keys(0).count(), 0);
        assert_eq!(
            keys(bit(3) | bit(127) | bit(0)).collect::<Vec<_>>(),
            [0, 3, 127]
        );
    }
}
