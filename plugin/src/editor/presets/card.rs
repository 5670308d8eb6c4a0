//! What is written about the preset that is shown, and what can be done with its file.

use super::super::theme::{NEAR, SIDE, Theme, body, small, title};
use super::browser::Browser;
use super::button::{tag, word};
use super::form::Form;
use super::session::Session;
use crate::presets::{Origin, Preset};
use egui::{Label, RichText, ScrollArea, Ui, vec2};
use nice_plug::prelude::ParamSetter;

impl Browser {
    /// Draws the card.
    pub(super) fn card(
        &mut self,
        ui: &mut Ui,
        session: &mut Session,
        theme: &Theme,
        setter: &ParamSetter<'_>,
    ) {
        let origin = self.shown.clone().or_else(|| session.chosen().origin());
        let entry = origin
            .as_ref()
            .and_then(|origin| session.library.find(origin));
        let (name, preset, reason) =
            match entry.map(|entry| (entry.name().to_owned(), &entry.preset)) {
                Some((name, Ok(preset))) => (name, Some(preset.clone()), None),
                Some((name, Err(reason))) => (name, None, Some(reason.clone())),
                None => (session.chosen().name(), session.preset(), None),
            };
        let missing = origin.is_some() && entry.is_none();
        ui.spacing_mut().item_spacing = vec2(SIDE, SIDE);
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            ui.add(Label::new(RichText::new(name.clone()).font(title()).color(theme.text)).wrap());
            if let Some(preset) = &preset {
                self.words(ui, preset, theme);
            }
            if let Some(reason) = &reason {
                alarm(ui, &format!("This file is broken. {reason}"), theme);
            }
            if missing {
                let what = "The song was made with this preset, which is not here now. Its sound is in the \
                            song; save it to have the preset again.";
                alarm(ui, what, theme);
            }
            ui.add_space(NEAR);
            // What a song says is no file until it is found.
            let there = origin.as_ref().filter(|_| !missing);
            self.deeds(ui, there, preset.as_deref(), session, theme, setter);
        });
    }

    fn words(&mut self, ui: &mut Ui, preset: &Preset, theme: &Theme) {
        let mut line = preset.instrument().to_owned();
        for more in [&preset.card.category, &preset.card.author] {
            if !more.is_empty() {
                line += "  ·  ";
                line += more;
            }
        }
        ui.add(Label::new(RichText::new(line).font(small()).color(theme.quiet)).wrap());
        if !preset.card.about.is_empty() {
            ui.add(
                Label::new(
                    RichText::new(&preset.card.about)
                        .font(body())
                        .color(theme.text),
                )
                .wrap(),
            );
        }
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(NEAR, NEAR);
            for word in &preset.card.tags {
                if tag(ui, word, theme)
                    .on_hover_text("Search for this tag")
                    .clicked()
                {
                    word.clone_into(&mut self.search.text);
                }
            }
        });
        if !preset.sound.scala.is_empty() {
            let text = "Brings a scale of its own, which goes again with the next preset.";
            ui.add(Label::new(RichText::new(text).font(small()).color(theme.quiet)).wrap());
        }
        for notice in &preset.notices {
            alarm(ui, &format!("Line {}: {}", notice.line, notice.what), theme);
        }
    }

    fn deeds(
        &mut self,
        ui: &mut Ui,
        origin: Option<&Origin>,
        preset: Option<&Preset>,
        session: &mut Session,
        theme: &Theme,
        setter: &ParamSetter<'_>,
    ) {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(NEAR, NEAR);
            if word(ui, "Save as…", session.chosen().changed, theme).clicked() {
                self.begin_saving(session);
            }
            if let (Some(Origin::User(file)), Some(preset)) = (origin, preset)
                && word(ui, "Rename…", false, theme).clicked()
            {
                self.form = Some(Form::rename(file, &preset.card.name));
            }
            if let Some(Origin::User(file)) = origin
                && word(ui, "Delete…", false, theme).clicked()
            {
                self.form = Some(Form::delete(file));
            }
            if let Some(preset) = preset
                && word(ui, "Export…", false, theme).clicked()
            {
                self.form = Some(Form::export(preset.clone(), &session.library));
            }
            if word(ui, "Import…", false, theme).clicked() {
                self.form = Some(Form::import());
            }
            if word(ui, "Init", false, theme).clicked() {
                session.reset(setter);
                self.shown = None;
            }
        });
    }
}

fn alarm(ui: &mut Ui, text: &str, theme: &Theme) {
    ui.add(Label::new(RichText::new(text).font(small()).color(theme.alarm)).wrap());
}
