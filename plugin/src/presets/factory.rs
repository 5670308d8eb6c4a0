//! The presets that come with the plug-in, inside it.

use super::preset::Preset;
use crate::params::body::INSTRUMENT;
use std::sync::{Arc, OnceLock};

/// One preset: its file's name, and its content.
type Entry = (&'static str, &'static str);

include!(concat!(env!("OUT_DIR"), "/presets.rs"));

/// The factory's presets, instrument by instrument and by name, read once for all instances.
///
/// # Panics
///
/// Never: a test reads them all.
pub fn factory() -> &'static [Arc<Preset>] {
    static READ: OnceLock<Vec<Arc<Preset>>> = OnceLock::new();
    READ.get_or_init(|| {
        let read =
            |(file, text): &Entry| Preset::read(text, file).expect("the factory's are whole");
        let mut presets: Vec<_> = FILES.iter().map(read).map(Arc::new).collect();
        let instrument = |preset: &Arc<Preset>| preset.sound.get(INSTRUMENT.id).unwrap_or_default();
        presets.sort_by(|a, b| instrument(a).total_cmp(&instrument(b)));
        presets
    })
}

#[cfg(test)]
mod tests {
    use super::{FILES, Preset, factory};
    use crate::factory::titles;
    use modes::tuning::Scale;
    use std::collections::HashSet;

    #[test]
    fn every_file_is_understood_to_the_last_line_and_has_a_whole_card() {
        for (file, text) in FILES {
            let preset = Preset::read(text, file).unwrap();
            assert_eq!(preset.notices, [], "{file}");
            let card = &preset.card;
            let stem = file.strip_suffix(".toml").unwrap();
            let words: String = card
                .name
                .to_lowercase()
                .replace(['\'', ','], "")
                .replace(' ', "-");
            assert!(stem.ends_with(&words), "{file} is {}", card.name);
            assert!(
                !card.category.is_empty() && !card.author.is_empty(),
                "{file}"
            );
            assert!((2..=6).contains(&card.tags.len()), "{file}");
            assert!(card.about.len() > 20 && card.about.ends_with('.'), "{file}");
            assert!(preset.sound.get("instr").is_some(), "{file}");
            let scale = preset.sound.scala.scale.as_bytes();
            assert!(scale.is_empty() || Scale::parse(scale).is_ok(), "{file}");
        }
    }

    #[test]
    fn names_differ_and_every_instrument_has_several() {
        let names: HashSet<_> = factory().iter().map(|preset| &preset.card.name).collect();
        assert_eq!(names.len(), factory().len());
        assert!(factory().len() >= 44, "{}", factory().len());
        for title in titles() {
            let count = factory()
                .iter()
                .filter(|preset| preset.instrument() == title)
                .count();
            assert!(count >= 4, "{title}: {count}");
        }
    }

    /// Bodies are an octave lower at twice the size, at four times the density and at a quarter of the
    /// stiffness.
    #[test]
    fn keys_stay_in_tune_but_for_octaves() {
        for preset in factory() {
            let get = |id| f64::from(preset.sound.get(id).unwrap_or(1.0));
            let ratio = (get("stiff") / get("dens")).sqrt() / get("size");
            let octaves = ratio.log2();
            let cents = 1200.0 * (octaves - octaves.round());
            assert!(cents.abs() < 1.0, "{}: {cents} cents", preset.card.name);
        }
    }

    #[test]
    fn no_two_sound_alike() {
        for (number, preset) in factory().iter().enumerate() {
            for other in &factory()[..number] {
                let differs = preset.sound != other.sound;
                assert!(differs, "{} and {}", preset.card.name, other.card.name);
            }
        }
    }
}
