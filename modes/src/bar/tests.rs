//! Bars against beams, against the whole mesh, and against what they were tuned to.

use super::*;
use crate::analytic::TimoshenkoBeam;
use crate::fem::{TetMass, assemble};
use crate::mesh::{BarPart, bar_hex20};
use crate::radiation::{coupling, rectified_area};
use crate::solve::{Band, modes_in_band};
use crate::{Family, Material, SolvedBody, equal_temperament_hz};

const COARSE: BarFineness = BarFineness {
    max_element_m: 0.012,
    across: 2,
    through: 2,
};

const F_SHARP_3: u8 = 54;

fn aluminium() -> Material {
    Material::named("aluminium").expect("a named material")
}

fn tuned(key: u8) -> Bar {
    let tuning = BarTuning {
        pitch_hz: equal_temperament_hz(key, 440.0),
        ratios: vibraphone_ratios(key),
        tolerance_cents: 1.0,
    };
    tune_bar(&vibraphone_stock(key), &aluminium(), COARSE, &tuning)
        .expect("within reach")
        .bar
}

fn solved(bar: &Bar) -> SolvedBody {
    bar_modes(bar, &aluminium(), COARSE, Band::AUDIBLE).expect("a sound mesh")
}

fn of_family(body: &SolvedBody, family: Family) -> Vec<f64> {
    let modes = body.modes.iter().filter(|m| m.label.family == family);
    modes.map(|m| m.hz).collect()
}

#[test]
fn a_uniform_bar_bends_as_a_beam_both_ways() {
    let bar = Bar::uniform(0.36, 0.022, 0.0127);
    let body = solved(&bar);
    let material = aluminium();
    for (family, depth_m, width_m, count) in [
        (Family::Bending, bar.thickness_m, bar.width_m, 4),
        (Family::Lateral, bar.width_m, bar.thickness_m, 4),
    ] {
        let beam = TimoshenkoBeam::from_rectangle(bar.length_m, depth_m, width_m, &material);
        let hz = of_family(&body, family);
        for (i, expected) in beam.free_free_hz(count).into_iter().enumerate() {
            let error = hz[i] / expected - 1.0;
            assert!(error.abs() < 2e-3, "{family:?} {}: {error:e}", i + 1);
        }
    }
    // √(E/ρ)/2L, less Rayleigh's correction for the section's Poisson motion, here 10⁻⁴.
    let rod_hz = (material.young_pa() / material.density_kg_m3).sqrt() / (2.0 * bar.length_m);
    let error = of_family(&body, Family::Longitudinal)[0] / rod_hz - 1.0;
    assert!(error.abs() < 5e-4, "{error:e}");
}

#[test]
fn a_thin_bar_moves_two_root_masses_at_its_ends() {
    let body = solved(&Bar::uniform(0.36, 0.02, 0.004));
    let first = &body.modes[0];
    assert_eq!(first.label.to_string(), "bending 1");
    // Blevins 1979, table 8-1.
    let expected = 2.0 / body.mass_kg.sqrt();
    let error = f64::from(first.shape[body.line.len() - 1][2].abs()) / expected - 1.0;
    assert!(error.abs() < 2e-3, "{error:e}");
    // The fundamental is held where it does not rise: only the little turn of the section is left.
    assert!(first.held < 4e-3 * expected * expected, "{}", first.held);
}

#[test]
fn four_quarters_are_the_whole() {
    let bar = tuned(F_SHARP_3);
    let mesh = bar_hex20(&bar, COARSE.grid(&bar), BarPart::Whole);
    let pencil = assemble(&mesh, &aluminium(), TetMass::Consistent).unwrap();
    let whole = modes_in_band(&pencil, Band::AUDIBLE).unwrap();
    let body = solved(&bar);
    assert_eq!(whole.modes.len(), body.modes.len());
    let surface = mesh.surface();
    for (mode, judge) in body.modes.iter().zip(&whole.modes) {
        assert!((mode.hz / judge.hz - 1.0).abs() < 1e-8, "{}", mode.label);
        if mode.hz < 8_000.0 {
            let expected = rectified_area(&mesh.nodes, &surface, &judge.vector);
            let area = mode.rectified_area;
            let error = coupling(area, mode.hz) / coupling(expected, mode.hz) - 1.0;
            assert!(error.abs() < 0.08, "{}: {error}", mode.label);
        }
    }
}

#[test]
fn mass_and_surface_are_the_shape_s() {
    let bar = tuned(F_SHARP_3);
    let body = solved(&bar);
    let expected = bar.volume_m3() * aluminium().density_kg_m3;
    assert!((body.mass_kg / expected - 1.0).abs() < 1e-4);
    let surface = &body.surface;
    let mut closed = [0.0; 3];
    let mut volume_m3 = 0.0;
    for i in 0..surface.len() {
        let (point, normal, area) = (surface.points_m[i], surface.normals[i], surface.areas_m2[i]);
        for a in 0..3 {
            closed[a] += normal[a] * area;
            volume_m3 += point[a] * normal[a] * area / 3.0;
        }
    }
    assert!(closed.iter().all(|sum| sum.abs() < 1e-12), "{closed:?}");
    assert!((volume_m3 / bar.volume_m3() - 1.0).abs() < 0.01);
}

#[test]
fn f_sharp_3_has_double_octave_and_third_on_the_paper_s_length() {
    let bar = tuned(F_SHARP_3);
    assert_eq!(bar.length_m, 0.36);
    let partials = bar_partials(&bar, &aluminium(), COARSE).unwrap();
    let hz = equal_temperament_hz(F_SHARP_3, 440.0);
    assert!((1200.0 * (partials.bending_hz[0] / hz).log2()).abs() < 0.1);
    for (ratio, wanted) in partials
        .ratios()
        .into_iter()
        .zip(vibraphone_ratios(F_SHARP_3))
    {
        assert!((1200.0 * (ratio / wanted).log2()).abs() < 1.1, "{ratio}");
    }
    let hz = of_family(&solved(&bar), Family::Bending);
    assert_eq!(hz[..3].len(), 3);
    for (found, tuned) in hz.iter().zip(partials.bending_hz) {
        assert!((found / tuned - 1.0).abs() < 1e-8);
    }
}

#[test]
fn keys_from_c2_to_c7_can_be_tuned() {
    for key in (36..=96).step_by(6) {
        let bar = tuned(key);
        let partials = bar_partials(&bar, &aluminium(), COARSE).unwrap();
        for (ratio, wanted) in partials.ratios().into_iter().zip(vibraphone_ratios(key)) {
            assert!(
                (1200.0 * (ratio / wanted).log2()).abs() < 1.1,
                "{key}: {ratio}"
            );
        }
    }
}

#[test]
fn ratios_out_of_reach_name_the_nearest() {
    let tuning = BarTuning {
        pitch_hz: 440.0,
        ratios: [2.0, 12.0],
        tolerance_cents: 1.0,
    };
    let error = tune_bar(&vibraphone_stock(69), &aluminium(), COARSE, &tuning).unwrap_err();
    assert!(matches!(error, BarTuneError::OutOfReach { .. }), "{error}");
    assert!(error.to_string().contains("1 : 2.000 : 12.000"), "{error}");
}

/// In the middle, where the line begins, a mode that is odd along the bar neither rises nor, unless it
/// is odd across too, moves sideways.
#[test]
fn the_strike_line_runs_from_the_middle_to_an_end() {
    let bar = tuned(72);
    let body = solved(&bar);
    let last = body.line.len() - 1;
    assert_eq!(body.line.points_m[0][0], 0.0);
    assert!((body.line.points_m[last][0] - 0.5 * bar.length_m).abs() < 1e-12);
    let rise = |name: &str, i: usize| {
        let mode = body
            .modes
            .iter()
            .find(|mode| mode.label.to_string() == name);
        mode.unwrap().shape[i][2].abs()
    };
    assert_eq!(rise("bending 2", 0), 0.0);
    assert!(rise("bending 1", 0) > 0.4 * rise("bending 1", last));
}

#[test]
fn a_bar_like_the_last_is_tuned_from_it() {
    let tuning = |key: u8| BarTuning {
        pitch_hz: equal_temperament_hz(key, 440.0),
        ratios: vibraphone_ratios(key),
        tolerance_cents: 1.0,
    };
    let (stock, material) = (vibraphone_stock(F_SHARP_3), aluminium());
    let last = tune_bar(&stock, &material, COARSE, &tuning(F_SHARP_3)).unwrap();
    // The same stock half a semitone higher, with other partials.
    let wanted = BarTuning {
        pitch_hz: 1.03 * tuning(F_SHARP_3).pitch_hz,
        ratios: [3.95, 9.8],
        ..tuning(F_SHARP_3)
    };
    let next = retune_bar(&last, &stock, &material, COARSE, &wanted).unwrap();
    let partials = bar_partials(&next.bar, &material, COARSE).unwrap();
    assert!((1200.0 * (partials.bending_hz[0] / wanted.pitch_hz).log2()).abs() < 0.1);
    for (ratio, wanted) in partials.ratios().into_iter().zip(wanted.ratios) {
        assert!((1200.0 * (ratio / wanted).log2()).abs() < 1.1, "{ratio}");
    }
    // What is not like it at all is found as if from nothing.
    let far = retune_bar(&last, &vibraphone_stock(89), &material, COARSE, &tuning(89)).unwrap();
    let cold = tune_bar(&vibraphone_stock(89), &material, COARSE, &tuning(89)).unwrap();
    assert!((far.bar.length_m / cold.bar.length_m - 1.0).abs() < 1e-3);
}

/// F6's neighbours are cut from stock that only just has their partials.
#[test]
fn the_highest_bars_can_be_turned_a_little_either_way() {
    let fineness = BarFineness {
        max_element_m: 0.007,
        across: 3,
        through: 2,
    };
    for key in [77, 87] {
        for times in [0.985, 1.005, 1.015] {
            let tuning = BarTuning {
                pitch_hz: times * equal_temperament_hz(key, 440.0),
                ratios: vibraphone_ratios(key),
                tolerance_cents: 1.0,
            };
            let tuned = tune_bar(&vibraphone_stock(key), &aluminium(), fineness, &tuning);
            assert!(tuned.is_ok(), "{key}, {times}: {tuned:?}");
        }
    }
}

/// Beams tell little of bars that are thick beside their length or hollowed deeply.
#[test]
fn bars_that_are_no_beams_are_found_near_where_beams_lead() {
    for (key, thicker, undercut) in [(78, 1.5, 0.0), (72, 2.0, 0.0), (78, 1.0, 1.0)] {
        let own = vibraphone_stock(key);
        let stock = BarStock {
            length_m: f64::sqrt(thicker) * own.length_m,
            thickness_m: thicker * own.thickness_m,
            ..own
        };
        let tuning = BarTuning {
            pitch_hz: equal_temperament_hz(key, 440.0),
            ratios: stretched(vibraphone_ratios(key), undercut),
            tolerance_cents: 1.0,
        };
        let fineness = BarFineness {
            max_element_m: 0.007,
            across: 3,
            through: 2,
        };
        let tuned = tune_bar(&stock, &aluminium(), fineness, &tuning).unwrap();
        let hz = bar_partials(&tuned.bar, &aluminium(), fineness)
            .unwrap()
            .bending_hz;
        for (hz, ratio) in hz
            .into_iter()
            .zip([1.0, tuning.ratios[0], tuning.ratios[1]])
        {
            let cents = 1200.0 * (hz / (ratio * tuning.pitch_hz)).log2();
            assert!(cents.abs() < 1.1, "{key}: {cents}");
        }
        let shorter = tuned.bar.length_m / stock.length_m;
        assert!((0.8..1.0).contains(&shorter), "{key}: {shorter}");
        // The next is found from it.
        let tuning = BarTuning {
            pitch_hz: 1.01 * tuning.pitch_hz,
            ..tuning
        };
        let next = retune_bar(&tuned, &stock, &aluminium(), fineness, &tuning).unwrap();
        let moved = next.bar.length_m / tuned.bar.length_m;
        assert!((moved - 1.0).abs() < 0.03, "{key}: {moved}");
    }
}
