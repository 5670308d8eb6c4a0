//! Which triangles of a sheet's surface are its one wall, its other wall and its rims.

use super::facing::Facing;
use crate::solid::ClosedSurface;
use crate::solid::features::Features;
use crate::solid::repair::edges::Edges;
use crate::solid::vector::{doubled_area, norm};

/// A way farther than so many times the middle one is not through the sheet.
const FAR: f64 = 5.0;

/// The share of the surface that rims and bends may take.
const BARE: f64 = 0.2;

/// Shares of the sheet that may be thinner and thicker than what is told.
const TOLD: [f64; 2] = [0.02, 0.98];

/// What a triangle is part of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    /// A wall, by its number.
    Wall(usize),
    /// A rim between both.
    Rim,
}

/// The smooth parts of a sheet's surface, those of the wall that is to be made anew first.
pub(super) struct Sides {
    /// The smooth part of each triangle: those of the outer wall, one for all of the inner wall, one for each rim.
    patch: Vec<u32>,
    /// The number of the inner wall; rims have greater ones, parts of the outer wall lesser ones.
    inner: u32,
    /// The thickness in the middle, in m, half of the sheet being thinner.
    pub(super) middle_m: f64,
    /// The least and the greatest thickness, in m.
    pub(super) thickness_m: [f64; 2],
}

impl Sides {
    /// Of walls whose outward normals have a cosine below `opposite`. `None` where the surface does not consist of two walls and little else.
    pub(super) fn of(
        surface: &ClosedSurface,
        sharp: &Features,
        facing: &[Option<Facing>],
        opposite: f64,
    ) -> Option<Self> {
        let areas: Vec<f64> = (0..surface.triangles.len())
            .map(|t| 0.5 * norm(doubled_area(surface.corners_m(t))))
            .collect();
        let facing: Vec<Option<Facing>> = facing
            .iter()
            .map(|facing| facing.filter(|facing| facing.cosine < opposite))
            .collect();
        let middle_m = quantile(&facing, &areas, 0.5)?;
        let limit_m = FAR * middle_m;
        let paired: Vec<Option<Facing>> = facing
            .iter()
            .map(|facing| facing.filter(|facing| facing.way_m < limit_m))
            .collect();
        let whole: f64 = areas.iter().sum();
        let bare = paired
            .iter()
            .zip(&areas)
            .filter(|(facing, _)| facing.is_none());
        if bare.map(|(_, area)| area).sum::<f64>() > BARE * whole {
            return None;
        }
        let edges = Edges::of(&surface.triangles);
        let regions = regions(&edges, &paired);
        let walls = walls(&regions, &paired)?;
        let parts = parts(&edges, &regions, &walls, &paired);
        let area_of = |wall: usize| {
            let own = parts
                .iter()
                .zip(&areas)
                .filter(|(part, _)| **part == Part::Wall(wall));
            own.map(|(_, area)| area).sum::<f64>()
        };
        let outer = usize::from(area_of(1) > area_of(0));
        if area_of(1 - outer) == 0.0 {
            return None;
        }
        let [least, most] = TOLD;
        Some(Self {
            middle_m,
            thickness_m: [
                quantile(&paired, &areas, least)?,
                quantile(&paired, &areas, most)?,
            ],
            inner: sharp.patch.iter().max()? + 1,
            patch: patch(&edges, sharp, &parts, outer),
        })
    }

    pub(super) fn is_outer(&self, part: u32) -> bool {
        part < self.inner
    }

    pub(super) fn is_inner(&self, part: u32) -> bool {
        part == self.inner
    }

    /// The rim among two smooth parts beside each other, and the line along which it meets the inner wall.
    pub(super) fn rim(&self, pair: [u32; 2]) -> Option<[u32; 2]> {
        let [first, last] = pair;
        (first < self.inner && last > self.inner).then_some([self.inner, last])
    }

    /// The lines between these parts.
    pub(super) fn features(&self, surface: &ClosedSurface) -> Features {
        Features::between(surface, self.patch.clone())
    }
}

/// The way through the sheet that a share of its area falls short of.
fn quantile(facing: &[Option<Facing>], areas: &[f64], share: f64) -> Option<f64> {
    let mut ways: Vec<(f64, f64)> = facing
        .iter()
        .zip(areas)
        .filter_map(|(facing, area)| facing.map(|facing| (facing.way_m, *area)))
        .collect();
    ways.sort_by(|(p, _), (q, _)| p.total_cmp(q));
    let mut left = share * ways.iter().map(|(_, area)| area).sum::<f64>();
    let reached = ways.iter().find(|(_, area)| {
        left -= area;
        left <= 0.0
    });
    reached.map(|(way_m, _)| *way_m)
}

/// Numbers of what hangs together, of triangles that have one behind them or that have none.
fn regions(edges: &Edges, paired: &[Option<Facing>]) -> Vec<u32> {
    connected(edges, paired.len(), |a, b| {
        paired[a].is_some() == paired[b].is_some()
    })
}

/// For each region of paired triangles which of two walls it is of; `None` where one has itself behind it, or
/// there is more than one sheet.
fn walls(regions: &[u32], paired: &[Option<Facing>]) -> Option<Vec<Option<usize>>> {
    let count = regions.iter().max().map_or(0, |most| *most as usize + 1);
    let mut behind: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (region, facing) in regions.iter().zip(paired) {
        let Some(facing) = facing else { continue };
        let other = regions[facing.triangle as usize] as usize;
        if paired[facing.triangle as usize].is_some() {
            behind[*region as usize].push(other);
            behind[other].push(*region as usize);
        }
    }
    let mut walls = vec![None; count];
    let first = behind.iter().position(|others| !others.is_empty())?;
    walls[first] = Some(0);
    let mut stack = vec![first];
    while let Some(at) = stack.pop() {
        let own = walls[at]?;
        for &other in &behind[at] {
            match walls[other] {
                None => {
                    walls[other] = Some(1 - own);
                    stack.push(other);
                }
                Some(wall) if wall == own => return None,
                Some(_) => {}
            }
        }
    }
    let all = (0..count).all(|region| behind[region].is_empty() || walls[region].is_some());
    all.then_some(walls)
}

/// What each triangle is part of: bare ones between two pieces of the same wall are of that wall.
fn parts(
    edges: &Edges,
    regions: &[u32],
    walls: &[Option<usize>],
    paired: &[Option<Facing>],
) -> Vec<Part> {
    let mut beside = vec![[false; 2]; walls.len()];
    for sides in edges.iter() {
        let [a, b] = [sides[0], sides[sides.len() - 1]].map(|side| side.triangle as usize);
        for (own, other) in [(a, b), (b, a)] {
            if let (None, Some(wall)) = (paired[own], walls[regions[other] as usize]) {
                beside[regions[own] as usize][wall] = true;
            }
        }
    }
    let part = |region: &u32| match (walls[*region as usize], beside[*region as usize]) {
        (Some(wall), _) => Part::Wall(wall),
        (None, [true, false]) => Part::Wall(0),
        (None, [false, true]) => Part::Wall(1),
        (None, _) => Part::Rim,
    };
    regions.iter().map(part).collect()
}

/// The smooth part of each triangle.
fn patch(edges: &Edges, sharp: &Features, parts: &[Part], outer: usize) -> Vec<u32> {
    let rims = connected(edges, parts.len(), |a, b| parts[a] == parts[b]);
    let inner = sharp.patch.iter().max().map_or(0, |most| most + 1);
    let all = parts.iter().zip(&sharp.patch).zip(&rims);
    all.map(|((part, &own), &rim)| match part {
        Part::Wall(wall) if *wall == outer => own,
        Part::Wall(_) => inner,
        Part::Rim => inner + 1 + rim,
    })
    .collect()
}

/// Numbers of what hangs together by edges whose two triangles are `alike`.
fn connected(edges: &Edges, triangles: usize, alike: impl Fn(usize, usize) -> bool) -> Vec<u32> {
    let mut parent: Vec<usize> = (0..triangles).collect();
    fn root(parent: &mut [usize], mut at: usize) -> usize {
        while parent[at] != at {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        at
    }
    for sides in edges.iter() {
        for pair in sides.windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|side| side.triangle as usize);
            if alike(a, b) {
                let (a, b) = (root(&mut parent, a), root(&mut parent, b));
                parent[b] = a;
            }
        }
    }
    let mut numbers = vec![u32::MAX; triangles];
    let mut next = 0;
    (0..triangles)
        .map(|t| {
            let number = &mut numbers[root(&mut parent, t)];
            if *number == u32::MAX {
                *number = next;
                next += 1;
            }
            *number
        })
        .collect()
}
