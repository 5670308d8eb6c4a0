//! Bodies of closed form as instruments.

use super::{Lowest, lowest};
use crate::analytic::{CircularMembrane, ClosedMode, RectangularMembrane};
use crate::factory::{Silent, build};
use crate::radiation::baffled_decay_per_s;
use crate::shape::ClosedShape;
use crate::{Bank, Mode, Recipe, ShapeRecipe, StrikeLine, equal_temperament_hz};

/// What a bank may weigh, in bytes.
const HEAVIEST: usize = 3_000_000;

fn factory() -> impl Iterator<Item = (Recipe, ClosedShape)> {
    Recipe::FACTORY.into_iter().filter_map(|(name, text)| {
        let recipe = Recipe::parse(text, name).unwrap();
        let ShapeRecipe::Closed(shape) = recipe.shape else {
            return None;
        };
        Some((recipe, shape))
    })
}

fn named(name: &str) -> (Recipe, ClosedShape) {
    factory().find(|(recipe, _)| recipe.name == name).unwrap()
}

#[test]
fn every_key_is_in_tune_and_the_bank_light() {
    let mut count = 0;
    for (recipe, _) in factory() {
        count += 1;
        let file = build(&recipe, &Silent).unwrap().write();
        assert!(file.len() < HEAVIEST, "{}: {}", recipe.name, file.len());
        let bank = Bank::read(&file).unwrap().spread_out();
        assert_eq!(bank.bodies.len(), recipe.keys.iter().len());
        for body in &bank.bodies {
            let cents = 1200.0 * (body.modes[0].hz / body.pitch_hz).log2();
            assert!(cents.abs() < recipe.tuning.tolerance_cents, "{}", bank.name);
            assert!(body.modes.len() >= 2, "{} key {}", bank.name, body.key);
        }
    }
    assert_eq!(count, 8);
}

/// φ of `mode` where the grid says a strike at `place` along and across lands, and the point, in m.
fn struck(line: &StrikeLine, mode: &Mode, place: [f64; 2]) -> ([f64; 2], f64) {
    let spot = line.grid().spot(place[0], place[1]);
    let at = |axis: usize| spot.value(|i| line.points_m[i][axis]);
    ([at(0), at(1)], mode.shape.normal_motion(line, place))
}

/// Wherever it is struck, a drum moves as its closed form says, in its lowest mode and in its highest.
#[test]
fn between_grid_points_a_round_drum_moves_as_it_should() {
    let (recipe, shape) = named("round-drums");
    let ClosedShape::CircularMembrane {
        radius_m,
        tension_n_m,
        thickness_m,
    } = shape
    else {
        panic!("a round drum is a circular membrane")
    };
    let body = build(&recipe, &Silent).unwrap().bodies.remove(0);
    // The lowest key's drum is so much larger, and thicker.
    let size = body.length_m / (2.0 * radius_m);
    let drum = CircularMembrane {
        radius_m: size * radius_m,
        tension_n_m: size * tension_n_m,
        mass_kg_m2: size * thickness_m * recipe.material.density_kg_m3,
    };
    let exact = drum.modes(recipe.mesh.highest_hz);
    assert_eq!(body.modes.len(), exact.len());
    let mut far = 0.0f64;
    for (mode, exact) in body.modes.iter().zip(&exact) {
        assert!((mode.hz / exact.hz() - 1.0).abs() < 1e-12);
        let most = 2.0 / drum.mass_kg().sqrt();
        for i in 0..60 {
            let place = [f64::from(i) * 0.618_034, f64::from(i) * 0.324_718].map(f64::fract);
            let (at_m, moves) = struck(&body.line, mode, place);
            far = far.max(at_m[0].hypot(at_m[1]) / drum.radius_m);
            let error = (moves - exact.displacement(at_m)).abs() / most;
            assert!(error < 0.01, "{} at {place:?}: {error}", mode.label);
        }
    }
    assert!(far > 0.95, "{far}");
}

/// The ways over a square go on from the other edge, so that every point is reached; on the edge it
/// rests.
#[test]
fn a_square_drum_is_struck_everywhere() {
    let (recipe, shape) = named("square-drums");
    let ClosedShape::RectangularMembrane {
        sides_m,
        tension_n_m,
        thickness_m,
    } = shape
    else {
        panic!("a square drum is a rectangular membrane")
    };
    let Lowest { solved, shapes, .. } = lowest(&recipe, &shape);
    let (line, shapes) = (solved.line, shapes.unwrap());
    let drum = RectangularMembrane {
        sides_m,
        tension_n_m,
        mass_kg_m2: thickness_m * recipe.material.density_kg_m3,
    };
    let reach = recipe.mesh.highest_hz / equal_temperament_hz(recipe.keys.low, 440.0);
    let exact = drum.modes(reach * drum.hz([1, 1]));
    assert_eq!(shapes.len(), exact.len());
    for number in [0, 3, exact.len() - 1] {
        for (i, point) in line.points_m.iter().enumerate() {
            let at_m = [0, 1].map(|axis| point[axis] + 0.5 * sides_m[axis]);
            let expected = exact[number].displacement(at_m);
            assert!((f64::from(shapes[number].at(i)[2]) - expected).abs() < 1e-4);
        }
    }
    // Where a way goes over the edge one sample stands for both sides, so that beside the other it is a
    // whole cell to the next.
    let grid = line.grid();
    let [along, across] = [grid.columns, grid.rows].map(|count| (count - 1) as f64);
    let farthest_m = (sides_m[0] / along).hypot(sides_m[1] / across);
    for at in [[0.01, 0.5], [0.99, 0.5], [0.2, 0.01], [0.5, 0.98]] {
        let wanted = [0, 1].map(|axis| (at[axis] - 0.5) * sides_m[axis]);
        let near = line
            .points_m
            .iter()
            .map(|p| (p[0] - wanted[0]).hypot(p[1] - wanted[1]));
        let nearest_m = near.fold(f64::INFINITY, f64::min);
        assert!(nearest_m <= farthest_m, "{at:?}: {nearest_m}");
    }
}

#[test]
fn pictures_show_both_sides() {
    for (recipe, shape) in factory() {
        let picture = lowest(&recipe, &shape).picture;
        let up = |[a, b, c]: &[u32; 3]| {
            let [p, q, r] = [a, b, c].map(|i| picture.points_m[*i as usize]);
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        };
        let (above, below) = picture.triangles.split_at(picture.triangles.len() / 2);
        assert!(above.iter().all(|triangle| up(triangle) >= 0.0));
        for (over, under) in above.iter().zip(below) {
            assert_eq!(up(over), -up(under), "{}", recipe.name);
        }
    }
}

/// A string's board takes the same share of all partials of a flexible string: d = 2 f₁ Y √(Tμ), for it
/// reflects all but 2Y√(Tμ) of each wave's amplitude once a period.
#[test]
fn a_string_s_board_damps_as_a_resistance_does() {
    let (recipe, shape) = named("strings");
    let ClosedShape::String {
        radius_m,
        tension_n,
        board_s_kg,
        ..
    } = shape
    else {
        panic!("a string is a string")
    };
    let body = lowest(&recipe, &shape).solved;
    let section_m2 = std::f64::consts::PI * radius_m * radius_m;
    let impedance = (tension_n * section_m2 * recipe.material.density_kg_m3).sqrt();
    let first = &body.modes[0];
    let expected = 2.0 * first.hz * board_s_kg * impedance;
    assert!((first.radiation_per_s / expected - 1.0).abs() < 1e-3);
}

#[test]
fn a_resonator_is_refused() {
    let (recipe, _) = named("tines");
    let text = format!(
        "{}\n[resonator]\nradius_m = 0.02\nlayer_m = 0.01\n",
        recipe.text
    );
    let error = Recipe::parse(&text, "my.toml").unwrap_err().to_string();
    assert_eq!(
        error,
        "my.toml: resonator is given, but must be left out: bodies of closed form have none"
    );
}

/// Decay by radiation as the closed form of the beam has it, against the sum over patches: of modes whose
/// sound is wide enough for the directions of that sum.
#[test]
fn beams_are_those_of_patches() {
    for name in ["round-drums", "square-drums", "round-plates"] {
        let (recipe, shape) = named(name);
        let body = lowest(&recipe, &shape).solved;
        let most = body.modes[0].radiation_per_s;
        for mode in body.modes.iter().take(12) {
            let points = body.surface.points_m.iter().map(|p| [p[0], p[1]]);
            let moved = body.surface.areas_m2.iter().zip(&mode.motion);
            let patches = points.zip(moved.map(|(area, u)| area * f64::from(*u)));
            let expected = baffled_decay_per_s(mode.hz, patches);
            let error = (mode.radiation_per_s - expected).abs();
            let allowed = 1e-4 * expected + 1e-6 * most;
            assert!(
                error < allowed,
                "{name} {}: {error} of {expected}",
                mode.label
            );
        }
    }
}
