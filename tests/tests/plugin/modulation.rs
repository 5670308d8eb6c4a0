//! What a host modulates for one note changes that note alone, and as much as it says.

use idiophone_tests::chime::{bent, off};
use idiophone_tests::{peak, plugin, plugin_with, strike};
use xtask::host::{Event, ParamId, TimedEvent};

const FRAMES: usize = 9600;
/// −60 dB: what is weaker than this beside the strongest partial is not measured.
const FAINT: f64 = 1e-3;
const KEY: u8 = 74;
const OTHER: u8 = 81;

fn parameter(name: &str) -> ParamId {
    let params = plugin().unwrap().params();
    params.iter().find(|param| param.name == name).unwrap().id
}

fn modulation(id: ParamId, key: u8, amount: f64) -> Event {
    Event::Modulation {
        id,
        note_id: u32::from(key),
        amount,
    }
}

fn sound(settings: &[&str], events: &[TimedEvent]) -> Vec<f32> {
    let mut plugin = plugin_with(settings).unwrap();
    plugin.activate(48_000.0, 512).unwrap();
    plugin.play(events, FRAMES, 512).unwrap().left
}

/// Greatest difference of `a` and the sum of `b` and `c`.
fn apart(a: &[f32], b: &[f32], c: &[f32]) -> f32 {
    let sum = b.iter().zip(c).map(|(b, c)| b + c);
    a.iter()
        .zip(sum)
        .fold(0.0, |most, (a, sum)| most.max((a - sum).abs()))
}

#[test]
fn only_the_addressed_note_changes() {
    let (one, other) = (strike(KEY, 0.8).at(0), strike(OTHER, 0.8).at(0));
    for (name, amount) in [
        ("Strike position", 0.3),
        ("Mallet hardness", -0.5),
        ("Alpha 2", 0.5),
    ] {
        let modulated = modulation(parameter(name), OTHER, amount).at(0);
        let alone = sound(&[], &[one]);
        let plain = sound(&[], &[other]);
        let moved = sound(&[], &[other, modulated]);
        let both = sound(&[], &[one, other, modulated]);
        let level = peak(&plain);
        assert!(
            apart(&moved, &plain, &[0.0; FRAMES]) > 0.01 * level,
            "{name}"
        );
        let off = apart(&both, &alone, &moved);
        assert!(off < 1e-6, "{name}: {off} beside a peak of {level}");
        // The next note of that key is as the parameters have it, whatever was said of the last.
        let again = Event::NoteOn {
            channel: 0,
            key: OTHER,
            note_id: 7,
            velocity: 0.8,
        };
        let next = sound(&[], &[modulated, again.at(0)]);
        assert_eq!(next, plain, "{name}");
    }
}

/// Modulation is in the host's units of the parameter.
#[test]
fn a_modulated_note_sounds_as_if_the_parameter_were_there() {
    let other = strike(OTHER, 0.8).at(0);
    let close = |a: &[f32], b: &[f32], what: &str| {
        let off = apart(a, b, &[0.0; FRAMES]) / peak(b);
        assert!(off < 2e-4, "{what}: {off}");
    };
    let position = modulation(parameter("Strike position"), OTHER, 0.25).at(0);
    let moved = sound(&["Strike position=10 %"], &[other, position]);
    close(
        &moved,
        &sound(&["Strike position=35 %"], &[other]),
        "position",
    );
    let far = modulation(parameter("Strike position"), OTHER, 1.0).at(0);
    let moved = sound(&["Strike position=10 %"], &[other, far]);
    close(
        &moved,
        &sound(&["Strike position=100 %"], &[other]),
        "the end",
    );
    let mut plugin = plugin().unwrap();
    let id = parameter("Mallet hardness");
    let [soft, hard] = ["20 MPa", "2 GPa"].map(|text| plugin.parse(id, text).unwrap());
    let harder = modulation(id, OTHER, hard - soft).at(0);
    let moved = sound(&["Mallet hardness=20 MPa"], &[other, harder]);
    close(
        &moved,
        &sound(&["Mallet hardness=2 GPa"], &[other]),
        "hardness",
    );
}

#[test]
fn damping_is_modulated_while_it_rings_both_ways() {
    let id = parameter("Alpha 2");
    let mut plugin = plugin().unwrap();
    let [five, twenty] = ["5 1/s", "20 1/s"].map(|text| plugin.parse(id, text).unwrap());
    let struck = [strike(KEY, 0.8).at(0)];
    for (what, set, amount, per_s) in [
        ("more", "Alpha 2=5 1/s", twenty - five, 10.0),
        ("less", "Alpha 2=20 1/s", five - twenty, 2.5),
        ("none", "Alpha 2=20 1/s", -1.0, 0.0),
    ] {
        let mut events = struck.to_vec();
        events.push(modulation(id, KEY, amount).at(1200));
        let sound = sound(&[set], &events);
        let off = off(&sound[2400..], 48_000.0, &bent(KEY, 0.0, per_s), FAINT);
        println!("{what}: {:.1e} of the decay off", off.decay);
        assert!(off.decay < 0.02, "{what}: {}", off.decay);
        assert!(off.unexplained_db < -60.0, "{what}: {}", off.unexplained_db);
    }
}
