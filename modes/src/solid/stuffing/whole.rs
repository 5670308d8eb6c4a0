//! One body that hangs together by faces.

use super::Tets;
use crate::solid::topology::Faces;
use crate::solid::vector::six_volumes;

/// Keeps the tetrahedra of the largest part joined by faces; returns how many parts there were.
pub(super) fn largest_part(tets: &mut Tets) -> usize {
    let neighbours = Faces::of(&tets.tets).neighbours(tets.tets.len());
    let mut part = vec![usize::MAX; tets.tets.len()];
    let mut volumes: Vec<f64> = Vec::new();
    for start in 0..tets.tets.len() {
        if part[start] != usize::MAX {
            continue;
        }
        let number = volumes.len();
        part[start] = number;
        let (mut stack, mut volume) = (vec![start], 0.0);
        while let Some(at) = stack.pop() {
            volume += six_volumes(tets.tets[at].map(|i| tets.points[i as usize])).abs();
            for &other in neighbours[at].iter().flatten() {
                if part[other as usize] == usize::MAX {
                    part[other as usize] = number;
                    stack.push(other as usize);
                }
            }
        }
        volumes.push(volume);
    }
    let largest = (0..volumes.len()).max_by(|&i, &j| volumes[i].total_cmp(&volumes[j]));
    let mut parts = part.iter();
    tets.tets.retain(|_| parts.next().copied() == largest);
    drop_unused(tets);
    volumes.len()
}

/// Gives each fan of tetrahedra that meets others only in a point its own point: a hinge would be
/// a motion without stiffness.
pub(super) fn unpinch(tets: &mut Tets) {
    let neighbours = Faces::of(&tets.tets).neighbours(tets.tets.len());
    let mut around: Vec<Vec<u32>> = vec![Vec::new(); tets.points.len()];
    for (t, tet) in (0u32..).zip(&tets.tets) {
        for &corner in tet {
            around[corner as usize].push(t);
        }
    }
    for (corner, mut left) in (0u32..).zip(around) {
        let mut first = true;
        while let Some(start) = left.pop() {
            let (mut fan, mut done) = (vec![start], 0);
            while done < fan.len() {
                for other in neighbours[fan[done] as usize].iter().flatten() {
                    if let Some(at) = left.iter().position(|t| t == other) {
                        fan.push(left.swap_remove(at));
                    }
                }
                done += 1;
            }
            if !std::mem::replace(&mut first, false) {
                let twin = tets.points.len() as u32;
                tets.points.push(tets.points[corner as usize]);
                for t in fan {
                    let own = tets.tets[t as usize].iter_mut().find(|c| **c == corner);
                    *own.expect("the fan is of this corner") = twin;
                }
            }
        }
    }
}

/// Renumbers the points without those that nothing uses.
fn drop_unused(tets: &mut Tets) {
    let mut ids = vec![u32::MAX; tets.points.len()];
    let mut points = Vec::new();
    for corner in tets.tets.iter_mut().flatten() {
        let id = &mut ids[*corner as usize];
        if *id == u32::MAX {
            *id = points.len() as u32;
            points.push(tets.points[*corner as usize]);
        }
        *corner = *id;
    }
    tets.points = points;
}
