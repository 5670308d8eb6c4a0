//! What a host keeps in a project.

use idiophone_tests::{Noise, peak, plugin, strike};
use xtask::host::Plugin;

fn values(plugin: &mut Plugin) -> Vec<f64> {
    let params = plugin.params();
    params
        .iter()
        .map(|param| plugin.value(param.id).unwrap())
        .collect()
}

/// An instance with every parameter off its default, and its values.
fn changed() -> (Plugin, Vec<f64>) {
    let mut plugin = plugin().unwrap();
    let mut noise = Noise::new(5);
    for param in plugin.params() {
        let value = param.min + noise.unit() * (param.max - param.min);
        let value = if param.stepped { value.round() } else { value };
        plugin.set(&[(param.id, value)]).unwrap();
    }
    let values = values(&mut plugin);
    (plugin, values)
}

fn differ(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).any(|(a, b)| (a - b).abs() > 1e-6)
}

#[test]
fn a_state_comes_back_in_another_instance() {
    let (mut first, wanted) = changed();
    let state = first.save().unwrap();
    let mut second = plugin().unwrap();
    assert!(differ(&values(&mut second), &wanted));
    second.load(&state).unwrap();
    assert!(!differ(&values(&mut second), &wanted));
    assert_eq!(second.save().unwrap(), state);
}

#[test]
fn a_state_comes_back_while_playing() {
    let (mut first, wanted) = changed();
    let state = first.save().unwrap();
    let mut second = plugin().unwrap();
    second.activate(48_000.0, 512).unwrap();
    second.play(&[strike(74, 0.8).at(0)], 4800, 512).unwrap();
    second.load(&state).unwrap();
    second.play(&[strike(74, 0.8).at(0)], 4800, 512).unwrap();
    assert!(!differ(&values(&mut second), &wanted));
}

#[test]
fn a_state_sounds_as_it_did() {
    let (mut first, _) = changed();
    let state = first.save().unwrap();
    let mut second = plugin().unwrap();
    second.load(&state).unwrap();
    let sound = |plugin: &mut Plugin| {
        plugin.activate(48_000.0, 512).unwrap();
        plugin
            .play(&[strike(74, 0.8).at(0)], 4800, 512)
            .unwrap()
            .left
    };
    assert_eq!(sound(&mut first), sound(&mut second));
}

/// Every value is within its range and the sound is finite (`play` sees to that).
fn assert_sane(plugin: &mut Plugin, case: &str) {
    for param in plugin.params() {
        let value = plugin.value(param.id).unwrap();
        assert!(
            (param.min..=param.max).contains(&value),
            "{case}: {} is {value}",
            param.name
        );
    }
    plugin.activate(48_000.0, 512).unwrap();
    let take = plugin.play(&[strike(74, 1.0).at(0)], 9600, 512).unwrap();
    assert!(peak(&take.left) < 100.0, "{case}");
    plugin.deactivate();
}

#[test]
fn what_is_no_state_is_refused() {
    let (mut plugin, before) = changed();
    let state = plugin.save().unwrap();
    let mut broken = state.clone();
    broken[8] ^= 1;
    let mut huge = state.clone();
    huge[..8].fill(0xFF);
    let mut garbled = state.clone();
    let mut noise = Noise::new(9);
    garbled[8..].fill_with(|| noise.data_byte());
    let cases: [(&str, &[u8]); 5] = [
        ("nothing", &[]),
        ("cut short", &state[..state.len() / 2]),
        ("a flipped bit", &broken),
        ("a huge length", &huge),
        ("noise", &garbled),
    ];
    for (case, bytes) in cases {
        assert!(plugin.load(bytes).is_err(), "{case}");
        assert!(!differ(&values(&mut plugin), &before), "{case}");
        assert_sane(&mut plugin, case);
    }
}

#[test]
fn values_out_of_range_and_missing_ones_are_healed() {
    let (mut plugin, _) = changed();
    let json = plugin.state().unwrap();
    let names: Vec<_> = json["params"]
        .as_object()
        .unwrap()
        .keys()
        .cloned()
        .collect();
    for number in [1e39, -1e39, -5.0, 1e30] {
        let mut json = json.clone();
        for name in &names {
            for value in json["params"][name].as_object_mut().unwrap().values_mut() {
                if value.is_f64() {
                    *value = number.into();
                }
            }
        }
        // Refused is as good as clamped.
        let _ = plugin.load_state(&json);
        assert_sane(&mut plugin, &number.to_string());
    }
    let mut json = json.clone();
    json["params"] = serde_json::json!({});
    plugin.load_state(&json).unwrap();
    for param in plugin.params() {
        let value = plugin.value(param.id).unwrap();
        let off = (value - param.default).abs() / (param.max - param.min);
        assert!(off < 1e-6, "{} is {value} without a word of it", param.name);
    }
}
