//! Maps of bodies against sums by hand and the symmetries of a square.

use super::{BodyMap, Hearing};
use crate::analytic::{ClosedMode, RectangularMembrane};
use crate::{Body, Family, Member, Mode, ModeLabel, StrikeLine};

const EVEN: Hearing = Hearing {
    sensitivity: |_| 1.0,
    range_db: 60.0,
};

/// A body in the plane z = 0 that is struck on `rows` × `columns` points of the unit square; `motion` gives
/// what a mode does at a place.
fn body(
    hz: &[f64],
    [rows, columns]: [usize; 2],
    motion: impl Fn(usize, [f64; 2]) -> [f32; 3],
) -> Body {
    let place = |i: usize| {
        let [row, column] = [i / columns, i % columns].map(|x| x as f64);
        [
            column / (columns - 1) as f64,
            row / (rows - 1).max(1) as f64,
        ]
    };
    let points = 0..rows * columns;
    let mode = |number: usize| Mode {
        hz: hz[number],
        coupling: 0.0,
        ears: [[0.0; 2]; 2],
        pipe_ears: [[0.0; 2]; 2],
        radiation_per_s: 0.0,
        support_per_s: 0.0,
        felt_per_s: 0.0,
        pipe_per_s: 0.0,
        residual: 0.0,
        label: ModeLabel {
            family: Family::Membrane,
            order: 1,
            index: number as u16,
            member: Member::Single,
        },
        shape: points.clone().map(|i| motion(number, place(i))).collect(),
    };
    Body {
        key: 60,
        pitch_hz: hz[0],
        length_m: 1.0,
        mass_kg: 1.0,
        matter: None,
        line: StrikeLine {
            points_m: points
                .clone()
                .map(|i| [place(i)[0], place(i)[1], 0.0])
                .collect(),
            normals: points.clone().map(|_| [0.0, 0.0, 1.0]).collect(),
            rows,
            closed: false,
        },
        surface: None,
        modes: (0..hz.len()).map(mode).collect(),
    }
}

/// Half-waves of all sorts along and across, with some motion along the surface that no strike excites.
fn wavy(hz: &[f64]) -> Body {
    body(hz, [5, 24], |mode, [along, across]| {
        let turn = (1 + mode) as f64 * (along + 0.3);
        let out = turn.cos() + 0.4 * (across * turn).sin();
        [0.5, -1.0, out as f32]
    })
}

/// The sum of the paper, term by term; a tone is the modes of one frequency.
fn by_hand_db(hearing: &Hearing, body: &Body, places: [[f64; 2]; 2]) -> f64 {
    let [one, other] = places.map(|place| {
        let motions = body
            .modes
            .iter()
            .map(|mode| mode.shape.normal_motion(&body.line, place));
        let energies: Vec<f64> = motions.map(|motion| motion * motion).collect();
        let whole: f64 = energies.iter().sum();
        energies
            .iter()
            .map(|energy| energy / whole)
            .collect::<Vec<f64>>()
    });
    let least = 10f64.powf(-0.1 * hearing.range_db);
    let heard = |share: f64| (10.0 * (share / least).log10()).max(0.0);
    let mut square = 0.0;
    for (i, mode) in body.modes.iter().enumerate() {
        square += (hearing.sensitivity)(mode.hz) * (heard(one[i]) - heard(other[i])).powi(2);
    }
    square.sqrt()
}

#[test]
fn distances_are_the_paper_s_sum() {
    let hz: Vec<f64> = (1..=12).map(|n| 170.0 * f64::from(n)).collect();
    let body = wavy(&hz);
    let places: Vec<[f64; 2]> = (0..40)
        .map(|i| [f64::from(i % 8) / 7.3, f64::from(i / 8) / 4.1])
        .collect();
    for hearing in [EVEN, Hearing::HUMAN] {
        let map = BodyMap::new(&hearing, &body, &places);
        for from in [[0.03, 0.0], [0.5, 0.7], [1.0, 1.0]] {
            for (to, found) in places.iter().zip(map.from_place_db(from)) {
                let expected = by_hand_db(&hearing, &body, [from, *to]);
                let found = f64::from(found);
                assert!(
                    (found - expected).abs() < 1e-3 * (1.0 + expected),
                    "{found} {expected}"
                );
                let alone = f64::from(map.distance_db(from, *to));
                assert!(
                    (alone - found).abs() < 1e-4 * (1.0 + found),
                    "{alone} {found}"
                );
            }
        }
    }
}

#[test]
fn a_place_is_at_no_distance_from_itself() {
    let body = wavy(&[200.0, 410.0, 830.0]);
    let places = [[0.2, 0.1], [0.7, 0.9], [0.0, 0.0]];
    let map = BodyMap::new(&Hearing::HUMAN, &body, &places);
    for (number, place) in places.iter().enumerate() {
        let distances_db = map.from_place_db(*place);
        assert_eq!(distances_db[number], 0.0);
        assert!(distances_db.iter().filter(|d| **d > 1.0).count() == 2);
    }
}

/// Two tones that are exchanged differ by so many dB each, whatever the ear makes of them.
#[test]
fn the_unit_is_a_difference_of_1_db_of_all_that_is_heard() {
    let hz = [500.0, 900.0, 1700.0];
    let [quiet, loud] = [0.5, 1.5];
    let body = body(&hz, [1, 6], |mode, [along, _]| {
        let first = loud + (quiet - loud) * along as f32;
        // The third is never heard.
        [0.0, 0.0, [first, loud + quiet - first, 1e-6][mode]]
    });
    let map = BodyMap::new(&Hearing::HUMAN, &body, &[[0.0, 0.0], [1.0, 0.0]]);
    let expected = 20.0 * (loud / quiet).log10();
    let found = map.from_place_db([0.0, 0.0])[1] / map.unit();
    assert!((found - expected).abs() < 1e-4, "{found} {expected}");
}

/// Which of two modes of one pitch is struck nobody hears; of two pitches everybody does.
#[test]
fn modes_of_one_pitch_are_one_tone() {
    let turned = |ratio: f64| {
        let hz = [300.0, 300.0 * ratio, 1000.0];
        let body = body(&hz, [1, 9], |mode, [along, _]| {
            let turn = 1.5 * along as f32;
            [0.0, 0.0, [turn.cos(), turn.sin(), 0.7][mode]]
        });
        BodyMap::new(&Hearing::HUMAN, &body, &[]).distance_db([0.1, 0.0], [0.8, 0.0])
    };
    assert!(turned(1.0) < 1e-2 && turned(1.001) < 1e-2);
    assert!(turned(1.01) > 3.0);
}

/// Along a string's held end lies the timbre of a strike close beside it, not that of rounding errors.
#[test]
fn held_ends_sound_as_what_is_beside_them() {
    let hz: Vec<f64> = (1..=8).map(|n| 110.0 * f64::from(n)).collect();
    let body = body(&hz, [1, 65], |mode, [along, _]| {
        let half_waves = (mode + 1) as f64;
        [
            0.0,
            0.0,
            (std::f64::consts::PI * half_waves * along).sin() as f32,
        ]
    });
    let map = BodyMap::new(&EVEN, &body, &[[0.0, 0.0], [1.0, 0.0]]);
    for end_db in map.from_place_db([0.005, 0.0]) {
        assert!(end_db < 0.1, "{end_db}");
    }
    assert!(map.from_place_db([0.5, 0.0])[0] > 60.0);
}

#[test]
fn a_body_that_does_not_move_is_not_heard() {
    let still = body(&[100.0], [2, 6], |_, _| [0.0; 3]);
    let map = BodyMap::new(&Hearing::HUMAN, &still, &[[0.5, 0.5]]);
    assert_eq!(
        (map.from_place_db([0.1, 0.0]), map.unit()),
        (vec![0.0], 0.0)
    );
    let nowhere = BodyMap::new(&Hearing::HUMAN, &still, &[]);
    assert!(nowhere.from_place_db([0.0; 2]).is_empty());
}

/// All eight places that the symmetries of a square exchange sound alike, and no others. At the edge, between
/// whose points and the next is interpolated, along and across differ.
#[test]
fn a_square_s_map_has_the_symmetries_of_the_square() {
    let membrane = RectangularMembrane {
        sides_m: [1.0; 2],
        tension_n_m: 1e5,
        mass_kg_m2: 1.0,
    };
    let modes = membrane.modes(1300.0);
    let hz: Vec<f64> = modes.iter().map(ClosedMode::hz).collect();
    let side = 25;
    let body = body(&hz, [side; 2], |mode, at_m| {
        [0.0, 0.0, modes[mode].displacement(at_m) as f32]
    });
    let at = |i: usize| i as f64 / (side - 1) as f64;
    let places: Vec<[f64; 2]> = (0..side * side)
        .map(|i| [at(i % side), at(i / side)])
        .collect();
    let map = BodyMap::new(&Hearing::HUMAN, &body, &places);
    let from = [4, 9];
    let distances_db = map.from_place_db(from.map(at));
    let mut alike = 0;
    for row in 1..side - 1 {
        for column in 1..side - 1 {
            let here_db = distances_db[row * side + column];
            let mirrored = |i: usize| side - 1 - i;
            for [x, y] in [
                [mirrored(column), row],
                [column, mirrored(row)],
                [row, column],
            ] {
                let there_db = distances_db[y * side + x];
                assert!(
                    (here_db - there_db).abs() < 0.02 * map.unit(),
                    "{here_db} {there_db}"
                );
            }
            alike += usize::from(here_db < 0.01 * map.unit());
        }
    }
    assert_eq!(alike, 8);
}
