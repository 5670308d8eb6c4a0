//! A mode as people see it: name, frequency, where it can be struck, and what damps it.

use super::mallet::contact_modulus_pa;
use super::source::reached;
use super::touch::Touch;
use super::{Hit, Settings};
use modes::{Bank, ModeLabel, ModeShape, Stencil, StrikeLine};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A mode of a body that strikes on its line make heard.
#[derive(Clone, Debug, PartialEq)]
pub struct Partial {
    /// Frequency as built, in Hz.
    pub hz: f64,
    /// Its name.
    pub label: ModeLabel,
    /// Decay rate by radiation, in 1/s.
    pub radiation_per_s: f64,
    /// Decay rate by the supports, in 1/s.
    pub supports_per_s: f64,
    /// Decay rate by the open resonator, in 1/s.
    pub resonator_per_s: f64,
    /// Decay rate by the whole weight of the damper's felt, in 1/s.
    pub felt_per_s: f64,
    shape: ModeShape,
    /// Where its body is struck.
    line: Arc<StrikeLine>,
    loudness: f64,
}

impl Partial {
    /// The modes that an engine has of a body, by rising frequency.
    #[must_use]
    pub fn all(body: &modes::Body) -> Vec<Self> {
        let line = Arc::new(body.line.clone());
        reached(body)
            .into_iter()
            .map(|mode| {
                let [radiation_per_s, supports_per_s, resonator_per_s, felt_per_s] =
                    mode.air.map(f64::from);
                Self {
                    hz: mode.hz,
                    label: mode.label,
                    radiation_per_s,
                    supports_per_s,
                    resonator_per_s,
                    felt_per_s,
                    loudness: mode.loudness(),
                    shape: mode.shape,
                    line: Arc::clone(&line),
                }
            })
            .collect()
    }

    /// How loud it is beside the others after a blow at `position` and `across`, 0…1, that lasts `contact_s`.
    ///
    /// The force goes with the sine of the time to the power of 3/2 (Hertz's law for a force much softer
    /// than the body); this is the outline of that pulse's spectrum without its zeros. Where walls give way
    /// or the mallet touches twice, levels are up to 6 dB off.
    #[must_use]
    pub fn level(&self, place: [f64; 2], contact_s: f64) -> f64 {
        if self.line.grid().columns < Stencil::POINTS {
            return 0.0;
        }
        let normal = self.shape.normal_motion(&self.line, place);
        let turned = TAU * self.hz * contact_s;
        let pulse = (1.0 + (turned / 4.4).powi(3)).powf(-5.0 / 6.0);
        normal.abs() * self.loudness * pulse
    }
}

/// How long a blow of `velocity` 0…1 on a body of that bank lasts, in s.
#[must_use]
pub fn contact_s(bank: &Bank, body: &modes::Body, settings: &Settings, velocity: f64) -> f64 {
    let (settings, tweak) = (settings.sane(), settings.tweak.sane());
    let touch = Touch::new(&settings, &Hit::plain(velocity).sane(), [0.0; 2]);
    let body_pa = contact_modulus_pa(&bank.matter_of(body).material) * tweak.stiffness;
    settings
        .mallet
        .contact_s(body_pa, body.mass_kg * tweak.mass(), touch.speed_m_s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::{Engine, Vectors};
    use crate::factory;

    /// The levels that are told are those that a blow gives.
    #[test]
    fn levels_are_those_of_blows() {
        for (index, key) in [(0, 60), (1, 60), (3, 60)] {
            let bank = factory::bank(index);
            let body = bank.bodies.iter().find(|body| body.key == key).unwrap();
            let settings = Settings::default();
            let contact_s = contact_s(bank, body, &settings, 0.8);
            let mut engine = Engine::with_vectors(bank, 96e3, Vectors::Plain);
            engine.strike(key, 0.8);
            let mut rest_s = 0.005;
            while rest_s > 0.0 {
                engine.process(&mut [0.0; 32], &mut [0.0; 32]);
                rest_s -= 32.0 / 96e3;
            }
            let mut found = vec![0.0; 4096];
            assert!(engine.levels(key, &mut found) >= Partial::all(body).len());
            let partials = Partial::all(body);
            let told = partials
                .iter()
                .map(|partial| partial.level([settings.strike_position, 0.0], contact_s));
            let pairs: Vec<(f64, f64, f64)> = partials
                .iter()
                .zip(told)
                .zip(&found)
                .map(|((partial, told), found)| (partial.hz, told, f64::from(*found)))
                .filter(|(hz, told, _)| *told > 0.0 && TAU * hz * contact_s < 4.0)
                .collect();
            let most =
                |value: fn(&(f64, f64, f64)) -> f64| pairs.iter().map(value).fold(0.0, f64::max);
            let (most_told, most_found) = (most(|pair| pair.1), most(|pair| pair.2));
            assert!(pairs.len() > 2 && most_found > 0.0);
            for (hz, told, found) in &pairs {
                let [told, found] =
                    [told / most_told, found / most_found].map(|x| 20.0 * x.log10());
                assert!(
                    found < -50.0 || (told - found).abs() < 6.0,
                    "{}: {hz:.0} Hz: {told:.1} dB, not {found:.1} dB",
                    bank.name
                );
            }
        }
    }
}
