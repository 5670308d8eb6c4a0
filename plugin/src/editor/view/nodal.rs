//! Nodal lines: where a mode leaves the surface in its place.

use super::super::solid::{Solid, Vector, add, between, dot};
use super::picture::Segment;

/// Share of the greatest motion below which all of a triangle is taken to rest.
const REST: f32 = 2e-3;

/// The lines on which the motion along the normal changes its sign, on a surface moved by `moved_m`.
///
/// A mode that does not move the surface along its normal anywhere, as torsion of a tube, has none.
pub(super) fn nodal_lines(solid: &Solid, motion: &[Vector], moved_m: &[Vector]) -> Vec<Segment> {
    let out: Vec<f32> = (motion.iter().zip(&solid.normals))
        .map(|(u, normal)| dot(*u, *normal))
        .collect();
    let all = motion
        .iter()
        .fold(0.0f32, |most, u| most.max(dot(*u, *u)))
        .sqrt();
    let most = out.iter().fold(0.0f32, |most, x| most.max(x.abs()));
    if most < 0.05 * all {
        return Vec::new();
    }
    let mut lines = Vec::new();
    for triangle in &solid.triangles {
        let values = triangle.map(|i| out[i as usize]);
        if values.iter().all(|x| x.abs() < REST * most) {
            continue;
        }
        let place = |i: u32| add(solid.points_m[i as usize], 1.0, moved_m[i as usize]);
        let mut ends = Vec::with_capacity(2);
        for k in 0..3 {
            let next = (k + 1) % 3;
            let [a, b] = [values[k], values[next]];
            if (a < 0.0) != (b < 0.0) {
                ends.push(between(
                    place(triangle[k]),
                    place(triangle[next]),
                    a / (a - b),
                ));
            }
        }
        if let [from, to] = ends[..] {
            lines.push([from, to]);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::Partial;
    use crate::factory;
    use modes::Family;

    /// A free bar's first bending mode rests at 22.4 % of its length from each end (Fletcher & Rossing 1998,
    /// §2.15), an arched one's a little farther in; its sides' flat ends have none.
    #[test]
    fn a_bar_rests_where_its_cord_runs() {
        let bank = factory::bank(1);
        let body = &bank.bodies[24];
        let solid = Solid::of(body, &bank.material);
        let partials = Partial::all(body);
        let first = partials
            .iter()
            .position(|p| p.label.family == Family::Bending);
        let motion = solid.motion(first.unwrap());
        let still = vec![[0.0; 3]; motion.len()];
        let lines = nodal_lines(&solid, &motion, &still);
        let on_top = lines.iter().flatten().filter(|point| point[2] > -1e-5);
        let places: Vec<f64> = on_top
            .map(|point| f64::from(point[0].abs()) / body.length_m)
            .collect();
        assert!(places.len() > 8);
        for place in &places {
            let from_the_end = 0.5 - place;
            assert!((0.19..0.26).contains(&from_the_end), "{from_the_end}");
        }
    }

    /// A bowl's mode of two waves has four nodal meridians (Rossing 2000).
    #[test]
    fn a_bowl_s_lowest_mode_has_four_meridians() {
        let bank = factory::bank(3);
        let body = &bank.bodies[12];
        let solid = Solid::of(body, &bank.material);
        let motion = solid.motion(0);
        let still = vec![[0.0; 3]; motion.len()];
        let lines = nodal_lines(&solid, &motion, &still);
        let rim_m = body.line.points_m[0][2] as f32;
        // Around the outside, half-way up the wall.
        let around: Vec<f32> = lines
            .iter()
            .filter(|[a, b]| (a[2] < 0.5 * rim_m) != (b[2] < 0.5 * rim_m))
            .map(|[a, _]| a[1].atan2(a[0]))
            .collect();
        let mut turns: Vec<i32> = around
            .iter()
            .map(|turn| (turn / std::f32::consts::FRAC_PI_2 * 4.0).round() as i32)
            .collect();
        turns.sort_unstable();
        turns.dedup();
        assert_eq!(turns.len(), 4, "{around:?}");
    }
}
