//! A quarter-wave tube below a bar.

use super::{AIR_KG_M3, SOUND_M_S};
use crate::Ears;
use std::f64::consts::{PI, TAU};

/// A tube, closed below, whose open end stands under the middle of a bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pipe {
    /// Frequency of its lowest resonance, in Hz.
    pub hz: f64,
    /// Inner radius, in m.
    pub radius_m: f64,
    /// Thickness in m of the layer of air that the bar takes along over the mouth: what couples the
    /// two.
    pub layer_m: f64,
}

impl Pipe {
    /// What the tube adds to a mode of `hz` whose middle moves up by `rise` per unit displacement, in
    /// kg^(−1/2): volume velocity at its mouth in m³/s per unit displacement (real, imaginary), and
    /// amplitude decay rate in 1/s.
    ///
    /// The bar presses ρω²·layer·rise on the mouth; what flows is that over the tube's impedance
    /// R − iρc cot(π hz/2 f), with R the radiation of an open end, ρc (ka)²/4, and the friction at
    /// the wall, 3·10⁻⁵ √hz/a per metre (Fletcher & Rossing 1998, §8.2–8.3).
    #[must_use]
    pub fn response(&self, hz: f64, rise: f64) -> ([f64; 2], f64) {
        let (omega, resistance) = (TAU * hz, AIR_KG_M3 * SOUND_M_S);
        let k = omega / SOUND_M_S;
        let length_m = SOUND_M_S / (4.0 * self.hz);
        let friction = 3e-5 * hz.sqrt() / self.radius_m * length_m;
        let re = resistance * ((k * self.radius_m).powi(2) / 4.0 + friction);
        let angle = k * length_m;
        let im = -resistance * angle.cos() / angle.sin();
        let square = re * re + im * im;
        if !square.is_finite() {
            return ([0.0; 2], 0.0);
        }
        let pressure = AIR_KG_M3 * omega * omega * self.layer_m * rise;
        let area = PI * self.radius_m * self.radius_m;
        let flow = [re, -im].map(|part| area * pressure * part / square);
        let power_w = 0.5 * pressure * flow[0];
        (flow, power_w / (omega * omega))
    }

    /// Complex pressure of that flow at ears `distances_m` away, in Pa: a monopole's, iωρQ/4πr.
    #[must_use]
    pub fn ears(&self, hz: f64, flow: [f64; 2], distances_m: [f64; 2]) -> Ears {
        let strength = AIR_KG_M3 * hz / 2.0;
        distances_m.map(|r| [-flow[1], flow[0]].map(|part| (strength * part / r) as f32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A3: Pipe = Pipe {
        hz: 220.0,
        radius_m: 0.02,
        layer_m: 0.01,
    };

    #[test]
    fn the_tube_answers_to_its_own_pitch() {
        let at = |hz: f64| A3.response(hz, 2.0).1 / hz.powi(2);
        assert!(at(220.0) > 100.0 * at(180.0) && at(220.0) > 100.0 * at(880.0));
        let (flow, _) = A3.response(220.0, 2.0);
        assert!(flow[1].abs() < 1e-9 * flow[0], "in phase with the pressure");
    }

    /// All that leaves the bar goes into the wall or out of the mouth.
    #[test]
    fn power_is_what_resistance_takes() {
        let (hz, rise) = (221.0, 2.0);
        let (flow, decay) = A3.response(hz, rise);
        let area = PI * A3.radius_m * A3.radius_m;
        let velocity_square = (flow[0].powi(2) + flow[1].powi(2)) / area.powi(2);
        let k = TAU * hz / SOUND_M_S;
        let friction = 3e-5 * hz.sqrt() / A3.radius_m * SOUND_M_S / (4.0 * A3.hz);
        let re = AIR_KG_M3 * SOUND_M_S * ((k * A3.radius_m).powi(2) / 4.0 + friction);
        let power = 0.5 * area * re * velocity_square;
        assert!((decay * (TAU * hz).powi(2) / power - 1.0).abs() < 1e-12);
    }
}
