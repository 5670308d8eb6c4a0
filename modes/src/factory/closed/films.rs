//! Films and plates whose shapes are products: as many of their modes as a recipe wants.

use super::lowest::Lowest;
use super::outline::Outline;
use super::sheet::Sheet;
use super::{DRAWN, Reach, grid};
use crate::analytic::{
    CircularMembrane, ClampedPlate, ClosedMode, ProductMode, RectangularMembrane, bessel_zeros,
    clamped_plate_roots,
};
use crate::{ModeLabel, Recipe};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4, PI, TAU};

/// Cells of a round body's picture: waves around it are as short as those outwards.
const DRAWN_ROUND: [usize; 2] = [12, 64];

/// Most modes of a body, whatever a recipe wants.
const MOST_MODES: f64 = 2400.0;

/// The most modes of a film of which a recipe does not say how many are enough.
const UNSAID: usize = 70;

pub(super) fn rectangle(membrane: &RectangularMembrane, recipe: &Recipe, reach: Reach) -> Lowest {
    let sides_m = membrane.sides_m;
    // Weyl's law, A k²/4π.
    let to_square = FRAC_PI_4 * (sides_m[0] / sides_m[1] + sides_m[1] / sides_m[0]);
    let first_hz = membrane.hz([1, 1]);
    let most = (MOST_MODES / to_square).sqrt();
    let modes = enough(recipe, reach, most, |ratio| {
        membrane.modes(ratio * first_hz)
    });
    let half_waves = [0, 1].map(|axis| {
        let all = modes.iter().map(|mode| mode.functions()[axis][0]);
        f64::from(all.max().unwrap_or(1))
    });
    let strike = grid::coarse();
    let sheet = Sheet {
        outline: Outline::Rectangle { sides_m },
        mass_kg: membrane.mass_kg(),
        modes: &modes,
        finer: grid::finer(&strike, half_waves, false),
        strike,
        radians: half_waves.map(|count| PI * count),
        longest_m: recipe.mesh.max_element_m,
        drawn: DRAWN,
    };
    sheet.lowest()
}

pub(super) fn drum(membrane: &CircularMembrane, recipe: &Recipe, reach: Reach) -> Lowest {
    let first = bessel_zeros(0, PI)[0];
    let most = (4.0 * MOST_MODES).sqrt() / first;
    let modes = enough(recipe, reach, most, |ratio| {
        membrane.modes(ratio * membrane.hz(first))
    });
    let root = modes
        .last()
        .map_or(first, |mode| mode.hz() / membrane.hz(1.0));
    let sizes_m = [membrane.radius_m, recipe.mesh.max_element_m];
    disc(sizes_m, membrane.mass_kg(), &modes, root).lowest()
}

pub(super) fn plate(plate: &ClampedPlate, recipe: &Recipe, reach: Reach) -> Lowest {
    let first = clamped_plate_roots(0, 4.0)[0];
    let most = 4.0 * MOST_MODES / (first * first);
    let modes = enough(recipe, reach, most, |ratio| {
        plate.modes(ratio * plate.hz(first))
    });
    let square = modes.last().map(|mode| mode.hz() / plate.hz(1.0));
    let root = square.map_or(first, f64::sqrt);
    let sizes_m = [plate.radius_m, recipe.mesh.max_element_m];
    disc(sizes_m, plate.mass_kg(), &modes, root).lowest()
}

/// A disc of that radius, with patches no longer than that, in m, and with these modes, of which the highest has that wave number times radius.
fn disc<M: ProductMode>(
    [radius_m, longest_m]: [f64; 2],
    mass_kg: f64,
    modes: &[M],
    root: f64,
) -> Sheet<'_, M> {
    let order = |label: ModeLabel| f64::from(label.order);
    let orders = modes.iter().map(|mode| order(mode.label()));
    let around = orders.fold(1.0, f64::max);
    let strike = grid::spokes();
    let across = (1.0 + FRAC_1_SQRT_2) * root / PI;
    Sheet {
        outline: Outline::Disc { radius_m },
        mass_kg,
        modes,
        finer: grid::finer(&strike, [across, 2.0 * around], true),
        strike,
        radians: [root, TAU * around],
        longest_m,
        drawn: DRAWN_ROUND,
    }
}

/// The modes that are enough for the lowest key; `up_to` gives those up to so many times the lowest
/// frequency, of which there are not too many up to `most` times it.
fn enough<M: ProductMode>(
    recipe: &Recipe,
    reach: Reach,
    most: f64,
    up_to: impl Fn(f64) -> Vec<M>,
) -> Vec<M> {
    let Some(fewest) = recipe.mesh.fewest_modes else {
        let mut modes = up_to(reach.wanted.min(most));
        modes.truncate(UNSAID);
        return modes;
    };
    let fewest = usize::from(fewest);
    let mut ratio = reach.wanted.min(most);
    let mut modes = up_to(ratio);
    if modes.len() >= fewest {
        return modes;
    }
    while modes.len() < fewest && ratio < reach.heard.min(most) {
        ratio = (1.25 * ratio).min(reach.heard);
        modes = up_to(ratio);
    }
    modes.truncate(fewest);
    modes
}
