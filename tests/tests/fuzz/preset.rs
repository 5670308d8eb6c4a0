//! Presets.

use super::case::cases;
use super::mutate;
use idiophone::presets::{Preset, factory};

#[test]
fn no_preset_panics() {
    let goods = factory();
    cases("preset", |noise| {
        let good = &goods[noise.below(goods.len() as u64) as usize];
        let text = mutate::text(noise, &good.text());
        match Preset::read(&text, "fuzz.toml") {
            Ok(preset) => {
                let saved = preset.text();
                let again = Preset::read(&saved, "fuzz.toml").unwrap();
                assert_eq!(again.text(), saved);
                assert_eq!(again.sound, preset.sound);
                true
            }
            Err(broken) => {
                assert!(broken.to_string().contains("fuzz.toml"), "{broken}");
                false
            }
        }
    });
}
