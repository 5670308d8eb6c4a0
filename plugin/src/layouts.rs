//! The outputs that a host can have.

use crate::engine::{OUTPUTS, Outputs};
use nice_plug::prelude::{AudioIOLayout, AuxiliaryBuffers, NonZeroU32, PortNames, new_nonzero_u32};

/// Outputs beside the main one.
const EXTRA: usize = OUTPUTS - 1;

/// What a host has that says nothing: the main output, which nice-plug 0.4.2 calls by the name of the main
/// input.
const STEREO: AudioIOLayout = AudioIOLayout {
    main_input_channels: None,
    main_output_channels: NonZeroU32::new(2),
    names: PortNames {
        layout: Some("Stereo"),
        main_input: Some("Main"),
        main_output: Some("Main"),
        ..PortNames::const_default()
    },
    ..AudioIOLayout::const_default()
};

/// The layouts of outputs, the usual one first.
pub(crate) const LAYOUTS: [AudioIOLayout; 2] = [
    STEREO,
    AudioIOLayout {
        aux_output_ports: &[new_nonzero_u32(2); EXTRA],
        names: PortNames {
            layout: Some("8 x stereo"),
            aux_outputs: &[
                "Output 2", "Output 3", "Output 4", "Output 5", "Output 6", "Output 7", "Output 8",
            ],
            ..STEREO.names
        },
        ..STEREO
    },
];

/// The outputs of a block.
pub(crate) fn outputs<'a>(
    left: &'a mut [f32],
    right: &'a mut [f32],
    others: &'a mut AuxiliaryBuffers<'_>,
) -> Outputs<'a> {
    let mut outputs = Outputs::main(left, right);
    for (number, buffer) in (1..).zip(others.outputs.iter_mut()) {
        if let [left, right] = buffer.as_slice() {
            outputs.connect(number, left, right);
        }
    }
    outputs
}
