//! A flat body in a wall whose shapes are products of functions of one coordinate.

use super::grid::Grid;
use super::lowest::Lowest;
use super::outline::{Cells, Outline};
use crate::analytic::{ClosedMode, ProductMode, gauss_kept};
use crate::bank::{Surface as Picture, SurfaceMotion};
use crate::radiation::{SOUND_M_S, Surface, beamed_decay_per_s};
use crate::{ModeShape, ShapeTables, SolvedBody, SolvedMode};
use rayon::prelude::*;
use std::collections::HashMap;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Points by which the sound of a side is summed, beside one for so many radians of the waves on it and
/// in the air together: Gauss's rule then leaves less than a thousandth.
const FEWEST: f64 = 12.0;
const RADIANS: f64 = 4.0;

/// A body by its modes.
pub(super) struct Sheet<'a, M> {
    pub(super) outline: Outline,
    pub(super) mass_kg: f64,
    pub(super) modes: &'a [M],
    /// The points where it is struck, and how many samples its tables have to a step of them.
    pub(super) strike: Grid,
    pub(super) finer: [usize; 2],
    /// Radians of the shortest waves along and across all of it, or around it.
    pub(super) radians: [f64; 2],
    /// Longest patch by which its sound is summed, in m.
    pub(super) longest_m: f64,
    /// Cells of its picture.
    pub(super) drawn: Cells,
}

/// Nodes and weights along or across, the whole being 0…1.
type Rule = Vec<(f64, f64)>;

impl<M: ProductMode + Sync> Sheet<'_, M> {
    /// The body with its picture.
    pub(super) fn lowest(&self) -> Lowest {
        let functions = [0, 1].map(|axis| Functions::new(self.modes, axis));
        Lowest {
            solved: self.solved(&functions),
            picture: self.picture(&functions),
            shapes: Some(self.shapes(&functions)),
        }
    }

    fn shapes(&self, functions: &[Functions<'_, M>; 2]) -> Vec<ModeShape> {
        let line = self.strike.line(self.outline);
        let samples = ShapeTables::samples_of(line.grid(), self.finer);
        let [along, across] = samples.expect("a grid has points");
        let ways =
            |count: usize, steps: usize| (0..count).map(move |i| i as f64 / steps.max(1) as f64);
        let first = ways(along, along - 1).map(|at| self.strike.first(self.outline, at));
        let around = if line.closed { across } else { across - 1 };
        let second = ways(across, around).map(|at| self.strike.second(self.outline, at));
        let values = [
            functions[0].at(&first.collect::<Vec<_>>()),
            functions[1].at(&second.collect::<Vec<_>>()),
        ];
        let tables = ShapeTables::new(line.grid(), self.finer, values.map(|v| v.by_sample()));
        let tables = Arc::new(tables.expect("there are modes"));
        let modes = self.modes.iter().enumerate();
        modes
            .map(|(i, mode)| {
                let which = [0, 1].map(|axis| functions[axis].of_mode[i] as u32);
                ModeShape::product(Arc::clone(&tables), which, mode.height() as f32)
            })
            .collect()
    }

    fn solved(&self, functions: &[Functions<'_, M>; 2]) -> SolvedBody {
        let rules = self.rules();
        let surface = self.surface(&rules);
        let nodes = [0, 1].map(|axis| rules[axis].iter().map(|(at, _)| *at).collect::<Vec<_>>());
        let values = [0, 1].map(|axis| functions[axis].at(&nodes[axis]));
        let felt_m = self.strike.points_m(self.outline)[0];
        let modes = self.modes.par_iter().enumerate().map(|(i, mode)| {
            let [along, across] = [0, 1].map(|axis| values[axis].of(functions[axis].of_mode[i]));
            let height = mode.height();
            let motion: Vec<f32> = across
                .iter()
                .flat_map(|v| along.iter().map(move |u| (height * u * v) as f32))
                .collect();
            SolvedMode {
                hz: mode.hz(),
                residual: 0.0,
                label: mode.label(),
                shape: Vec::new(),
                rectified_area: surface.rectified_area(&motion),
                radiation_per_s: beamed_decay_per_s(mode.hz(), |wave| mode.beamed(wave)),
                motion,
                held: 0.0,
                felt: mode.displacement(felt_m).powi(2),
            }
        });
        SolvedBody {
            length_m: self.outline.length_m(),
            mass_kg: self.mass_kg,
            line: self.strike.line(self.outline),
            modes: modes.collect(),
            surface,
            orthonormality: 0.0,
        }
    }

    /// Where along and across the surface is summed: by Gauss, and around in equal steps, which are exact
    /// for waves of fewer than one to a step.
    fn rules(&self) -> [Rule; 2] {
        let highest_hz = self.modes.last().map_or(0.0, ClosedMode::hz);
        let air_per_m = TAU * highest_hz / SOUND_M_S;
        let spans_m = self.outline.spans_m();
        let longest = self.outline.cells(self.longest_m);
        #[expect(clippy::cast_sign_loss, reason = "radians are not negative")]
        let gauss = |axis: usize| {
            let radians = self.radians[axis] + air_per_m * spans_m[axis];
            let count = (FEWEST + radians / RADIANS) as usize;
            gauss_kept(count.max(longest[axis])).to_vec()
        };
        if let Outline::Disc { radius_m } = self.outline {
            #[expect(clippy::cast_sign_loss, reason = "radians are not negative")]
            let count = (FEWEST + self.radians[1] / TAU + air_per_m * radius_m) as usize;
            let count = count.max(longest[1]);
            let step = |i: usize| ((i as f64 + 0.5) / count as f64, 1.0 / count as f64);
            return [gauss(0), (0..count).map(step).collect()];
        }
        [gauss(0), gauss(1)]
    }

    fn surface(&self, [along, across]: &[Rule; 2]) -> Surface {
        let [x, y] = self.outline.middle_m();
        let mut surface = Surface::default();
        for (v, across) in across {
            for (u, along) in along {
                let (point, area_m2) = self.outline.place([*u, *v]);
                surface.points_m.push([point[0] - x, point[1] - y, 0.0]);
                surface.normals.push([0.0, 0.0, 1.0]);
                surface.areas_m2.push(area_m2 * along * across);
            }
        }
        surface
    }

    fn picture(&self, functions: &[Functions<'_, M>; 2]) -> Picture {
        let shares = self.drawn.map(|cells| {
            let corner = |i: usize| i as f64 / cells as f64;
            (0..=cells).map(corner).collect::<Vec<_>>()
        });
        let values = [0, 1].map(|axis| functions[axis].at(&shares[axis]));
        let modes = self.modes.iter().enumerate().take(Picture::MOST_MODES);
        let motions = modes.map(|(i, mode)| {
            let [along, across] = [0, 1].map(|axis| values[axis].of(functions[axis].of_mode[i]));
            let height = mode.height();
            let points = across.iter().flat_map(|v| {
                let point = move |u: &f64| [0.0, 0.0, (height * u * v) as f32];
                along.iter().map(point)
            });
            SurfaceMotion::of(&points.collect::<Vec<_>>())
        });
        self.outline.picture(self.drawn, motions.collect())
    }
}

/// The functions of one coordinate that modes are made of, in the order in which modes need them.
struct Functions<'a, M> {
    modes: &'a [M],
    axis: usize,
    /// A mode that has it, of each function.
    having: Vec<usize>,
    /// Which function each mode has.
    of_mode: Vec<usize>,
}

/// Values of functions.
struct Values {
    samples: usize,
    /// Of one function after the other.
    all: Vec<f64>,
}

impl<'a, M: ProductMode + Sync> Functions<'a, M> {
    fn new(modes: &'a [M], axis: usize) -> Self {
        let mut known = HashMap::new();
        let mut having = Vec::new();
        let numbers = modes.iter().enumerate().map(|(i, mode)| {
            *known.entry(mode.functions()[axis]).or_insert_with(|| {
                having.push(i);
                having.len() - 1
            })
        });
        let of_mode = numbers.collect();
        Self {
            modes,
            axis,
            having,
            of_mode,
        }
    }

    /// The values where the coordinate is `shares`.
    fn at(&self, shares: &[f64]) -> Values {
        let values = self.having.par_iter().flat_map_iter(|i| {
            let mode = &self.modes[*i];
            let value = |share: &f64| match self.axis {
                0 => mode.along(*share),
                _ => mode.across(*share),
            };
            shares.iter().map(value)
        });
        Values {
            samples: shares.len(),
            all: values.collect(),
        }
    }
}

impl Values {
    fn of(&self, function: usize) -> &[f64] {
        &self.all[function * self.samples..][..self.samples]
    }

    /// Those of all functions at one sample after the other. Adding 0 turns −0 to 0.
    fn by_sample(&self) -> Vec<f32> {
        let functions = self.all.chunks_exact(self.samples);
        (0..self.samples)
            .flat_map(|sample| functions.clone().map(move |own| own[sample] as f32 + 0.0))
            .collect()
    }
}
