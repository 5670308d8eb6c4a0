//! What is done with presets, steps and sides, through the host.

use super::super::chosen::Chosen;
use super::super::history::{Past, Side, Turn};
use super::super::log::Log;
use super::super::param::Param;
use super::super::saved::Saved;
use crate::params::body::INSTRUMENT;
use crate::params::{Controls, Spec, TrimTable};
use crate::presets::{Library, Origin, Preset, Scala, Sound, TrimList};
use crate::user_folder;
use nice_plug::prelude::ParamSetter;
use std::path::PathBuf;
use std::sync::Arc;

/// Presets, steps and sides of a window.
pub(in super::super) struct Session {
    controls: Arc<Controls>,
    pub(super) saved: Arc<Saved>,
    pub(super) params: Vec<Param>,
    log: Arc<Log>,
    pub(super) past: Past,
    pub(super) library: Library,
}

impl Drop for Session {
    fn drop(&mut self) {
        *self.saved.past() = std::mem::take(&mut self.past);
    }
}

impl Session {
    pub(in super::super) fn new(
        controls: &Arc<Controls>,
        saved: &Arc<Saved>,
        params: &[Param],
        log: &Arc<Log>,
    ) -> Self {
        Self {
            controls: Arc::clone(controls),
            past: std::mem::take(&mut *saved.past()),
            saved: Arc::clone(saved),
            params: params.to_vec(),
            log: Arc::clone(log),
            library: Library::open(user_folder()),
        }
    }

    /// Keeps presets in another folder than the user's.
    pub(in super::super) fn move_to(&mut self, home: Option<PathBuf>) {
        self.library = Library::open(home);
    }

    pub(super) fn param(&self, id: &str) -> Option<&Param> {
        self.params.iter().find(|param| param.spec.id == id)
    }

    /// Takes up the gestures that have ended; `played` says that playing made them.
    pub(in super::super) fn listen(&mut self, now_s: f64, played: bool) {
        for change in self.log.ended() {
            let name = self.param(change.id).map_or("", |param| param.spec.name);
            self.past.history.gesture(change, name, now_s, played);
        }
    }

    /// Takes up the modes that have been trimmed by hand: which, and the lists before and after.
    pub(in super::super) fn trimmed(&mut self, trimmed: Vec<(String, Turn<TrimList>)>, now_s: f64) {
        for (name, turn) in trimmed {
            self.past.history.trim(turn, &name, now_s);
        }
    }

    /// Which preset is chosen.
    pub(super) fn chosen(&self) -> Chosen {
        self.saved.chosen()
    }

    /// The chosen preset, or that of a new instance.
    pub(super) fn preset(&self) -> Option<Arc<Preset>> {
        match self.chosen().origin() {
            None => Some(Arc::new(Preset::init(self.instrument()))),
            Some(origin) => self.library.find(&origin)?.preset.clone().ok(),
        }
    }

    /// The chosen preset's name.
    pub(super) fn name(&self) -> String {
        let chosen = self.chosen();
        let entry = chosen
            .origin()
            .and_then(|origin| self.library.find(&origin));
        entry.map_or_else(|| chosen.name(), |entry| entry.name().to_owned())
    }

    /// Index of the instrument that is played.
    fn instrument(&self) -> usize {
        let plain = self.param(INSTRUMENT.id).map_or(0.0, Param::plain).round();
        #[expect(clippy::cast_sign_loss, reason = "what is below 0 saturates")]
        let index = plain as usize;
        index
    }

    /// Finds out whether the sound is still the chosen preset's, as far as that is there.
    pub(in super::super) fn compare(&self) {
        let chosen = self.chosen();
        let changed = match chosen.origin() {
            None => self.differs(&Sound::init(self.instrument())),
            Some(origin) => match self.library.find(&origin).map(|entry| &entry.preset) {
                Some(Ok(preset)) => self.differs(&preset.sound),
                _ => return,
            },
        };
        if changed != chosen.changed {
            self.saved.choose(Chosen { changed, ..chosen });
        }
    }

    /// Whether something that is shown differs from a sound.
    fn differs(&self, sound: &Sound) -> bool {
        let differs = |(spec, plain): (&Spec, f32)| {
            let now = self.param(spec.id).map(Param::plain);
            now.is_some_and(|now| now != plain && spec.format(now) != spec.format(plain))
        };
        let retuned = !sound.scala.is_empty() && sound.scala != self.scala();
        retuned || !sound.is_trimmed(&self.trims().list()) || sound.wanted().any(differs)
    }

    pub(super) fn trims(&self) -> &TrimTable {
        self.controls.trims()
    }

    pub(in super::super) fn scala(&self) -> Scala {
        let texts = self.controls.tuning();
        Scala {
            scale: texts.scale(),
            keyboard: texts.keyboard(),
        }
    }

    pub(super) fn set_scala(&self, scala: &Scala) {
        let texts = self.controls.tuning();
        texts.set_scale(scala.scale.clone());
        texts.set_keyboard(scala.keyboard.clone());
    }

    /// Loads a preset, in one step.
    pub(super) fn load(
        &mut self,
        preset: &Preset,
        origin: Option<&Origin>,
        setter: &ParamSetter<'_>,
    ) {
        let wanted = preset.sound.wanted();
        let place = |(spec, plain): (&'static Spec, f32)| {
            Some((spec.id, self.param(spec.id)?.place(plain)))
        };
        let values = wanted.filter_map(place).collect();
        let own = &preset.sound.scala;
        let scala = if !own.is_empty() || self.chosen().tuned {
            own.clone()
        } else {
            // The song's own.
            self.scala()
        };
        let side = Side {
            values,
            scala,
            trims: preset.sound.trims.clone(),
            chosen: Chosen {
                key: origin.map(Origin::key).unwrap_or_default(),
                changed: false,
                tuned: !own.is_empty(),
            },
        };
        self.go(&side, preset.card.name.clone(), self.past.heard, setter);
    }

    /// Everything as in a new instance, but for the instrument.
    pub(super) fn reset(&mut self, setter: &ParamSetter<'_>) {
        let init = Preset::init(self.instrument());
        self.load(&init, None, setter);
    }

    /// Loads the preset before (−1) or after (1) the chosen one among those that can be had.
    pub(super) fn next(&mut self, way: isize, among: &[Origin], setter: &ParamSetter<'_>) {
        let has = |origin: &&Origin| self.library.find(origin).is_some_and(|e| e.preset.is_ok());
        let good: Vec<_> = among.iter().filter(has).cloned().collect();
        let here = self.chosen().origin();
        let here = good.iter().position(|origin| Some(origin) == here.as_ref());
        let at = match here {
            Some(here) => here.checked_add_signed(way).filter(|at| *at < good.len()),
            None if way > 0 => Some(0),
            None => good.len().checked_sub(1),
        };
        if let Some(origin) = at.and_then(|at| good.get(at)) {
            self.choose(origin, setter);
        }
    }

    /// Loads the preset of that origin, if it can be had.
    pub(super) fn choose(&mut self, origin: &Origin, setter: &ParamSetter<'_>) {
        let entry = self.library.find(origin);
        if let Some(preset) = entry.and_then(|entry| entry.preset.clone().ok()) {
            self.load(&preset, Some(origin), setter);
        }
    }
}
