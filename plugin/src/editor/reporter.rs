//! Where the audio thread lets the editor look.

use super::link::Link;
use crate::engine::Engine;

/// Tells an editor what it asks for; asked for nothing, it does nothing.
#[derive(Default)]
pub(crate) struct Reporter {
    peaks: [f32; 2],
    /// Whether the last frame showed something that sounds.
    sounded: bool,
}

impl Reporter {
    /// A block has been played; whether the editor has something new to draw.
    pub(crate) fn report(
        &mut self,
        link: &Link,
        instrument: usize,
        engine: &Engine,
        block: [&[f32]; 2],
    ) -> bool {
        for (peak, samples) in self.peaks.iter_mut().zip(block) {
            *peak = samples.iter().fold(*peak, |peak, x| peak.max(x.abs()));
        }
        link.hear(block[0], block[1]);
        let sounds = engine.awake() != 0;
        if !link.is_wanted() || !(sounds || self.sounded) {
            return false;
        }
        link.show(|frame| frame.fill(instrument, engine, self.peaks));
        self.peaks = [0.0; 2];
        self.sounded = sounds;
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factory;
    use nice_assert_no_alloc::assert_no_alloc;

    #[test]
    fn what_is_asked_for_is_told_until_all_is_silent() {
        let link = Link::default();
        let (mut reporter, mut last) = (Reporter::default(), Box::default());
        let mut engine = Engine::new(factory::bank(0), 48e3);
        let (mut left, mut right) = ([0.0; 256], [0.0; 256]);
        let mut block = |engine: &mut Engine| {
            engine.process(&mut left, &mut right);
            assert_no_alloc(|| reporter.report(&link, 0, engine, [&left, &right]))
        };
        engine.strike(60, 1.0);
        assert!(!block(&mut engine), "nothing is asked for");
        link.look(&mut last);
        assert!(block(&mut engine));
        assert!(!block(&mut engine), "once");
        assert!(link.look(&mut last));
        assert!(last.energies_j[60] > 1e-6 && last.energies_j[61] == 0.0);
        assert!(last.peaks[0] > 1e-3 && last.peaks[0] <= 1.0);
        assert_eq!(last.struck.map(|struck| struck.key), Some(60));
        engine.choke_all();
        while engine.awake() != 0 {
            block(&mut engine);
        }
        link.look(&mut last);
        assert!(block(&mut engine), "the end is told too");
        link.look(&mut last);
        assert_eq!(last.energies_j, [0.0; 128]);
        assert!(!block(&mut engine), "then nothing");
    }
}
