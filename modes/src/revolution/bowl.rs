//! The meridian of a bowl.

use super::Wall;
use crate::Family;
use crate::fem::Meridian;
use crate::shape::{Bowl, ProfileError};

/// Steps in which the profile's arc is measured.
const ARC_STEPS: usize = 2000;

/// The meridian of `bowl`, cells no longer than `max_element_m` and `layers` of them through the wall,
/// its base on z = 0. Position 0 of the strike line is the rim, 1 the middle of the base; the bowl
/// stands on the edge of its base.
///
/// # Errors
///
/// [`ProfileError`] if the profile is not that of a bowl.
pub fn bowl(bowl: &Bowl, max_element_m: f64, layers: usize) -> Result<Wall, ProfileError> {
    bowl.check()?;
    let arc = Arc::new(bowl);
    #[expect(clippy::cast_sign_loss, reason = "lengths are positive")]
    let count = |length_m: f64| (length_m / max_element_m).ceil().max(2.0) as usize;
    let (base, side) = (count(bowl.base_radius_m), count(arc.length_m()));
    let along = base + side;
    // Outer point and inward normal at a half step from the axis.
    let place = |j: usize| -> ([f64; 2], [f64; 2], f64) {
        if j <= 2 * base {
            let r = bowl.base_radius_m * j as f64 / (2 * base) as f64;
            let normal = if j == 2 * base {
                arc.normal(0.0)
            } else {
                [0.0, 1.0]
            };
            return ([r, 0.0], normal, bowl.base_wall_m);
        }
        let share = arc.share((j - 2 * base) as f64 / (2 * side) as f64);
        (bowl.outer_m(share), arc.normal(share), bowl.wall_m(share))
    };
    let meridian = Meridian::new(
        [along, layers],
        |_, _| true,
        |j, i| {
            let ([r, z], [nr, nz], wall_m) = place(j);
            let depth_m = wall_m * i as f64 / (2 * layers) as f64;
            [(r + nr * depth_m).max(0.0), z + nz * depth_m]
        },
    );
    let line: Vec<u32> = (0..=2 * along)
        .rev()
        .filter_map(|j| meridian.node_at(j, 0))
        .collect();
    let line_normals = (0..=2 * along)
        .rev()
        .map(|j| place(j).1.map(|x| -x))
        .collect();
    Ok(Wall {
        length_m: bowl.height_m,
        line,
        line_normals,
        mirrors: false,
        held: meridian.node_at(2 * base, 0).into_iter().collect(),
        felt: meridian.node_at(2 * along, 0).into_iter().collect(),
        heard: meridian.sides.clone(),
        mouth_m: Some([bowl.rim_radius_m - bowl.rim_wall_m, bowl.height_m]),
        family: Family::Shell,
        meridian,
    })
}

/// The length along the profile's wall.
struct Arc<'a> {
    bowl: &'a Bowl,
    /// Length in m up to each step of the share.
    lengths_m: Vec<f64>,
}

impl<'a> Arc<'a> {
    fn new(bowl: &'a Bowl) -> Self {
        let mut lengths_m = vec![0.0];
        let mut last = bowl.outer_m(0.0);
        let mut length = 0.0;
        for i in 1..=ARC_STEPS {
            let next = bowl.outer_m(i as f64 / ARC_STEPS as f64);
            length += (next[0] - last[0]).hypot(next[1] - last[1]);
            lengths_m.push(length);
            last = next;
        }
        Self { bowl, lengths_m }
    }

    fn length_m(&self) -> f64 {
        self.lengths_m[ARC_STEPS]
    }

    /// The share of the profile at the `part` of its length.
    fn share(&self, part: f64) -> f64 {
        let wanted = part * self.length_m();
        let step = self
            .lengths_m
            .partition_point(|&l| l < wanted)
            .clamp(1, ARC_STEPS);
        let (low, high) = (self.lengths_m[step - 1], self.lengths_m[step]);
        (step as f64 - (high - wanted) / (high - low)) / ARC_STEPS as f64
    }

    /// Inward unit normal (r, z) of the wall at `share`.
    fn normal(&self, share: f64) -> [f64; 2] {
        let h = 0.5 / ARC_STEPS as f64;
        let (p, q) = (self.bowl.outer_m(share - h), self.bowl.outer_m(share + h));
        let (dr, dz) = (q[0] - p[0], q[1] - p[1]);
        let length = dr.hypot(dz);
        [-dz / length, dr / length]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TABLE_1;
    use crate::fem::Harmonic;
    use crate::revolution::LAYERS;

    /// What the check lets pass can be cut into cells, fine ones and coarse.
    #[test]
    fn every_profile_that_passes_has_a_sound_mesh() {
        const WALLS: [f64; 5] = [0.0051, 0.01, 0.1, 0.2, 0.4];
        let (mut passed, mut refused) = (0, 0);
        for squareness in [2.0, 4.0, 10.0] {
            for base_radius_m in [0.01, 0.3, 0.6, 0.9, 0.99] {
                for height_m in [0.1, 0.3, 1.0, 3.0] {
                    for (base_wall_m, rim_wall_m) in
                        WALLS.iter().flat_map(|&b| WALLS.map(|r| (b, r)))
                    {
                        let shape = Bowl {
                            rim_radius_m: 1.0,
                            base_radius_m,
                            height_m,
                            squareness,
                            base_wall_m,
                            rim_wall_m,
                        };
                        if shape.check().is_err() {
                            refused += 1;
                            continue;
                        }
                        passed += 1;
                        for longest_m in [0.2, 1.0] {
                            let wall = bowl(&shape, longest_m, LAYERS).unwrap();
                            let solid = Harmonic::new(&wall.meridian, &TABLE_1[0].material, 2);
                            assert!(solid.is_ok(), "{shape:?}, cells of {longest_m} m");
                        }
                    }
                }
            }
        }
        assert!(passed > 0 && refused > 0);
    }
}
