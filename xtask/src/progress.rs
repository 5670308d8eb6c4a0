//! A bar on the terminal for what takes seconds.

use crate::banks::Progress;
use indicatif::{ProgressBar, ProgressStyle};

/// Does `work` under a bar that follows what it reports.
pub(crate) fn with_bar<R>(name: &str, work: impl FnOnce(&(dyn Fn(Progress) + Sync)) -> R) -> R {
    let bar = ProgressBar::new(0);
    if let Ok(style) =
        ProgressStyle::with_template("{msg} {wide_bar} {pos}/{len} bodies, {elapsed}, {eta} left")
    {
        bar.set_style(style);
    }
    bar.set_message(name.to_owned());
    let done = work(&|progress| {
        bar.set_length(progress.total as u64);
        bar.set_position(progress.done as u64);
    });
    bar.finish_and_clear();
    done
}
