//! How loud people hear a programme: ITU-R BS.1770-4.

use std::f64::consts::PI;

/// A block and the step to the next one, in s.
const BLOCK_S: f64 = 0.4;
const STEP_S: f64 = 0.1;
/// Blocks below this do not count, in LUFS.
const ABSOLUTE_LUFS: f64 = -70.0;
/// Nor do those so far below the mean of the others, in LU.
const RELATIVE_LU: f64 = -10.0;

/// Integrated loudness of a left and a right channel, in LUFS; −∞ for silence or less than a block.
pub(crate) fn integrated_lufs(channels: [&[f32]; 2], rate_hz: f64) -> f64 {
    let block = crate::whole::whole((BLOCK_S * rate_hz).round());
    let step = crate::whole::whole((STEP_S * rate_hz).round());
    let squares = channels.map(|channel| weighted_squares(channel, rate_hz));
    let powers = |channel: &[f64]| -> Vec<f64> {
        let windows = channel.windows(block).step_by(step);
        windows
            .map(|window| window.iter().sum::<f64>() / block as f64)
            .collect()
    };
    let [left, right] = [powers(&squares[0]), powers(&squares[1])];
    let blocks: Vec<f64> = left.iter().zip(&right).map(|(l, r)| l + r).collect();
    let over = |least: f64| -> f64 {
        let counted = blocks.iter().filter(|power| lufs(**power) > least);
        let (sum, count) = counted.fold((0.0, 0u32), |(sum, n), power| (sum + power, n + 1));
        lufs(sum / f64::from(count.max(1)))
    };
    over((over(ABSOLUTE_LUFS) + RELATIVE_LU).max(ABSOLUTE_LUFS))
}

fn lufs(power: f64) -> f64 {
    -0.691 + 10.0 * power.log10()
}

/// Squares of the samples as the ear weighs them.
fn weighted_squares(channel: &[f32], rate_hz: f64) -> Vec<f64> {
    let (mut head, mut low) = (Biquad::head(rate_hz), Biquad::low(rate_hz));
    let weigh = |sample: &f32| low.next(head.next(f64::from(*sample))).powi(2);
    channel.iter().map(weigh).collect()
}

/// A filter of second order.
struct Biquad {
    b: [f64; 3],
    a: [f64; 2],
    state: [f64; 2],
}

impl Biquad {
    /// A shelf for what the head does to high frequencies. Annex 1, Table 1 has its coefficients at
    /// 48 kHz; they are the bilinear transform of this prototype, which serves at any rate.
    fn head(rate_hz: f64) -> Self {
        let k = (PI * 1_681.974_450_955_533 / rate_hz).tan();
        let q = 0.707_175_236_955_419_6;
        let high = 10f64.powf(3.999_843_853_973_347 / 20.0);
        let band = high.powf(0.499_666_774_154_541_6);
        let a0 = 1.0 + k / q + k * k;
        Self {
            b: [
                (high + band * k / q + k * k) / a0,
                2.0 * (k * k - high) / a0,
                (high - band * k / q + k * k) / a0,
            ],
            a: [2.0 * (k * k - 1.0) / a0, (1.0 - k / q + k * k) / a0],
            state: [0.0; 2],
        }
    }

    /// A high pass for what nobody hears: Table 2.
    fn low(rate_hz: f64) -> Self {
        let k = (PI * 38.135_470_876_024_44 / rate_hz).tan();
        let q = 0.500_327_037_323_877_3;
        let a0 = 1.0 + k / q + k * k;
        Self {
            b: [1.0, -2.0, 1.0],
            a: [2.0 * (k * k - 1.0) / a0, (1.0 - k / q + k * k) / a0],
            state: [0.0; 2],
        }
    }

    fn next(&mut self, x: f64) -> f64 {
        let y = self.b[0] * x + self.state[0];
        self.state[0] = self.b[1] * x - self.a[0] * y + self.state[1];
        self.state[1] = self.b[2] * x - self.a[1] * y;
        y
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sine(hz: f64, level_dbfs: f64, seconds: f64, rate_hz: f64) -> Vec<f32> {
        let peak = 10f64.powf(level_dbfs / 20.0);
        (0..crate::whole::whole(seconds * rate_hz))
            .map(|i| (peak * (2.0 * PI * hz * i as f64 / rate_hz).sin()) as f32)
            .collect()
    }

    fn assert_lufs(signal: &[f32], rate_hz: f64, expected: f64) {
        let lufs = integrated_lufs([signal, signal], rate_hz);
        assert!((lufs - expected).abs() < 0.1, "{lufs} beside {expected}");
    }

    /// Cases 1 to 3 of EBU Tech 3341, and its tolerance.
    #[test]
    fn tones_have_the_loudness_that_the_ebu_says() {
        for rate_hz in [44.1e3, 48e3, 96e3] {
            assert_lufs(&sine(1e3, -23.0, 20.0, rate_hz), rate_hz, -23.0);
            assert_lufs(&sine(1e3, -33.0, 20.0, rate_hz), rate_hz, -33.0);
        }
        let parts = [(-36.0, 10.0), (-23.0, 60.0), (-36.0, 10.0)];
        let gated = parts.map(|(level, seconds)| sine(1e3, level, seconds, 48e3));
        assert_lufs(&gated.concat(), 48e3, -23.0);
    }

    /// Annex 1, Tables 1 and 2, at 48 kHz.
    #[test]
    fn filters_are_those_of_the_standard() {
        let (head, low) = (Biquad::head(48e3), Biquad::low(48e3));
        let close = |ours: &[f64], theirs: &[f64]| {
            let all = ours.iter().zip(theirs);
            all.for_each(|(a, b)| assert!((a - b).abs() < 1e-7, "{a} {b}"));
        };
        close(
            &head.b,
            &[
                1.535_124_859_586_97,
                -2.691_696_189_406_38,
                1.198_392_810_852_85,
            ],
        );
        close(&head.a, &[-1.690_659_293_182_41, 0.732_480_774_215_85]);
        close(&low.a, &[-1.990_047_454_833_98, 0.990_072_250_366_21]);
    }

    #[test]
    fn silence_is_minus_infinity() {
        assert_eq!(
            integrated_lufs([&[0.0; 48_000]; 2], 48e3),
            f64::NEG_INFINITY
        );
        assert_eq!(integrated_lufs([&[]; 2], 48e3), f64::NEG_INFINITY);
    }
}
