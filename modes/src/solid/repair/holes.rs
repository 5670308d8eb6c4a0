//! Small holes closed, large ones refused.

use super::super::obj::cut_polygon;
use super::super::vector::{doubled_area, norm};
use super::edges::Edges;
use super::{MeshError, Note, Work};
use std::collections::HashMap;

/// The largest share of the surface that a hole may have and be closed.
const LARGEST: f64 = 0.25;

/// The largest share that all of them may have together: a pipe open at both ends has less.
const LARGEST_SUM: f64 = 0.5;

/// A share below which a hole is a crack, closed without a word.
const CRACK: f64 = 1e-9;

pub(super) fn close(work: &mut Work) -> Result<(), MeshError> {
    let rims = rims(work);
    if rims.is_empty() {
        return Ok(());
    }
    let surface = work.area();
    let (holes, mut closed) = (rims.len(), 0.0);
    let mut notes = Vec::new();
    for rim in rims {
        let lids = cut_polygon(&rim, &work.points);
        let area: f64 = lids
            .iter()
            .map(|t| 0.5 * norm(doubled_area(work.corners(t))))
            .sum();
        let share = area / (surface + area);
        let (edges, near) = (rim.len(), work.points[rim[0] as usize]);
        if share > LARGEST {
            return Err(MeshError::Open { edges, share, near });
        }
        closed += area;
        if share > CRACK {
            notes.push(Note::HoleClosed { edges, share, near });
        }
        work.triangles.extend(lids);
    }
    let share = closed / (surface + closed);
    if share > LARGEST_SUM {
        return Err(MeshError::Torn { holes, share });
    }
    work.notes.append(&mut notes);
    Ok(())
}

/// The rims of the holes, the way round that a lid goes.
fn rims(work: &Work) -> Vec<Vec<u32>> {
    // A side that its neighbours leave open is closed by one that goes the other way.
    let mut next: HashMap<u32, Vec<u32>> = HashMap::new();
    let mut starts = Vec::new();
    for sides in Edges::of(&work.triangles).iter() {
        let up = sides.iter().filter(|side| side.up).count();
        let down = sides.len() - up;
        let [low, high] = sides[0].edge;
        let (from, to) = if up > down { (high, low) } else { (low, high) };
        for _ in 0..up.abs_diff(down) {
            next.entry(from).or_default().push(to);
            starts.push(from);
        }
    }
    let mut rims = Vec::new();
    for start in starts {
        let mut path = vec![start];
        let mut place: HashMap<u32, usize> = HashMap::from([(start, 0)]);
        while let Some(to) = path.last().and_then(|end| next.get_mut(end)?.pop()) {
            match place.get(&to) {
                // The path closes on itself: that part is a rim, the rest goes on.
                Some(&from) => {
                    let mut rim = vec![to];
                    rim.extend(path.drain(from + 1..));
                    for gone in &rim[1..] {
                        place.remove(gone);
                    }
                    rims.push(rim);
                }
                None => {
                    place.insert(to, path.len());
                    path.push(to);
                }
            }
        }
    }
    rims.retain(|rim| rim.len() > 2);
    rims
}
