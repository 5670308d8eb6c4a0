//! What hands do, as MIDI, MPE, CLAP and VST3 have it.

mod channels;
mod mpe;
mod notes;
mod pedals;
mod real_time;
mod support;
