//! What the mallet does: the force of the last blow over time, and which partials it reaches.

use super::super::axis::{Axis, notch};
use super::super::places::halves;
use super::super::plot::Scene;
use super::super::ringing::hertz;
use super::super::theme::{NEAR, Theme, small};
use crate::engine::{Mallet, Pulse, Settings, Tweak};
use egui::epaint::{Mesh, Vertex, WHITE_UV};
use egui::{
    Align2, Color32, CornerRadius, Painter, Pos2, Rangef, Rect, Shape, Stroke, Ui, pos2, vec2,
};

/// Frequencies in Hz and levels in dB below that at 0 Hz that are drawn.
const HZ: [f64; 2] = [40.0, 20e3];
const FLOOR_DB: f32 = 60.0;
/// Points of the spectrum.
const POINTS: usize = 140;
/// Level in dB that bounds what a blow reaches.
const REACHES_DB: f64 = -12.0;

/// The last blow, worked out once.
#[derive(Default)]
pub(in super::super) struct Blow {
    known: Option<(Asked, Pulse, Vec<f64>)>,
}

/// What a pulse depends on.
#[derive(Clone, Copy, PartialEq)]
struct Asked {
    instrument: usize,
    key: u8,
    velocity: f64,
    position: f64,
    mallet: Mallet,
    tweak: Tweak,
    range_db: f64,
}

fn frequency(point: usize) -> f64 {
    HZ[0] * (HZ[1] / HZ[0]).powf(point as f64 / (POINTS - 1) as f64)
}

fn below_db(share: f64) -> f32 {
    (-20.0 * share.max(1e-6).log10()) as f32
}

impl Blow {
    /// The pulse of the last blow on the body that is shown, or of one as it would be, and its spectrum.
    fn follow(&mut self, velocity: f64, scene: &Scene<'_>) -> (&Pulse, &[f64]) {
        let Settings { mallet, tweak, .. } = *scene.settings;
        let key = scene.shown.key;
        let struck = scene.frame.struck.filter(|struck| struck.key == key);
        let asked = Asked {
            instrument: scene.shown.instrument,
            key,
            velocity: struck.map_or(velocity, |struck| struck.velocity),
            position: struck.map_or(scene.settings.strike_position, |struck| struck.position),
            mallet,
            tweak,
            range_db: scene.settings.velocity_range_db,
        };
        if self.known.as_ref().is_none_or(|(old, _, _)| *old != asked) {
            self.known = None;
        }
        let (_, pulse, spectrum) = self.known.get_or_insert_with(|| {
            let bank = &scene.shown.bank;
            let body = bank.bodies.iter().find(|body| body.key == key);
            let none = Pulse {
                step_s: 1e-5,
                force_n: Vec::new(),
            };
            let pulse = body.map_or(none, |body| {
                Pulse::of(bank, body, scene.settings, asked.velocity, asked.position)
            });
            let spectrum = (0..POINTS).map(|i| pulse.share(frequency(i))).collect();
            (asked, pulse, spectrum)
        });
        (pulse, spectrum)
    }

    /// Draws both in `area`.
    pub(in super::super) fn show(&mut self, ui: &Ui, area: Rect, velocity: f64, scene: &Scene<'_>) {
        let theme = scene.theme;
        let (pulse, spectrum) = self.follow(velocity, scene);
        let painter = ui.painter().with_clip_rect(area);
        let mallet = &scene.settings.mallet;
        let reaches = (0..POINTS)
            .rev()
            .find(|i| below_db(spectrum[*i]) <= -REACHES_DB as f32);
        let told = format!(
            "{:.0} g, radius {:.0} mm, {}: {:.0} N for {:.2} ms, bright up to {}",
            1e3 * mallet.mass_kg,
            1e3 * mallet.head_radius_m,
            pascals(mallet.hardness_pa),
            pulse.peak_n(),
            1e3 * pulse.length_s(),
            hertz(frequency(reaches.unwrap_or(0)))
        );
        let at = area.left_top() + vec2(2.0, 2.0);
        painter.text(at, Align2::LEFT_TOP, told, small(), theme.text);
        let rest = Rect::from_min_max(area.left_top() + vec2(0.0, 20.0), area.max);
        let [left, right] = halves(rest, 0.42, true);
        force(&painter, inner(left), pulse, theme);
        reach(&painter, inner(right), spectrum, scene);
    }
}

/// A plot's place within its part.
fn inner(part: Rect) -> Rect {
    Rect::from_min_max(part.min + vec2(38.0, 4.0), part.max - vec2(4.0, 18.0))
}

/// A modulus for people.
fn pascals(pascals: f64) -> String {
    if pascals >= 1e9 {
        format!("{:.1} GPa", 1e-9 * pascals)
    } else {
        format!("{:.0} MPa", 1e-6 * pascals)
    }
}

/// 1, 2 or 5 times a power of ten that is a third to the whole of `most`.
fn round(most: f64) -> f64 {
    let power = 10f64.powf(most.max(1e-12).log10().floor());
    let steps = [5.0, 2.0, 1.0].map(|step| step * power);
    steps
        .into_iter()
        .find(|step| *step <= most)
        .unwrap_or(power)
}

/// Force over time.
fn force(painter: &Painter, area: Rect, pulse: &Pulse, theme: &Theme) {
    painter.rect_filled(area, CornerRadius::same(3), theme.ground);
    let (most_n, whole_s) = (1.15 * pulse.peak_n(), 1.25 * pulse.length_s());
    if most_n <= 0.0 {
        return;
    }
    let fine = Stroke::new(1.0, theme.line.gamma_multiply(0.55));
    let y_of = |force_n: f64| area.bottom() - area.height() * (force_n / most_n) as f32;
    let x_of = |time_s: f64| area.left() + area.width() * (time_s / whole_s) as f32;
    let [tick_n, tick_s] = [round(most_n), round(whole_s)];
    painter.hline(area.x_range(), y_of(tick_n), fine);
    notch(
        painter,
        pos2(area.left() - NEAR, y_of(tick_n)),
        &format!("{tick_n:.0} N"),
        theme,
    );
    painter.vline(x_of(tick_s), area.y_range(), fine);
    let at = pos2(x_of(tick_s), area.bottom() + 9.0);
    let text = format!("{} ms", 1e3 * tick_s);
    painter.text(at, Align2::CENTER_CENTER, text, small(), theme.quiet);
    let points: Vec<Pos2> = std::iter::once(0.0)
        .chain(pulse.force_n.iter().copied())
        .chain([0.0])
        .enumerate()
        .map(|(i, force_n)| pos2(x_of(i as f64 * pulse.step_s), y_of(force_n)))
        .collect();
    filled(painter, area, &points, theme.glow);
}

/// Which frequencies the force has, and the partials that it reaches.
fn reach(painter: &Painter, area: Rect, spectrum: &[f64], scene: &Scene<'_>) {
    let theme = scene.theme;
    painter.rect_filled(area, CornerRadius::same(3), theme.ground);
    let hz = Axis::log(HZ, area.x_range());
    let fine = Stroke::new(1.0, theme.line.gamma_multiply(0.55));
    for (tick, text) in [(100.0, "100"), (1e3, "1k"), (10e3, "10k")] {
        painter.vline(hz.place(tick), area.y_range(), fine);
        let at = pos2(hz.place(tick), area.bottom() + 9.0);
        painter.text(at, Align2::CENTER_CENTER, text, small(), theme.quiet);
    }
    notch(painter, area.left_bottom() + vec2(-NEAR, 9.0), "Hz", theme);
    let levels = Rangef::new(area.top() + 4.0, area.bottom());
    let y_of = |db: f32| levels.min + levels.span() * (db / FLOOR_DB).clamp(0.0, 1.0);
    for db in [0.0, 24.0, 48.0] {
        painter.hline(area.x_range(), y_of(db), fine);
        let at = pos2(area.left() - NEAR, y_of(db).max(area.top() + 6.0));
        notch(
            painter,
            at,
            &format!("−{db:.0} dB").replace("−0 dB", "0 dB"),
            theme,
        );
    }
    let points: Vec<Pos2> = spectrum
        .iter()
        .enumerate()
        .map(|(i, share)| pos2(hz.place(frequency(i)), y_of(below_db(*share))))
        .collect();
    filled(painter, area, &points, theme.glow);
    for partial in &scene.shown.partials {
        let played = partial.hz * scene.frame.held.ratio;
        if !hz.holds(played) {
            continue;
        }
        let x = hz.place(played);
        let share = (x - area.left()) / area.width() * (POINTS - 1) as f32;
        #[expect(clippy::cast_sign_loss, reason = "within the area")]
        let level = spectrum[(share.round() as usize).min(POINTS - 1)];
        let span = Rangef::new(y_of(below_db(level)), area.bottom());
        painter.vline(x, span, Stroke::new(1.0, theme.text.gamma_multiply(0.45)));
    }
}

/// A curve over what is below it.
fn filled(painter: &Painter, area: Rect, points: &[Pos2], colour: Color32) {
    let mut mesh = Mesh::default();
    let uv = WHITE_UV;
    for pos in points {
        for (pos, color) in [
            (*pos, colour.gamma_multiply(0.35)),
            (pos2(pos.x, area.bottom()), colour.gamma_multiply(0.08)),
        ] {
            mesh.vertices.push(Vertex { pos, uv, color });
        }
    }
    for i in 0..points.len().saturating_sub(1) as u32 {
        let k = 2 * i;
        mesh.indices.extend([k, k + 1, k + 2, k + 1, k + 3, k + 2]);
    }
    painter.add(Shape::mesh(mesh));
    painter.line(points.to_vec(), Stroke::new(1.5, colour));
}

#[cfg(test)]
mod tests {
    use super::round;

    #[test]
    fn ticks_are_round_and_within() {
        for most in [0.00031, 0.9, 1.0, 47.0, 512.0] {
            let tick = round(most);
            assert!(tick <= most && tick > 0.3 * most, "{most}: {tick}");
        }
    }
}
