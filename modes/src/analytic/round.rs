//! What round membranes and plates share: nodal diameters, and pairs of modes.

use crate::{Family, Member, ModeLabel};
use std::f64::consts::TAU;

/// A mode of a round body, but for how it depends on the radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Round {
    /// Nodal diameters.
    pub(super) order: u16,
    /// Counted from 1 by frequency among those of its order.
    index: u16,
    /// Which of a pair: A goes with the cosine, B with the sine.
    member: Member,
    /// Wave number times the radius.
    pub(super) root: f64,
}

/// The modes of a round body whose wave numbers times radius `roots` gives for each order; order by
/// order until one has none.
pub(super) fn round_modes(roots: impl Fn(u16) -> Vec<f64>) -> Vec<Round> {
    let mut modes = Vec::new();
    for order in 0..u16::MAX {
        let roots = roots(order);
        if roots.is_empty() {
            break;
        }
        let members: &[Member] = match order {
            0 => &[Member::Single],
            _ => &[Member::A, Member::B],
        };
        for (&root, index) in roots.iter().zip(1..) {
            modes.extend(members.iter().map(|&member| Round {
                order,
                index,
                member,
                root,
            }));
        }
    }
    // The sort is stable: A stays before B.
    modes.sort_by(|p: &Round, q| p.root.total_cmp(&q.root));
    modes
}

impl Round {
    /// Mean square of the wave around the axis.
    pub(super) fn mean_square(&self) -> f64 {
        if self.order == 0 { 1.0 } else { 0.5 }
    }

    /// The distance from the middle as a share of the radius, and the wave around the axis, at a
    /// point; nothing outside the rim.
    pub(super) fn place(&self, [x_m, y_m]: [f64; 2], radius_m: f64) -> Option<(f64, f64)> {
        let share = x_m.hypot(y_m) / radius_m;
        let (sin, cos) = (f64::from(self.order) * y_m.atan2(x_m)).sin_cos();
        let wave = if self.member == Member::B { sin } else { cos };
        (share <= 1.0).then_some((share, wave))
    }

    /// What tells its functions of the distance and of the turn from those of other modes.
    pub(super) fn functions(&self) -> [[u16; 2]; 2] {
        let sine = u16::from(self.member == Member::B);
        [[self.order, self.index], [self.order, sine]]
    }

    /// The wave around the axis at a turn, 0…1.
    pub(super) fn wave(&self, turn: f64) -> f64 {
        let (sin, cos) = (TAU * f64::from(self.order) * turn).sin_cos();
        if self.member == Member::B { sin } else { cos }
    }

    /// What a function of the distance is on the far side of the middle over what it is on this side: the
    /// wave turns over there if it has an odd number of nodal diameters.
    pub(super) fn parity(&self, share: f64) -> f64 {
        if share < 0.0 && self.order % 2 == 1 {
            -1.0
        } else {
            1.0
        }
    }

    pub(super) fn label(&self, family: Family) -> ModeLabel {
        ModeLabel {
            family,
            order: self.order,
            index: self.index,
            member: self.member,
        }
    }
}
