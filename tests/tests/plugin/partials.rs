//! What sounds beside what the bank says.

use idiophone_tests::chime::{CONTACT_S, Off, off, partials};
use idiophone_tests::{plugin_with, strike};
use modes::Mode;

const KEY: u8 = 74;
/// Length of sound that is looked at.
const WINDOW_S: f64 = 0.4;
/// −90 dB: what is weaker than this beside the strongest partial is not measured.
const FAINT: f64 = 3.2e-5;

fn rendered(rate_hz: f64, settings: &[&str]) -> Vec<f32> {
    let mut plugin = plugin_with(settings).unwrap();
    plugin.activate(rate_hz, 512).unwrap();
    let frames = |seconds: f64| xtask::midi::frame(seconds, rate_hz) as usize;
    let whole = frames(CONTACT_S + WINDOW_S);
    let take = plugin.play(&[strike(KEY, 1.0).at(0)], whole, 512).unwrap();
    take.left[frames(CONTACT_S)..].to_vec()
}

/// Every partial that can be told apart is where the bank says; the sum of all explains the sound.
fn assert_partials(rate_hz: f64, decay_per_s: impl Fn(&Mode) -> f64, settings: &[&str]) -> Off {
    let expected = partials(KEY, 1.0, |mode, _| decay_per_s(mode));
    let off = off(&rendered(rate_hz, settings), rate_hz, &expected, FAINT);
    println!(
        "{rate_hz} Hz: {} of {} partials measured, at most {:.1e} cents and {:.1e} of the decay \
         off; {:.1} dB unexplained",
        off.count,
        expected.len(),
        off.cents,
        off.decay,
        off.unexplained_db
    );
    assert!(off.count >= 20, "{} partials", off.count);
    assert!(off.cents < 0.02, "{} cents", off.cents);
    assert!(off.decay < 0.003, "{} of the decay rate", off.decay);
    assert!(off.unexplained_db < -120.0, "{} dB", off.unexplained_db);
    off
}

#[test]
fn partials_are_the_bank_s_at_every_rate() {
    let damping = idiophone::factory::bank(0).damping;
    let levels: Vec<_> = [44_100.0, 48_000.0, 96_000.0, 192_000.0]
        .map(|rate_hz| assert_partials(rate_hz, |mode| mode.decay_per_s(&damping), &[]).strongest())
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
