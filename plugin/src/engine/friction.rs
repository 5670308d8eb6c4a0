//! The force between a bow or a stick and a surface that slides under it.

/// Coefficients of friction at rest and at speed, of rosined hair or of wood and leather on metal.
const AT_REST: f64 = 1.0;
const SLIDING: f64 = 0.25;

/// Speed in m/s within which the contact sticks, and over which friction falls.
const STICKS_M_S: f64 = 1e-3;
const FALLS_M_S: f64 = 0.1;

/// Rounds of the solution at most; two or three are the rule.
const ROUNDS: usize = 60;

/// Coefficient of friction at a sliding speed of 0 or more in m/s, and its slope: up to its greatest in a
/// creep, then falling (Stribeck's curve in rational functions).
#[inline(always)]
fn coefficient(speed_m_s: f64) -> (f64, f64) {
    let creep = 1.0 / (speed_m_s + STICKS_M_S);
    let fall = 1.0 / (1.0 + speed_m_s / FALLS_M_S);
    let (stuck, level) = (speed_m_s * creep, SLIDING + (AT_REST - SLIDING) * fall);
    let slope =
        STICKS_M_S * creep * creep * level - stuck * (AT_REST - SLIDING) * fall * fall / FALLS_M_S;
    (stuck * level, slope)
}

/// Impulse in N·s over a step, on a surface that slides by `speed_m_s` under a bow that presses with
/// `press_n_s` (force times step), when 1 N·s changes that speed by `mobility` m/s.
///
/// The speed that counts is the mean of those before and after, and the impulse never turns it round: all
/// that friction does besides the bow's work is to take energy.
#[inline(always)]
pub(crate) fn rub(speed_m_s: f64, press_n_s: f64, mobility: f64) -> f64 {
    let most = speed_m_s.abs();
    let gain = 0.5 * mobility * press_n_s;
    if !(most > 0.0 && gain > 0.0) {
        return 0.0;
    }
    // v + gain μ(v) = most; there is a root between 0 and `most`, and the one that sticks is looked for.
    let (mut low, mut high) = (0.0, most);
    let mut speed = most.min(STICKS_M_S * most / (gain * AT_REST + most));
    for _ in 0..ROUNDS {
        let (friction, slope) = coefficient(speed);
        let off = speed + gain * friction - most;
        if off > 0.0 {
            high = speed;
        } else {
            low = speed;
        }
        let newton = speed - off / (1.0 + gain * slope);
        let next = if newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
        if (next - speed).abs() <= 1e-9 * most {
            speed = next;
            break;
        }
        speed = next;
    }
    (2.0 * (most - speed) / mobility).copysign(speed_m_s)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn friction_falls_with_speed() {
        let steps: Vec<f64> = (0..200).map(|i| 1e-5 * 1.07f64.powi(i)).collect();
        for v in &steps {
            let (mu, slope) = coefficient(*v);
            let step = 1e-6 * v;
            let numeric = (coefficient(v + step).0 - coefficient(v - step).0) / (2.0 * step);
            assert!((slope - numeric).abs() < 1e-5 * (1.0 + slope.abs()), "{v}");
            assert!(mu > 0.0 && mu < AT_REST);
        }
        let peak = steps.iter().map(|v| coefficient(*v).0).fold(0.0, f64::max);
        assert!(peak > 0.8 && coefficient(2.0).0 < 0.3);
    }

    #[test]
    fn friction_only_slows_what_slides() {
        for i in 0..1000 {
            let speed = 1e-4 * 1.01f64.powi(i) * if i % 2 == 0 { 1.0 } else { -1.0 };
            for press in [1e-7, 1e-5, 1e-3, 1e-1] {
                for mobility in [0.1, 10.0, 1000.0] {
                    let impulse = rub(speed, press, mobility);
                    let mean = speed - 0.5 * mobility * impulse;
                    assert!(impulse * mean >= 0.0, "{speed}, {press}, {mobility}");
                    // The law of friction holds within a millionth of the speed.
                    let off = |mean: f64| {
                        mean + 0.5 * mobility * press * coefficient(mean.max(0.0)).0
                            - f64::abs(speed)
                    };
                    let mean = mean.abs();
                    assert!(off(mean - 1e-6 * speed.abs()) <= 0.0 || mean < 1e-6 * speed.abs());
                    assert!(off(mean + 1e-6 * speed.abs()) >= 0.0);
                }
            }
        }
        assert_eq!(rub(0.0, 1.0, 1.0), 0.0);
    }
}
