//! `demo`: everything, from the recipes to pictures of the sounds.

mod piece;

use super::{Figure, Precompute, Spectrogram, bundle};
use crate::mesh_bank::MeshOptions;
use crate::midi::Song;
use crate::workspace;
use anyhow::{Context, Result};
use clap::Args;
use piece::Piece;
use std::fs;
use std::path::Path;

/// Arguments of `demo`.
#[derive(Args, Debug)]
pub struct Demo {
    /// Only these instruments; without a name, all of them
    #[arg(value_name = "NAME")]
    pub names: Vec<String>,
}

impl Demo {
    pub(super) fn run(&self) -> Result<()> {
        let pieces = Piece::called(&self.names)?;
        let out = workspace::target_dir()?.join("demo");
        fs::create_dir_all(&out).with_context(|| format!("{}: cannot write", out.display()))?;

        println!("1/3 The banks: shapes, their finite elements, their modes.");
        Precompute {
            name: None,
            force: false,
            mesh: MeshOptions::default(),
        }
        .run()?;
        println!("2/3 The plug-in, with the banks inside.");
        bundle::bundle()?;
        println!("3/3 A piece for each, played by the plug-in and damped by hand at its end;");
        println!("    its spectrogram, and the modes of one body.");
        for piece in &pieces {
            show(piece, &out)?;
        }

        println!();
        println!("CLAP  {}", workspace::bundled_clap()?.display());
        println!("VST3  {}", workspace::bundled_vst3()?.display());
        println!();
        println!("`cargo xtask install` puts the plug-in where your DAW looks for it.");
        Ok(())
    }
}

/// Writes a piece's sound and pictures to the folder `out`.
fn show(piece: &Piece, out: &Path) -> Result<()> {
    println!("{}", piece.title);
    let name = piece.name;
    let wav = out.join(format!("{name}.wav"));
    let song_s = Song::read(&piece.song())?.seconds;
    piece.render(song_s, &wav).run()?;
    Spectrogram {
        input: wav,
        output: out.join(format!("{name}.png")),
        title: Some(format!("{}: songs/{name}.mid", piece.title)),
    }
    .run()?;
    Figure {
        instrument: name.to_owned(),
        output: out.join(format!("{name}-modes.png")),
        key: None,
    }
    .run()
}
