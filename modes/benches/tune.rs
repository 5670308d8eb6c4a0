//! What a turn of a shape knob costs: bodies tuned from nothing, retuned from the last one, solved.
//!
//! Each name tells the modes that were found; bars use rayon's threads, the rest one. Bound by the
//! factorisations and by the substitutions of Lanczos.

use criterion::{Criterion, criterion_group, criterion_main};
use modes::bar::{
    BarFineness, BarTuning, bar_modes, retune_bar, tune_bar, vibraphone_ratios, vibraphone_stock,
};
use modes::revolution::{Bell, LAYERS, SolvedWall, bowl};
use modes::shape::Tube;
use modes::solve::Band;
use modes::tube::{TubeTuning, retune_tube, tune_tube};
use modes::{Material, NamedMaterial, Recipe, ShapeRecipe, equal_temperament_hz};

fn material(name: &str) -> Material {
    NamedMaterial::find(name)
        .expect("a named material")
        .material
}

fn bars(c: &mut Criterion) {
    let fineness = BarFineness {
        max_element_m: 0.007,
        across: 3,
        through: 2,
    };
    let metal = material("aluminium");
    for key in [53, 65, 77, 89] {
        let stock = vibraphone_stock(key);
        let tuning = |times: f64| BarTuning {
            pitch_hz: times * equal_temperament_hz(key, 440.0),
            ratios: vibraphone_ratios(key),
            tolerance_cents: 1.0,
        };
        let tune = || tune_bar(&stock, &metal, fineness, &tuning(1.0)).expect("within reach");
        let last = tune();
        let solve = || bar_modes(&last.bar, &metal, fineness, Band::AUDIBLE).expect("solved");
        let modes = solve().modes.len();
        let mut group = c.benchmark_group(format!("vibraphone bar {key}, {modes} modes"));
        group.sample_size(10);
        group.bench_function("tuned from nothing", |b| b.iter(tune));
        group.bench_function("retuned by 9 cents", |b| {
            b.iter(|| {
                retune_bar(&last, &stock, &metal, fineness, &tuning(1.005)).expect("within reach")
            });
        });
        group.bench_function("solved", |b| b.iter(solve));
        group.finish();
    }
}

fn tubes(c: &mut Criterion) {
    let metal = material("brass");
    let shape = Bell {
        plug_m: 0.016,
        ..Bell::open(Tube {
            outer_radius_m: 0.016,
            wall_m: 0.0015,
            length_m: 0.0,
        })
    };
    let band = Band {
        high_hz: 10_000.0,
        ..Band::AUDIBLE
    };
    for key in [48, 66, 84] {
        let tuning = |times: f64| TubeTuning {
            pitch_hz: 2.0 * times * equal_temperament_hz(key, 440.0),
            partial: 4,
            tolerance_cents: 0.5,
        };
        let tune = || tune_tube(&shape, &metal, 0.009, &tuning(1.0)).expect("within reach");
        let last = tune();
        let solve = || SolvedWall::new(last.wall(0.009, LAYERS), &metal, band).expect("solved");
        let modes = solve().body(None).modes.len();
        let mut group = c.benchmark_group(format!("tubular bell {key}, {modes} modes"));
        group.sample_size(10);
        group.bench_function("tuned from nothing", |b| b.iter(tune));
        group.bench_function("retuned by 9 cents", |b| {
            b.iter(|| retune_tube(&last, &metal, 0.009, &tuning(1.005)).expect("within reach"));
        });
        group.bench_function("solved", |b| b.iter(solve));
        group.finish();
    }
}

fn bowls(c: &mut Criterion) {
    for (name, text) in Recipe::FACTORY {
        let recipe = Recipe::parse(text, name).expect("a factory recipe");
        let ShapeRecipe::Bowl(shape) = recipe.shape else {
            continue;
        };
        let band = Band {
            high_hz: recipe.mesh.highest_hz,
            ..Band::AUDIBLE
        };
        let solve = || {
            let wall = bowl(&shape, recipe.mesh.max_element_m, LAYERS).expect("a profile");
            SolvedWall::new(wall, &recipe.material, band)
                .expect("solved")
                .body(None)
        };
        let modes = solve().modes.len();
        let mut group = c.benchmark_group(format!("{name}, {modes} modes"));
        group.sample_size(10);
        group.bench_function("solved", |b| b.iter(solve));
        group.finish();
    }
}

criterion_group!(benches, bars, tubes, bowls);
criterion_main!(benches);
