//! A bar on the terminal for what takes seconds.

use indicatif::{ProgressBar, ProgressStyle};
use modes::factory::Progress;
use std::ops::ControlFlow;

struct Bar(ProgressBar);

impl Progress for Bar {
    fn advance(&self, done: usize, total: usize) -> ControlFlow<()> {
        self.0.set_length(total as u64);
        self.0.set_position(done as u64);
        ControlFlow::Continue(())
    }
}

/// Does `work` under a bar that follows what it reports.
pub(crate) fn with_bar<R>(name: &str, work: impl FnOnce(&dyn Progress) -> R) -> R {
    let bar = ProgressBar::new(0);
    if let Ok(style) =
        ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len}, {elapsed}, {eta} left")
    {
        bar.set_style(style);
    }
    bar.set_message(name.to_owned());
    let done = work(&Bar(bar.clone()));
    bar.finish_and_clear();
    done
}
