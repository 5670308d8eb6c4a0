//! A logarithmic axis.

/// A range of values laid along pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Axis {
    ends: [f64; 2],
    pixels: [i32; 2],
}

impl Axis {
    /// An axis on `pixels`, from first to last, that has all `values` with a share `margin` of
    /// itself left free at each end.
    pub(super) fn around(
        values: impl Iterator<Item = f64>,
        margin: f64,
        pixels: [i32; 2],
    ) -> Option<Self> {
        let (low, high) = values
            .filter(|value| value.is_finite() && *value > 0.0)
            .fold((f64::INFINITY, 0.0), |(low, high), value: f64| {
                (value.min(low), value.max(high))
            });
        if high <= 0.0 {
            return None;
        }
        // One value alone gets half an octave to each side.
        let span = (high / low).max(2.0);
        let middle = (high * low).sqrt();
        let reach = span.powf(0.5 / (1.0 - 2.0 * margin));
        Some(Self {
            ends: [middle / reach, middle * reach],
            pixels,
        })
    }

    /// The pixel of a value.
    pub(super) fn at(&self, value: f64) -> i32 {
        let [low, high] = self.ends;
        let [from, to] = self.pixels.map(f64::from);
        (from + (value / low).ln() / (high / low).ln() * (to - from)).round() as i32
    }

    /// Values to write at the axis: 1, 2 and 5 times powers of ten, or those powers alone if there
    /// are many.
    pub(super) fn ticks(&self) -> Vec<f64> {
        let [low, high] = self.ends;
        let decades = (high / low).log10();
        let steps: &[f64] = if decades > 4.0 {
            &[1.0]
        } else {
            &[1.0, 2.0, 5.0]
        };
        let exponents = low.log10().floor() as i32..=high.log10().floor() as i32;
        exponents
            .flat_map(|exponent| steps.iter().map(move |step| step * 10f64.powi(exponent)))
            .filter(|tick| (low..=high).contains(tick))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_lie_within_the_margins_in_even_octaves() {
        let axis = Axis::around([100.0, 1600.0].into_iter(), 0.1, [0, 1000]).unwrap();
        let at = [100.0, 200.0, 400.0, 800.0, 1600.0].map(|value| axis.at(value));
        assert_eq!(at, [100, 300, 500, 700, 900]);
    }

    #[test]
    fn an_axis_may_run_upwards() {
        let axis = Axis::around([1.0, 100.0].into_iter(), 0.0, [600, 100]).unwrap();
        assert_eq!(
            [1.0, 10.0, 100.0].map(|value| axis.at(value)),
            [600, 350, 100]
        );
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let axis = Axis::around([0.3, 30.0].into_iter(), 0.0, [0, 100]).unwrap();
        let ticks: Vec<_> = axis
            .ticks()
            .iter()
            .map(|tick| format!("{tick:.1}"))
            .collect();
        assert_eq!(ticks, ["0.5", "1.0", "2.0", "5.0", "10.0", "20.0"]);
        let wide = Axis::around([1e-3, 1e3].into_iter(), 0.01, [0, 100]).unwrap();
        assert_eq!(wide.ticks().len(), 7);
    }

    #[test]
    fn nothing_has_no_axis() {
        assert_eq!(Axis::around([0.0, f64::NAN].into_iter(), 0.1, [0, 1]), None);
    }
}
