//! `demo`: everything, from the recipe to a picture of the sound.

use super::{Precompute, Render, Spectrogram, bundle};
use crate::workspace;
use anyhow::{Context, Result};
use clap::Args;
use std::fs;

/// A hand laid on the tubes after the last bar, which would otherwise ring for minutes.
const DAMPING: &str = "Alpha 2@27.5:0.25 1/s,28:0.5 1/s,28.5:1 1/s,29:1.5 1/s,29.5:2 1/s";

/// Arguments of `demo`.
#[derive(Args, Debug)]
pub struct Demo {}

impl Demo {
    pub(super) fn run(&self) -> Result<()> {
        let out = workspace::target_dir()?.join("demo");
        fs::create_dir_all(&out).with_context(|| format!("{}: cannot write", out.display()))?;
        let song = workspace::root().join("songs").join("chimes.mid");
        let (wav, png) = (out.join("chimes.wav"), out.join("chimes.png"));

        println!("1/4 The bank: tubes, their finite elements, their modes.");
        Precompute {
            name: None,
            force: false,
        }
        .run()?;
        println!("2/4 The plug-in, with the bank inside.");
        bundle::bundle()?;
        println!("3/4 A piece for chimes, played by the plug-in; its end is damped by hand.");
        let mut render = Render::plain(song, wav.clone());
        render.automate.push(DAMPING.to_owned());
        render.run()?;
        println!("4/4 What it sounds like, in a picture.");
        Spectrogram {
            input: wav.clone(),
            output: png.clone(),
            title: Some("Idiophone: songs/chimes.mid".to_owned()),
        }
        .run()?;

        println!();
        println!("CLAP         {}", workspace::bundled_clap()?.display());
        println!("VST3         {}", workspace::bundled_vst3()?.display());
        println!("sound        {}", wav.display());
        println!("spectrogram  {}", png.display());
        println!();
        println!("`cargo xtask install` puts the plug-in where your DAW looks for it.");
        Ok(())
    }
}
