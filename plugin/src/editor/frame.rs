//! What the editor sees of the engine at one instant.

use crate::engine::{Engine, Held, Struck};

/// Modes of a body that are shown at most.
pub const MOST_MODES: usize = 2048;

/// One look at the engine.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Number of the instrument; see [`crate::shelf::Shelf`].
    pub instrument: usize,
    /// The last blow.
    pub struck: Option<Struck>,
    /// Energy of each key's body, in J.
    pub energies_j: [f32; 128],
    /// How loud each mode of the body struck last is, as an amplitude over full scale.
    pub levels: Vec<f32>,
    /// How far each of them swings, in m·kg^(1/2).
    pub swings: Vec<f32>,
    /// What holds that body.
    pub held: Held,
    /// Samples of a second; 0 if unknown.
    pub rate_hz: f64,
    /// Greatest samples of the left and the right channel since the frame before.
    pub peaks: [f32; 2],
}

impl Default for Frame {
    /// Silence, with room for every mode.
    fn default() -> Self {
        Self {
            instrument: 0,
            struck: None,
            energies_j: [0.0; 128],
            levels: Vec::with_capacity(MOST_MODES),
            swings: Vec::with_capacity(MOST_MODES),
            held: Held::default(),
            rate_hz: 0.0,
            peaks: [0.0; 2],
        }
    }
}

impl Frame {
    /// Writes what there is to see; does not allocate.
    pub fn fill(&mut self, instrument: usize, engine: &Engine, peaks: [f32; 2]) {
        self.instrument = instrument;
        self.peaks = peaks;
        self.rate_hz = engine.sample_rate_hz();
        self.struck = engine.struck();
        engine.energies_j(&mut self.energies_j);
        self.levels.resize(MOST_MODES, 0.0);
        self.swings.resize(MOST_MODES, 0.0);
        let mut count = 0;
        self.held = Held::default();
        if let Some(struck) = self.struck {
            count = engine.levels(struck.key, &mut self.levels);
            engine.swings(struck.key, &mut self.swings);
            self.held = engine.held(struck.key);
        }
        self.levels.truncate(count);
        self.swings.truncate(count);
    }
}
