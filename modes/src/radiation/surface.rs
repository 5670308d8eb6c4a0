//! What of a body touches the air, in flat patches.

/// The patches of a body's surface, small against the waves on it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Middle of each patch, in m, in the body's own frame.
    pub points_m: Vec<[f64; 3]>,
    /// Outward unit normal of each patch.
    pub normals: Vec<[f64; 3]>,
    /// Area of each patch, in m².
    pub areas_m2: Vec<f64>,
    /// Radius and height in m of a round mouth about the z axis, through which alone the patches
    /// that face the axis are heard.
    pub mouth_m: Option<[f64; 2]>,
}

impl Surface {
    /// Number of patches.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points_m.len()
    }

    /// Whether there are no patches.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points_m.is_empty()
    }

    /// Whether the way from patch `i` to `receiver` is free, where its normal points to.
    ///
    /// Bodies are taken as convex but for their mouth: what starts inside must leave through it.
    #[must_use]
    pub fn is_heard_at(&self, i: usize, receiver: [f64; 3]) -> bool {
        let (point, normal) = (self.points_m[i], self.normals[i]);
        let inwards = point[0] * normal[0] + point[1] * normal[1] < 0.0
            || (normal[2] > 0.0 && self.mouth_m.is_some_and(|[_, height]| point[2] < height));
        let Some([radius_m, height_m]) = self.mouth_m.filter(|_| inwards) else {
            return true;
        };
        let rise = receiver[2] - point[2];
        let share = (height_m - point[2]) / rise;
        if rise <= 0.0 || share > 1.0 {
            return false;
        }
        let [x, y] = [0, 1].map(|a| point[a] + share * (receiver[a] - point[a]));
        x.hypot(y) <= radius_m
    }

    /// The surface with all lengths times `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            points_m: self
                .points_m
                .iter()
                .map(|p| p.map(|x| factor * x))
                .collect(),
            normals: self.normals.clone(),
            mouth_m: self.mouth_m.map(|mouth| mouth.map(|x| factor * x)),
            areas_m2: self.areas_m2.iter().map(|a| factor * factor * a).collect(),
        }
    }

    /// ∫|φ·n| dS in m² kg^(−1/2) of a mode's `motion` φ·n on each patch: "summing the amount of
    /// normal displacement … over the surface" (O'Brien 2002 §3.4).
    #[must_use]
    pub fn rectified_area(&self, motion: &[f32]) -> f64 {
        let patches = self.areas_m2.iter().zip(motion);
        patches
            .map(|(area, motion)| area * f64::from(motion.abs()))
            .sum()
    }
}
