//! Amplitude against frequency after a strike, as in van den Doel & Pai 1998, Figs. 5 to 7.

use crate::canvas::{self, Canvas, Drawing, FAINT, INK, NAME, SMALL, TITLE};
use anyhow::Result;
use modes::analytic::Struck;
use plotters::style::RGBColor;
use plotters::style::text_anchor::{HPos, VPos};
use std::path::Path;

/// The figure's edges, in pixels.
const LEFT: i32 = 84;
const RIGHT: i32 = 1150;
const TOP: i32 = 64;
const BOTTOM: i32 = 608;

/// Between two ticks of the frequency's axis, in Hz.
const TICK_HZ: f64 = 1000.0;

const GRID: RGBColor = RGBColor(36, 38, 48);
const STEM: RGBColor = RGBColor(255, 176, 64);

/// Draws `struck` as stems, the loudest as high as the figure, as a PNG. Both axes are even.
///
/// # Errors
///
/// If the file cannot be written.
pub(crate) fn draw_stems(title: &str, struck: &[Struck], path: &Path) -> Result<()> {
    let axes = Axes::of(struck);
    canvas::save(path, |canvas| {
        canvas.write(title, TITLE, INK, [LEFT, 30], (HPos::Left, VPos::Center))?;
        axes.draw(canvas)?;
        for mode in struck {
            let x = axes.x(mode.hz);
            canvas.fill([x, axes.y(mode.amplitude.abs())], [x, BOTTOM], STEM)?;
        }
        Ok(())
    })
}

/// Even axes from zero to a little beyond the highest and the loudest mode.
struct Axes {
    highest_hz: f64,
    loudest: f64,
}

impl Axes {
    fn of(struck: &[Struck]) -> Self {
        let highest_hz = struck.iter().map(|mode| mode.hz).fold(0.0, f64::max);
        let loudest = struck.iter().map(|mode| mode.amplitude.abs());
        Self {
            highest_hz: (highest_hz / TICK_HZ).ceil().max(1.0) * TICK_HZ,
            loudest: loudest.fold(0.0, f64::max),
        }
    }

    fn x(&self, hz: f64) -> i32 {
        LEFT + (hz / self.highest_hz * f64::from(RIGHT - LEFT)).round() as i32
    }

    fn y(&self, amplitude: f64) -> i32 {
        let share = if self.loudest > 0.0 {
            amplitude / self.loudest
        } else {
            0.0
        };
        BOTTOM - (share * f64::from(BOTTOM - TOP)).round() as i32
    }

    fn draw(&self, canvas: &Canvas<'_>) -> Drawing<()> {
        let (below, beside) = ((HPos::Center, VPos::Top), (HPos::Right, VPos::Center));
        let mut hz = 0.0;
        while hz <= self.highest_hz {
            let x = self.x(hz);
            canvas.fill([x, TOP], [x, BOTTOM], GRID)?;
            canvas.write(&format!("{hz:.0}"), SMALL, INK, [x, BOTTOM + 10], below)?;
            hz += TICK_HZ;
        }
        for fifth in 0..=5 {
            let share = f64::from(fifth) / 5.0;
            let y = self.y(share * self.loudest);
            canvas.fill([LEFT, y], [RIGHT, y], GRID)?;
            canvas.write(&format!("{share:.1}"), SMALL, INK, [LEFT - 10, y], beside)?;
        }
        let at = [(LEFT + RIGHT) / 2, BOTTOM + 36];
        canvas.write("frequency in Hz", NAME, FAINT, at, below)?;
        let at = [RIGHT, TOP - 22];
        canvas.write(
            "amplitude, of the loudest",
            NAME,
            FAINT,
            at,
            (HPos::Right, VPos::Center),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_loudest_reaches_the_top_and_half_of_it_half_the_way() {
        let of = |hz, amplitude| Struck { hz, amplitude };
        let axes = Axes::of(&[of(500.0, -4.0), of(1990.0, 2.0)]);
        assert_eq!(axes.y(4.0), TOP);
        assert_eq!(axes.y(2.0), TOP.midpoint(BOTTOM));
        assert_eq!(
            [axes.x(0.0), axes.x(1000.0), axes.x(2000.0)],
            [LEFT, LEFT.midpoint(RIGHT), RIGHT]
        );
    }
}
