//! `render`: a MIDI file through the built plug-in into a WAV file.

use super::bundle;
use crate::host::Event;
use crate::host::{Audio, Library, Plugin, TimedEvent};
use crate::midi::{self, Song};
use crate::output::PendingFile;
use crate::settings;
use anyhow::{Context, Result, bail};
use clap::Args;
use hound::{SampleFormat, WavSpec, WavWriter};
use modes::tuning::Tuning;
use std::fs::File;
use std::io::BufWriter;
use std::ops::RangeInclusive;
use std::path::PathBuf;

/// Sample rates that can be asked for, in Hz.
const RATES_HZ: RangeInclusive<u32> = 8_000..=384_000;
/// Block lengths that can be asked for, in frames.
const BLOCKS: RangeInclusive<u32> = 1..=65_536;
/// Tails that can be asked for, in s.
const TAILS_S: RangeInclusive<f64> = 0.0..=600.0;
/// The tail ends at the latest this long after the song unless asked for, in s.
const LONGEST_TAIL_S: f64 = 30.0;
/// Full scale times this is silence: −90 dBFS.
const SILENCE: f32 = 3.162_277_7e-5;
/// Silence this long ends the tail, in s.
const SILENT_S: f64 = 0.5;
/// Frames of two 32-bit floats that the 32-bit lengths of a WAV file can count.
const WAV_FRAMES: u64 = (u32::MAX as u64 - 128) / 8;

/// Arguments of `render`.
#[derive(Args, Debug, Clone)]
pub struct Render {
    /// MIDI file, format 0 or 1
    #[arg(value_name = "SONG.mid")]
    pub song: PathBuf,
    /// WAV file to write: 32-bit float, stereo
    #[arg(value_name = "OUT.wav")]
    pub out: PathBuf,
    /// Start with a parameter at a value, written as a host shows it ("Output=-6 dB")
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub set: Vec<String>,
    /// Step a parameter to values at times in seconds ("Alpha 1@0:2 ns,4.5:300 ns")
    #[arg(long, value_name = "NAME@SECONDS:VALUE,…")]
    pub automate: Vec<String>,
    /// Tune the keys by a Scala scale
    #[arg(long, value_name = "SCALE.scl")]
    pub scale: Option<PathBuf>,
    /// Lay the scale on the keys by a Scala keyboard map
    #[arg(long, value_name = "MAP.kbm")]
    pub keyboard: Option<PathBuf>,
    /// Sample rate in Hz
    #[arg(long, value_name = "HZ", default_value_t = 48_000)]
    pub rate: u32,
    /// Longest block that the plug-in is asked for, in frames
    #[arg(long, value_name = "FRAMES", default_value_t = 512)]
    pub block: u32,
    /// Go on this long after the song; without it, until 0.5 s below −90 dBFS, 30 s at most
    #[arg(long, value_name = "SECONDS", allow_hyphen_values = true)]
    pub tail: Option<f64>,
    /// Another plug-in than the bundled one, which is built first if it is missing
    #[arg(long, value_name = "FILE.clap")]
    pub plugin: Option<PathBuf>,
}

/// What has been written.
struct Sound {
    writer: WavWriter<BufWriter<File>>,
    frames: u64,
    peak: f32,
    silent_frames: u64,
}

impl Render {
    /// Renders `song` to `out` with the bundled plug-in as it comes.
    pub(super) fn plain(song: PathBuf, out: PathBuf) -> Self {
        Self {
            song,
            out,
            set: Vec::new(),
            automate: Vec::new(),
            scale: None,
            keyboard: None,
            rate: 48_000,
            block: 512,
            tail: None,
            plugin: None,
        }
    }

    pub(super) fn run(&self) -> Result<()> {
        self.validate()?;
        let song = Song::read(&self.song)?;
        let rate_hz = f64::from(self.rate);
        let end = midi::frame(song.seconds, rate_hz);
        let longest = end + midi::frame(self.tail.unwrap_or(LONGEST_TAIL_S), rate_hz);
        if longest > WAV_FRAMES {
            let allowed_s = WAV_FRAMES as f64 / rate_hz;
            bail!(
                "{}: lasts {:.0} s with its tail; allowed: {allowed_s:.0} s, what a WAV file holds at {} Hz",
                self.song.display(),
                longest as f64 / rate_hz,
                self.rate
            );
        }
        let tuning = self.tuning()?;
        let (pending, file) = PendingFile::create(&self.out)?;
        let path = match &self.plugin {
            Some(path) => path.clone(),
            None => bundle::bundled_clap()?,
        };
        let mut plugin = Library::open(&path)?.instantiate()?;
        if let Some([scale, keyboard]) = &tuning {
            plugin.tune(scale, keyboard)?;
        }
        let events = self.events(&mut plugin, &song)?;
        plugin.activate(rate_hz, self.block)?;
        let mut sound = Sound::new(file, self.rate)?;
        plugin
            .on_audio_thread(|audio| self.play(audio, &events, end, longest, &mut sound))?
            .with_context(|| self.out.display().to_string())?;
        let (frames, peak) = (sound.frames, sound.peak);
        sound.writer.finalize()?;
        pending.finish()?;
        println!(
            "{}: {:.2} s, {} Hz, stereo, 32-bit float, peak {:.1} dBFS",
            self.out.display(),
            frames as f64 / rate_hz,
            self.rate,
            20.0 * peak.log10()
        );
        Ok(())
    }

    fn validate(&self) -> Result<()> {
        if !RATES_HZ.contains(&self.rate) {
            bail!("--rate {}: allowed: 8000…384000 Hz", self.rate);
        }
        if !BLOCKS.contains(&self.block) {
            bail!("--block {}: allowed: 1…65536 frames", self.block);
        }
        match self.tail {
            Some(tail) if !TAILS_S.contains(&tail) => bail!("--tail {tail}: allowed: 0…600 s"),
            _ => Ok(()),
        }
    }

    /// The texts of the scale and of the keyboard map, if there is one of them; both can be read.
    fn tuning(&self) -> Result<Option<[String; 2]>> {
        if self.scale.is_none() && self.keyboard.is_none() {
            return Ok(None);
        }
        Tuning::load(self.scale.as_deref(), self.keyboard.as_deref())?;
        let text = |path: &Option<PathBuf>| -> Result<String> {
            let bytes = path.as_deref().map(std::fs::read).transpose()?;
            Ok(plain(bytes.unwrap_or_default()))
        };
        Ok(Some([text(&self.scale)?, text(&self.keyboard)?]))
    }

    /// Applies the settings and gives the song's events and the automation's, by rising frame.
    fn events(&self, plugin: &mut Plugin, song: &Song) -> Result<Vec<TimedEvent>> {
        let mut settings = Vec::new();
        for text in &self.set {
            settings.push(settings::setting(plugin, text)?);
        }
        let rate_hz = f64::from(self.rate);
        let mut events = Vec::new();
        for text in &self.automate {
            for step in settings::automation(plugin, text)? {
                let (id, value) = (step.id, step.value);
                let event = Event::Param { id, value };
                events.push(event.at(midi::frame(step.seconds, rate_hz)));
            }
        }
        if !settings.is_empty() {
            plugin.set(&settings)?;
        }
        // The sort is stable: a note struck as a parameter steps sounds with the new value.
        events.extend(song.at_rate(rate_hz));
        events.sort_by_key(|event| event.frame);
        Ok(events)
    }

    /// Plays the song and its tail.
    fn play(
        &self,
        audio: &mut Audio<'_>,
        events: &[TimedEvent],
        end: u64,
        longest: u64,
        sound: &mut Sound,
    ) -> Result<()> {
        let silent_frames = midi::frame(SILENT_S, f64::from(self.rate));
        // The sound ends at a frame, not with a block: its length is the same for any of them.
        let over = |sound: &Sound| {
            sound.frames >= longest
                || self.tail.is_none()
                    && sound.frames >= end
                    && sound.silent_frames >= silent_frames
        };
        let block = u64::from(self.block);
        let mut events = events;
        while !over(sound) {
            let start = sound.frames;
            let next = (start + block).min(longest);
            let due = events.partition_point(|event| event.frame < next);
            let (now, later) = events.split_at(due);
            events = later;
            let now: Vec<_> = now.iter().map(|at| at.event.at(at.frame - start)).collect();
            let take = audio.play(&now, (next - start) as usize, self.block as usize)?;
            for (&left, &right) in take.left.iter().zip(&take.right) {
                if over(sound) {
                    break;
                }
                sound.write(left, right)?;
            }
        }
        Ok(())
    }
}

/// A file of Scala's as a text: some are in Latin-1, whose bytes are the characters' numbers.
fn plain(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes)
        .unwrap_or_else(|error| error.as_bytes().iter().copied().map(char::from).collect())
}

impl Sound {
    fn new(file: File, rate: u32) -> Result<Self> {
        let spec = WavSpec {
            channels: 2,
            sample_rate: rate,
            bits_per_sample: 32,
            sample_format: SampleFormat::Float,
        };
        Ok(Self {
            writer: WavWriter::new(BufWriter::new(file), spec)?,
            frames: 0,
            peak: 0.0,
            silent_frames: 0,
        })
    }

    fn write(&mut self, left: f32, right: f32) -> Result<()> {
        self.writer.write_sample(left)?;
        self.writer.write_sample(right)?;
        let level = left.abs().max(right.abs());
        self.peak = self.peak.max(level);
        self.silent_frames = if level > SILENCE {
            0
        } else {
            self.silent_frames + 1
        };
        self.frames += 1;
        Ok(())
    }
}
