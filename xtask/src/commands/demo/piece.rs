//! The piece that shows an instrument, and what it is played with.

use crate::commands::Render;
use crate::workspace;
use anyhow::{Result, bail};
use modes::Recipe;
use std::path::{Path, PathBuf};

/// A single strike peaks at −15 dB of full scale at most; these pieces leave room for more.
const GAIN: &str = "Output gain=12 dB";

/// Bowls that ring shortly, and drums, are played fast and loud.
const LESS_GAIN: &str = "Output gain=6 dB";

/// A hand laid on the bodies after the last bar, which would otherwise ring for minutes: seconds
/// after the song's end, and Alpha 2 in 1/s from then on.
const HAND: [(f64, f64); 5] = [(0.3, 0.25), (0.8, 0.5), (1.3, 1.0), (1.8, 1.5), (2.3, 2.0)];

/// An instrument's piece.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Piece {
    /// The instrument's name, which is also the song's.
    pub(super) name: &'static str,
    /// The instrument's name for people.
    pub(super) title: String,
}

impl Piece {
    /// The pieces of the factory's instruments called `names`, of all if there are no names; in
    /// the factory's order.
    pub(super) fn called(names: &[String]) -> Result<Vec<Self>> {
        let known = || Recipe::FACTORY.iter().map(|(name, _)| *name);
        for wanted in names {
            if !known().any(|name| name == wanted) {
                let known: Vec<_> = known().collect();
                bail!("no instrument `{wanted}`; allowed: {}", known.join(", "));
            }
        }
        Recipe::FACTORY
            .iter()
            .filter(|(name, _)| names.is_empty() || names.iter().any(|wanted| wanted == name))
            .map(|(name, text)| {
                let title = Recipe::parse(text, name)?.title;
                Ok(Self { name, title })
            })
            .collect()
    }

    /// The MIDI file.
    pub(super) fn song(&self) -> PathBuf {
        workspace::root()
            .join("songs")
            .join(format!("{}.mid", self.name))
    }

    /// How a song of `song_s` is rendered to `wav`.
    pub(super) fn render(&self, song_s: f64, wav: &Path) -> Render {
        let mut render = Render::plain(self.song(), wav.to_owned());
        render.set.push(format!("Instrument={}", self.title));
        render
            .set
            .extend(hands(self.name).iter().map(|&set| set.to_owned()));
        let steps = HAND.map(|(after_s, per_s)| format!("{:.2}:{per_s} 1/s", song_s + after_s));
        render.automate.push(format!("Alpha 2@{}", steps.join(",")));
        render
    }
}

/// Gains and mallets by which the pieces come out about equally loud, and dampers where there is a
/// pedal. The hardnesses are no measured ones.
fn hands(name: &str) -> &'static [&'static str] {
    match name {
        "vibraphone" => &[GAIN, "Mallet hardness=120 MPa", "Note-off=damps"],
        "tubular-bells" => &[GAIN, "Mallet hardness=300 MPa", "Note-off=damps"],
        "singing-bowls" => &[GAIN, "Mallet hardness=600 MPa"],
        "crystal-bowls" => &[GAIN, "Mallet hardness=400 MPa"],
        "metal-bowls" | "oak-bowls" => &[LESS_GAIN, "Mallet hardness=500 MPa"],
        "square-drums" | "round-drums" | "l-drums" => &[LESS_GAIN],
        _ => &[GAIN],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::midi::Song;
    use std::collections::HashSet;

    fn names(wanted: &[&str]) -> Vec<&'static str> {
        let wanted: Vec<_> = wanted.iter().map(|name| (*name).to_owned()).collect();
        let pieces = Piece::called(&wanted).expect("the names are known");
        pieces.iter().map(|piece| piece.name).collect()
    }

    #[test]
    fn without_names_every_instrument_plays() {
        assert_eq!(names(&[]), Recipe::FACTORY.map(|(name, _)| name));
        assert_eq!(names(&["oak-bowls", "chimes"]), ["chimes", "oak-bowls"]);
    }

    #[test]
    fn an_unknown_name_gets_the_list() {
        let error = Piece::called(&["gong".to_owned()]).unwrap_err().to_string();
        assert!(error.contains("`gong`"), "{error}");
        assert!(error.contains("chimes, vibraphone"), "{error}");
    }

    #[test]
    fn every_song_lasts_half_a_minute_and_keeps_to_its_keys() {
        for piece in Piece::called(&[]).unwrap() {
            let song = Song::read(&piece.song()).unwrap();
            assert!((20.0..=35.0).contains(&song.seconds), "{}", piece.name);
            let (_, text) = Recipe::FACTORY
                .into_iter()
                .find(|(name, _)| *name == piece.name)
                .unwrap();
            let keys: HashSet<u8> = Recipe::parse(text, piece.name)
                .unwrap()
                .keys
                .iter()
                .collect();
            for at in song.events {
                if let crate::host::Event::NoteOn { key, .. } = at.event {
                    assert!(keys.contains(&key), "{}: key {key}", piece.name);
                }
            }
        }
    }

    #[test]
    fn the_hand_comes_after_the_song() {
        let piece = &Piece::called(&["vibraphone".to_owned()]).unwrap()[0];
        let render = piece.render(20.0, Path::new("a.wav"));
        assert!(render.automate[0].starts_with("Alpha 2@20.30:0.25 1/s,20.80:0.5 1/s"));
    }
}
