//! Cost of a frame of the body on the processor, before anything is drawn: 2,000 modes that ring, a
//! surface of at least 20,000 triangles.

use criterion::{Criterion, criterion_group, criterion_main};
use egui::{Color32, Pos2, Rect, vec2};
use idiophone::editor::{Laid, Paint, Portrait, Solid, Swinging};
use idiophone::engine::Partial;
use idiophone::factory;
use modes::sound_map::{BodyMap, Hearing};
use modes::{Body, Material};
use std::hint::black_box;

const MODES: usize = 2000;
const TRIANGLES: usize = 20_000;
const FRAME_S: f32 = 1.0 / 60.0;

/// Values and what lies half-way between each two.
fn halved<const N: usize, T: Copy>(values: &[[T; N]], mean: impl Fn(T, T) -> T) -> Vec<[T; N]> {
    let mut out = Vec::with_capacity(2 * values.len());
    for pair in values.windows(2) {
        out.push(pair[0]);
        out.push(std::array::from_fn(|k| mean(pair[0][k], pair[1][k])));
    }
    out.extend(values.last());
    out
}

/// A singing bowl with as many modes and as fine a strike line as are asked for.
fn bowl() -> (Body, Material) {
    let index = factory::BANKS
        .iter()
        .position(|(name, _)| *name == "singing-bowls");
    let bank = factory::bank(index.unwrap_or(0));
    let mut body = bank.bodies[12].clone();
    while Solid::of(&body, &bank.material).triangles.len() < TRIANGLES {
        body.line.points_m = halved(&body.line.points_m, |a, b| 0.5 * (a + b));
        body.line.normals = halved(&body.line.normals, |a, b| 0.5 * (a + b));
        for mode in &mut body.modes {
            let shape: Vec<_> = mode.shape.iter().collect();
            mode.shape = halved(&shape, |a, b| 0.5 * (a + b)).into();
        }
    }
    let first = body.modes.clone();
    body.modes = (0..MODES)
        .map(|i| {
            let mut mode = first[i % first.len()].clone();
            let round = (i / first.len()) as u16;
            mode.hz *= 1.0 + 0.003 * f64::from(round);
            mode.label.index += 100 * round;
            mode
        })
        .collect();
    (body, bank.material)
}

fn picture(c: &mut Criterion) {
    let (body, material) = bowl();
    let solid = Solid::of(&body, &material);
    let hz: Vec<f64> = Partial::all(&body)
        .iter()
        .map(|partial| partial.hz)
        .collect();
    assert!(solid.triangles.len() >= TRIANGLES && hz.len() > MODES * 9 / 10);
    let swings: Vec<f32> = (0..hz.len())
        .map(|i| 1e-6 / (1.0 + (i * 7919 % hz.len()) as f32))
        .collect();
    let area = Rect::from_min_size(Pos2::ZERO, vec2(900.0, 600.0));
    let paint = Paint {
        own: Color32::GRAY,
        moving: [Color32::YELLOW, Color32::BLUE],
        map: None,
        ink: Color32::WHITE,
        metal: true,
        pixel: 0.5,
    };
    let mut group = c.benchmark_group(format!(
        "{} modes, {} triangles",
        hz.len(),
        solid.triangles.len()
    ));
    for (name, alone) in [
        ("all ring", None),
        ("one mode with its nodal lines", Some(6)),
    ] {
        let swinging = Swinging {
            hz: &hz,
            swings: &swings,
            alone,
            times: 1.0,
        };
        let mut portrait = Portrait::default();
        portrait.turn_to(&solid, true);
        group.bench_function(name, |b| {
            b.iter(|| {
                portrait.swing(&solid, area, &swinging, FRAME_S);
                black_box(portrait.mesh(&solid, &swinging, &paint))
            });
        });
    }
    let colours = vec![Color32::RED; solid.points_m.len()];
    let mapped = Paint {
        map: Some(Laid {
            colours: &colours,
            beyond: 0.0,
        }),
        ..paint
    };
    let swinging = Swinging {
        hz: &hz,
        swings: &swings,
        alone: None,
        times: 1.0,
    };
    let mut portrait = Portrait::default();
    portrait.turn_to(&solid, true);
    group.bench_function("all ring under a map", |b| {
        b.iter(|| {
            portrait.swing(&solid, area, &swinging, FRAME_S);
            black_box(portrait.mesh(&solid, &swinging, &mapped))
        });
    });
    group.bench_function("another body", |b| {
        b.iter(|| black_box(Solid::of(&body, &material)));
    });
    group.finish();
}

/// The map of timbre of a square drum at as many places as a surface has points.
fn map(c: &mut Criterion) {
    let index = factory::BANKS
        .iter()
        .position(|(name, _)| *name == "square-drums");
    let body = &factory::bank(index.unwrap_or(0)).bodies[0];
    let places: Vec<[f64; 2]> = (0..TRIANGLES)
        .map(|i| [(i % 200) as f64 / 199.0, (i / 200) as f64 / 99.0])
        .collect();
    let map = BodyMap::new(&Hearing::HUMAN, body, &places);
    let mut group = c.benchmark_group(format!(
        "map of {} modes at {} places",
        body.modes.len(),
        places.len()
    ));
    group.bench_function("from another place", |b| {
        b.iter(|| black_box(map.from_place_db(black_box([0.3, 0.6]))));
    });
    group.bench_function("of another body", |b| {
        b.iter(|| black_box(BodyMap::new(&Hearing::HUMAN, body, &places)));
    });
    group.finish();
}

criterion_group!(benches, picture, map);
criterion_main!(benches);
