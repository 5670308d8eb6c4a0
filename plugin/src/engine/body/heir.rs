//! A body that goes on where another like it was: motion passes from mode to mode by name.

use super::Body;
use crate::engine::oscillators::{Kernel, LANES, Pack};
use modes::ModeLabel;

/// The modes of a body by name, and where they are in it.
#[derive(Clone, Debug)]
pub(super) struct Names(Vec<(u64, usize)>);

impl Names {
    /// Of modes in the order of the body's.
    pub(super) fn new(labels: impl Iterator<Item = ModeLabel>) -> Self {
        let mut names: Vec<_> = labels
            .enumerate()
            .map(|(mode, label)| (number(&label), mode))
            .collect();
        names.sort_unstable();
        Self(names)
    }

    /// The modes that both have, as (ours, theirs).
    fn shared<'a>(&'a self, theirs: &'a Self) -> impl Iterator<Item = (usize, usize)> + 'a {
        let mut rest = theirs.0.iter().peekable();
        self.0.iter().filter_map(move |&(name, ours)| {
            while rest.next_if(|(other, _)| *other < name).is_some() {}
            let (_, theirs) = rest.next_if(|(other, _)| *other == name)?;
            Some((ours, *theirs))
        })
    }
}

/// A name as a number.
fn number(label: &ModeLabel) -> u64 {
    let parts = [
        label.family as u64,
        u64::from(label.order),
        u64::from(label.index),
        label.member as u64,
    ];
    parts
        .into_iter()
        .fold(0, |number, part| number << 16 | part)
}

impl Body {
    /// Goes on where `old` is, at a point of the grid, among its own packs `old_packs`: each mode moves as
    /// the one of the same name did, with the same energy, and sounds with the same sign. A bow stays on;
    /// mallets do not.
    pub(crate) fn inherit(
        &mut self,
        (kernel, step_s): (Kernel, f64),
        packs: &mut [Pack],
        (old, old_packs): (&Self, &[Pack]),
    ) {
        let packs = &mut packs[self.place.clone()];
        let old_packs = &old_packs[old.place.clone()];
        for (ours, theirs) in self.names.shared(&old.names) {
            let (to, i) = (&mut packs[ours / LANES], ours % LANES);
            let (from, j) = (&old_packs[theirs / LANES], theirs % LANES);
            // A solver leaves the sign of a shape open.
            let (source, other) = (&self.sources[ours / LANES], &old.sources[theirs / LANES]);
            let sign = if source.agrees(i, other, j) {
                1.0
            } else {
                -1.0
            };
            (to.x[i], to.y[i]) = (sign * from.x[j], sign * from.y[j]);
        }
        self.live = self.tones.len();
        if self.rub.carry(&old.rub) {
            self.substeps = old.substeps;
            self.tune_steps(kernel, step_s);
            self.driven = true;
        }
    }

    /// Whether a mallet is on it.
    pub(crate) fn is_struck(&self) -> bool {
        self.mallets.iter().any(|mallet| mallet.touches)
    }
}
