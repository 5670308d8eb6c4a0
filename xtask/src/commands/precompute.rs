//! `precompute`: the banks, from their recipes.

use crate::banks::{self, Built};
use crate::table::Table;
use anyhow::Result;
use clap::Args;

/// Arguments of `precompute`.
#[derive(Args, Debug)]
pub struct Precompute {
    /// Only this bank, or the recipe in this file
    #[arg(value_name = "NAME")]
    pub name: Option<String>,
    /// Compute even what lies ready
    #[arg(long)]
    pub force: bool,
}

impl Precompute {
    pub(super) fn run(&self) -> Result<()> {
        let names = match &self.name {
            Some(name) => vec![name.clone()],
            None => banks::names()?,
        };
        let mut table = Table::new(["bank", "keys", "modes", "worst residual", "seconds", "file"]);
        for name in names {
            table.push(row(&banks::precompute(&name, self.force)?));
        }
        print!("{}", table.text(false));
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
