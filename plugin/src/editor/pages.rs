//! The parameters on pages, group by group.

use super::choice::{choice, switch};
use super::hands::Hands;
use super::knob::{CELL, knob};
use super::param::Param;
use super::theme::{NEAR, SIDE, Theme, body, small};
use egui::{
    Align, Align2, CursorIcon, Id, Layout, Rect, Role, ScrollArea, Sense, Stroke, Ui, UiBuilder,
    WidgetInfo, pos2, vec2,
};
use nice_plug::prelude::ParamSetter;

/// Pages and the groups that are on them; what is in no group listed here is on the last.
const PAGES: [(&str, &[&str]); 6] = [
    ("Strike", &["Strike", "Mallet"]),
    ("Damping", &["Damping"]),
    ("Bow", &["Bow"]),
    ("Body", &["Body", "Motor"]),
    ("Sound", &["Listener", "Output"]),
    ("Hands", &[]),
];

/// Height of the line of tabs.
const TABS: f32 = 26.0;

/// Which page is open.
#[derive(Default)]
pub(super) struct Pages {
    open: usize,
}

/// The page that a parameter is on.
fn page_of(group: &str) -> usize {
    PAGES
        .iter()
        .position(|(_, groups)| groups.contains(&group))
        .unwrap_or(PAGES.len() - 1)
}

/// The parameters on a page. The instrument is above them all.
fn here(params: &[Param], page: usize) -> impl Iterator<Item = &Param> {
    params
        .iter()
        .filter(move |param| page_of(&param.group) == page && param.spec.id != "instr")
}

impl Pages {
    /// Draws tabs and the open page at `area`.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        area: Rect,
        params: &[Param],
        theme: &Theme,
        hands: &mut Hands,
        setter: &ParamSetter<'_>,
    ) {
        let there: Vec<usize> = (0..PAGES.len())
            .filter(|page| here(params, *page).next().is_some())
            .collect();
        if !there.contains(&self.open) {
            self.open = there.first().copied().unwrap_or(0);
        }
        self.tabs(ui, area, &there, theme);
        let several = {
            let mut groups = here(params, self.open).map(|param| &param.group);
            let first = groups.next();
            groups.any(|group| Some(group) != first)
        };
        let page = Rect::from_min_max(pos2(area.left(), area.top() + TABS + NEAR), area.max);
        let mut inner = ui.new_child(
            UiBuilder::new()
                .id_salt(("page", self.open))
                .max_rect(page)
                .layout(Layout::top_down(Align::Min)),
        );
        inner.set_clip_rect(page.intersect(ui.clip_rect()));
        ScrollArea::vertical()
            .auto_shrink([false, false])
            .show(&mut inner, |ui| {
                let mut rest = here(params, self.open).peekable();
                while let Some(first) = rest.next() {
                    let mut group = vec![first];
                    while let Some(param) = rest.next_if(|param| param.group == first.group) {
                        group.push(param);
                    }
                    if several {
                        heading(ui, &first.group, theme);
                    } else {
                        ui.add_space(SIDE);
                    }
                    ui.horizontal_wrapped(|ui| {
                        ui.spacing_mut().item_spacing = vec2(NEAR, SIDE);
                        for param in group {
                            control(ui, param, theme, hands, setter);
                        }
                    });
                }
            });
    }

    fn tabs(&mut self, ui: &Ui, area: Rect, there: &[usize], theme: &Theme) {
        let text_width = |name: &str| {
            let text = ui
                .painter()
                .layout_no_wrap(name.to_owned(), body(), theme.text);
            text.size().x
        };
        let texts: f32 = there.iter().map(|page| text_width(PAGES[*page].0)).sum();
        let room = (area.width() - texts) / there.len().max(1) as f32;
        let room = room.clamp(NEAR, 2.0 * SIDE);
        let mut x = area.left();
        for page in there {
            let name = PAGES[*page].0;
            let width = text_width(name) + room;
            let rect = Rect::from_min_size(pos2(x, area.top()), vec2(width, TABS));
            x += width;
            let response = ui.interact(rect, Id::unique(("tab", page)), Sense::click());
            let open = self.open == *page;
            response.widget_info(|| WidgetInfo::selected(Role::Tab, true, open, name));
            if response.clicked() {
                self.open = *page;
            }
            let colour = if open || response.hovered() || response.has_focus() {
                theme.text
            } else {
                theme.quiet
            };
            ui.painter()
                .text(rect.center(), Align2::CENTER_CENTER, name, body(), colour);
            if open {
                ui.painter().hline(
                    rect.shrink2(vec2(0.5 * room, 0.0)).x_range(),
                    rect.bottom() - 2.0,
                    Stroke::new(2.0, theme.glow),
                );
            }
            response.on_hover_cursor(CursorIcon::PointingHand);
        }
        ui.painter().hline(
            area.x_range(),
            area.top() + TABS,
            Stroke::new(1.0, theme.line),
        );
    }
}

/// The name of a group, where there are several.
fn heading(ui: &mut Ui, name: &str, theme: &Theme) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 18.0), Sense::hover());
    ui.painter().text(
        rect.left_center() + vec2(NEAR, 0.0),
        Align2::LEFT_CENTER,
        name.to_uppercase(),
        small(),
        theme.quiet,
    );
}

/// A parameter's control: a knob if it glides, else a switch or a list.
fn control(ui: &mut Ui, param: &Param, theme: &Theme, hands: &mut Hands, setter: &ParamSetter<'_>) {
    // A list is two cells wide and does not break.
    if ui.available_size_before_wrap().x < CELL.x {
        ui.end_row();
    }
    match param.steps() {
        None => knob(ui, param, theme, hands, setter),
        Some(1) => switch(ui, param, theme, setter),
        Some(_) => choice(ui, param, theme, setter),
    };
}
