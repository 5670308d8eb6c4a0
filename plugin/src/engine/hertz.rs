//! The force between a round head and a surface, so computed that no energy is created.

/// A Hertz contact with loss: F = K δ^(3/2) (1 + λ δ̇) (Hertz; Hunt & Crossley, J. Appl. Mech. 42,
/// 1975), never pulling.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Hertz {
    /// K, in N/m^(3/2).
    pub(crate) stiffness: f64,
    /// λ, in s/m.
    pub(crate) loss_s_m: f64,
}

/// Rounds of Newton's method at most; three or four are the rule.
const ROUNDS: usize = 24;

/// What a step of a contact did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Push {
    /// ∫F dt over the step, in N·s.
    pub(crate) impulse_n_s: f64,
    /// Compression after it, in m.
    pub(crate) depth_m: f64,
}

impl Hertz {
    /// The same, but stiffer by what makes up for following a contact in steps of `share` of its time: the
    /// swing of a spring comes out slower by (ωT)²/12 (Hairer, Lubich & Wanner, Geometric Numerical
    /// Integration, 2006, of the implicit midpoint rule).
    pub(crate) fn followed(self, share: f64) -> Self {
        let turn = (std::f64::consts::PI * share).min(1.0);
        Self {
            stiffness: self.stiffness * (1.0 + turn * turn / 6.0),
            ..self
        }
    }

    /// A step of `step_s` from compression `depth_m` at closing speed `speed_m_s`, when an impulse of
    /// 1 N·s changes that speed by `mobility` m/s.
    ///
    /// The impulse J is what makes the work done at the mean of the speeds before and after it equal
    /// to the gain of stored energy, and to what the loss takes: J = T ΔU/Δδ, Δδ = T (v − J·mobility/2).
    /// So the sum of kinetic and stored energy never grows, however long the step
    /// (Chatziioannou & van Walstijn, J. Sound Vib. 332, 2015, for a lumped collision).
    #[inline(always)]
    pub(crate) fn step(&self, depth_m: f64, speed_m_s: f64, mobility: f64, step_s: f64) -> Push {
        let free = depth_m + step_s * speed_m_s;
        if depth_m <= 0.0 && free <= 0.0 {
            return Push {
                impulse_n_s: 0.0,
                depth_m: free,
            };
        }
        let start = Start::new(depth_m);
        let loss = self.loss_s_m * start.root3 / step_s;
        let gain = 0.5 * step_s * step_s * mobility * self.stiffness;
        // f(δ) = δ − free + gain · max(0, slope of energy + loss) grows and is convex: from the right of
        // its root Newton's steps go down to it without overshooting. So they do from where the force at
        // the start would leave the head, but for a first step too far.
        let mut depth = free - gain * start.root3;
        for _ in 0..ROUNDS {
            let (force, stiffness) = start.force(depth);
            let push = force + loss * (depth - depth_m);
            let (push, stiffness) = if push > 0.0 {
                (push, stiffness + loss)
            } else {
                (0.0, 0.0)
            };
            let move_m = (depth - free + gain * push) / (1.0 + gain * stiffness);
            depth -= move_m;
            // What is left is of the square of this.
            if move_m.abs() <= 1e-7 * (depth.abs() + depth_m.abs()) {
                break;
            }
        }
        let impulse_n_s = (2.0 * (free - depth) / (step_s * mobility)).max(0.0);
        Push {
            impulse_n_s,
            depth_m: free - 0.5 * step_s * mobility * impulse_n_s,
        }
    }
}

/// The compression at the start of a step and its roots.
struct Start {
    depth: f64,
    root: f64,
    root3: f64,
}

impl Start {
    #[inline(always)]
    fn new(depth: f64) -> Self {
        let root = depth.max(0.0).sqrt();
        Self {
            depth,
            root,
            root3: root * root * root,
        }
    }

    /// (U(δ) − U(δ₀)) / (δ − δ₀) for K = 1, and its slope over δ. With a = √δ₀ and b = √δ the quotient
    /// is 2/5 (a⁴ + a³b + a²b² + ab³ + b⁴)/(a + b): nothing cancels.
    #[inline(always)]
    fn force(&self, depth: f64) -> (f64, f64) {
        let (a, b) = (self.root, depth.max(0.0).sqrt());
        if self.depth >= 0.0 && depth >= 0.0 {
            let sum = a + b;
            if sum == 0.0 {
                return (0.0, 0.0);
            }
            let top = b * (b * (b * (b + a) + a * a) + self.root3) + a * self.root3;
            let slope = b * (b * (4.0 * b + 3.0 * a) + 2.0 * a * a) + self.root3;
            // d/dδ is d/db over 2b, which goes to 0 where there is nothing to divide.
            let twice = (2.0 * b).max(1e-9 * a);
            let inverse = 1.0 / (sum * twice);
            let force = 0.4 * top * twice * inverse;
            return (force, (0.4 * slope - force) * inverse);
        }
        let apart = depth - self.depth;
        if depth > 0.0 {
            let force = 0.4 * b * b * b * b * b / apart;
            return (force, (b * b * b - force) / apart);
        }
        if self.depth > 0.0 {
            let force = 0.4 * self.root3 * a * a / -apart;
            return (force, force / -apart);
        }
        (0.0, 0.0)
    }
}
