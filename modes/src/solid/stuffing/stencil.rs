//! What is left of one tetrahedron of the lattice inside the body.

use super::Corner;
use super::cuts::State;
use crate::solid::lattice::Lattice;

/// Gives `keep` the tetrahedra, positively oriented, that the part of `tet` inside the body is cut
/// into.
pub(super) fn cut_tet(
    tet: [usize; 4],
    lattice: &Lattice,
    state: impl Fn(usize) -> State,
    mut keep: impl FnMut([Corner; 4]),
) {
    let those =
        |wanted: State| -> Vec<usize> { tet.into_iter().filter(|&n| state(n) == wanted).collect() };
    let [inner, on, outer] = [State::Inside, State::On, State::Outside].map(those);
    // An even permutation keeps the orientation; an odd one is made up for at the end.
    let sorted: Vec<usize> = [&inner[..], &on, &outer].concat();
    let odd = is_odd(tet, &sorted);
    let mut keep = |mut corners: [Corner; 4]| {
        if odd {
            corners.swap(2, 3);
        }
        keep(corners);
    };
    let point = Corner::Point;
    let cut = |i: usize, o: usize| Corner::Cut(inner[i], outer[o]);
    let diagonal =
        |i: usize, j: usize, o: usize| starts_at(lattice, inner[i], inner[j], outer[o]) == inner[i];
    match (inner.len(), on.len(), outer.len()) {
        (_, _, 0) => keep([0, 1, 2, 3].map(|i| point(sorted[i]))),
        (1, 2, 1) => keep([point(inner[0]), point(on[0]), point(on[1]), cut(0, 0)]),
        (1, 1, 2) => keep([point(inner[0]), point(on[0]), cut(0, 0), cut(0, 1)]),
        (1, 0, 3) => keep([point(inner[0]), cut(0, 0), cut(0, 1), cut(0, 2)]),
        (2, 1, 1) => {
            let [p, q, apex] = [point(inner[0]), point(inner[1]), point(on[0])];
            let [p_cut, q_cut] = [cut(0, 0), cut(1, 0)];
            if diagonal(0, 1, 0) {
                keep([p, q, apex, q_cut]);
                keep([p, q_cut, apex, p_cut]);
            } else {
                keep([p, q, apex, p_cut]);
                keep([q, q_cut, apex, p_cut]);
            }
        }
        (3, 0, 1) => wedge(
            [0, 1, 2].map(|i| point(inner[i])),
            [0, 1, 2].map(|i| cut(i, 0)),
            [diagonal(0, 1, 0), diagonal(1, 2, 0), diagonal(2, 0, 0)],
            &mut keep,
        ),
        (2, 0, 2) => {
            let (first, second) = (diagonal(0, 1, 0), diagonal(1, 0, 1));
            wedge(
                [point(inner[0]), cut(0, 0), cut(0, 1)],
                [point(inner[1]), cut(1, 0), cut(1, 1)],
                // The side that no neighbour shares must not complete a circle.
                [first, !first, second],
                &mut keep,
            );
        }
        _ => {}
    }
}

/// Whether `sorted` is an odd permutation of `tet`.
fn is_odd(tet: [usize; 4], sorted: &[usize]) -> bool {
    let place = |n: usize| sorted.iter().position(|&m| m == n);
    let places = tet.map(place);
    let swaps = (0..4).flat_map(|i| (0..i).map(move |j| (i, j)));
    swaps.filter(|&(i, j)| places[i] < places[j]).count() % 2 == 1
}

/// The inner end of the diagonal of the quadrilateral that is left of a face with two inner points
/// and an outer: it goes to the cut of the long edge if that is cut; of two short ones parity
/// decides (Labelle & Shewchuk 2007, §3.2).
fn starts_at(lattice: &Lattice, p: usize, q: usize, outer: usize) -> usize {
    match (p % 2 == outer % 2, q % 2 == outer % 2) {
        (true, false) => q,
        (false, true) => p,
        _ => {
            let even = |n: usize| lattice.half(n).iter().sum::<i64>().div_euclid(2) % 2 == 0;
            match (even(p), even(q)) {
                (true, false) => p,
                (false, true) => q,
                _ => p.min(q),
            }
        }
    }
}

/// Cuts a wedge in three; `down[i]` says that the diagonal of the side from `top[i]` to `top[i + 1]`
/// goes from `top[i]` to `bottom[i + 1]` and not from `top[i + 1]` to `bottom[i]`.
pub(in crate::solid) fn wedge<T: Copy>(
    top: [T; 3],
    bottom: [T; 3],
    down: [bool; 3],
    keep: &mut impl FnMut([T; 4]),
) {
    // Diagonals that do not go round in a circle meet at some corner of the top.
    let Some(i) = (0..3).find(|&i| down[i] && !down[(i + 2) % 3]) else {
        return;
    };
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    keep([top[i], bottom[j], bottom[k], bottom[i]]);
    if down[j] {
        keep([top[i], top[j], bottom[k], bottom[j]]);
        keep([top[i], top[j], top[k], bottom[k]]);
    } else {
        keep([top[i], top[k], bottom[k], bottom[j]]);
        keep([top[i], top[j], top[k], bottom[j]]);
    }
}
