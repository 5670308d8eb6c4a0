//! Blows against theory: how long they last, and that they create nothing.

use super::super::body::{Body, Strike, Tuned};
use super::super::losses::Drain;
use super::super::mallet::Mallet;
use super::super::oscillators::{Kernel, Pack, Vectors};
use super::super::source::Hearing;
use super::super::touch::{Touch, grain};
use super::*;

/// Numbers in 0…1, always the same.
struct Chance(u64);

impl Chance {
    fn unit(&mut self) -> f64 {
        self.0 += 1;
        (grain(7, self.0) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Evenly spread over the octaves from `low` to `high`.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.unit())
    }
}

/// A body of `modes` modes whose shapes and frequencies are chance.
fn random_body(chance: &mut Chance, modes: usize) -> modes::Body {
    let mass_kg = chance.between(0.01, 10.0);
    let lowest = chance.between(30.0, 3000.0);
    const POINTS: u8 = 8;
    let modes = (0..modes)
        .map(|i| modes::Mode {
            hz: lowest * (1.0 + i as f64 * (0.5 + chance.unit())),
            coupling: 1.0,
            ears: [[1.0, 0.0]; 2],
            pipe_ears: [[0.0; 2]; 2],
            radiation_per_s: chance.between(1e-3, 300.0) as f32,
            support_per_s: 0.0,
            felt_per_s: 0.0,
            pipe_per_s: 0.0,
            residual: 0.0,
            label: modes::ModeLabel {
                family: modes::Family::Other,
                order: 0,
                index: i as u16,
                member: modes::Member::Single,
            },
            shape: (0..POINTS)
                .map(|_| {
                    [
                        ((4.0 * chance.unit() - 2.0) / mass_kg.sqrt()) as f32,
                        0.0,
                        0.0,
                    ]
                })
                .collect(),
        })
        .collect();
    modes::Body {
        key: 60,
        pitch_hz: lowest,
        length_m: 0.3,
        mass_kg,
        line: modes::StrikeLine::single(
            (0..POINTS).map(|i| [0.0, 0.0, f64::from(i)]).collect(),
            vec![[1.0, 0.0, 0.0]; usize::from(POINTS)],
        ),
        matter: None,
        surface: None,
        modes,
    }
}

impl Contact {
    /// Energy of the mallet, of the body as a whole and of the compression, in J.
    fn energy_j(&self) -> f64 {
        let depth = self.depth_m.max(0.0);
        0.5 * self.mass_kg * self.speed_m_s * self.speed_m_s
            + 0.5 * self.body_kg * self.body_m_s * self.body_m_s
            + 0.4 * self.hertz.stiffness * depth * depth * depth.sqrt()
    }
}

/// Body and mallet are given apart from it.
const STUFF: modes::Matter = modes::Matter {
    material: modes::Material {
        lambda_pa: 5e10,
        mu_pa: 2.6e10,
        density_kg_m3: 2700.0,
    },
    damping: modes::Damping {
        rayleigh: modes::Rayleigh {
            alpha1_s: 0.0,
            alpha2_per_s: 0.0,
        },
        loss_factor: 0.0,
    },
};

const FREE: Tuned = Tuned {
    trims: 0,
    drain: Drain {
        alpha1_s: 0.0,
        alpha2_per_s: 0.0,
        loss_factor: 0.0,
        radiation: 1.0,
        supports: 0.0,
        resonator: 0.0,
        felt: 0.0,
        hand_per_s: 0.0,
    },
    ratio: 1.0,
};

/// ½ Σ |z|², in J.
fn energy_j(packs: &[Pack]) -> f64 {
    let squares = |pack: &Pack| -> f64 {
        let values = pack.x.iter().chain(&pack.y);
        values.map(|z| z * z).sum()
    };
    0.5 * packs.iter().map(squares).sum::<f64>()
}

/// Ten thousand mallets on bodies that may ring already: after each sample there is no more energy in
/// modes, body, mallet and compression together than before it.
#[test]
fn no_blow_creates_energy() {
    let kernel = Kernel::new(Vectors::Widest);
    let mut chance = Chance(1);
    let (mut worst, mut touched, mut returned) = (0.0f64, 0, 0);
    for trial in 0..10_000u64 {
        let step_s = 1.0 / chance.between(8e3, 768e3);
        let given = random_body(&mut chance, 3 + (trial % 30) as usize);
        let mut body = Body::new((&given, &STUFF), 1.0, 0, None);
        let mut packs = vec![Pack::STILL; body.place.len()];
        let moved = body.listen(&Hearing::AS_BUILT);
        body.tune(kernel, &mut packs, (FREE, moved), step_s);
        let rings = chance.between(1e-4, 3.0);
        for pack in &mut packs {
            for i in 0..LANES {
                pack.x[i] = rings * (chance.unit() - 0.5);
                pack.y[i] = rings * (chance.unit() - 0.5);
            }
        }
        let mallet = Mallet {
            mass_kg: chance.between(1e-3, 1.0),
            head_radius_m: chance.between(1e-3, 0.1),
            hardness_pa: chance.between(1e6, 1e11),
            loss_s_m: if trial % 3 == 0 {
                0.0
            } else {
                chance.between(1e-3, 2.0)
            },
            roughness: if trial % 2 == 0 { 0.0 } else { chance.unit() },
            press_n: 0.0,
        };
        let strike = Strike {
            mallet,
            body_pa: chance.between(1e8, 1e12),
            heavier: 1.0,
            touch: Touch {
                speed_m_s: chance.between(1e-3, 10.0),
                position: chance.unit(),
                across: 0.0,
            },
            seed: trial,
        };
        body.strike(kernel, &strike, step_s);
        let mut before = energy_j(&packs) + body.contact(0).energy_j();
        let start = before;
        for _ in 0..200 {
            let (mut left, mut right) = ([0.0], [0.0]);
            body.drive(kernel, &mut packs, 0, step_s, [&mut left, &mut right]);
            let after = energy_j(&packs) + body.contact(0).energy_j();
            worst = worst.max((after - before) / start);
            before = after;
        }
        touched += u32::from(body.contact(0).body_m_s > 0.0);
        returned += u32::from(body.contact(0).depth_m < 0.0);
    }
    println!("{touched} touched, {returned} left; greatest gain {worst:.1e} of the energy");
    // Some bodies swing away faster than the mallet comes.
    assert!(touched > 9500 && returned > 6000, "{touched}, {returned}");
    assert!(worst < 1e-12, "{worst}");
}

/// Contact time in s with a body of 10 t that does not bend, at `step_s`, and the speed after it over that
/// before.
fn bounce(mallet: &Mallet, body_pa: f64, speed_m_s: f64, steps: f64) -> (f64, f64) {
    let body_kg = 1e4;
    let contact_s = mallet.contact_s(body_pa, body_kg, speed_m_s);
    let step_s = contact_s / steps;
    let mut contact = Contact::new(0);
    contact.begin(&Blow {
        mallet: *mallet,
        hertz: mallet.hertz(body_pa).followed(1.0 / steps),
        body_kg,
        mobility: 0.0,
        speed_m_s,
        seed: 1,
    });
    let (mut time, mut before) = (0.0, 0.0);
    loop {
        contact.meet(0.0, step_s);
        if contact.depth_m <= 0.0 {
            let share = before / (before - contact.depth_m);
            return (time + share * step_s, -contact.speed_m_s / speed_m_s);
        }
        before = contact.depth_m;
        time += step_s;
    }
}

/// Johnson 1985, §11.4: τ = 2.87 (m²/(R E*² v))^(1/5), so τ ∝ v^(−1/5).
#[test]
fn contact_lasts_as_long_as_hertz_has_it() {
    let mallet = Mallet {
        loss_s_m: 0.0,
        ..Mallet::DEFAULT
    };
    for steps in [12.0, 40.0, 400.0] {
        for speed in [0.05, 0.5, 5.0] {
            let (time, back) = bounce(&mallet, 7e10, speed, steps);
            let expected = mallet.contact_s(7e10, 1e4, speed);
            let error = time / expected - 1.0;
            println!("{steps} steps at {speed} m/s: {error:.1e}, comes back with {back:.4}");
            assert!(error.abs() < 0.5 / steps + 2e-3, "{error}");
            assert!((back - 1.0).abs() < 1e-5, "{back}");
        }
        let [slow, fast] = [0.1, 3.2].map(|speed| bounce(&mallet, 7e10, speed, steps).0);
        assert!((slow / fast - 2.0).abs() < 1e-9, "{}", slow / fast);
    }
}

/// Hunt & Crossley 1975: a head of small loss comes back with about 1 − 2/3 λv of its speed.
#[test]
fn a_lossy_head_comes_back_slower() {
    for loss_s_m in [0.01, 0.05, 0.1] {
        let mallet = Mallet {
            loss_s_m,
            ..Mallet::DEFAULT
        };
        let (_, back) = bounce(&mallet, 7e10, 1.0, 200.0);
        let expected = 1.0 - 2.0 / 3.0 * loss_s_m;
        println!("{loss_s_m}: {back:.4} for {expected:.4}");
        assert!(
            (back - expected).abs() < 0.6 * loss_s_m * loss_s_m + 1e-3,
            "{back}"
        );
    }
}
