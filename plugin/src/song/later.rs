//! Parameters of later versions, kept for them.
//!
//! The framework saves the parameters that it knows. Others go into a field of their own, from which a
//! version that knows them takes them back.

use super::LATER;
use nice_plug::plugin::ParamValue;
use nice_plug::prelude::PluginState;
use serde_json::{Map, Value};

/// What a field says: values by id; none if it is no such field.
pub(super) fn read(field: &str) -> Option<Map<String, Value>> {
    serde_json::from_str(field).ok()
}

/// Puts parameters that an earlier version kept back among the others, unless they have a value there.
pub(crate) fn recall_known(state: &mut PluginState, known: impl Fn(&str) -> bool) {
    let kept = state.fields.get(LATER).and_then(|field| read(field));
    for (id, value) in kept.unwrap_or_default() {
        if known(&id)
            && let Ok(value) = serde_json::from_value::<ParamValue>(value)
        {
            state.params.entry(id).or_insert(value);
        }
    }
}

/// Writes all parameters that are not known into their field, with those that are there already. A field
/// that cannot be read stays as it is.
pub(crate) fn keep_unknown(state: &mut PluginState, known: impl Fn(&str) -> bool) {
    let field = state.fields.get(LATER);
    let Some(mut later) = field.map_or_else(|| Some(Map::new()), |field| read(field)) else {
        return;
    };
    later.retain(|id, _| !known(id));
    for (id, value) in &state.params {
        if !known(id)
            && let Ok(value) = serde_json::to_value(value)
        {
            later.insert(id.clone(), value);
        }
    }
    if later.is_empty() {
        state.fields.remove(LATER);
    } else {
        let field = Value::Object(later).to_string();
        state.fields.insert(LATER.to_owned(), field);
    }
}

/// Whether a version, as `1.10.2`, comes after another; no if it is no version.
pub(super) fn is_later(version: &str, than: &str) -> bool {
    let parse = |text: &str| -> Option<Vec<u32>> {
        let numbers = text.split(['-', '+']).next()?.split('.');
        numbers.map(|number| number.parse().ok()).collect()
    };
    matches!((parse(version), parse(than)), (Some(a), Some(b)) if a > b)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(params: &[(&str, f32)], field: Option<&str>) -> PluginState {
        let value = |(id, value): &(&str, f32)| ((*id).to_owned(), ParamValue::F32(*value));
        let field = field.map(|field| (LATER.to_owned(), field.to_owned()));
        PluginState {
            version: String::new(),
            params: params.iter().map(value).collect(),
            fields: field.into_iter().collect(),
        }
    }

    #[test]
    fn what_one_version_keeps_the_next_takes_back() {
        let old = |id: &str| id == "gain";
        let new = |id: &str| ["gain", "wobble"].contains(&id);
        let mut saved = state(&[("gain", 1.0), ("wobble", 2.0), ("spin", 3.0)], None);
        keep_unknown(&mut saved, old);
        let kept = saved.fields[LATER].clone();
        assert_eq!(kept, "{\"spin\":{\"f32\":3.0},\"wobble\":{\"f32\":2.0}}");
        let mut again = state(&[("gain", -1.0)], Some(&kept));
        keep_unknown(&mut again, old);
        assert_eq!(again.fields[LATER], kept);
        recall_known(&mut again, new);
        keep_unknown(&mut again, new);
        assert!(matches!(again.params["wobble"], ParamValue::F32(2.0)));
        assert_eq!(again.fields[LATER], "{\"spin\":{\"f32\":3.0}}");
        keep_unknown(&mut again, |_| true);
        assert!(!again.fields.contains_key(LATER));
    }

    #[test]
    fn what_is_there_counts_before_what_was_kept() {
        let mut state = state(&[("gain", 1.0)], Some("{\"gain\":{\"f32\":9.0}}"));
        recall_known(&mut state, |_| true);
        assert!(matches!(state.params["gain"], ParamValue::F32(1.0)));
    }

    #[test]
    fn what_cannot_be_read_stays() {
        for field in ["[1", "7", "{\"a\":{\"f64\":1.5}}"] {
            let mut state = state(&[("gain", 1.0)], Some(field));
            recall_known(&mut state, |_| true);
            keep_unknown(&mut state, |id| id == "gain");
            assert_eq!(state.fields[LATER], field);
        }
    }

    #[test]
    fn versions_are_compared_by_their_numbers() {
        assert!(is_later("0.10.0", "0.9.3") && is_later("1.0.0-beta", "0.9.3"));
        for other in ["0.9.3", "0.9.2", "", "x", "1.x"] {
            assert!(!is_later(other, "0.9.3"), "{other}");
        }
    }
}
