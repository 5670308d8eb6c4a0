//! A host's modulation of a parameter for one note alone.

use nice_plug::prelude::{FloatParam, Param};

/// How far `modulation`, in shares of the host's 0…1, moves a note's value from the one that all notes
/// share, in the parameter's unit.
///
/// The host counts from the value that is set, whatever modulates all notes together; a note that it does
/// not modulate has that in place.
pub(super) fn moved(control: &FloatParam, modulation: f64) -> f64 {
    if modulation == 0.0 {
        return 0.0;
    }
    let note = control.preview_plain(control.unmodulated_normalized_value() + modulation as f32);
    f64::from(note) - f64::from(control.value())
}

#[cfg(test)]
mod tests {
    use super::moved;
    use nice_plug::prelude::{FloatParam, FloatRange};

    #[test]
    fn notes_move_within_the_range() {
        let range = FloatRange::Linear {
            min: 0.0,
            max: 100.0,
        };
        let control = FloatParam::new("", 30.0, range);
        for (modulation, by) in [(0.0, 0.0), (0.25, 25.0), (1.0, 70.0), (-0.5, -30.0)] {
            assert!((moved(&control, modulation) - by).abs() < 1e-4);
        }
    }
}
