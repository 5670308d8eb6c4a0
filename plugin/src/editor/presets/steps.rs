//! Going from one sound to another, back and forth.

use super::super::chosen::Chosen;
use super::super::history::{Side, Step};
use super::super::log::Change;
use super::super::param::Param;
use super::session::Session;
use crate::params::body::INSTRUMENT;
use crate::presets::Scala;
use egui::{Key, Modifiers, Ui};
use nice_plug::prelude::ParamSetter;

impl Session {
    /// What is heard now.
    fn side(&self) -> Side {
        let place = |param: &Param| (param.spec.id, param.value());
        Side {
            values: self.params.iter().map(place).collect(),
            scala: self.scala(),
            trims: self.trims().list(),
            chosen: self.chosen(),
        }
    }

    /// Goes to a sound in one step: one gesture for each parameter that differs.
    pub(super) fn go(&mut self, to: &Side, name: String, heard: usize, setter: &ParamSetter<'_>) {
        let mut changes = Vec::new();
        for (id, to) in &to.values {
            let Some(param) = self.param(id) else {
                continue;
            };
            let from = param.value();
            if from != *to {
                param.jump(setter, *to);
                let (id, to) = (param.spec.id, *to);
                changes.push(Change { id, from, to });
            }
        }
        let (scala, trims, chosen) = (self.scala(), self.trims().list(), self.chosen());
        if scala != to.scala {
            self.set_scala(&to.scala);
        }
        self.trims().set_list(&to.trims);
        self.saved.choose(to.chosen.clone());
        self.past.history.push(Step {
            name,
            changes,
            scala: (scala != to.scala).then(|| [scala, to.scala.clone()]),
            trims: (trims != to.trims).then(|| [trims, to.trims.clone()]),
            chosen: Some([chosen, to.chosen.clone()]),
            side: (heard != self.past.heard).then_some([self.past.heard, heard]),
        });
        self.past.heard = heard;
    }

    /// Tunes by other texts, in one step; the tuning is the song's own from now on.
    pub(in super::super) fn tune(&mut self, to: &Scala, name: String, setter: &ParamSetter<'_>) {
        let (from, chosen) = (self.scala(), self.chosen());
        let kept = Chosen {
            tuned: false,
            ..chosen.clone()
        };
        let step = Step {
            name,
            scala: Some([from, to.clone()]),
            chosen: Some([chosen, kept]),
            ..Step::default()
        };
        self.step(&step, 1, setter);
        self.past.history.push(step);
    }

    /// Takes a step back (0) or forward (1).
    fn step(&mut self, step: &Step, way: usize, setter: &ParamSetter<'_>) {
        for change in &step.changes {
            if let Some(param) = self.param(change.id) {
                param.jump(setter, [change.from, change.to][way]);
            }
        }
        if let Some(scala) = &step.scala {
            self.set_scala(&scala[way]);
            // Texts are no parameters: this tells the host that the song has changed.
            if let Some(same) = self.param(INSTRUMENT.id) {
                same.jump(setter, same.value());
            }
        }
        if let Some(trims) = &step.trims {
            self.trims().set_list(&trims[way]);
        }
        if let Some(chosen) = &step.chosen {
            self.saved.choose(chosen[way].clone());
        }
        if let Some(side) = step.side {
            self.past.heard = side[way];
        }
    }

    /// Undoes and does again by key, unless someone types.
    pub(in super::super) fn keys(&mut self, ui: &Ui, setter: &ParamSetter<'_>) {
        if ui.ctx().text_edit_focused() {
            return;
        }
        let pressed = |modifiers, key| ui.input_mut(|input| input.consume_key(modifiers, key));
        let shifted = Modifiers::COMMAND | Modifiers::SHIFT;
        if pressed(shifted, Key::Z) || pressed(Modifiers::COMMAND, Key::Y) {
            self.redo(setter);
        } else if pressed(Modifiers::COMMAND, Key::Z) {
            self.undo(setter);
        }
    }

    /// Undoes the last step.
    pub(in super::super) fn undo(&mut self, setter: &ParamSetter<'_>) {
        if let Some(step) = self.past.history.undo() {
            self.step(&step, 0, setter);
        }
    }

    /// Does the step again that was undone last.
    pub(in super::super) fn redo(&mut self, setter: &ParamSetter<'_>) {
        if let Some(step) = self.past.history.redo() {
            self.step(&step, 1, setter);
        }
    }

    /// Hears the other side of the comparison; a side that was never heard begins as this one.
    pub(super) fn turn(&mut self, side: usize, setter: &ParamSetter<'_>) {
        if side == self.past.heard {
            return;
        }
        let here = self.side();
        let there = self.past.sides[side]
            .clone()
            .unwrap_or_else(|| here.clone());
        self.past.sides[self.past.heard] = Some(here);
        self.go(&there, format!("side {}", ["A", "B"][side]), side, setter);
    }

    /// Makes the other side the same as this one.
    pub(super) fn copy(&mut self) {
        self.past.sides[1 - self.past.heard] = Some(self.side());
    }
}
