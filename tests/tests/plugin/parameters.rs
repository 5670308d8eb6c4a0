//! What a host's generic interface shows.

use idiophone_tests::plugin;
use std::collections::HashSet;
use xtask::host::{Param, Plugin};
use xtask::settings;

fn shown(plugin: &mut Plugin) -> Vec<Param> {
    let params = plugin.params();
    params.into_iter().filter(|param| !param.hidden).collect()
}

#[test]
fn names_are_there_once() {
    let mut plugin = plugin().unwrap();
    let params = shown(&mut plugin);
    let names: HashSet<_> = params.iter().map(|param| &param.name).collect();
    let ids: HashSet<_> = params.iter().map(|param| param.id).collect();
    assert_eq!(names.len(), params.len());
    assert_eq!(ids.len(), params.len());
    assert!(params.iter().all(|param| param.automatable));
    for wanted in ["Strike position", "Mallet hardness", "α1", "α2", "Output"] {
        settings::find(&params, wanted).unwrap();
    }
}

#[test]
fn numbers_have_units() {
    let mut plugin = plugin().unwrap();
    for param in shown(&mut plugin) {
        let text = plugin.text(param.id, param.default).unwrap();
        if text.starts_with(|c: char| c.is_ascii_digit() || c == '-') {
            let unit = text.trim_start_matches(|c: char| c.is_ascii_digit() || "-+.e ".contains(c));
            assert!(!unit.is_empty(), "{}: {text}", param.name);
        }
    }
}

/// A text that the plug-in wrote must mean, read back, what is written the same way.
#[test]
fn texts_read_back() {
    const STEPS: usize = 10;
    let mut plugin = plugin().unwrap();
    for param in shown(&mut plugin) {
        for step in 0..=STEPS {
            let share = step as f64 / STEPS as f64;
            let mut value = param.min + share * (param.max - param.min);
            if param.stepped {
                value = value.round();
            }
            let text = plugin.text(param.id, value).unwrap();
            let read = plugin.parse(param.id, &text);
            let read = read.unwrap_or_else(|| panic!("{}: {text} is refused", param.name));
            let again = plugin.text(param.id, read).unwrap();
            assert_eq!(text, again, "{}", param.name);
            let off = (read - value).abs() / (param.max - param.min);
            assert!(off < 5e-3, "{}: {text} is {off} off", param.name);
        }
    }
}

#[test]
fn values_set_are_values_held() {
    let mut plugin = plugin().unwrap();
    for param in shown(&mut plugin) {
        for value in [param.max, param.min, param.default] {
            plugin.set(&[(param.id, value)]).unwrap();
            let held = plugin.value(param.id).unwrap();
            let off = (held - value).abs() / (param.max - param.min);
            assert!(off < 1e-6, "{}: {held} for {value}", param.name);
        }
    }
}

#[test]
fn settings_are_read_as_shown_or_refused() {
    let mut plugin = plugin().unwrap();
    let params = shown(&mut plugin);
    for param in &params {
        for value in [param.min, param.default, param.max] {
            let text = plugin.text(param.id, value).unwrap();
            let setting = format!("{}={text}", param.name);
            let (id, read) = settings::setting(&mut plugin, &setting).unwrap();
            assert_eq!(id, param.id);
            assert!(
                (read - value).abs() < 5e-3 * (param.max - param.min),
                "{setting}"
            );
        }
    }
    let says = |plugin: &mut Plugin, text: &str| {
        format!("{:#}", settings::setting(plugin, text).unwrap_err())
    };
    let unknown = says(&mut plugin, "Reverb=1");
    assert!(
        params.iter().all(|param| unknown.contains(&param.name)),
        "{unknown}"
    );
    for (name, value) in [("Alpha 1", "-1 s"), ("Alpha 1", "1 s"), ("Alpha 1", "much")] {
        let param = settings::find(&params, name).unwrap();
        let error = says(&mut plugin, &format!("{name}={value}"));
        let least = plugin.text(param.id, param.min).unwrap();
        let greatest = plugin.text(param.id, param.max).unwrap();
        assert!(
            error.contains(&least) && error.contains(&greatest),
            "{error}"
        );
        assert!(!error.contains('\n'), "{error}");
    }
    assert!(settings::automation(&mut plugin, "Alpha 2@0:1 1/s,0.5:2 1/s").is_ok());
    for bad in [
        "Alpha 2@x:1",
        "Alpha 2@1",
        "Alpha 2@-1:1",
        "Alpha 2:1",
        "Alpha 2@0:-5",
    ] {
        assert!(settings::automation(&mut plugin, bad).is_err(), "{bad}");
    }
}
