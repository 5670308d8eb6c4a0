//! A note for each preset that is chosen in the browser, if that is wanted.

use super::super::link::{Link, Touch};
use egui::Ui;
use std::time::Duration;

/// The body that is struck, and how hard: C4 at velocity 100.
const KEY: u8 = 60;
const VELOCITY: f32 = 100.0 / 127.0;
/// Parameters reach the audio thread before the note, and the body of a new instrument in most cases too,
/// in s.
const WAIT_S: f64 = 0.12;
/// An instrument that takes longer is not waited for, in s.
const PATIENCE_S: f64 = 2.0;
/// How long the key is held, in s.
const HELD_S: f64 = 1.2;

/// What is to be heard.
#[derive(Default)]
pub(super) struct Hearing {
    pub(super) on: bool,
    asked_s: Option<f64>,
    struck_s: Option<f64>,
}

impl Hearing {
    /// A preset was chosen.
    pub(super) fn ask(&mut self, now_s: f64) {
        self.asked_s = self.on.then_some(now_s);
    }

    /// Strikes and lets go when it is time; `ready` says that the instrument is the chosen one.
    pub(super) fn play(&mut self, ui: &Ui, ready: bool, [position, across]: [f32; 2], link: &Link) {
        let now_s = ui.input(|input| input.time);
        if self
            .struck_s
            .is_some_and(|struck_s| now_s > struck_s + HELD_S)
        {
            self.let_go(link);
        }
        if let Some(asked_s) = self.asked_s {
            if now_s > asked_s + PATIENCE_S {
                self.asked_s = None;
            } else if ready && now_s > asked_s + WAIT_S {
                self.asked_s = None;
                self.let_go(link);
                link.touch(Touch::Strike {
                    key: KEY,
                    velocity: VELOCITY,
                    position,
                    across,
                });
                self.struck_s = Some(now_s);
            }
        }
        if self.asked_s.is_some() || self.struck_s.is_some() {
            ui.ctx().request_repaint_after(Duration::from_millis(16));
        }
    }

    fn let_go(&mut self, link: &Link) {
        if self.struck_s.take().is_some() {
            link.touch(Touch::Release { key: KEY });
        }
    }
}
