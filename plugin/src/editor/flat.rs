//! Bodies that lie flat: where they end, and convex pieces of them.

use super::outline::turn;
use egui::Pos2;
use modes::{Body, Surface};
use std::collections::{HashMap, HashSet};

/// Whether it is struck from one side only.
pub(super) fn is_flat(body: &Body) -> bool {
    let normals = &body.line.normals;
    normals.first().is_some_and(|first| {
        let along = |other: &[f64; 3]| (0..3).map(|k| first[k] * other[k]).sum::<f64>();
        first[2] > 0.999 && normals.iter().all(|other| along(other) > 0.999)
    })
}

/// The way around the triangles that are seen from above at `points`, clockwise on a screen, without the points
/// on straight parts of it; none if there is not just one.
pub(super) fn boundary(surface: &Surface, points: &[Pos2]) -> Option<Vec<Pos2>> {
    let mut next: HashMap<u32, u32> = HashMap::new();
    let seen = |t: &&[u32; 3]| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        turn(a, b, c) < 0.0
    };
    let welded = weld(points);
    let mut inner = HashSet::new();
    let edges = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| welded[i as usize]);
        [[a, b], [b, c], [c, a]].into_iter().filter(|[a, b]| a != b)
    };
    for [a, b] in surface.triangles.iter().filter(seen).flat_map(edges) {
        inner.insert([a, b]);
    }
    for [a, b] in &inner {
        if !inner.contains(&[*b, *a]) && next.insert(*a, *b).is_some() {
            return None;
        }
    }
    let first = *next.keys().min()?;
    let mut way = vec![first];
    let mut at = *next.get(&first)?;
    while at != first && way.len() <= next.len() {
        way.push(at);
        at = *next.get(&at)?;
    }
    if way.len() != next.len() {
        return None;
    }
    // Counter-clockwise from above is counter-clockwise on the screen too.
    let way: Vec<Pos2> = way.iter().rev().map(|i| points[*i as usize]).collect();
    let n = way.len();
    let bends = |i: &usize| turn(way[(i + n - 1) % n], way[*i], way[(i + 1) % n]).abs() > 1e-6;
    let corners: Vec<Pos2> = (0..n).filter(bends).map(|i| way[i]).collect();
    (corners.len() > 2).then_some(corners)
}

/// For each point the first that lies where it does: the seam of a round surface is no edge.
fn weld(points: &[Pos2]) -> Vec<u32> {
    let mut known = HashMap::new();
    let place = |p: &Pos2| ((p.x * 1e4).round() as i32, (p.y * 1e4).round() as i32);
    (0..)
        .zip(points)
        .map(|(i, point)| *known.entry(place(point)).or_insert(i))
        .collect()
}

/// Convex pieces of a polygon that goes clockwise on a screen, as numbers of corners: itself, or else its ears
/// (Meisters 1975).
pub(super) fn pieces(corners: &[Pos2]) -> Vec<Vec<usize>> {
    let mut left: Vec<usize> = (0..corners.len()).collect();
    let mut pieces = Vec::new();
    while left.len() > 3 && !is_convex(corners, &left) {
        let n = left.len();
        let ear = (0..n).find(|&i| is_ear(corners, &left, i));
        // A way that crosses itself has none.
        let i = ear.unwrap_or(0);
        pieces.push(vec![left[(i + n - 1) % n], left[i], left[(i + 1) % n]]);
        left.remove(i);
    }
    pieces.push(left);
    pieces
}

fn around(left: &[usize], i: usize) -> [usize; 3] {
    let n = left.len();
    [left[(i + n - 1) % n], left[i], left[(i + 1) % n]]
}

fn is_convex(corners: &[Pos2], left: &[usize]) -> bool {
    (0..left.len()).all(|i| {
        let [a, b, c] = around(left, i).map(|k| corners[k]);
        turn(a, b, c) >= 0.0
    })
}

fn is_ear(corners: &[Pos2], left: &[usize], i: usize) -> bool {
    let tip = around(left, i);
    let [a, b, c] = tip.map(|k| corners[k]);
    let inside = |p: Pos2| turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
    turn(a, b, c) > 0.0 && left.iter().all(|k| tip.contains(k) || !inside(corners[*k]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::editor::outline::Outlines;
    use crate::factory;
    use egui::{Rect, pos2, vec2};

    fn area(corners: &[Pos2]) -> f32 {
        let rest = corners.windows(2).skip(1);
        0.5 * rest.map(|w| turn(corners[0], w[0], w[1])).sum::<f32>()
    }

    #[test]
    fn an_l_is_covered_by_convex_pieces() {
        let l =
            [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)].map(|(x, y)| pos2(x as f32, y as f32));
        let pieces = pieces(&l);
        let all: f32 = pieces
            .iter()
            .map(|piece| {
                assert!(is_convex(&l, piece), "{piece:?}");
                area(&piece.iter().map(|k| l[*k]).collect::<Vec<_>>())
            })
            .sum();
        assert_eq!(all, 3.0);
    }

    #[test]
    fn outlines_of_flat_instruments_are_their_own() {
        let rect = Rect::from_min_size(Pos2::ZERO, vec2(1.0, 1.0));
        let share = |name: &str| {
            let index = factory::BANKS.iter().position(|(other, _)| *other == name);
            let body = &factory::bank(index.unwrap()).bodies[0];
            let outline = Outlines::default().of(body).unwrap();
            let pieces = outline.pieces(rect);
            let share: f32 = pieces.map(|piece| area(&piece)).sum();
            (share, outline.is_slender())
        };
        let (l, _) = share("l-drums");
        assert!((l - 0.75).abs() < 1e-3, "three squares of four: {l}");
        let (square, _) = share("square-drums");
        assert!((square - 1.0).abs() < 1e-3, "{square}");
        let (round, _) = share("round-drums");
        let circle = std::f32::consts::FRAC_PI_4;
        assert!((round - circle).abs() < 0.02, "{round}");
        for name in ["strings", "tines", "free-bars", "clamped-bars"] {
            let (bar, slender) = share(name);
            assert!((bar - 1.0).abs() < 1e-3 && slender, "{name}: {bar}");
        }
    }
}
