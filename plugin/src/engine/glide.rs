//! A parameter on its way to a new value, in equal steps of the control grid.

/// A value that moves to its target in a straight line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Glide {
    from: f64,
    to: f64,
    left: u32,
    steps: u32,
}

impl Glide {
    /// At rest at `value`; a later change takes `steps` grid steps.
    pub(crate) fn new(value: f64, steps: u32) -> Self {
        Self {
            from: value,
            to: value,
            left: 0,
            steps: steps.max(1),
        }
    }

    /// Sets out for `target` from wherever it is.
    pub(crate) fn aim(&mut self, target: f64) {
        if target != self.to {
            self.from = self.value();
            self.to = target;
            self.left = self.steps;
        }
    }

    /// Arrives at once.
    pub(crate) fn snap(&mut self) {
        self.left = 0;
    }

    /// Takes one step.
    pub(crate) fn advance(&mut self) {
        self.left = self.left.saturating_sub(1);
    }

    /// Where it is; exactly the target once there.
    pub(crate) fn value(&self) -> f64 {
        if self.left == 0 {
            return self.to;
        }
        self.to + (self.from - self.to) * (f64::from(self.left) / f64::from(self.steps))
    }
}

#[cfg(test)]
mod tests {
    use super::Glide;

    #[test]
    fn moves_in_equal_steps_and_arrives_exactly() {
        let mut glide = Glide::new(1.0, 4);
        glide.aim(0.3);
        let mut seen = vec![glide.value()];
        for _ in 0..5 {
            glide.advance();
            seen.push(glide.value());
        }
        for (value, expected) in seen.iter().zip([1.0, 0.825, 0.65, 0.475, 0.3, 0.3]) {
            assert!((value - expected).abs() < 1e-15);
        }
        assert_eq!(seen[4], 0.3);
    }
}
