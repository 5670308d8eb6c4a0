//! Sound as a sum of decaying sines of known frequency and decay, by least squares.

use std::f64::consts::TAU;

/// A partial that is expected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Partial {
    /// Frequency, in Hz.
    pub hz: f64,
    /// Amplitude decay rate, in 1/s.
    pub decay_per_s: f64,
    /// Whether to measure how far it is off, which needs neighbours at a distance.
    pub measured: bool,
}

/// A partial that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Amplitude at the first sample.
    pub amplitude: f64,
    /// How far its frequency is from what was expected, in cents; 0 unless measured.
    pub cents_off: f64,
    /// How far its decay rate is off, as a fraction; 0 unless measured.
    pub decay_off: f64,
}

/// What was found, and the greatest sample that it does not explain.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// In the order of what was expected.
    pub partials: Vec<Found>,
    /// Greatest magnitude of sound less fit.
    pub residual: f64,
}

/// Fits a e^λt to `sound` for each partial, and where it is measured b t e^λt as well: to first
/// order b/a is how far λ is off.
#[must_use]
pub fn fit(sound: &[f32], rate_hz: f64, partials: &[Partial]) -> Fit {
    let mut columns = Vec::new();
    for partial in partials {
        let wave = |weight: &dyn Fn(f64) -> f64, phase: f64| -> Vec<f64> {
            (0..sound.len())
                .map(|i| {
                    let t = i as f64 / rate_hz;
                    let envelope = (-partial.decay_per_s * t).exp();
                    weight(t) * envelope * (TAU * partial.hz * t + phase).cos()
                })
                .collect()
        };
        // The real part of a complex amplitude times e^iωt: a cosine and a negative sine.
        columns.push(wave(&|_| 1.0, 0.0));
        columns.push(wave(&|_| 1.0, TAU / 4.0));
        if partial.measured {
            columns.push(wave(&|t| t, 0.0));
            columns.push(wave(&|t| t, TAU / 4.0));
        }
    }
    let sound: Vec<f64> = sound.iter().map(|&sample| f64::from(sample)).collect();
    let (weights, residual) = least_squares(columns, sound);
    let mut weights = weights.as_slice();
    let partials = partials
        .iter()
        .map(|partial| {
            let (mine, rest) = weights.split_at(if partial.measured { 4 } else { 2 });
            weights = rest;
            found(partial, mine)
        })
        .collect();
    Fit { partials, residual }
}

fn found(partial: &Partial, weights: &[f64]) -> Found {
    let &[x, y, ref moved @ ..] = weights else {
        unreachable!("two weights at least")
    };
    let power = x * x + y * y;
    // b/a as real and imaginary part: −Δd and Δω.
    let (decay, omega) = match *moved {
        [u, v] => ((x * u + y * v) / power, (x * v - y * u) / power),
        _ => (0.0, 0.0),
    };
    Found {
        amplitude: power.sqrt(),
        cents_off: 1200.0 * (1.0 + omega / (TAU * partial.hz)).log2(),
        decay_off: -decay / partial.decay_per_s,
    }
}

/// Weights of `columns` that come nearest to `goal`, and the greatest magnitude of what is left.
///
/// Gram–Schmidt done twice, which is as good as Householder's (Björck 1994); columns that the
/// others explain get no weight.
fn least_squares(mut columns: Vec<Vec<f64>>, mut goal: Vec<f64>) -> (Vec<f64>, f64) {
    let n = columns.len();
    let mut upper = vec![vec![0.0; n]; n];
    let mut share = vec![0.0; n];
    for j in 0..n {
        let (before, rest) = columns.split_at_mut(j);
        let column = &mut rest[0];
        let whole = dot(column, column).sqrt();
        for _ in 0..2 {
            for (i, unit) in before.iter().enumerate() {
                let part = dot(unit, column);
                upper[i][j] += part;
                subtract(column, part, unit);
            }
        }
        let left = dot(column, column).sqrt();
        if left > 1e-10 * whole {
            upper[j][j] = left;
            column.iter_mut().for_each(|x| *x /= left);
            share[j] = dot(column, &goal);
            subtract(&mut goal, share[j], column);
        } else {
            column.fill(0.0);
        }
    }
    let mut weights = vec![0.0; n];
    for j in (0..n).rev() {
        if upper[j][j] > 0.0 {
            let known: f64 = (j + 1..n).map(|k| upper[j][k] * weights[k]).sum();
            weights[j] = (share[j] - known) / upper[j][j];
        }
    }
    let residual = goal.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    (weights, residual)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn subtract(from: &mut [f64], times: f64, what: &[f64]) {
    for (from, what) in from.iter_mut().zip(what) {
        *from -= times * what;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_put_in_is_found() {
        let rate_hz = 48_000.0;
        // 0.005 cents and 0.3 % off what is expected, beside a neighbour that is not.
        let sound: Vec<f32> = (0..24_000)
            .map(|i| {
                let t = f64::from(i) / rate_hz;
                let hz = 600.0 * 2f64.powf(0.005 / 1200.0);
                let first = 0.5 * (-2.006 * t).exp() * (TAU * hz * t + 0.4).cos();
                let second = 0.1 * (-40.0 * t).exp() * (TAU * 900.0 * t).sin();
                (first + second) as f32
            })
            .collect();
        let partial = |hz, decay_per_s| Partial {
            hz,
            decay_per_s,
            measured: true,
        };
        let fit = fit(
            &sound,
            rate_hz,
            &[partial(600.0, 2.0), partial(900.0, 40.0)],
        );
        assert!((fit.partials[0].amplitude - 0.5).abs() < 1e-4);
        assert!((fit.partials[0].cents_off - 0.005).abs() < 1e-4);
        assert!((fit.partials[0].decay_off - 0.003).abs() < 1e-4);
        assert!((fit.partials[1].amplitude - 0.1).abs() < 1e-4);
        assert!(fit.partials[1].cents_off.abs() < 1e-3);
        assert!(fit.residual < 1e-4);
    }
}
