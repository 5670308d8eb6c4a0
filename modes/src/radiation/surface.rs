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
