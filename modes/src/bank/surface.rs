//! What a body looks like, and how its surface moves in its lowest modes.

/// A body's outside, drawn and in motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Length of the body that the points are of, in m: of a body of another length they are larger or
    /// smaller in that proportion, see [`super::Body::surface_scale`].
    pub length_m: f64,
    /// Points, in m, in the frame of the strike grid.
    pub points_m: Vec<[f32; 3]>,
    /// Triangles of points, counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
    /// How the points move in each of the lowest modes, in the order of the body's modes, at most
    /// [`Self::MOST_MODES`]. A body that shares the surface of a larger one may have fewer modes, and
    /// shapes that all differ by the same factor.
    pub motions: Vec<SurfaceMotion>,
}

/// How the points of a surface move in one mode.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceMotion {
    /// What a step of the numbers stands for, in kg^(−1/2).
    pub step: f32,
    /// Displacement of each point, in steps.
    pub points: Vec<[i8; 3]>,
}

impl Surface {
    /// Modes of which a surface shows the motion: beyond, waves are too short to be seen.
    pub const MOST_MODES: usize = 128;
}

impl SurfaceMotion {
    /// `motion` in kg^(−1/2) at each point, in steps of which the greatest component has 127.
    #[must_use]
    pub fn of(motion: &[[f32; 3]]) -> Self {
        let most = motion
            .iter()
            .flatten()
            .fold(0.0f32, |most, x| most.max(x.abs()));
        let step = most / 127.0;
        let whole = |x: f32| {
            if step > 0.0 {
                (x / step).round() as i8
            } else {
                0
            }
        };
        Self {
            step,
            points: motion.iter().map(|u| u.map(whole)).collect(),
        }
    }

    /// φ at point `i`, in kg^(−1/2).
    ///
    /// # Panics
    ///
    /// If there is no such point.
    #[must_use]
    pub fn at(&self, i: usize) -> [f32; 3] {
        self.points[i].map(|steps| self.step * f32::from(steps))
    }
}

#[cfg(test)]
mod tests {
    use super::SurfaceMotion;

    #[test]
    fn motion_is_kept_to_half_a_step() {
        let motion: Vec<[f32; 3]> = (0..50)
            .map(|i| [(i as f32).sin(), 0.2 * (i as f32).cos(), -0.7])
            .collect();
        let kept = SurfaceMotion::of(&motion);
        for (i, u) in motion.iter().enumerate() {
            for (x, y) in kept.at(i).iter().zip(u) {
                assert!((x - y).abs() <= 0.501 / 127.0, "{x} {y}");
            }
        }
        assert_eq!(SurfaceMotion::of(&[[0.0; 3]]).at(0), [0.0; 3]);
    }
}
