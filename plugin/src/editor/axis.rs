//! From values to places on the screen.

use super::theme::{Theme, small};
use egui::{Align2, Painter, Pos2, Rangef};

/// A logarithmic axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis {
    from: f64,
    to: f64,
    span: Rangef,
}

impl Axis {
    /// From the first value at the near end of `span` to the second at its far end.
    pub(super) fn log([from, to]: [f64; 2], span: Rangef) -> Self {
        let from = from.max(f64::MIN_POSITIVE);
        Self {
            from: from.ln(),
            to: to.max(1.001 * from).ln(),
            span,
        }
    }

    /// Where a value is.
    pub(super) fn place(&self, value: f64) -> f32 {
        let share = (value.ln() - self.from) / (self.to - self.from);
        self.span.min + self.span.span() * share as f32
    }

    /// What is at a place.
    pub(super) fn value(&self, place: f32) -> f64 {
        let share = f64::from((place - self.span.min) / self.span.span());
        (self.from + share * (self.to - self.from)).exp()
    }

    /// Whether the axis reaches so far.
    pub(super) fn holds(&self, value: f64) -> bool {
        (self.from..=self.to).contains(&value.ln())
    }
}

/// What stands beside an axis.
pub(super) fn notch(painter: &Painter, at: Pos2, text: &str, theme: &Theme) {
    painter.text(at, Align2::RIGHT_CENTER, text, small(), theme.quiet);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_ratios_take_equal_room() {
        let axis = Axis::log([10.0, 1000.0], Rangef::new(100.0, 300.0));
        for (value, place) in [(10.0, 100.0), (100.0, 200.0), (1000.0, 300.0)] {
            assert!((axis.place(value) - place).abs() < 1e-3);
            assert!((axis.value(place) / value - 1.0).abs() < 1e-6);
        }
        assert!(axis.holds(10.5) && !axis.holds(9.0) && !axis.holds(1001.0));
    }
}
