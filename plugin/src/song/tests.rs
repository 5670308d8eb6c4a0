//! Songs come back as they were, whoever saved them.

use super::*;
use crate::params::heal;
use crate::shelf::{OWN, Own};
use nice_plug::plugin::ParamValue;
use nice_plug::prelude::{Param, PluginState};

/// An instance's end of the host.
struct Instance {
    controls: Arc<Controls>,
    song: Song,
}

impl Instance {
    fn new() -> Self {
        let controls = Arc::<Controls>::default();
        #[cfg(feature = "gui")]
        let params = crate::editor::Desk::default().params(&controls);
        #[cfg(not(feature = "gui"))]
        let params: Arc<dyn Params> = controls.clone();
        let song = Song::new(params, Arc::clone(&controls));
        Self { controls, song }
    }

    /// As the framework loads.
    fn load(&self, state: &PluginState) {
        let mut state = state.clone();
        heal(&mut state);
        if let Some(ParamValue::I32(number)) = state.params.get("instr") {
            self.choose(usize::try_from(*number).unwrap());
        }
        self.song.deserialize_fields(&state.fields);
    }

    fn choose(&self, index: usize) {
        let pointer = self.song.param_map()[0].1;
        // SAFETY: the controls are alive.
        #[expect(unsafe_code, reason = "the framework hands out raw pointers")]
        unsafe {
            pointer._internal_set_normalized_value(index as f32 / OWN as f32);
        }
    }

    /// As the framework saves, but for the parameters.
    fn save(&self) -> PluginState {
        let number = self.controls.body.index() as i32;
        state(
            &[("instr", ParamValue::I32(number))],
            &self.song.serialize_fields(),
        )
    }

    fn notices(&self) -> Vec<String> {
        let notices = self.controls.notices().all().into_iter();
        notices.map(|notice| notice.text).collect()
    }
}

fn state(params: &[(&str, ParamValue)], fields: &BTreeMap<String, String>) -> PluginState {
    let owned = |(id, value): &(&str, ParamValue)| ((*id).to_owned(), value.clone());
    PluginState {
        version: "999.1.0".to_owned(),
        params: params.iter().map(owned).collect(),
        fields: fields.clone(),
    }
}

fn fields(pairs: &[(&str, &str)]) -> BTreeMap<String, String> {
    let owned = |(key, field): &(&str, &str)| ((*key).to_owned(), (*field).to_owned());
    pairs.iter().map(owned).collect()
}

fn chimes_body(name: &str) -> Own {
    crate::shelf::small(name)
}

#[test]
fn an_own_instrument_travels_and_is_saved_word_for_word() {
    let first = Instance::new();
    first.controls.shelf().put(chimes_body("bell"));
    first.choose(OWN);
    let saved = first.save();
    assert!(saved.fields[INSTRUMENT].contains("\"own\""));
    let second = Instance::new();
    second.load(&saved);
    assert_eq!(second.controls.body.index(), OWN);
    assert_eq!(second.controls.shelf().own().unwrap().title(), "The bell");
    assert_eq!(second.song.serialize_fields(), saved.fields);
    assert_eq!(second.notices(), [""; 0]);
    second.load(&Instance::new().save());
    assert!(
        second.controls.shelf().own().is_none(),
        "that song had none"
    );
}

#[test]
fn a_drawing_travels_solved_and_only_while_it_is_wanted() {
    let first = Instance::new();
    first.controls.shelf().put(chimes_body("bell"));
    first.choose(OWN);
    let shape = &first.controls.shape;
    let number = first.controls.shelf().number(OWN);
    let turn = |controls: &Controls, share: f32| {
        // SAFETY: the controls are alive.
        #[expect(unsafe_code, reason = "the framework hands out raw pointers")]
        unsafe {
            controls
                .shape
                .wall
                .as_ptr()
                ._internal_set_normalized_value(share);
        }
    };
    turn(&first.controls, 1.0);
    assert!(
        !first.save().fields.contains_key(SHAPED),
        "nothing is solved"
    );
    let own = first.controls.shelf().own().unwrap();
    let mut bank = own.bank().clone();
    let recipe = crate::maker::recipe_of(&bank).unwrap();
    bank.provenance.recipe = shape.drawing().apply(&recipe).unwrap().text;
    first.controls.solved().put(Own::new(bank.clone()).unwrap());
    let saved = first.save();
    let second = Instance::new();
    second.load(&saved);
    let reached = second.controls.shelf().number(OWN);
    assert!(
        second.controls.shaped(reached).is_none(),
        "its knob is not turned"
    );
    turn(&second.controls, 1.0);
    assert_eq!(second.controls.shaped(reached).unwrap().bank(), &bank);
    assert_eq!(second.save().fields[SHAPED], saved.fields[SHAPED]);
    turn(&first.controls, 0.5);
    assert!(first.controls.shaped(number).is_none());
    second.load(&Instance::new().save());
    assert!(!second.save().fields.contains_key(SHAPED));
}

#[test]
fn instruments_are_found_by_name_when_numbers_have_moved() {
    let instance = Instance::new();
    let named = fields(&[(INSTRUMENT, "{\"name\":\"oak-bowls\",\"title\":\"Oak\"}")]);
    instance.load(&state(&[("instr", ParamValue::I32(2))], &named));
    assert_eq!(
        crate::factory::BANKS[instance.controls.body.index()].0,
        "oak-bowls"
    );
    assert_eq!(instance.notices(), [""; 0]);
}

#[test]
fn an_instrument_of_the_future_is_kept_until_another_is_chosen() {
    let gong = "{\"name\":\"gong\", \"title\":\"Great gong\", \"of\":\"bronze\"}";
    for (number, field, kept) in [(3, Some(gong), gong), (99, None, "99"), (-7, None, "-7")] {
        let instance = Instance::new();
        let field = field.map(|field| (INSTRUMENT, field));
        let field: Vec<_> = field.into_iter().collect();
        instance.load(&state(
            &[("instr", ParamValue::I32(number))],
            &fields(&field),
        ));
        assert_eq!(instance.controls.body.index(), 0);
        let notice = instance.notices().concat();
        assert!(notice.contains("update Idiophone to 999.1.0"), "{notice}");
        assert!(notice.contains("Wind chimes"), "{notice}");
        let again = Instance::new();
        again.load(&instance.save());
        assert_eq!(again.save().fields[INSTRUMENT], kept);
        again.choose(1);
        assert!(again.save().fields[INSTRUMENT].contains("vibraphone"));
        again.choose(0);
        assert_eq!(again.save().fields[INSTRUMENT], kept);
        again.controls.stay();
        assert!(again.save().fields[INSTRUMENT].contains("chimes"));
        assert_eq!(again.notices(), [""; 0]);
    }
}

#[test]
fn a_bank_that_cannot_be_read_stays_in_the_song_with_a_notice() {
    let text = chimes_body("bell").text().to_owned();
    let cut = &text[..text.len() / 2];
    let newer = text.replace("\"layout\":1", "\"layout\":2");
    let damaged = text.replace("\"hash\":\"", "\"hash\":\"0");
    for (broken, expected) in [
        (cut, "damaged"),
        (&newer, "\"The bell\" is kept as of layout 2"),
        (&damaged, "\"The bell\" is damaged"),
        ("null", "damaged"),
        ("", "damaged"),
    ] {
        let instance = Instance::new();
        instance.controls.shelf().put(chimes_body("gong"));
        let saved = state(
            &[("instr", ParamValue::I32(OWN as i32))],
            &fields(&[(BANK, broken), (INSTRUMENT, &Wish::of(OWN).write())]),
        );
        instance.load(&saved);
        let notices = instance.controls.notices().all();
        let [notice] = &notices[..] else {
            panic!("{notices:?}");
        };
        assert!(notice.text.contains(expected), "{notice:?}");
        assert!(matches!(notice.cure, Some(Cure::Load(_))));
        let shelf = instance.controls.shelf();
        let number = shelf.number(OWN);
        assert_eq!(shelf.bank(number).name, "gong", "the last good sound");
        assert_eq!(instance.save().fields[BANK], broken);
        assert_eq!(instance.controls.body.index(), OWN);
    }
}

#[test]
fn what_is_not_known_goes_back_as_it_came() {
    let instance = Instance::new();
    let params = [
        ("instr", ParamValue::I32(1)),
        ("wobble", ParamValue::F32(0.5)),
        ("spin", ParamValue::String("left".to_owned())),
    ];
    let unknown = "{\"deep\": [1, 2, {\"x\": null}]}";
    instance.load(&state(
        &params,
        &fields(&[("mesh", unknown), ("odd", "no json")]),
    ));
    let notice = instance.notices().concat();
    assert!(notice.contains("Idiophone 999.1.0: 4 settings"), "{notice}");
    let saved = instance.save();
    assert_eq!(saved.fields["mesh"], unknown);
    assert_eq!(saved.fields["odd"], "no json");
    let later = "{\"spin\":{\"string\":\"left\"},\"wobble\":{\"f32\":0.5}}";
    assert_eq!(saved.fields[LATER], later);
    assert!(!saved.fields.contains_key(SAVED_BY));
    let again = Instance::new();
    again.load(&saved);
    assert_eq!(again.song.serialize_fields(), saved.fields);
    again.load(&Instance::new().save());
    assert_eq!(again.notices(), [""; 0], "that song had nothing unknown");
    assert!(!again.save().fields.contains_key("mesh"));
}
