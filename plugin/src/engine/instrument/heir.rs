//! An instrument that goes on where another like it was.

use super::{Engine, keys};
use crate::engine::GRID;
use crate::engine::body::Moved;
use crate::engine::damper::bit;

impl Engine {
    /// Frames until what rings here can be handed over: to the next point of the grid.
    #[must_use]
    pub fn until_grid(&self) -> usize {
        (GRID - (self.position % GRID as u64) as usize) % GRID
    }

    /// Whether a mallet is on any body.
    #[must_use]
    pub fn is_struck(&self) -> bool {
        let mut driven = keys(self.driven).filter_map(|key| self.body(key));
        driven.any(super::Body::is_struck)
    }

    /// Makes ready, while this sleeps, to [`Engine::inherit`] from `old`: tunes at most `most` of the bodies
    /// that ring there; whether all are now tuned as they would be. Does not allocate.
    pub fn foresee(&mut self, old: &Self, most: usize) -> bool {
        self.follow(old);
        let mut tuned = 0;
        for key in keys(old.awake) {
            if self.is_fit(key) {
                continue;
            }
            if tuned == most {
                return false;
            }
            self.fit(key);
            tuned += 1;
        }
        true
    }

    /// Takes over all that hands and parameters do to `old`.
    fn follow(&mut self, old: &Self) {
        self.settings = old.settings;
        self.glides.clone_from(&old.glides);
        self.motor.clone_from(&old.motor);
        self.hands = old.hands;
        self.choked = old.choked;
        self.bowed = old.bowed;
        self.swinging = old.swinging;
        self.swings = old.swings;
        self.gain = old.gain;
        self.position = old.position;
        self.struck = old.struck;
        self.routes.inherit(&old.routes);
        self.moved();
        (self.stale, self.unheard) = (u128::MAX, u128::MAX);
    }

    /// Goes on where `old` is, which must be at a point of the grid ([`Engine::until_grid`]) and run at the
    /// same rate: with all that hands and parameters do there, and with the motion of its bodies, mode by
    /// mode of the same name. Mallets that touch are left out. Does not allocate.
    pub fn inherit(&mut self, old: &Self) {
        self.follow(old);
        for key in keys(old.awake) {
            if let Some(body) = self.bodies[usize::from(key)].as_mut() {
                body.fading = Moved::NONE;
            }
            self.fit(key);
            let theirs = old.body(key);
            let (Some(body), Some(theirs)) = (self.bodies[usize::from(key)].as_mut(), theirs)
            else {
                continue;
            };
            let how = (self.kernel, self.step_s);
            body.inherit(how, &mut self.packs, (theirs, &old.packs));
            self.awake |= bit(key);
            if body.driven {
                self.driven |= bit(key);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::{Hit, Hold, Listener, Settings};
    use crate::factory;
    use modes::Bank;

    const RATE_HZ: f64 = 48_000.0;

    fn render(engine: &mut Engine, frames: usize) -> Vec<f32> {
        let (mut left, mut right) = (vec![0.0; frames], vec![0.0; frames]);
        engine.process(&mut left, &mut right);
        left
    }

    /// Some keys of the vibraphone.
    fn bank() -> Bank {
        let mut bank = factory::bank(1).clone();
        bank.bodies.retain(|body| body.key % 12 == 0);
        bank
    }

    fn ringing(bank: &Bank) -> Engine {
        let mut engine = Engine::new(bank, RATE_HZ);
        engine.set(&Settings {
            limiter: false,
            ..Settings::default()
        });
        for key in [48, 60, 72] {
            engine.hit(key, &Hit::plain(0.8));
        }
        render(&mut engine, 4810);
        let frames = engine.until_grid();
        render(&mut engine, frames);
        engine
    }

    fn level(sound: &[f32]) -> f32 {
        sound.iter().fold(0.0, |most, x| most.max(x.abs()))
    }

    fn farthest(a: &[f32], b: &[f32]) -> f32 {
        let apart = a.iter().zip(b).map(|(a, b)| (a - b).abs());
        apart.fold(0.0, f32::max)
    }

    #[test]
    fn the_same_instrument_goes_on_the_same() {
        let bank = bank();
        let mut old = ringing(&bank);
        let mut new = Engine::new(&bank, RATE_HZ);
        new.inherit(&old);
        let (old, new) = (render(&mut old, 9600), render(&mut new, 9600));
        assert!(old.iter().any(|x| x.abs() > 0.01));
        assert!(farthest(&old, &new) < 1e-6, "{}", farthest(&old, &new));
    }

    #[test]
    fn what_is_tuned_ahead_a_few_at_a_time_sounds_as_what_is_not() {
        let bank = bank();
        let mut old = ringing(&bank);
        old.set(&Settings {
            limiter: false,
            listener: Listener {
                angle_deg: 20.0,
                ..Listener::AS_BUILT
            },
            ..Settings::default()
        });
        render(&mut old, 4800);
        let [mut ahead, mut new] = [(); 2].map(|()| Engine::new(&bank, RATE_HZ));
        assert!(!ahead.foresee(&old, 0), "none is tuned so");
        let mut rounds = 0;
        while !ahead.foresee(&old, 1) {
            rounds += 1;
            assert!(rounds <= 6, "three bodies, each twice at most");
        }
        assert!(rounds >= 2, "one body at a time");
        assert_eq!(ahead.awake(), 0);
        ahead.inherit(&old);
        new.inherit(&old);
        let (ahead, new) = (render(&mut ahead, 9600), render(&mut new, 9600));
        assert!(level(&new) > 0.01);
        assert!(farthest(&ahead, &new) < 1e-6, "{}", farthest(&ahead, &new));
    }

    #[test]
    fn signs_and_the_order_of_modes_do_not_matter() {
        let bank = bank();
        let mut old = ringing(&bank);
        let mut turned = bank.clone();
        for body in &mut turned.bodies {
            body.modes.pop();
            for mode in body.modes.iter_mut().step_by(2) {
                let flipped = |parts: &mut [[f32; 2]; 2]| {
                    for x in parts.iter_mut().flatten() {
                        *x = -*x;
                    }
                };
                flipped(&mut mode.ears);
                flipped(&mut mode.pipe_ears);
                for x in mode.shape.make_mut().iter_mut().flatten() {
                    *x = -*x;
                }
            }
        }
        let mut new = Engine::new(&turned, RATE_HZ);
        new.inherit(&old);
        let (old, new) = (render(&mut old, 9600), render(&mut new, 9600));
        assert!(farthest(&old, &new) < 1e-4, "{}", farthest(&old, &new));
    }

    #[test]
    fn a_mode_of_another_name_stands_still() {
        let bank = bank();
        let mut old = ringing(&bank);
        let mut named = bank.clone();
        for mode in named.bodies.iter_mut().flat_map(|body| &mut body.modes) {
            mode.label.index += 1000;
        }
        let mut new = Engine::new(&named, RATE_HZ);
        new.inherit(&old);
        assert!(render(&mut old, 960).iter().any(|x| x.abs() > 0.01));
        assert!(render(&mut new, 960).iter().all(|x| x.abs() < 1e-12));
    }

    #[test]
    fn a_bow_stays_on() {
        let bowls = factory::bank(3);
        let mut old = Engine::new(bowls, RATE_HZ);
        let pressed = Hold {
            bow_pressure: 1.0,
            ..Hold::FREE
        };
        old.hold(60, &pressed);
        render(&mut old, 96_000);
        let mut new = Engine::new(bowls, RATE_HZ);
        new.inherit(&old);
        let before = level(&render(&mut old, 4800));
        let (old, new) = (render(&mut old, 96_000), render(&mut new, 100_800));
        let after = level(&old[91_200..]);
        assert!(after > 1.1 * before, "the bow feeds it: {before} {after}");
        let apart = farthest(&old, &new[4800..]);
        assert!(apart < 1e-3 * after, "{apart} of {after}");
    }
}
