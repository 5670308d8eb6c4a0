//! Bodies of closed form with their drawing changed, against what the closed form says of the change.

use crate::factory::{Silent, build};
use crate::{Bank, Body, Recipe, Variation};

const OWN: Variation = Variation {
    length: 1.0,
    wall: 1.0,
    width: 1.0,
    profile: 0.0,
    poisson: None,
};

/// The lowest body of a factory instrument in its own drawing and in another.
fn both(name: &str, variation: Variation) -> [Body; 2] {
    let (name, text) = Recipe::FACTORY.iter().find(|(n, _)| *n == name).unwrap();
    let own = Recipe::parse(text, name).unwrap();
    let varied = own.varied(&variation).unwrap();
    [own, varied].map(|recipe| {
        let Bank { mut bodies, .. } = build(&recipe, &Silent).unwrap();
        let body = bodies.remove(0);
        let cents = 1200.0 * (body.modes[0].hz / body.pitch_hz).log2();
        assert!(cents.abs() < 0.01, "{cents}");
        body
    })
}

fn near(found: f64, expected: f64, by: f64) {
    assert!(
        (found / expected - 1.0).abs() < by,
        "{found}, not {expected}"
    );
}

/// B of a string, from its second and first partial: f₂/f₁ = 2 √((1 + 4B)/(1 + B)).
fn inharmonicity(body: &Body) -> f64 {
    let square = (0.5 * body.modes[1].hz / body.modes[0].hz).powi(2);
    (square - 1.0) / (4.0 - square)
}

/// At one pitch and length B = π² E I/T L² goes as the square of the thickness, for tension does too; at
/// one thickness as the inverse fourth power of the length (Fletcher 1964, as
/// [`crate::analytic::TautString::inharmonicity`]).
#[test]
fn a_thicker_or_shorter_string_is_stretched_more() {
    let [own, thick] = both("strings", Variation { wall: 1.5, ..OWN });
    near(inharmonicity(&thick) / inharmonicity(&own), 1.5 * 1.5, 2e-3);
    near(thick.mass_kg / own.mass_kg, 1.5 * 1.5, 2e-3);
    let [own, long] = both(
        "strings",
        Variation {
            length: 1.25,
            ..OWN
        },
    );
    near(
        inharmonicity(&own) / inharmonicity(&long),
        1.25_f64.powi(4),
        2e-3,
    );
    near(long.length_m / own.length_m, 1.25, 2e-3);
    // √(Tμ) of the longer, which is tighter: its board takes the more.
    let board = f64::from(long.modes[0].radiation_per_s / own.modes[0].radiation_per_s);
    near(board, 1.25, 2e-3);
}

/// Clamped plates and thin bars have the same partials whatever their thickness; what is thicker is as
/// much longer as the root, and heavier.
#[test]
fn a_thicker_plate_or_bar_is_larger_and_keeps_its_partials() {
    for (name, mass) in [
        ("round-plates", 4.0),
        ("free-bars", 8.0_f64.sqrt()),
        ("tines", 8.0_f64.sqrt()),
    ] {
        let [own, thick] = both(name, Variation { wall: 2.0, ..OWN });
        near(thick.length_m / own.length_m, 2.0_f64.sqrt(), 1e-9);
        near(thick.mass_kg / own.mass_kg, mass, 1e-9);
        assert_eq!(thick.modes.len(), own.modes.len());
        for (a, b) in own.modes.iter().zip(&thick.modes) {
            near(b.hz, a.hz, 1e-9);
        }
    }
}

/// What is taut by the same stress keeps size and partials; a film of twice the mass is damped half as
/// much by the air that it moves.
#[test]
fn a_thicker_film_rings_longer() {
    for name in ["round-drums", "square-drums", "l-drums"] {
        let [own, thick] = both(name, Variation { wall: 2.0, ..OWN });
        near(thick.length_m / own.length_m, 1.0, 1e-9);
        let most = own
            .modes
            .iter()
            .fold(0.0f32, |most, mode| most.max(mode.radiation_per_s));
        // What cancels itself is left to rounding.
        for a in own.modes.iter().filter(|a| a.radiation_per_s > 1e-6 * most) {
            // Of modes of one frequency either may come first.
            let b = thick.modes.iter().find(|b| b.label == a.label).unwrap();
            near(b.hz, a.hz, 1e-9);
            near(f64::from(a.radiation_per_s / b.radiation_per_s), 2.0, 1e-4);
        }
        let [own, large] = both(name, Variation { length: 1.2, ..OWN });
        near(large.length_m / own.length_m, 1.2, 1e-9);
        near(large.modes[1].hz, own.modes[1].hz, 1e-9);
        assert!(large.modes[0].radiation_per_s > 1.1 * own.modes[0].radiation_per_s);
    }
}

/// f of m and n half-waves goes as √(m²/a² + n²/b²) (van den Doel & Pai 1998, Eq. 18).
#[test]
fn a_square_drum_made_broader_has_a_rectangle_s_partials() {
    let [_, broad] = both("square-drums", Variation { width: 1.7, ..OWN });
    let hz = |m: f64, n: f64| (m * m + n * n / (1.7 * 1.7)).sqrt();
    let mut expected: Vec<f64> = (1..9)
        .flat_map(|m| (1..9).map(move |n| (f64::from(m), f64::from(n))))
        .map(|(m, n)| hz(m, n) / hz(1.0, 1.0))
        .collect();
    expected.sort_by(f64::total_cmp);
    for (mode, expected) in broad.modes.iter().zip(expected).take(20) {
        near(mode.hz / broad.modes[0].hz, expected, 1e-9);
    }
}

/// A wider bar moves the same way and stirs more air.
#[test]
fn a_wider_bar_is_heavier_and_radiates_more_of_it() {
    let [own, wide] = both("free-bars", Variation { width: 2.0, ..OWN });
    near(wide.mass_kg / own.mass_kg, 2.0, 1e-9);
    near(wide.modes[1].hz, own.modes[1].hz, 1e-9);
    assert!(wide.modes[0].ears != own.modes[0].ears);
}
