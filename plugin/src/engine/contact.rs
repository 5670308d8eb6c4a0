//! Mallets that are on a body now.

use super::GRID;
use super::bessel::ORDERS;
use super::body::Span;
use super::oscillators::Buses;
use super::pulse::Pulse;

/// One mallet on one body.
#[derive(Clone, Debug)]
pub(crate) struct Contact {
    /// The body's key; none when the slot is free.
    pub(crate) key: Option<u8>,
    /// The force.
    pub(crate) pulse: Pulse,
    /// What a unit impulse adds to the x of each of the body's modes.
    pub(crate) gain: Vec<f64>,
    /// What one newton takes off the buses, from the body itself and from its open resonator: see
    /// [`super::body::Body::strike`].
    pub(crate) still: [[f64; 3]; 2],
    /// Legendre moments of the force over the samples being rendered, by order.
    pub(crate) moments: [[f64; GRID]; ORDERS],
    elapsed: u32,
    given_n_s: f64,
    /// Impulse of the sample before the next one, in N·s.
    last_n_s: f64,
}

impl Contact {
    /// A free slot for bodies of up to `modes` modes, padded.
    pub(crate) fn new(modes: usize) -> Self {
        Self {
            key: None,
            pulse: Pulse {
                impulse_n_s: 0.0,
                duration_s: 1.0,
            },
            gain: vec![0.0; modes.next_multiple_of(super::oscillators::LANES)],
            still: [[0.0; 3]; 2],
            moments: [[0.0; GRID]; ORDERS],
            elapsed: 0,
            given_n_s: 0.0,
            last_n_s: 0.0,
        }
    }

    /// Begins a contact; the caller fills in the gains.
    pub(crate) fn begin(&mut self, key: u8, pulse: Pulse) {
        self.key = Some(key);
        self.pulse = pulse;
        self.elapsed = 0;
        self.given_n_s = 0.0;
        self.last_n_s = 0.0;
    }

    /// Works out the moments of the next `samples` samples of `step_s` and counts them as gone by.
    #[inline(always)]
    pub(crate) fn prepare(&mut self, samples: usize, step_s: f64) {
        for n in 0..samples {
            let moments = self.pulse.moments(f64::from(self.elapsed) * step_s, step_s);
            for (order, moment) in self.moments.iter_mut().zip(moments) {
                order[n] = moment;
            }
            self.given_n_s += moments[0];
            self.elapsed += 1;
        }
    }

    /// Takes what the force holds without moving off `buses`, whose samples are those of the last
    /// [`Self::prepare`].
    pub(crate) fn press(&mut self, span: Span, buses: &mut Buses) {
        let [mut open, step] = span.open;
        for n in 0..span.samples {
            // The mean force about the instant of a sample: half of the one before it, half of it.
            let force_n = 0.5 * (self.last_n_s + self.moments[0][n]) / span.step_s;
            self.last_n_s = self.moments[0][n];
            for (k, bus) in buses.iter_mut().enumerate() {
                bus[n] -= force_n * (self.still[0][k] + open * self.still[1][k]);
            }
            open += step;
        }
    }

    /// Whether the mallet has left.
    pub(crate) fn is_over(&self, step_s: f64) -> bool {
        f64::from(self.elapsed) * step_s >= self.pulse.duration_s && self.last_n_s == 0.0
    }

    /// Impulse still to come, in N·s.
    pub(crate) fn left_n_s(&self) -> f64 {
        self.pulse.impulse_n_s - self.given_n_s
    }
}

/// The moments of all contacts for the next samples, as a task for a kernel.
pub(crate) struct Prepare<'a> {
    pub(crate) contacts: &'a mut [Contact],
    pub(crate) samples: usize,
    pub(crate) step_s: f64,
}

impl pulp::WithSimd for Prepare<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) {
        for contact in self.contacts.iter_mut().filter(|c| c.key.is_some()) {
            contact.prepare(self.samples, self.step_s);
        }
    }
}

/// The slot for a new contact: a free one, or else the one with the least impulse left.
pub(crate) fn slot_for_next(contacts: &[Contact]) -> usize {
    let left = |contact: &Contact| {
        contact
            .key
            .map_or(f64::NEG_INFINITY, |_| contact.left_n_s())
    };
    let mut best = 0;
    for (i, contact) in contacts.iter().enumerate() {
        if left(contact) < left(&contacts[best]) {
            best = i;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::{Contact, GRID, slot_for_next};
    use crate::engine::pulse::Pulse;

    #[test]
    fn the_most_spent_contact_gives_way() {
        let mut contacts = vec![Contact::new(1); 3];
        let pulse = Pulse {
            impulse_n_s: 0.1,
            duration_s: 2e-3,
        };
        for slot in [0, 1, 2] {
            assert_eq!(slot_for_next(&contacts), slot);
            contacts[slot].begin(60, pulse);
        }
        contacts[1].prepare(GRID, 1.0 / 48_000.0);
        assert_eq!(slot_for_next(&contacts), 1);
        assert!(!contacts[1].is_over(1.0 / 48_000.0));
        for _ in 0..2 {
            contacts[1].prepare(GRID, 1.0 / 48_000.0);
        }
        assert!(contacts[1].is_over(1.0 / 48_000.0));
        assert!(contacts[1].left_n_s().abs() < 1e-9);
    }
}
