//! `precompute`: the banks, from their recipes.

use crate::banks::{self, Built};
use crate::progress;
use crate::table::Table;
use anyhow::Result;
use clap::Args;

/// Arguments of `precompute`.
#[derive(Args, Debug)]
pub struct Precompute {
    /// Only this bank
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
            None => banks::names(),
        };
        let mut table = Table::new(["bank", "keys", "modes", "worst residual", "seconds", "file"]);
        for name in names {
            let built =
                progress::with_bar(&name, |report| banks::precompute(&name, self.force, report))?;
            table.push(row(&built));
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
    let worst = modes().map(|mode| mode.residual).fold(0.0, f64::max);
    [
        built.bank.name.clone(),
        keys,
        modes().count().to_string(),
        format!("{worst:.1e}"),
        built
            .seconds
            .map_or_else(|| "ready".to_owned(), |seconds| format!("{seconds:.1}")),
        built.path.display().to_string(),
    ]
}
