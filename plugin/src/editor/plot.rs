//! The partials of a body: upwards how loud each is, downwards how long it rings and why it stops.

use super::axis::Axis;
use super::card::card;
use super::frame::Frame;
use super::grid::{FLOOR_DB, Halves, grid};
use super::ringing::{Ringing, hertz};
use super::shown::Shown;
use super::theme::{Cause, Theme, small};
use super::trimming::{Grasp, Scales, Trimming, all_back, words};
use crate::engine::{Settings, Trim};
use crate::params::TrimTable;
use egui::{
    Align2, CursorIcon, Id, Painter, Rangef, Rect, Role, Sense, Stroke, Ui, WidgetInfo, pos2, vec2,
};
use modes::{Damping, ModeLabel};

/// Greatest distance in points of the pointer from the partial that it is on.
const REACH: f32 = 10.0;
/// Time in s beyond which it does not matter how long a partial rings.
const LONGEST_S: f64 = 100.0;
/// What the plot needs to know.
pub(super) struct Scene<'a> {
    pub(super) shown: &'a Shown,
    pub(super) frame: &'a Frame,
    pub(super) settings: &'a Settings,
    /// What the material damps by itself.
    pub(super) own: &'a Damping,
    /// How long a blow lasts, in s.
    pub(super) contact_s: f64,
    /// What is made of single modes.
    pub(super) trims: &'a TrimTable,
    pub(super) theme: &'a Theme,
}

/// What the pointer is on.
#[derive(Default)]
pub(super) struct Pointed {
    /// Number of the partial.
    pub(super) number: Option<usize>,
    /// What can be done there, in words.
    pub(super) hint: Option<String>,
}

/// A partial on its place.
pub(super) struct Line {
    number: usize,
    pub(super) label: ModeLabel,
    trim: Trim,
    /// Whether another is heard alone.
    mute: bool,
    x: f32,
    /// Levels in dB below the loudest: what a blow would give, and what there is.
    set_db: f32,
    live_db: f32,
    ringing: Ringing,
}

/// Draws the plot at `area` and lets hands take partials; what the pointer is on.
pub(super) fn plot(ui: &mut Ui, area: Rect, scene: &Scene<'_>, trimming: &mut Trimming) -> Pointed {
    let header = Rect::from_min_size(area.min, vec2(area.width(), 20.0));
    let rest = Rect::from_min_max(pos2(area.left(), header.bottom()), area.max);
    let halves = Halves::of(rest);
    let partials = &scene.shown.partials;
    let lowest = partials.first().map_or(100.0, |first| first.hz);
    let highest = partials.last().map_or(1e4, |last| last.hz);
    let ratio = scene.frame.held.ratio;
    let span = [0.8 * lowest * ratio, (1.1 * highest * ratio).min(20e3)];
    let hz = Axis::log(span, halves.up.x_range());
    let t60 = Axis::log([0.01, 100.0], halves.down.y_range());
    let lines = lines(scene, &hz);
    let response = ui.interact(area, Id::unique("partials"), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Role::Group, true, "Partial levels"));
    let here = response
        .interact_pointer_pos()
        .or(response.hover_pos())
        .filter(|at| at.y > header.bottom());
    let under = here.and_then(|at| nearest(&lines, at.x));
    let grasp = |at: egui::Pos2| {
        if at.y > halves.down.top() {
            Grasp::Ringing
        } else {
            Grasp::Level
        }
    };
    let scales = Scales {
        db: FLOOR_DB / halves.up.height(),
        folds: 1e4f32.ln() / halves.down.height(),
    };
    let held = under.zip(here).map(|(line, at)| (line.label, grasp(at)));
    trimming.hands(ui, &response, held, &lines, &scales, scene.trims);
    let told = trimming.told();
    let pointed = lines.iter().find(|line| Some(line.label) == told).or(under);
    let painter = ui.painter();
    grid(painter, &halves, &hz, &t60, scene.theme);
    for line in &lines {
        let on = pointed.is_some_and(|on| on.number == line.number);
        draw(painter, scene, line, &halves, &t60, on);
    }
    let taken = all_back(ui, header, scene.trims, scene.theme);
    let header = header.with_max_x(header.right() - taken);
    describe(ui, header, scene, pointed.or_else(|| first_told(&lines)));
    response.on_hover_cursor(CursorIcon::ResizeVertical);
    let hint = "Click a partial to hear it alone; drag it up or down to make it louder or softer, its lower half \
                longer or shorter; right click: as built";
    Pointed {
        number: pointed.map(|line| line.number),
        hint: here.map(|_| hint.to_owned()),
    }
}

/// One of the partials in words.
fn describe(ui: &Ui, header: Rect, scene: &Scene<'_>, told: Option<&Line>) {
    if let Some(line) = told {
        let trim = words(&line.trim);
        let gap = if trim.is_empty() { "" } else { " " };
        let name = format!("{}{gap}{trim}", line.label);
        card(ui, header, &name, &line.ringing, scene.theme);
    }
}

/// The name and decay of the partial that is to be told of first.
pub(super) fn leading(scene: &Scene<'_>) -> Option<(String, Ringing)> {
    let everywhere = Axis::log([1.0, 1e6], Rangef::new(0.0, 1.0));
    let lines = lines(scene, &everywhere);
    let line = first_told(&lines)?;
    Some((line.label.to_string(), line.ringing))
}

fn lines(scene: &Scene<'_>, hz: &Axis) -> Vec<Line> {
    let settings = &scene.settings;
    let place = [settings.strike_position, settings.strike_across];
    let partials = &scene.shown.partials;
    let trims = scene.trims.get();
    let alone = trims
        .solo()
        .filter(|solo| partials.iter().any(|partial| partial.label == *solo));
    let levels: Vec<f64> = partials
        .iter()
        .map(|partial| partial.level(place, scene.contact_s))
        .collect();
    let most = levels
        .iter()
        .fold(f64::MIN_POSITIVE, |most, x| most.max(*x));
    let below_db = |share: f64| (-20.0 * share.max(1e-9).log10()) as f32;
    let held = &scene.frame.held;
    partials
        .iter()
        .zip(&levels)
        .enumerate()
        .map(|(number, (partial, level))| {
            let trim = trims.get(&partial.label);
            let mute = alone.is_some_and(|alone| alone != partial.label);
            let ringing = Ringing::of(partial, &scene.settings.losses, scene.own, held)
                .trimmed(trim.ringing.into());
            let live = scene.shown.live(scene.frame, number);
            Line {
                number,
                label: partial.label,
                trim,
                mute,
                x: hz.place(ringing.hz),
                set_db: below_db(level / most) - trim.level_db,
                live_db: below_db(if mute { 0.0 } else { live.into() }),
                ringing,
            }
        })
        .filter(|line| hz.holds(line.ringing.hz))
        .collect()
}

/// The partial nearest to the pointer; of those near alike, the loudest.
fn nearest(lines: &[Line], x: f32) -> Option<&Line> {
    let near = lines
        .iter()
        .filter(|line| (line.x - x).abs() <= REACH && line.set_db < FLOOR_DB);
    let cost = |line: &Line| (line.x - x).abs() + 0.1 * line.set_db;
    near.min_by(|a, b| cost(a).total_cmp(&cost(b)))
}

/// The partial that is heard alone, or else the one of which most is heard: loud after a blow, and for
/// long.
fn first_told(lines: &[Line]) -> Option<&Line> {
    let heard = lines.iter().filter(|line| !line.mute);
    let cost = |line: &Line| {
        let rings_s = line.ringing.t60_s().min(LONGEST_S);
        line.set_db - 20.0 * rings_s.log10() as f32
    };
    heard.min_by(|a, b| cost(a).total_cmp(&cost(b)))
}

fn draw(painter: &Painter, scene: &Scene<'_>, line: &Line, halves: &Halves, t60: &Axis, on: bool) {
    let (theme, Halves { up, down, .. }) = (scene.theme, *halves);
    let (x, width) = (line.x, if on { 4.0 } else { 2.5 });
    let y_of = |db: f32| up.top() + up.height() * (db / FLOOR_DB).clamp(0.0, 1.0);
    let rise = |db: f32| Rangef::new(y_of(db), up.bottom());
    let audible = !line.mute && (line.set_db < FLOOR_DB || line.live_db < FLOOR_DB);
    if line.set_db < FLOOR_DB {
        let colour = if on {
            theme.text
        } else {
            theme
                .quiet
                .gamma_multiply(if line.mute { 0.25 } else { 0.6 })
        };
        painter.vline(x, rise(line.set_db), Stroke::new(width, colour));
    }
    if line.live_db < FLOOR_DB {
        painter.vline(x, rise(line.live_db), Stroke::new(width + 0.5, theme.glow));
        painter.circle_filled(pos2(x, y_of(line.live_db)), 0.5 * width + 1.5, theme.glow);
    }
    let end = t60.place(line.ringing.t60_s().clamp(0.01, 100.0));
    let mut y = down.top();
    for (cause, share) in Cause::ALL.into_iter().zip(line.ringing.shares()) {
        let to = y + (end - down.top()) * share as f32;
        let colour = theme
            .cause(cause)
            .gamma_multiply(if audible { 1.0 } else { 0.25 });
        painter.vline(x, Rangef::new(y, to), Stroke::new(width, colour));
        y = to;
    }
    if line.trim != Trim::NONE {
        let at = pos2(x, 0.5 * (up.bottom() + down.top()));
        painter.circle(at, 3.5, theme.glow, Stroke::new(1.5, theme.panel));
    }
    if on {
        let right = x > up.center().x;
        let anchor = if right {
            Align2::RIGHT_TOP
        } else {
            Align2::LEFT_TOP
        };
        let at = pos2(x + if right { -5.0 } else { 5.0 }, up.top() + 2.0);
        painter.text(at, anchor, hertz(line.ringing.hz), small(), theme.text);
    }
}
