//! Nested dissection: a fill-reducing order of elimination for large meshes.
//!
//! George 1973; separators are level sets of a breadth-first search, made thinner by moving vertices
//! across (Ashcraft & Liu 1997), and small pieces are left to minimum degree.

use super::graph::Graph;
use std::collections::BinaryHeap;

/// Pieces no larger than this are not cut.
const PIECE: usize = 60;

/// Share of a piece that each side of a first cut must have, and what refinement must leave it.
const FIRST_SHARE: f64 = 0.2;
const SHARE: f64 = 0.3;

/// Moves without gain before a refinement gives up.
const PATIENCE: usize = 300;

/// The vertices of `graph` in the order of elimination; `order_piece` orders a graph that is not cut
/// further.
pub(super) fn nested_dissection(
    graph: Graph,
    order_piece: &impl Fn(&Graph) -> Vec<u32>,
) -> Vec<u32> {
    if graph.len() <= PIECE {
        return order_piece(&graph);
    }
    let sides = Cut::new(&graph).sides;
    let pick = |side: Side| -> Vec<u32> {
        (0u32..)
            .zip(&sides)
            .filter(|&(_, &s)| s == side)
            .map(|(v, _)| v)
            .collect()
    };
    let mut number = vec![u32::MAX; graph.len()];
    let parts = [Side::Left, Side::Right].map(|side| {
        let vertices = pick(side);
        let part = graph.induced(&vertices, &mut number);
        (vertices, part)
    });
    let separator = pick(Side::Separator);
    drop(graph);
    let mut order = Vec::with_capacity(sides.len());
    for (vertices, part) in parts {
        let inner = nested_dissection(part, order_piece);
        order.extend(inner.into_iter().map(|v| vertices[v as usize]));
    }
    order.extend(separator);
    order
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Left,
    Right,
    Separator,
}

/// A graph in two parts that do not touch, and what is between them.
struct Cut<'a> {
    graph: &'a Graph,
    sides: Vec<Side>,
    left: usize,
    right: usize,
}

impl<'a> Cut<'a> {
    fn new(graph: &'a Graph) -> Self {
        let levels = levels(graph);
        let reached: usize = levels.iter().map(Vec::len).sum();
        let mut cut = Self {
            graph,
            sides: vec![Side::Right; graph.len()],
            left: 0,
            right: graph.len(),
        };
        let least = (FIRST_SHARE * reached as f64).ceil();
        let mut before = 0;
        let mut best: Option<(usize, usize)> = None;
        for (at, level) in levels.iter().enumerate() {
            let after = reached - before - level.len();
            if before.min(after) as f64 >= least && best.is_none_or(|(size, _)| level.len() < size)
            {
                best = Some((level.len(), at));
            }
            before += level.len();
        }
        // Parts that do not touch at all need no separator; a knot without thin levels stays whole.
        let middle = if reached < graph.len() {
            levels.len()
        } else {
            best.map_or(levels.len() / 2, |(_, at)| at)
        };
        for (at, level) in levels.iter().enumerate() {
            for &v in level {
                if at < middle {
                    cut.place(v as usize, Side::Left);
                } else if at == middle {
                    cut.place(v as usize, Side::Separator);
                }
            }
        }
        if reached == graph.len() {
            while cut.refine() {}
        }
        cut
    }

    fn place(&mut self, v: usize, side: Side) {
        match self.sides[v] {
            Side::Left => self.left -= 1,
            Side::Right => self.right -= 1,
            Side::Separator => {}
        }
        match side {
            Side::Left => self.left += 1,
            Side::Right => self.right += 1,
            Side::Separator => {}
        }
        self.sides[v] = side;
    }

    /// Neighbours of `v` on `side`.
    fn on(&self, v: usize, side: Side) -> usize {
        let neighbours = self.graph.neighbours(v).iter();
        neighbours
            .filter(|&&u| self.sides[u as usize] == side)
            .count()
    }

    fn separator(&self) -> usize {
        self.graph.len() - self.left - self.right
    }

    /// What a cut costs: its separator, and a little for uneven sides.
    fn cost(&self) -> f64 {
        let uneven = self.left.abs_diff(self.right) as f64 / self.graph.len() as f64;
        self.separator() as f64 * (1.0 + 0.5 * uneven)
    }

    /// One pass of Fiduccia & Mattheyses 1982 on a vertex separator: each vertex leaves it at most
    /// once, best first, and what did no good is undone. Whether the cut got cheaper.
    fn refine(&mut self) -> bool {
        let start = self.cost();
        let mut best = start;
        let mut heap = BinaryHeap::new();
        let mut moved = vec![false; self.graph.len()];
        for v in 0..self.graph.len() {
            if self.sides[v] == Side::Separator {
                self.offer(&mut heap, v);
            }
        }
        // Vertices and where they were.
        let mut journal: Vec<(usize, Side)> = Vec::new();
        let (mut good, mut idle) = (0, 0);
        while let Some((gain, _, v, left)) = heap.pop() {
            let (to, from) = if left {
                (Side::Left, Side::Right)
            } else {
                (Side::Right, Side::Left)
            };
            if moved[v] || self.sides[v] != Side::Separator {
                continue;
            }
            let now = 1 - self.on(v, from).cast_signed();
            if now != gain {
                heap.push((now, usize::MAX - v, v, left));
                continue;
            }
            let shrinking = if left { self.right } else { self.left };
            let pulled = (1 - now).cast_unsigned();
            if (shrinking as f64) < SHARE * self.graph.len() as f64 + pulled as f64 {
                continue;
            }
            moved[v] = true;
            journal.push((v, Side::Separator));
            self.place(v, to);
            for &u in self.graph.neighbours(v) {
                let u = u as usize;
                if self.sides[u] == from {
                    journal.push((u, from));
                    self.place(u, Side::Separator);
                    if !moved[u] {
                        self.offer(&mut heap, u);
                    }
                }
            }
            for &u in self.graph.neighbours(v) {
                if self.sides[u as usize] == Side::Separator && !moved[u as usize] {
                    self.offer(&mut heap, u as usize);
                }
            }
            idle += 1;
            if self.cost() < best {
                (best, good, idle) = (self.cost(), journal.len(), 0);
            } else if idle > PATIENCE {
                break;
            }
        }
        for (v, side) in journal.drain(good..).rev() {
            self.place(v, side);
        }
        best < start
    }

    fn offer(&self, heap: &mut BinaryHeap<(isize, usize, usize, bool)>, v: usize) {
        for (left, from) in [(true, Side::Right), (false, Side::Left)] {
            let gain = 1 - self.on(v, from).cast_signed();
            heap.push((gain, usize::MAX - v, v, left));
        }
    }
}

/// Level sets of the breadth-first search from a vertex that is far from others.
fn levels(graph: &Graph) -> Vec<Vec<u32>> {
    let mut best = search(graph, 0);
    loop {
        let far = best.last().and_then(|level| {
            let degree = |&v: &u32| graph.neighbours(v as usize).len();
            level.iter().copied().min_by_key(degree)
        });
        let next = search(graph, far.unwrap_or(0));
        if next.len() <= best.len() {
            return best;
        }
        best = next;
    }
}

fn search(graph: &Graph, from: u32) -> Vec<Vec<u32>> {
    let mut seen = vec![false; graph.len()];
    seen[from as usize] = true;
    let mut levels = vec![vec![from]];
    while let Some(last) = levels.last() {
        let mut next = Vec::new();
        for &v in last {
            for &u in graph.neighbours(v as usize) {
                if !seen[u as usize] {
                    seen[u as usize] = true;
                    next.push(u);
                }
            }
        }
        if next.is_empty() {
            break;
        }
        levels.push(next);
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::super::graph::compressed;
    use super::*;
    use crate::fem::Pattern;

    /// A strip of squares with their diagonals.
    fn strip(width: u32, length: u32) -> Graph {
        let columns: Vec<Vec<u32>> = (0..width * length)
            .map(|v| {
                let (x, y) = (v % width, v / width);
                let mut rows = vec![v];
                if x + 1 < width {
                    rows.push(v + 1);
                }
                if y + 1 < length {
                    rows.extend(
                        (x.saturating_sub(1)..=(x + 1).min(width - 1)).map(|x| (y + 1) * width + x),
                    );
                }
                rows
            })
            .collect();
        compressed(&Pattern::from_columns(&columns)).0
    }

    #[test]
    fn a_strip_is_cut_across() {
        let graph = strip(20, 90);
        let cut = Cut::new(&graph);
        assert_eq!(cut.separator(), 20);
        for v in 0..graph.len() {
            if cut.sides[v] == Side::Left {
                assert_eq!(cut.on(v, Side::Right), 0);
            }
        }
        let least = SHARE * graph.len() as f64;
        assert!(cut.left as f64 >= least && cut.right as f64 >= least);
    }

    #[test]
    fn every_vertex_is_eliminated_once() {
        let plain = |piece: &Graph| (0..u32::try_from(piece.len()).unwrap()).collect();
        for graph in [strip(1, 1), strip(3, 30), strip(40, 40)] {
            let n = graph.len();
            let mut order = nested_dissection(graph, &plain);
            order.sort_unstable();
            assert!(order.into_iter().eq(0..u32::try_from(n).unwrap()));
        }
    }

    /// Uncoupled unknowns have no levels to cut at.
    #[test]
    fn pieces_that_do_not_touch_need_no_separator() {
        let columns: Vec<_> = (0..200).map(|v| vec![v]).collect();
        let graph = compressed(&Pattern::from_columns(&columns)).0;
        assert_eq!(Cut::new(&graph).separator(), 0);
    }
}
