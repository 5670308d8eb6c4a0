//! What sounds beside what the bank says.

use idiophone_tests::{Fit, Partial, fit, plugin, strike};
use modes::{Mode, Motion};
use xtask::settings;

const KEY: u8 = 74;
/// The mallet has left by then.
const CONTACT_S: f64 = 0.005;
/// Length of sound that is looked at.
const WINDOW_S: f64 = 0.4;
/// −90 dB: what is weaker than this beside the strongest partial is not measured.
const FAINT: f64 = 3.2e-5;

/// The partials of the key; those are measured that no other overlaps.
fn expected(decay_per_s: impl Fn(&Mode) -> f64) -> Vec<Partial> {
    let bank = idiophone::factory::bank(0);
    let body = bank.bodies.iter().find(|body| body.key == KEY).unwrap();
    let mut motions: Vec<_> = body
        .modes
        .iter()
        .filter_map(|mode| match Motion::of(mode.hz, decay_per_s(mode)) {
            Motion::Ringing { hz, decay_per_s } => Some((hz, decay_per_s)),
            Motion::Overdamped => None,
        })
        .collect();
    // The two of a degenerate pair are one partial.
    motions.dedup_by(|a, b| (a.0 - b.0).abs() < 1e-6 * b.0);
    let apart = |i: usize, j: usize| {
        let (hz, decay_per_s) = motions[i];
        j >= motions.len() || i == j || (motions[j].0 - hz).abs() > 0.25 * decay_per_s
    };
    (0..motions.len())
        .map(|i| Partial {
            hz: motions[i].0,
            decay_per_s: motions[i].1,
            measured: apart(i, i.saturating_sub(1)) && apart(i, i + 1),
        })
        .collect()
}

fn rendered(rate_hz: f64, settings: &[&str]) -> Vec<f32> {
    let mut plugin = plugin().unwrap();
    for text in settings {
        let setting = settings::setting(&mut plugin, text).unwrap();
        plugin.set(&[setting]).unwrap();
    }
    plugin.activate(rate_hz, 512).unwrap();
    let frames = |seconds: f64| xtask::midi::frame(seconds, rate_hz) as usize;
    let whole = frames(CONTACT_S + WINDOW_S);
    let take = plugin.play(&[strike(KEY, 1.0).at(0)], whole, 512).unwrap();
    take.left[frames(CONTACT_S)..].to_vec()
}

fn strongest(fit: &Fit) -> f64 {
    fit.partials
        .iter()
        .fold(0.0, |most, partial| most.max(partial.amplitude))
}

/// Every partial that can be told apart is where the bank says; the sum of all explains the sound.
fn assert_partials(rate_hz: f64, decay_per_s: impl Fn(&Mode) -> f64, settings: &[&str]) -> Fit {
    let expected = expected(decay_per_s);
    let found = fit(&rendered(rate_hz, settings), rate_hz, &expected);
    let most = strongest(&found);
    let (mut cents, mut decay, mut count) = (0.0f64, 0.0f64, 0);
    for (partial, found) in expected.iter().zip(&found.partials) {
        if partial.measured && found.amplitude > FAINT * most {
            cents = cents.max(found.cents_off.abs());
            decay = decay.max(found.decay_off.abs());
            count += 1;
        }
    }
    let unexplained = 20.0 * (found.residual / most).log10();
    println!(
        "{rate_hz} Hz: {count} of {} partials measured, at most {cents:.1e} cents and {decay:.1e} \
         of the decay off; {unexplained:.1} dB unexplained",
        expected.len()
    );
    assert!(count >= 20, "{count} partials");
    assert!(cents < 0.02, "{cents} cents");
    assert!(decay < 0.003, "{decay} of the decay rate");
    assert!(unexplained < -120.0, "{unexplained} dB unexplained");
    found
}

#[test]
fn partials_are_the_bank_s_at_every_rate() {
    let damping = idiophone::factory::bank(0).damping;
    let levels: Vec<_> = [44_100.0, 48_000.0, 96_000.0, 192_000.0]
        .map(|rate_hz| {
            strongest(&assert_partials(
                rate_hz,
                |mode| mode.decay_per_s(&damping),
                &[],
            ))
        })
        .into();
    for level in &levels {
        let db = 20.0 * (level / levels[0]).log10();
        println!("{db:.4} dB louder than at 44100 Hz");
        assert!(db.abs() < 0.1, "{levels:?}");
    }
}

#[test]
fn partials_follow_the_damping() {
    let rate_per_s = |mode: &Mode| {
        let omega = std::f64::consts::TAU * mode.hz;
        let added = 0.5 * (5e-8 * omega * omega + 3.0) + 0.5 * 1e-4 * omega;
        added + 2.0 * f64::from(mode.radiation_per_s) + 0.5 * f64::from(mode.support_per_s)
    };
    let settings = [
        "Own damping=0 x",
        "Alpha 1=5e-8 s",
        "Alpha 2=3 1/s",
        "Loss factor=1e-4",
        "Radiation damping=2 x",
        "Supports=0.5 x",
    ];
    assert_partials(48_000.0, rate_per_s, &settings);
}
