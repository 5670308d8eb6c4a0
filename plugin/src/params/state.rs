//! A saved state made fit to load.

use super::spec::{SPECS, Spec};
use super::text::Text;
use nice_plug::plugin::ParamValue;
use nice_plug::prelude::PluginState;

/// Brings every value into its range and gives every parameter that is missing its default; what is
/// not known stays.
///
/// Hosts hand over what a file says: without this an infinite gain goes through, and a song from
/// before a parameter existed keeps whatever value that parameter had.
pub fn heal(state: &mut PluginState) {
    for spec in &SPECS {
        let healed = healed(spec, state.params.get(spec.id));
        state.params.insert(spec.id.to_owned(), healed);
    }
}

fn healed(spec: &Spec, saved: Option<&ParamValue>) -> ParamValue {
    match (spec.text, saved) {
        (Text::Switch { .. }, Some(ParamValue::Bool(on))) => ParamValue::Bool(*on),
        (Text::Switch { .. }, _) => ParamValue::Bool(spec.default >= 0.5),
        (Text::Instrument, Some(ParamValue::I32(index))) => {
            ParamValue::I32(spec.sane(*index as f32) as i32)
        }
        (Text::Instrument, _) => ParamValue::I32(spec.default as i32),
        (_, Some(ParamValue::F32(value))) if value.is_finite() => {
            ParamValue::F32(spec.sane(*value))
        }
        _ => ParamValue::F32(spec.default),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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

    fn number(params: &BTreeMap<String, ParamValue>, id: &str) -> f32 {
        match params.get(id) {
            Some(ParamValue::F32(value)) => *value,
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
        ]);
        let last = SPECS[0].max as i32;
        assert!(matches!(params.get("instr"), Some(ParamValue::I32(index)) if *index == last));
        assert_eq!(number(&params, "gain"), 0.0);
        assert_eq!(number(&params, "alpha1"), 0.0);
        assert_eq!(number(&params, "alpha2"), 100.0);
        assert_eq!(number(&params, "width"), 100.0);
        assert_eq!(number(&params, "pos"), 40.0);
        assert_eq!(
            number(&params, "hard"),
            crate::params::MALLET_HARDNESS.default
        );
        assert!(matches!(params.get("noff"), Some(ParamValue::Bool(false))));
        assert!(matches!(params.get("later"), Some(ParamValue::I32(3))));
        assert_eq!(params.len(), SPECS.len() + 1);
    }
}
