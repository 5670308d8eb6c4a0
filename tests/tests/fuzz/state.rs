//! States as hosts hand them over, to the built plug-in.

use super::bank::small;
use super::case::cases;
use super::mutate;
use idiophone::shelf::{OWN, Own};
use idiophone_tests::plugin;
use serde_json::json;

/// What a state is before its JSON.
const LENGTH: usize = size_of::<u64>();

/// The framework logs every fault that it finds, a hundred thousand a minute.
#[expect(unsafe_code, reason = "the plug-in reads the environment by itself")]
fn hush() {
    // SAFETY: the standard library locks the environment against its own readers, which are all that there
    // are: the plug-in, which has a library of its own, is not loaded yet.
    unsafe { std::env::set_var("NICE_LOG", if cfg!(windows) { "NUL" } else { "/dev/null" }) };
}

#[test]
fn no_state_panics_and_what_is_loaded_is_saved_and_loaded_alike() {
    hush();
    let mut plugin = plugin().unwrap();
    let mut state = plugin.state().unwrap();
    let own = Own::new(small()).unwrap();
    state["params"]["instr"] = json!({"i32": OWN});
    state["fields"]["instrument"] = json!({"name": "own", "title": "Your own"})
        .to_string()
        .into();
    state["fields"]["bank"] = own.text().into();
    state["fields"]["scale"] = json!("a\n2\n3/2\n2/1\n").to_string().into();
    let good = state.to_string();
    // Without the bank, most changes hit something else.
    state["fields"]["bank"] = "{\"layout\":1}".into();
    let short = state.to_string();
    cases("state", |noise| {
        let good = if noise.below(8) == 0 { &good } else { &short };
        let text = mutate::text(noise, good);
        let mut bytes = (text.len() as u64).to_le_bytes().to_vec();
        bytes.extend(text.as_bytes());
        if noise.below(16) == 0 {
            bytes = mutate::bytes(noise, &bytes);
        }
        let loaded = plugin.load(&bytes).is_ok();
        if loaded {
            let saved = plugin.save().unwrap();
            plugin.load(&saved).unwrap();
            let again = plugin.save().unwrap();
            let [first, second] =
                [&saved, &again].map(|bytes| String::from_utf8_lossy(&bytes[LENGTH..]));
            assert!(first == second, "{first}\n{second}");
        }
        loaded
    });
}
