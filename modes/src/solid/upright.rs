//! Which way up a mesh most likely is.

use super::Soup;
use crate::Up;

/// How near to the floor its lowest point is, and to the middle of the floor its own, over its longest side.
const ON_FLOOR: f64 = 0.02;
const IN_MIDDLE: f64 = 0.25;

/// The axis along which a mesh stands on the floor, as things are mostly modelled: from 0 upwards, the
/// other two about their middle. None if that is true of no axis or of several.
#[must_use]
pub fn upright(soup: &Soup) -> Option<Up> {
    let ends = [0, 1, 2].map(|axis| {
        let corners = soup.triangles.iter().flatten();
        let at = |i: &u32| soup.points.get(*i as usize).map(|point| point[axis]);
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        corners
            .filter_map(at)
            .fold(start, |[low, high], x| [low.min(x), high.max(x)])
    });
    let longest = ends
        .iter()
        .fold(0.0, |most: f64, [low, high]| most.max(high - low));
    let stands = |axis: usize| ends[axis][0].abs() <= ON_FLOOR * longest;
    let centred = |axis: usize| {
        let [low, high] = ends[axis];
        (low + high).abs() <= 2.0 * IN_MIDDLE * (high - low)
    };
    let mut found = Up::ALL
        .into_iter()
        .zip(0..3)
        .filter(|(_, axis)| stands(*axis) && centred((axis + 1) % 3) && centred((axis + 2) % 3));
    match (found.next(), found.next()) {
        (Some((up, _)), None) => Some(up),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::gallery::{cuboid, cylinder};
    use super::upright;
    use crate::Up;

    /// A drum on the floor, its axis the one of that number.
    fn drum(axis: usize) -> crate::solid::Soup {
        let mut drum = cylinder(0.2, 0.3, 24);
        let low = drum
            .points
            .iter()
            .map(|point| point[2])
            .fold(f64::INFINITY, f64::min);
        for point in &mut drum.points {
            let [x, y, z] = [point[0], point[1], point[2] - low];
            point[axis] = z;
            point[(axis + 1) % 3] = x;
            point[(axis + 2) % 3] = y;
        }
        drum
    }

    #[test]
    fn what_stands_on_the_floor_tells_which_way_is_up() {
        for (axis, up) in Up::ALL.into_iter().enumerate() {
            assert_eq!(upright(&drum(axis)), Some(up));
        }
    }

    #[test]
    fn what_hangs_in_the_middle_or_lies_in_the_corner_does_not() {
        let mut corner = cuboid([1.0; 3]);
        let low = [0, 1, 2].map(|a| {
            let places = corner.points.iter().map(|point| point[a]);
            places.fold(f64::INFINITY, f64::min)
        });
        for point in &mut corner.points {
            *point = [0, 1, 2].map(|a| point[a] - low[a]);
        }
        assert_eq!(upright(&corner), None);
        for point in &mut corner.points {
            *point = point.map(|x| x - 0.5);
        }
        assert_eq!(upright(&corner), None);
    }
}
