//! Everything that a host keeps in a song, and goes back into it untouched if this version does not know it.

mod later;
mod wish;

pub(crate) use later::{keep_unknown, recall_known};
pub(crate) use wish::resolve;

use crate::notices::{Cure, Notice, Subject};
use crate::params::Controls;
use crate::shelf::OwnError;
use nice_plug::prelude::{ParamPtr, Params};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use wish::Wish;

/// Field of the instrument's name.
const INSTRUMENT: &str = "instrument";
/// Field of the user's own bank.
const BANK: &str = "bank";
/// Field of the bank that was solved for the knobs of the drawing.
const SHAPED: &str = "shaped";
/// Field of parameters that this version does not know.
const LATER: &str = "later";
/// Field by which [`crate::params::heal`] tells which version saved a song; songs have none.
const SAVED_BY: &str = "saved by";

/// The parameters and the fields beside them.
pub(crate) struct Song {
    /// Parameters, and fields of one value each.
    params: Arc<dyn Params>,
    controls: Arc<Controls>,
    /// Fields that this version does not know, or not any longer as they are.
    unknown: Mutex<BTreeMap<String, String>>,
}

impl Song {
    /// Of the parameters and fields in `params`, which hold those of `controls`.
    pub(crate) fn new(params: Arc<dyn Params>, controls: Arc<Controls>) -> Self {
        Self {
            params,
            controls,
            unknown: Mutex::default(),
        }
    }

    fn unknown(&self) -> MutexGuard<'_, BTreeMap<String, String>> {
        self.unknown.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The instrument that the song wants.
    fn take_wish(&self, fields: &BTreeMap<String, String>, saved_by: Option<&str>) {
        let field = fields.get(INSTRUMENT);
        let wish = field.and_then(|field| Wish::read(field));
        let unmet = wish.filter(|wish| wish.index().is_none());
        self.controls.notices().clear(Subject::Instrument);
        if let Some(wish) = &unmet {
            self.controls.notices().post(Notice {
                subject: Subject::Instrument,
                text: format!(
                    "This song plays {}, which this version does not have: update Idiophone{}. {} plays \
                     instead; the song keeps its choice.",
                    wish.title(),
                    saved_by.map_or_else(String::new, |version| format!(" to {version}")),
                    Wish::of(0).title(),
                ),
                cure: Some(Cure::Stay),
            });
        }
        // Word for word: there may be more to it than this version reads.
        self.controls.wish_for(unmet.and(field.cloned()));
    }

    /// The user's own bank.
    fn take_bank(&self, field: Option<&str>) {
        let notices = self.controls.notices();
        notices.clear(Subject::Bank);
        if let Err(error) = self.controls.shelf().restore(field) {
            notices.post(Notice {
                subject: Subject::Bank,
                text: format!(
                    "The song's own instrument cannot be read: {error}. The song keeps it as it is."
                ),
                cure: Some(Cure::Load(title(&error))),
            });
        }
    }

    /// Parameters and fields of a later version.
    fn take_unknown(&self, fields: &BTreeMap<String, String>, saved_by: Option<&str>) {
        let known = self.params.serialize_fields();
        let ours = |key: &str| {
            known.contains_key(key) || [INSTRUMENT, BANK, SHAPED, SAVED_BY].contains(&key)
        };
        let unknown: BTreeMap<String, String> = fields
            .iter()
            .filter(|(key, _)| !ours(key))
            .map(|(key, field)| (key.clone(), field.clone()))
            .collect();
        let later = unknown.get(LATER).and_then(|field| later::read(field));
        let params = later.map_or(0, |later| later.len());
        let fields = unknown.keys().filter(|key| *key != LATER).count();
        let count = params + fields;
        self.controls.notices().clear(Subject::Song);
        if count > 0 {
            let who = saved_by.map_or_else(
                || "another version of Idiophone".to_owned(),
                |version| format!("Idiophone {version}"),
            );
            let (settings, are) = if count == 1 {
                ("setting", "is")
            } else {
                ("settings", "are")
            };
            self.controls.notices().post(Notice {
                subject: Subject::Song,
                text: format!(
                    "This song was saved by {who}: {count} {settings} of it {are} not known here, and \
                     stay in the song."
                ),
                cure: None,
            });
        }
        *self.unknown() = unknown;
    }
}

/// What a song calls a bank that cannot be read.
fn title(error: &OwnError) -> String {
    match error {
        OwnError::Bank { title, .. }
        | OwnError::Silent { title }
        | OwnError::Large { title, .. }
        | OwnError::Newer { title, .. }
        | OwnError::Damaged { title, .. } => title.clone(),
        OwnError::File(_) | OwnError::Copy { .. } => String::new(),
    }
}

// SAFETY: the pointers are those of `params`, which this holds.
#[expect(unsafe_code, reason = "the framework's trait is so")]
unsafe impl Params for Song {
    fn param_map(&self) -> Vec<(String, ParamPtr, String)> {
        self.params.param_map()
    }

    fn serialize_fields(&self) -> BTreeMap<String, String> {
        let mut fields = self.params.serialize_fields();
        for (key, field) in &*self.unknown() {
            fields.entry(key.clone()).or_insert_with(|| field.clone());
        }
        let index = self.controls.body.index();
        // Once another instrument is chosen than the one that stands in, that is what is wished for.
        let wish = self.controls.wish().filter(|_| index == 0);
        let instrument = wish.unwrap_or_else(|| Wish::of(index).write());
        fields.insert(INSTRUMENT.to_owned(), instrument);
        if let Some(bank) = self.controls.shelf().text() {
            fields.insert(BANK.to_owned(), bank);
        }
        let number = self.controls.shelf().number(index);
        if let Some(own) = self.controls.shaped(number) {
            fields.insert(SHAPED.to_owned(), own.text().to_owned());
        }
        fields
    }

    fn deserialize_fields(&self, fields: &BTreeMap<String, String>) {
        self.params.deserialize_fields(fields);
        let saved_by = fields.get(SAVED_BY).map(String::as_str);
        self.take_wish(fields, saved_by);
        self.take_bank(fields.get(BANK).map(String::as_str));
        let shaped = fields.get(SHAPED).map(String::as_str);
        self.controls.solved().restore(shaped);
        self.take_unknown(fields, saved_by);
    }
}

/// Notes in a song's fields which version saved it, if that is later than this one; else nothing.
pub(crate) fn note_version(version: &str, fields: &mut BTreeMap<String, String>) {
    fields.remove(SAVED_BY);
    if later::is_later(version, env!("CARGO_PKG_VERSION")) {
        fields.insert(SAVED_BY.to_owned(), version.to_owned());
    }
}

#[cfg(test)]
mod tests;
