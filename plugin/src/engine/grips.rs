//! How a bow or a stick gets hold of a body's modes.

use super::bow::{Grip, Rub};
use super::oscillators::LANES;
use super::source::Reached;
use modes::{Family, Member};
use std::f64::consts::FRAC_PI_2;

/// Frequency in Hz from which on hair, leather and their width give way instead of moving the surface.
const YIELDS_HZ: f64 = 1500.0;

/// The bow for a body with these modes, whose strike line begins at `start_m`.
///
/// A shell is rubbed around its rim: of a mode with m waves that moves U outwards at its crests the wall
/// goes U/m along the rim at its nodes, as it does not stretch (Rayleigh, Theory of Sound, 1894, §232).
/// Which way the crests of a pair lie follows from how far its two move at the strike line. Anything else
/// is bowed up and down at the beginning of the line.
pub(super) fn bow(modes: &[Reached], start_m: [f64; 3]) -> Rub {
    let shell = modes
        .iter()
        .any(|mode| mode.label.family == Family::Shell && mode.label.order >= 2);
    let mut grips = vec![[Grip::default(); LANES]; modes.len().div_ceil(LANES)];
    for (i, mode) in modes.iter().enumerate() {
        let grip = if shell {
            around(modes, mode)
        } else {
            Some(edge(mode))
        };
        let firm = 1.0 / (1.0 + (mode.hz / YIELDS_HZ).powi(2));
        let grip = grip.unwrap_or_default();
        grips[i / LANES][i % LANES] = Grip {
            size: firm * grip.size,
            ..grip
        };
    }
    let radius_m = start_m[0].hypot(start_m[1]);
    Rub::new(grips, (shell && radius_m > 0.0).then_some(radius_m))
}

fn edge(mode: &Reached) -> Grip {
    Grip {
        size: mode.start,
        waves: 0.0,
        from_rad: -FRAC_PI_2,
    }
}

/// A mode along the rim; none if it is not one of a pair of which both are heard.
fn around(modes: &[Reached], mode: &Reached) -> Option<Grip> {
    let label = mode.label;
    let of = |member: Member| {
        let wanted = modes::ModeLabel { member, ..label };
        let found = modes.iter().find(|other| other.label == wanted)?;
        Some(found.start)
    };
    if label.order < 2 {
        return None;
    }
    // A moves outwards by U cos m(θ − α), B by U sin m(θ − α), and the line is at θ = 0.
    let (a, b) = (of(Member::A)?, of(Member::B)?);
    let waves = f64::from(label.order);
    let (size, crest) = (a.hypot(b) / waves, (-b).atan2(a));
    match label.member {
        Member::A => Some(Grip {
            size: -size,
            waves,
            from_rad: crest,
        }),
        Member::B => Some(Grip {
            size,
            waves,
            from_rad: crest - FRAC_PI_2,
        }),
        Member::Single => None,
    }
}
