//! What has been heard of late: frequencies over the last seconds.

use super::super::axis::{Axis, notch};
use super::super::link::Link;
use super::super::theme::{NEAR, Theme, small};
use super::fourier::{Fourier, STRETCH};
use egui::{
    Align2, Color32, ColorImage, Id, Image, Rangef, Rect, Role, Sense, Stroke, TextureHandle,
    TextureOptions, Ui, WidgetInfo, pos2, vec2,
};

/// Seconds that are shown, and instants in them.
const SHOWN_S: f64 = 4.0;
const INSTANTS: usize = 256;
/// Bands over frequency, and what they span in Hz.
const BANDS: usize = 112;
const HZ: [f64; 2] = [40.0, 20e3];
/// Levels in dB of full scale that are black and white.
const LEVELS_DB: [f32; 2] = [-100.0, -18.0];
/// Rate that is taken if none is known, in Hz.
const USUAL_HZ: f64 = 48e3;

/// What is remembered of the sound.
pub(in super::super) struct Spectrum {
    read: u64,
    /// Samples that are not over yet, the last stretch before them included.
    sound: Vec<f32>,
    /// Instant by instant, each band's level as a share of the range.
    levels: Vec<[u8; BANDS]>,
    next: usize,
    fourier: Fourier,
    texture: Option<TextureHandle>,
    /// Theme and instants of the texture.
    drawn: Option<(bool, usize)>,
    /// Instants so far.
    count: usize,
}

impl Default for Spectrum {
    fn default() -> Self {
        Self {
            read: 0,
            sound: vec![0.0; STRETCH],
            levels: vec![[0; BANDS]; INSTANTS],
            next: 0,
            fourier: Fourier::default(),
            texture: None,
            drawn: None,
            count: 0,
        }
    }
}

/// Lower edge of a band, in Hz.
fn edge(band: usize) -> f64 {
    HZ[0] * (HZ[1] / HZ[0]).powf(band as f64 / BANDS as f64)
}

impl Spectrum {
    /// Takes in what has been played since it was last called, at `rate_hz`, or at the usual rate if that
    /// is 0.
    pub(in super::super) fn hear(&mut self, link: &Link, rate_hz: f64) {
        let rate_hz = if rate_hz > 0.0 { rate_hz } else { USUAL_HZ };
        #[expect(clippy::cast_sign_loss, reason = "rates are not negative")]
        let hop = (SHOWN_S * rate_hz / INSTANTS as f64).max(1.0) as usize;
        let lost = link.heard(&mut self.read, &mut self.sound);
        for _ in 0..(lost as usize / hop).min(INSTANTS) {
            self.put([0; BANDS]);
        }
        let mut done = 0;
        while self.sound.len() - done >= STRETCH + hop {
            done += hop;
            let instant = self.bands(done, rate_hz);
            self.put(instant);
        }
        self.sound.drain(..done);
    }

    fn put(&mut self, instant: [u8; BANDS]) {
        self.levels[self.next] = instant;
        self.next = (self.next + 1) % INSTANTS;
        self.count += 1;
    }

    /// The level of each band in the stretch from a sample on: its loudest bin's, or what lies between bins.
    fn bands(&mut self, from: usize, rate_hz: f64) -> [u8; BANDS] {
        let sound = &self.sound[from..from + STRETCH];
        let bins: Vec<f32> = self.fourier.amplitudes(sound).collect();
        let place = |hz: f64| (hz * STRETCH as f64 / rate_hz).min((bins.len() - 2) as f64);
        let between = |at: f64| {
            #[expect(clippy::cast_sign_loss, reason = "frequencies are not negative")]
            let bin = at as usize;
            let share = (at - bin as f64) as f32;
            bins[bin] + share * (bins[bin + 1] - bins[bin])
        };
        std::array::from_fn(|band| {
            let [from, to] = [band, band + 1].map(|band| place(edge(band)));
            #[expect(clippy::cast_sign_loss, reason = "frequencies are not negative")]
            let inside =
                &bins[from.ceil() as usize..(to.floor() as usize + 1).max(from.ceil() as usize)];
            let loudest = inside
                .iter()
                .fold(between(0.5 * (from + to)), |most, x| most.max(*x));
            let db = 20.0 * loudest.max(1e-9).log10();
            let share = (db - LEVELS_DB[0]) / (LEVELS_DB[1] - LEVELS_DB[0]);
            #[expect(clippy::cast_sign_loss, reason = "within 0 to 255")]
            let level = (255.0 * share.clamp(0.0, 1.0)) as u8;
            level
        })
    }

    /// Draws it in `area`.
    pub(in super::super) fn show(&mut self, ui: &mut Ui, area: Rect, theme: &Theme) {
        let plot = Rect::from_min_max(
            pos2(area.left() + 30.0, area.top() + 4.0),
            pos2(area.right() - 4.0, area.bottom() - 18.0),
        );
        let response = ui.interact(plot, Id::unique("spectrum"), Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::Group, true, "Spectrogram"));
        self.paint(ui, theme);
        if let Some(texture) = &self.texture {
            Image::new((texture.id(), plot.size()))
                .corner_radius(3)
                .paint_at(ui, plot);
        }
        let painter = ui.painter().with_clip_rect(area);
        let hz = Axis::log(HZ, Rangef::new(plot.bottom(), plot.top()));
        let fine = Stroke::new(1.0, theme.line.gamma_multiply(0.45));
        for (tick, text) in [(100.0, "100"), (1e3, "1k"), (10e3, "10k")] {
            let y = hz.place(tick);
            painter.hline(plot.x_range(), y, fine);
            notch(&painter, pos2(plot.left() - NEAR, y), text, theme);
        }
        for back_s in 0..4u8 {
            let share = 1.0 - f32::from(back_s) / SHOWN_S as f32;
            let x = plot.left() + share * plot.width();
            let (text, anchor) = if back_s == 0 {
                ("now".to_owned(), Align2::RIGHT_CENTER)
            } else {
                painter.vline(x, plot.y_range(), fine);
                (format!("−{back_s} s"), Align2::CENTER_CENTER)
            };
            let at = pos2(x, plot.bottom() + 9.0);
            painter.text(at, anchor, text, small(), theme.quiet);
        }
        let at = plot.left_bottom() + vec2(-NEAR, 9.0);
        notch(&painter, at, "Hz", theme);
        response.on_hover_text(
            "What has sounded in the last four seconds: low frequencies below, the loudest brightest. \
             A partial that rings is a line that fades.",
        );
    }

    /// Makes the picture anew, if it has changed.
    fn paint(&mut self, ui: &Ui, theme: &Theme) {
        let drawn = Some((theme.dark, self.count));
        if self.drawn == drawn {
            return;
        }
        self.drawn = drawn;
        let colours: Vec<Color32> = (0..=255u8).map(|level| heat(level, theme)).collect();
        let mut pixels = vec![Color32::BLACK; INSTANTS * BANDS];
        for instant in 0..INSTANTS {
            let levels = &self.levels[(self.next + instant) % INSTANTS];
            for (band, level) in levels.iter().enumerate() {
                pixels[(BANDS - 1 - band) * INSTANTS + instant] = colours[usize::from(*level)];
            }
        }
        let image = ColorImage::new([INSTANTS, BANDS], pixels);
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => {
                let texture = ui
                    .ctx()
                    .load_texture("spectrum", image, TextureOptions::LINEAR);
                self.texture = Some(texture);
            }
        }
    }

    /// A new window, which knows nothing of the picture.
    pub(in super::super) fn forget(&mut self) {
        (self.texture, self.drawn) = (None, None);
    }
}

/// The colour of a level: from the ground over what glows to the brightest.
fn heat(level: u8, theme: &Theme) -> Color32 {
    let share = f32::from(level) / 255.0;
    let brightest = if theme.dark {
        Color32::from_rgb(255, 246, 224)
    } else {
        Color32::from_rgb(80, 36, 0)
    };
    if share < 0.65 {
        Theme::mix(theme.ground, theme.glow, (share / 0.65).powf(1.3))
    } else {
        Theme::mix(theme.glow, brightest, (share - 0.65) / 0.35)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f32::consts::TAU;

    #[test]
    fn a_tone_is_a_line_at_its_frequency_and_what_was_missed_is_dark() {
        let link = Link::default();
        let mut spectrum = Spectrum::default();
        let tone: Vec<f32> = (0..24_000u16)
            .map(|i| 0.5 * (TAU * 1000.0 / 48e3 * f32::from(i)).sin())
            .collect();
        link.hear(&tone, &tone);
        spectrum.hear(&link, 48e3);
        assert!(spectrum.count > 20);
        let last = spectrum.levels[spectrum.next - 1];
        let loudest = (0..BANDS).max_by_key(|band| last[*band]).unwrap();
        assert!(
            (edge(loudest - 1)..edge(loudest + 2)).contains(&1000.0),
            "{}",
            edge(loudest)
        );
        assert_eq!(last[loudest], 255, "−6 dB is beyond the brightest");
        assert!(last[10] < 40);
        let before = spectrum.count;
        for _ in 0..8 {
            link.hear(&tone, &tone);
        }
        spectrum.hear(&link, 48e3);
        let told = (spectrum.count - before) as f64 * SHOWN_S / INSTANTS as f64;
        assert!((told - 4.0).abs() < 0.1, "{told} s of 4 s");
        assert!(spectrum.levels.iter().any(|instant| instant[loudest] == 0));
    }
}
