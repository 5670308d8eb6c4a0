//! `params`: the plug-in's parameters as tables, group by group.

use super::bundle;
use crate::host::{Library, Param, Plugin};
use crate::table::Table;
use anyhow::Result;
use clap::Args;
use std::path::PathBuf;

/// Arguments of `params`.
#[derive(Args, Debug)]
pub struct Params {
    /// Write the table in Markdown
    #[arg(long)]
    pub markdown: bool,
    /// Another plug-in than the bundled one, which is built first if it is missing
    #[arg(long, value_name = "FILE.clap")]
    pub plugin: Option<PathBuf>,
}

impl Params {
    pub(super) fn run(&self) -> Result<()> {
        let path = match &self.plugin {
            Some(path) => path.clone(),
            None => bundle::bundled_clap()?,
        };
        let mut plugin = Library::open(&path)?.instantiate()?;
        let mut params = plugin.params();
        params.retain(|param| !param.hidden);
        for (number, group) in params.chunk_by(|a, b| a.module == b.module).enumerate() {
            let mut table = Table::new(["parameter", "from", "to", "default", "automatable"]);
            for param in group {
                table.push(row(&mut plugin, param));
            }
            let (gap, mark) = (
                if number > 0 { "\n" } else { "" },
                if self.markdown { "### " } else { "" },
            );
            println!(
                "{gap}{mark}{}\n\n{}",
                group[0].module,
                table.text(self.markdown).trim_end()
            );
        }
        Ok(())
    }
}

fn row(plugin: &mut Plugin, param: &Param) -> [String; 5] {
    let mut text = |value: f64| {
        plugin
            .text(param.id, value)
            .unwrap_or_else(|| value.to_string())
    };
    [
        param.name.clone(),
        text(param.min),
        text(param.max),
        text(param.default),
        if param.automatable { "yes" } else { "no" }.to_owned(),
    ]
}
