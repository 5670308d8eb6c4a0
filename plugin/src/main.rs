//! The instrument as a program of its own: sound, MIDI and the window without a DAW.

use std::process::ExitCode;

fn main() -> ExitCode {
    if nice_plug::nice_export_standalone::<idiophone::Idiophone>() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
