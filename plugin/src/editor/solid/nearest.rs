//! The nearest of many points, without a look at each.

use super::{Vector, add, dot};

/// Points in their order along the axis on which they are spread the farthest.
#[derive(Clone, Debug, Default)]
pub(super) struct Finder {
    axis: usize,
    /// Their numbers.
    order: Vec<u32>,
}

impl Finder {
    pub(super) fn of(points_m: &[Vector]) -> Self {
        let spread = |axis: usize| {
            let along = points_m.iter().map(|point| point[axis]);
            along.clone().fold(f32::MIN, f32::max) - along.fold(f32::MAX, f32::min)
        };
        let axis = (0..3).max_by(|a, b| spread(*a).total_cmp(&spread(*b)));
        let axis = axis.unwrap_or(0);
        let mut order: Vec<u32> = (0..points_m.len() as u32).collect();
        let at = |number: u32| points_m[number as usize][axis];
        order.sort_unstable_by(|a, b| at(*a).total_cmp(&at(*b)));
        Self { axis, order }
    }

    /// The number of the point that is nearest to `to`, the first of those equally near; none of none. The
    /// points are those that the finder is of.
    pub(super) fn nearest(&self, points_m: &[Vector], to: Vector) -> Option<usize> {
        let aside = |number: &u32| points_m[*number as usize][self.axis] - to[self.axis];
        let middle = self.order.partition_point(|number| aside(number) < 0.0);
        let (below, above) = self.order.split_at(middle);
        let mut best = (f32::INFINITY, u32::MAX);
        // Outwards on either side, as long as the axis alone does not take one farther away than the best.
        let mut look = |side: &mut dyn Iterator<Item = &u32>| {
            for number in side {
                let apart = add(points_m[*number as usize], -1.0, to);
                let found = (dot(apart, apart), *number);
                if aside(number).powi(2) > best.0 {
                    break;
                }
                if found < best {
                    best = found;
                }
            }
        };
        look(&mut above.iter());
        look(&mut below.iter().rev());
        (best.0 < f32::INFINITY).then_some(best.1 as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against a look at each, from places on and off the points, some of which are twice there.
    #[test]
    fn it_finds_what_a_look_at_each_finds() {
        let points_m: Vec<Vector> = (0..400u16)
            .map(|i| {
                let turn = 0.37 * f32::from(i % 350);
                [turn.cos(), 0.02 * turn, (2.3 * turn).sin()]
            })
            .collect();
        let finder = Finder::of(&points_m);
        for i in 0..1000u16 {
            let turn = 0.011 * f32::from(i);
            let to = [1.2 * turn.sin(), 0.03 * turn - 0.4, (1.9 * turn).cos()];
            let away = |number: &usize| {
                let apart = add(points_m[*number], -1.0, to);
                dot(apart, apart)
            };
            let each = (0..400).min_by(|a, b| away(a).total_cmp(&away(b)));
            assert_eq!(finder.nearest(&points_m, to), each, "{to:?}");
        }
        for (number, point) in points_m.iter().enumerate().take(350) {
            assert_eq!(finder.nearest(&points_m, *point), Some(number));
        }
        assert_eq!(Finder::of(&[]).nearest(&[], [0.0; 3]), None);
    }
}
