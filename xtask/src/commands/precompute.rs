//! `precompute`: banks, from recipes and from meshes.

use crate::banks::{self, Built};
use crate::mesh_bank::{self, MeshOptions};
use crate::table::Table;
use anyhow::Result;
use clap::Args;
use modes::FreeRecipe;
use std::time::Instant;

const HEADER: [&str; 6] = ["bank", "keys", "modes", "worst residual", "seconds", "file"];

/// Arguments of `precompute`.
#[derive(Args, Debug)]
pub struct Precompute {
    /// Only this bank, or the recipe in this file
    #[arg(value_name = "NAME")]
    pub name: Option<String>,
    /// Compute even what lies ready
    #[arg(long)]
    pub force: bool,
    /// A mesh instead
    #[command(flatten)]
    pub mesh: MeshOptions,
}

impl Precompute {
    pub(super) fn run(&self) -> Result<()> {
        let named = self.name.as_deref().map(mesh_bank::recipe).transpose()?;
        if let Some(recipe) = self.mesh.recipe()?.or(named.flatten()) {
            return self.make(&recipe);
        }
        let names = match &self.name {
            Some(name) => vec![name.clone()],
            None => banks::names()?,
        };
        let mut table = Table::new(HEADER);
        for name in names {
            table.push(row(&banks::precompute(&name, self.force)?));
        }
        print!("{}", table.text(false));
        Ok(())
    }

    /// Of meshes: the table, then what was found in them.
    fn make(&self, recipe: &FreeRecipe) -> Result<()> {
        let start = Instant::now();
        let (path, made) = self.mesh.make(recipe)?;
        let mut table = Table::new(HEADER);
        table.push(row(&Built {
            bank: made.bank.spread_out(),
            path,
            seconds: Some(start.elapsed().as_secs_f64()),
        }));
        print!("{}", table.text(false));
        for note in made.notes {
            println!("{note}");
        }
        Ok(())
    }
}

fn row(built: &Built) -> [String; 6] {
    let bodies = &built.bank.bodies;
    let modes = || bodies.iter().flat_map(|body| &body.modes);
    let keys = match (bodies.first(), bodies.last()) {
        (Some(first), Some(last)) => format!("{}…{}", first.key, last.key),
        _ => "none".to_owned(),
    };
    [
        built.bank.name.clone(),
        keys,
        modes().count().to_string(),
        format!("{:.1e}", built.bank.provenance.max_residual),
        built
            .seconds
            .map_or_else(|| "ready".to_owned(), |seconds| format!("{seconds:.1}")),
        built.path.display().to_string(),
    ]
}
