//! A saved state made fit to load.

use super::spec::{Spec, specs};
use super::text::Text;
use super::trims::Words;
use crate::song;
use nice_plug::params::persist::deserialize_field;
use nice_plug::plugin::ParamValue;
use nice_plug::prelude::PluginState;

/// The texts of the tuning.
const TEXTS: [&str; 2] = ["scale", "kbm"];

/// Which preset was chosen, if any: its key, whether it is changed, and whether it brought the tuning.
#[cfg(feature = "gui")]
const PRESET: &str = "preset";

/// Brings every value into its range and gives every parameter that is missing its default; what is
/// not known stays, and has its copy among the fields. A tuning that is missing is none, and so are a preset and
/// trims that nobody can read. The instrument is found by its name, where the state has that.
///
/// Hosts hand over what a file says: without this an infinite gain goes through, and a song from
/// before a parameter existed keeps whatever value that parameter had.
pub fn heal(state: &mut PluginState) {
    song::note_version(&state.version, &mut state.fields);
    song::recall_known(state, is_known);
    song::resolve(state);
    for spec in specs() {
        let healed = healed(spec, state.params.get(spec.id));
        state.params.insert(spec.id.to_owned(), healed);
    }
    for text in TEXTS {
        let field = state.fields.entry(text.to_owned()).or_default();
        if deserialize_field::<String>(field).is_err() {
            // An empty text as JSON.
            "\"\"".clone_into(field);
        }
    }
    #[cfg(feature = "gui")]
    heal_preset(state);
    let field = state.fields.entry("trims".to_owned()).or_default();
    if deserialize_field::<Words>(field).is_err() {
        "[]".clone_into(field);
    }
    song::keep_unknown(state, is_known);
}

/// A song from before presets has none.
#[cfg(feature = "gui")]
fn heal_preset(state: &mut PluginState) {
    let field = state.fields.entry(PRESET.to_owned()).or_default();
    if deserialize_field::<(String, bool, bool)>(field).is_err() {
        // None, as JSON.
        "[\"\",false,false]".clone_into(field);
    }
}

fn is_known(id: &str) -> bool {
    specs().any(|spec| spec.id == id)
}

fn healed(spec: &Spec, saved: Option<&ParamValue>) -> ParamValue {
    match (spec.text, saved) {
        (Text::Switch { .. }, Some(ParamValue::Bool(on))) => ParamValue::Bool(*on),
        (Text::Switch { .. }, _) => ParamValue::Bool(spec.default >= 0.5),
        (Text::Choice(_), Some(ParamValue::I32(index))) => {
            ParamValue::I32(spec.sane(*index as f32) as i32)
        }
        (Text::Choice(_), _) => ParamValue::I32(spec.default as i32),
        (_, Some(ParamValue::F32(value))) if value.is_finite() => {
            ParamValue::F32(spec.sane(*value))
        }
        _ => ParamValue::F32(spec.default),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hands::{Mpe, Source};
    use crate::params::mallet::HARDNESS;
    use std::collections::BTreeMap;

    fn loaded(params: &[(&str, ParamValue)]) -> BTreeMap<String, ParamValue> {
        let mut state = PluginState {
            version: String::new(),
            params: params
                .iter()
                .map(|(id, value)| ((*id).to_owned(), value.clone()))
                .collect(),
            fields: BTreeMap::new(),
        };
        heal(&mut state);
        state.params
    }

    #[test]
    fn a_state_without_texts_of_a_tuning_has_empty_ones() {
        let field = |text: &str| {
            let mut state = PluginState {
                version: String::new(),
                params: BTreeMap::new(),
                fields: BTreeMap::from([("scale".to_owned(), text.to_owned())]),
            };
            heal(&mut state);
            (state.fields["scale"].clone(), state.fields["kbm"].clone())
        };
        let (scale, map) = field("\"a\\n1\\n2/1\"");
        assert_eq!((scale.as_str(), map.as_str()), ("\"a\\n1\\n2/1\"", "\"\""));
        assert_eq!(field("7").0, "\"\"");
    }

    #[cfg(feature = "gui")]
    #[test]
    fn a_song_from_before_presets_has_none_and_one_with_a_preset_keeps_it() {
        let field = |saved: Option<&str>| {
            let saved = saved.map(|text| (PRESET.to_owned(), text.to_owned()));
            let mut state = PluginState {
                version: String::new(),
                params: BTreeMap::new(),
                fields: saved.into_iter().collect(),
            };
            heal(&mut state);
            deserialize_field::<(String, bool, bool)>(&state.fields[PRESET]).unwrap()
        };
        assert_eq!(field(None), (String::new(), false, false));
        assert_eq!(field(Some("[3]")), (String::new(), false, false));
        let mine = ("user/A.toml".to_owned(), true, false);
        assert_eq!(field(Some("[\"user/A.toml\",true,false]")), mine);
    }

    #[test]
    fn trims_that_nobody_can_read_are_none() {
        let label = r#"{"family":"torsion","order":0,"index":2,"member":"single"}"#;
        let good = format!("[[{label},-6.0,2.0]]");
        for (saved, healed) in [(Some(&*good), &*good), (Some("[[7]]"), "[]"), (None, "[]")] {
            let fields = saved.map(|text| ("trims".to_owned(), text.to_owned()));
            let mut state = PluginState {
                version: String::new(),
                params: BTreeMap::new(),
                fields: fields.into_iter().collect(),
            };
            heal(&mut state);
            assert_eq!(state.fields["trims"], healed);
        }
    }

    fn number(params: &BTreeMap<String, ParamValue>, id: &str) -> f32 {
        match params.get(id) {
            Some(ParamValue::F32(value)) => *value,
            other => panic!("{id} is {other:?}"),
        }
    }

    fn chosen(params: &BTreeMap<String, ParamValue>, id: &str) -> i32 {
        match params.get(id) {
            Some(ParamValue::I32(value)) => *value,
            other => panic!("{id} is {other:?}"),
        }
    }

    #[test]
    fn wild_values_are_tamed_and_missing_ones_supplied() {
        let params = loaded(&[
            ("gain", ParamValue::F32(f32::INFINITY)),
            ("alpha1", ParamValue::F32(-5.0)),
            ("alpha2", ParamValue::F32(1e30)),
            ("width", ParamValue::Bool(true)),
            ("noff", ParamValue::F32(1.0)),
            ("pos", ParamValue::F32(40.0)),
            ("later", ParamValue::I32(3)),
            ("instr", ParamValue::I32(99)),
            ("mallet", ParamValue::I32(i32::MIN)),
            ("src_1", ParamValue::F32(2.0)),
            ("tgt_8", ParamValue::I32(3)),
            ("limit", ParamValue::I32(0)),
        ]);
        assert_eq!(chosen(&params, "instr"), 0, "the first stands in");
        assert_eq!(number(&params, "gain"), 0.0);
        assert_eq!(number(&params, "alpha1"), 0.0);
        assert_eq!(number(&params, "alpha2"), 100.0);
        assert_eq!(number(&params, "width"), 100.0);
        assert_eq!(number(&params, "pos"), 40.0);
        assert_eq!(number(&params, "hard"), HARDNESS.default);
        assert_eq!(number(&params, "dep_2"), 50.0);
        assert_eq!(chosen(&params, "mallet"), 0);
        assert_eq!(chosen(&params, "src_1"), Source::Expression as i32);
        assert_eq!(chosen(&params, "tgt_8"), 3);
        assert_eq!(chosen(&params, "mpe"), Mpe::Auto as i32);
        assert!(matches!(params.get("limit"), Some(ParamValue::Bool(true))));
        assert!(matches!(params.get("noff"), Some(ParamValue::Bool(false))));
        assert!(matches!(params.get("later"), Some(ParamValue::I32(3))));
        assert_eq!(params.len(), specs().count() + 1);
    }
}
