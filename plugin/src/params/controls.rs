//! The parameters as the host holds them.

use super::assign::Assign;
use super::body::Body;
use super::bow::Bows;
use super::damping::Damping;
use super::hands::Hands;
use super::listener::Ears;
use super::mallet::Mallets;
use super::motor::Motor;
use super::output::Output;
use super::shape::Shape;
use super::strike::Strike;
use super::trims::{TrimField, TrimTable};
use crate::engine::Settings;
use crate::hands::{self, SLOTS};
use crate::maker::{Drawn, Solved, Stores, wanted_text};
use crate::notices::{Notices, Subject};
use crate::shelf::{Own, Shelf, Shelved};
use crate::tuning::{KeyboardText, ScaleText, TuningTexts};
use nice_plug::prelude::Params;
use std::sync::{Arc, Mutex, PoisonError};

/// One control for each [`super::Spec`]; the engine smooths what they say.
#[derive(Params)]
pub struct Controls {
    /// Which bodies there are.
    #[nested(group = "Body")]
    pub body: Body,
    /// How they are drawn.
    #[nested(group = "Shape")]
    pub shape: Shape,
    /// Where and how fast they are struck.
    #[nested(group = "Strike")]
    pub strike: Strike,
    /// What strikes.
    #[nested(group = "Mallet")]
    pub mallet: Mallets,
    /// What rubs.
    #[nested(group = "Bow")]
    pub bow: Bows,
    /// What takes the sound away.
    #[nested(group = "Damping")]
    pub damping: Damping,
    /// The discs in the resonators' mouths.
    #[nested(group = "Motor")]
    pub motor: Motor,
    /// Where the listener is.
    #[nested(group = "Listener")]
    pub listener: Ears,
    /// How hands are understood.
    #[nested(group = "Hands")]
    pub hands: Hands,
    /// Who moves what.
    #[nested(array, group = "Assign")]
    pub assign: [Assign; SLOTS],
    /// Level and outputs of the whole.
    #[nested(group = "Output")]
    pub output: Output,
    /// The scale that travels with the song.
    #[persist = "scale"]
    pub scale: ScaleText,
    /// The keyboard map that travels with the song.
    #[persist = "kbm"]
    pub keyboard: KeyboardText,
    /// What is made of single modes, which travels with the song too.
    #[persist = "trims"]
    pub trimmed: TrimField,
    trims: Arc<TrimTable>,
    tuning: Arc<TuningTexts>,
    shelf: Arc<Shelf>,
    solved: Arc<Solved>,
    drawn: Arc<Drawn>,
    notices: Arc<Notices>,
    /// The instrument that the song wants and this version does not have, as the song says it.
    wish: Mutex<Option<String>>,
}

impl Default for Controls {
    fn default() -> Self {
        let tuning = Arc::new(TuningTexts::default());
        let trims = Arc::new(TrimTable::default());
        Self {
            scale: ScaleText(Arc::clone(&tuning)),
            keyboard: KeyboardText(Arc::clone(&tuning)),
            tuning,
            trimmed: TrimField(Arc::clone(&trims)),
            trims,
            shelf: Arc::default(),
            solved: Arc::default(),
            drawn: Arc::default(),
            notices: Arc::default(),
            wish: Mutex::default(),
            body: Body::default(),
            shape: Shape::default(),
            strike: Strike::default(),
            mallet: Mallets::default(),
            bow: Bows::default(),
            damping: Damping::default(),
            motor: Motor::default(),
            listener: Ears::default(),
            hands: Hands::default(),
            assign: Assign::all(),
            output: Output::default(),
        }
    }
}

impl Controls {
    /// What the engine is to aim at, with hands off.
    #[must_use]
    pub fn settings(&self) -> Settings {
        let mut settings = Settings::DEFAULT;
        self.body.apply(&mut settings);
        self.strike.apply(&mut settings);
        self.mallet.apply(&mut settings);
        self.bow.apply(&mut settings);
        self.damping.apply(&mut settings);
        self.motor.apply(&mut settings);
        self.listener.apply(&mut settings);
        self.output.apply(&mut settings);
        settings
    }

    /// The tuning that travels with the song.
    #[must_use]
    pub fn tuning(&self) -> &TuningTexts {
        &self.tuning
    }

    /// What is made of single modes.
    #[must_use]
    pub fn trims(&self) -> &TrimTable {
        &self.trims
    }

    /// The instruments within reach.
    #[must_use]
    pub fn shelf(&self) -> &Arc<Shelf> {
        &self.shelf
    }

    /// The drawing that was last solved to the end.
    #[must_use]
    pub fn solved(&self) -> &Arc<Solved> {
        &self.solved
    }

    /// That drawing's bank, if it is what the instrument of that number is to sound like now.
    pub(crate) fn shaped(&self, number: usize) -> Option<Arc<Own>> {
        let text = wanted_text(&self.shape.drawing(), &self.shelf.bank(number))?;
        self.solved.of(&text)
    }

    /// The bank of the instrument of that number in the drawing that sounds.
    #[must_use]
    pub fn sounding(&self, number: usize) -> Shelved {
        let drawn = self.drawn.of(number);
        drawn.unwrap_or_else(|| self.shelf.bank(number))
    }

    /// What the maker takes from and gives to.
    pub(crate) fn stores(&self) -> Stores {
        Stores {
            shelf: Arc::clone(&self.shelf),
            solved: Arc::clone(&self.solved),
            drawn: Arc::clone(&self.drawn),
            notices: Arc::clone(&self.notices),
        }
    }

    /// What the user should know.
    #[must_use]
    pub fn notices(&self) -> &Arc<Notices> {
        &self.notices
    }

    /// The instrument that the song wants and this version does not have, as the song says it.
    pub(crate) fn wish(&self) -> Option<String> {
        let wish = self.wish.lock();
        wish.unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// See [`Self::wish`].
    pub(crate) fn wish_for(&self, wish: Option<String>) {
        *self.wish.lock().unwrap_or_else(PoisonError::into_inner) = wish;
    }

    /// The song is content with the instrument that stands in.
    pub fn stay(&self) {
        self.wish_for(None);
        self.notices.clear(Subject::Instrument);
    }

    /// How hands are understood.
    #[must_use]
    pub fn hands(&self) -> hands::Settings {
        self.hands.settings(&self.assign)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{GROUPS, specs};
    use nice_plug::prelude::Param;

    #[test]
    fn controls_and_table_agree() {
        let controls = Controls::default();
        let map = controls.param_map();
        assert_eq!(map.len(), specs().count());
        let rows = GROUPS
            .iter()
            .flat_map(|group| group.specs.iter().map(|spec| (group.name, spec)));
        for ((id, pointer, group), (group_name, spec)) in map.iter().zip(rows) {
            assert_eq!((id.as_str(), group.as_str()), (spec.id, group_name));
            // SAFETY: `controls`, which the pointers point into, is alive.
            #[expect(unsafe_code, reason = "the framework hands out raw pointers")]
            let (name, default) = unsafe {
                let text = pointer.default_normalized_value();
                (
                    pointer.name(),
                    pointer.normalized_value_to_string(text, true),
                )
            };
            assert_eq!(name, spec.name);
            assert_eq!(default, spec.format(spec.default), "{name}");
        }
    }

    #[test]
    fn defaults_are_the_engine_s_and_the_hands_own() {
        let (ours, engine) = (Controls::default().settings(), Settings::default());
        assert_eq!(ours.sane(), ours);
        assert!((ours.strike_position - engine.strike_position).abs() < 1e-7);
        assert!((ours.mallet.mass_kg - engine.mallet.mass_kg).abs() < 1e-8);
        assert!((ours.mallet.head_radius_m - engine.mallet.head_radius_m).abs() < 1e-8);
        assert!((ours.mallet.loss_s_m - engine.mallet.loss_s_m).abs() < 1e-8);
        assert!((ours.bow.speed_m_s - engine.bow.speed_m_s).abs() < 1e-8);
        let ours = Settings {
            strike_position: engine.strike_position,
            mallet: crate::engine::Mallet {
                hardness_pa: ours.mallet.hardness_pa,
                ..engine.mallet
            },
            bow: crate::engine::Bow {
                speed_m_s: engine.bow.speed_m_s,
                ..ours.bow
            },
            ..ours
        };
        assert_eq!(ours, engine);
        assert_eq!(Controls::default().hands(), hands::Settings::DEFAULT);
    }

    #[test]
    fn a_host_s_number_keeps_its_text() {
        let controls = Controls::default();
        let alpha1 = &controls.damping.alpha1;
        for text in ["1.00e-7 s", "8.00e-6 s", "2.00e-5 s", "0 s"] {
            let normalized = alpha1.string_to_normalized_value(text);
            let shown = normalized.map(|n| alpha1.normalized_value_to_string(n, true));
            assert_eq!(shown.as_deref(), Some(text));
        }
        let hardness = &controls.mallet.hardness;
        for text in ["1.00 MPa", "20.0 MPa", "1.00 GPa", "100 GPa"] {
            let normalized = hardness.string_to_normalized_value(text);
            let shown = normalized.map(|n| hardness.normalized_value_to_string(n, true));
            assert_eq!(shown.as_deref(), Some(text));
        }
    }
}
