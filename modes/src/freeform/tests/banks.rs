//! Whole banks, and bodies solved at two sizes against their spread.

use super::super::{FreeError, free_bank as joined, solved_piece};
use super::material;
use crate::mesh::{Mesh, brick_tet10};
use crate::solve::Watch;
use crate::{
    Bank, Body, Damping, FreeFineness, FreeRecipe, FreeTuning, KeyRange, ListenerRecipe,
    LossRecipe, Material, MeshScale, MeshShape, Piece, SpreadRule, TunedMode, Up,
};

fn build(material: Material, rule: SpreadRule) -> FreeRecipe {
    FreeRecipe {
        name: "brick".into(),
        title: "Brick".into(),
        a4_hz: 440.0,
        pieces: vec![Piece {
            keys: KeyRange { low: 60, high: 96 },
            tuning: FreeTuning {
                rule,
                mode: TunedMode::Lowest,
            },
            shape: MeshShape {
                file: "brick.obj".into(),
                objects: Vec::new(),
                scale: MeshScale::Unit(1.0),
                wall_m: None,
                up: Up::Z,
            },
            material,
            damping: Damping::default(),
            losses: LossRecipe {
                support_kg_s: 0.01,
                felt_kg_s: 0.5,
            },
            fineness: FreeFineness {
                most_modes: 12,
                ..FreeFineness::default()
            },
        }],
        listener: ListenerRecipe {
            distance_m: 50.0,
            above_m: 10.0,
            row_m: 0.0,
        },
        text: "a brick".into(),
    }
}

/// The bank of a recipe of one piece.
fn free_bank(recipe: &FreeRecipe, mesh: &Mesh, watch: &dyn Watch) -> Result<Bank, FreeError> {
    Ok(joined(recipe, vec![solved_piece(recipe, 0, mesh, watch)?]))
}

fn brick(scale: f64) -> Mesh {
    brick_tet10([0.2, 0.03, 0.01].map(|x| scale * x), [6, 1, 1])
}

fn at(bank: &Bank, key: u8) -> Body {
    let bank = bank.clone().spread_out();
    let found = bank.bodies.into_iter().find(|body| body.key == key);
    found.unwrap()
}

fn near(found: f64, expected: f64, bound: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(
        off <= bound * expected.abs(),
        "{what}: {found}, not {expected}"
    );
}

/// Whether modes of `found` are those of `expected`, a body solved as `found` was spread to be; ears to
/// `ears` of their size.
fn compare(found: &Body, expected: &Body, touch: f64, ears: f64) {
    near(found.length_m, expected.length_m, 1e-6, "length");
    near(found.mass_kg, expected.mass_kg, 1e-6, "mass");
    for (p, q) in found.line.points_m.iter().zip(&expected.line.points_m) {
        for a in 0..3 {
            assert!((p[a] - q[a]).abs() < 1e-6 * expected.length_m);
        }
    }
    let count = found.modes.len().min(expected.modes.len());
    assert!(count >= 6, "{count}");
    for (found, expected) in found.modes.iter().zip(&expected.modes).take(count) {
        near(found.hz, expected.hz, 1e-6, "hz");
        near(found.coupling, expected.coupling, 1e-4, "coupling");
        let rates = [
            (found.radiation_per_s, expected.radiation_per_s, 1.0),
            (found.support_per_s, expected.support_per_s, touch),
            (found.felt_per_s, expected.felt_per_s, touch),
        ];
        for (found, expected, factor) in rates {
            near(f64::from(found), factor * f64::from(expected), 2e-3, "rate");
        }
        let size = |ear: [f32; 2]| f64::from(ear[0]).hypot(f64::from(ear[1]));
        for (p, q) in found.ears.iter().zip(expected.ears) {
            near(size(*p), size(q), ears, "ear");
        }
        // A mode's sign is free.
        let most = |shape: &crate::ModeShape| {
            shape
                .iter()
                .flatten()
                .fold(0.0f32, |most, x| most.max(x.abs()))
        };
        near(
            f64::from(most(&found.shape)),
            f64::from(most(&expected.shape)),
            1e-4,
            "shape",
        );
    }
}

#[test]
fn a_body_of_another_size_is_the_spread_one() {
    let bank = free_bank(&build(material(), SpreadRule::Size), &brick(1.0), &()).unwrap();
    assert_eq!(bank.check(), Ok(()));
    let spread = at(&bank, 84);
    let scale = spread.length_m / bank.bodies[0].length_m;
    let own = free_bank(&build(material(), SpreadRule::Fixed), &brick(scale), &()).unwrap();
    // Supports of the same stuff are larger with the body: their resistance goes with their area.
    compare(&spread, &own.bodies[0], scale * scale, 1e-2);
    near(spread.modes[0].hz, spread.pitch_hz, 1e-9, "pitch");
}

#[test]
fn a_body_of_another_density_or_stiffness_is_the_spread_one() {
    for rule in [SpreadRule::Density, SpreadRule::Stiffness] {
        let bank = free_bank(&build(material(), rule), &brick(1.0), &()).unwrap();
        let spread = at(&bank, 72);
        let ratio = spread.modes[0].hz / bank.bodies[0].modes[0].hz;
        let mut changed = material();
        if rule == SpreadRule::Density {
            changed.density_kg_m3 /= ratio * ratio;
        } else {
            changed.lambda_pa *= ratio * ratio;
            changed.mu_pa *= ratio * ratio;
        }
        let own = free_bank(&build(changed, SpreadRule::Fixed), &brick(1.0), &()).unwrap();
        let (found, expected) = (&spread, &own.bodies[0]);
        near(found.mass_kg, expected.mass_kg, 1e-6, "mass");
        assert_eq!(found.line, expected.line);
        for (found, expected) in found.modes.iter().zip(&expected.modes) {
            near(found.hz, expected.hz, 1e-6, "hz");
            near(found.coupling, expected.coupling, 1e-4, "coupling");
            let touched = [found, expected].map(|mode| f64::from(mode.support_per_s));
            near(touched[0], touched[1], 2e-3, "support");
        }
    }
}

#[test]
fn a_bank_has_a_surface_and_comes_back_from_its_file() {
    let bank = free_bank(&build(material(), SpreadRule::Size), &brick(1.0), &()).unwrap();
    let surface = bank.bodies[0].surface.as_ref().unwrap();
    assert_eq!(surface.motions.len(), bank.bodies[0].modes.len());
    assert!(surface.triangles.len() > 100);
    let file = bank.write();
    assert_eq!(Bank::read(&file), Ok(bank.clone()));
    let spread = bank.spread_out();
    assert_eq!(spread.bodies.len(), 37);
    assert_eq!(spread.check(), Ok(()));
    assert_eq!(Bank::read(&spread.write()), Ok(spread));
}

#[test]
fn the_tuned_mode_can_be_chosen() {
    let tuned = |tuned: TunedMode| {
        let mut build = build(material(), SpreadRule::Size);
        build.pieces[0].tuning.mode = tuned;
        free_bank(&build, &brick(1.0), &()).map(|bank| bank.spread.unwrap().zones[0].tuned)
    };
    assert_eq!(tuned(TunedMode::Lowest), Ok(0));
    assert_eq!(tuned(TunedMode::Number(3)), Ok(2));
    assert!(tuned(TunedMode::Loudest).is_ok());
    let missing = tuned(TunedMode::Number(0)).unwrap_err();
    assert!(matches!(missing, FreeError::NoSuchMode { number: 0, .. }));
}

#[test]
fn bodies_that_nobody_hears_are_refused() {
    let tiny = brick(0.05);
    let error = free_bank(&build(material(), SpreadRule::Fixed), &tiny, &()).unwrap_err();
    assert!(
        error.to_string().contains("no mode below 20000 Hz"),
        "{error}"
    );
}

#[test]
fn a_solution_can_be_cancelled() {
    let stop = |_: usize, _: usize| std::ops::ControlFlow::Break(());
    let error = free_bank(&build(material(), SpreadRule::Fixed), &brick(1.0), &stop);
    assert_eq!(error, Err(FreeError::Solve(crate::SolveError::Cancelled)));
}
