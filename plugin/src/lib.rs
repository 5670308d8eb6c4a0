//! An instrument that sounds struck objects from their modes of vibration.
//!
//! [`engine`] turns strikes into sound and knows no host; [`params`] names everything that can be
//! automated; the rest is the shell that CLAP and VST3 hosts load.

#[cfg(feature = "gui")]
pub mod editor;
pub mod engine;
pub mod factory;
mod guard;
pub mod hands;
mod key_name;
mod layouts;
pub mod maker;
#[cfg(feature = "gui")]
pub mod mesher;
mod notes;
pub mod notices;
pub mod params;
mod player;
pub mod presets;
mod remote;
pub mod shelf;
mod song;
mod stage;
mod tuner;
pub mod tuning;
mod user_folder;
mod workshop;

pub use user_folder::user_folder;

use maker::Maker;
#[cfg(feature = "gui")]
use nice_plug::prelude::AsyncExecutor;
use nice_plug::prelude::{
    ActivateContext, AudioIOLayout, AuxiliaryBuffers, Buffer, BufferConfig, ClapFeature,
    ClapPlugin, MidiConfig, Params, Plugin, PluginState, PolyModulationConfig, ProcessContext,
    ProcessMode, ProcessStatus, RemoteControlsContext, Vst3Plugin, Vst3SubCategory,
};
use params::Controls;
use player::Player;
use song::Song;
use stage::Stage;
use std::sync::Arc;
use tuner::Tuner;
use tuning::MtsClient;
use workshop::Workshop;

/// The plug-in.
#[derive(Default)]
pub struct Idiophone {
    controls: Arc<Controls>,
    player: Option<Player>,
    workshop: Option<Workshop>,
    maker: Option<Maker>,
    #[cfg(feature = "gui")]
    desk: editor::Desk,
}

impl Plugin for Idiophone {
    const NAME: &'static str = "Idiophone";
    const VENDOR: &'static str = "Idiophone";
    const URL: &'static str = "";
    const EMAIL: &'static str = "";
    const VERSION: &'static str = env!("CARGO_PKG_VERSION");
    const AUDIO_IO_LAYOUTS: &'static [AudioIOLayout] = &layouts::LAYOUTS;
    const MIDI_INPUT: MidiConfig = MidiConfig::MidiCCs;
    const SAMPLE_ACCURATE_AUTOMATION: bool = true;
    /// Beyond this many events in a block the framework allocates.
    const INPUT_EVENT_CAPACITY: usize = 8192;

    #[cfg(feature = "gui")]
    type Editor = editor::Window;
    #[cfg(not(feature = "gui"))]
    type Editor = ();
    type SysExMessage = ();
    type BackgroundTask = ();

    fn params(&self) -> Arc<dyn Params> {
        #[cfg(feature = "gui")]
        let params = self.desk.params(&self.controls);
        #[cfg(not(feature = "gui"))]
        let params = self.controls.clone();
        Arc::new(Song::new(params, Arc::clone(&self.controls)))
    }

    #[cfg(feature = "gui")]
    fn editor(&mut self, _executor: AsyncExecutor<Self>) -> Option<Self::Editor> {
        Some(self.desk.window(&self.controls))
    }

    fn filter_state(state: &mut PluginState) {
        params::heal(state);
    }

    fn activate(
        &mut self,
        _layout: &AudioIOLayout,
        buffer: &BufferConfig,
        _context: &mut impl ActivateContext<Self>,
    ) -> bool {
        let rate_hz = f64::from(buffer.sample_rate);
        let shelf = self.controls.shelf();
        self.workshop = Some(Workshop::open(Arc::clone(shelf), rate_hz));
        let number = shelf.number(self.controls.body.index());
        self.maker = Some(Maker::open(self.controls.stores(), number, rate_hz));
        let mut stage = match self.controls.shaped(number) {
            Some(own) => Stage::new(number, own.bank(), rate_hz),
            None => Stage::new(number, &shelf.bank(number), rate_hz),
        };
        stage.trim(&self.controls.trims().get());
        let stage = match buffer.process_mode {
            ProcessMode::Offline => stage.patient(),
            ProcessMode::Realtime | ProcessMode::Buffered => stage,
        };
        let controls = Arc::clone(&self.controls);
        self.player = Some(Player::new(stage, self.tuner(), controls, rate_hz));
        true
    }

    fn deactivate(&mut self) {
        self.workshop = None;
        self.maker = None;
    }

    fn reset(&mut self) {
        if let Some(player) = &mut self.player {
            player.reset();
        }
    }

    fn process(
        &mut self,
        buffer: &mut Buffer<'_>,
        aux: &mut AuxiliaryBuffers<'_>,
        context: &mut impl ProcessContext<Self>,
    ) -> ProcessStatus {
        let channels = buffer.as_slice();
        let (Some(player), [left, right]) = (&mut self.player, &mut *channels) else {
            for channel in channels {
                channel.fill(0.0);
            }
            return ProcessStatus::Normal;
        };
        if let Some(workshop) = &self.workshop {
            let number = self.controls.shelf().number(self.controls.body.index());
            player.stage().turn(number, workshop);
            if let Some(maker) = &self.maker {
                let drawing = self.controls.shape.drawing();
                player.stage().reshape(&drawing, maker, workshop);
            }
        }
        #[cfg(feature = "gui")]
        let open = self.desk.is_open();
        #[cfg(feature = "gui")]
        if open {
            self.desk.play(player);
        }
        player.play::<Self>(&mut layouts::outputs(left, right, aux), context);
        #[cfg(feature = "gui")]
        if open {
            self.desk.report(player, [left, right]);
            // A click is to be heard at once, whatever the host makes of silence.
            return ProcessStatus::KeepAlive;
        }
        match player.tail() {
            Some(0) => ProcessStatus::Normal,
            Some(frames) => ProcessStatus::Tail(frames),
            None => ProcessStatus::KeepAlive,
        }
    }
}

impl ClapPlugin for Idiophone {
    const CLAP_ID: &'static str = "org.idiophone.idiophone";
    const CLAP_DESCRIPTION: Option<&'static str> =
        Some("Chimes and other struck objects, sounded from their shape and material");
    const CLAP_MANUAL_URL: Option<&'static str> = None;
    const CLAP_SUPPORT_URL: Option<&'static str> = None;
    const CLAP_FEATURES: &'static [ClapFeature] = &[
        ClapFeature::Instrument,
        ClapFeature::Synthesizer,
        ClapFeature::Stereo,
    ];

    const CLAP_POLY_MODULATION_CONFIG: Option<PolyModulationConfig> = Some(PolyModulationConfig {
        max_voice_capacity: 128,
        // A key has one body: another note on it goes on with what rings there.
        supports_overlapping_voices: false,
    });

    fn remote_controls(&self, context: &mut impl RemoteControlsContext) {
        remote::pages(&self.controls, context);
    }
}

impl Idiophone {
    /// How keys are tuned now, by whoever tunes them.
    fn tuner(&self) -> Tuner {
        let texts = self.controls.tuning();
        if let Some(folder) = user_folder() {
            texts.visit(&folder);
        }
        let master = MtsClient::connect().unwrap_or_else(|error| {
            nice_plug::nice_warn!("{error}");
            None
        });
        Tuner::new(texts.tuning(), master)
    }
}

impl Vst3Plugin for Idiophone {
    const VST3_CLASS_ID: [u8; 16] = *b"IdiophoneModal01";
    const VST3_SUBCATEGORIES: &'static [Vst3SubCategory] =
        &[Vst3SubCategory::Instrument, Vst3SubCategory::Synth];
}

nice_plug::nice_export_vst3!(Idiophone);
