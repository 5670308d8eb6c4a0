//! How the editor looks: colours, sizes of type, and spacing, in the dark and in the light.

use egui::style::{ScrollStyle, Selection, WidgetVisuals};
use egui::{Color32, CornerRadius, FontFamily, FontId, Shadow, Stroke, TextStyle, Visuals, vec2};

/// Space between things that belong together.
pub(super) const NEAR: f32 = 4.0;
/// Space between things side by side.
pub(super) const SIDE: f32 = 8.0;
/// Space between panels, and from a panel's edge to what it holds.
pub(super) const APART: f32 = 12.0;
/// Radius of panels' corners.
pub(super) const CORNER: u8 = 6;

/// The sizes of type: names of things, what is read, and what is looked up.
pub(super) fn title() -> FontId {
    FontId::proportional(17.0)
}
/// See [`title`].
pub(super) fn body() -> FontId {
    FontId::proportional(13.0)
}
/// See [`title`].
pub(super) fn small() -> FontId {
    FontId::proportional(11.0)
}

/// What takes the energy of a mode; each has its own colour everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// α1: takes high partials first.
    Alpha1,
    /// α2: takes all alike.
    Alpha2,
    /// tan φ: internal friction.
    LossFactor,
    /// What the air carries away, through a resonator too.
    Radiation,
    /// Cords and cushions.
    Supports,
    /// Felt and hands.
    Damper,
}

impl Cause {
    /// All, in the order in which they are stacked.
    pub const ALL: [Self; 6] = [
        Self::Alpha1,
        Self::Alpha2,
        Self::LossFactor,
        Self::Radiation,
        Self::Supports,
        Self::Damper,
    ];

    /// Its name for people.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Alpha1 => "Alpha 1",
            Self::Alpha2 => "Alpha 2",
            Self::LossFactor => "Loss factor",
            Self::Radiation => "Radiation",
            Self::Supports => "Supports",
            Self::Damper => "Damper",
        }
    }

    /// The cause that a parameter of this id sets.
    pub(super) fn of(id: &str) -> Option<Self> {
        match id {
            "alpha1" => Some(Self::Alpha1),
            "alpha2" => Some(Self::Alpha2),
            "tanphi" => Some(Self::LossFactor),
            "radia" => Some(Self::Radiation),
            "suppt" => Some(Self::Supports),
            "noff" => Some(Self::Damper),
            _ => None,
        }
    }
}

/// The colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Theme {
    pub(super) dark: bool,
    /// Behind everything.
    pub(super) ground: Color32,
    /// What holds things together.
    pub(super) panel: Color32,
    /// What can be taken hold of.
    pub(super) raised: Color32,
    /// Rules and scales.
    pub(super) line: Color32,
    pub(super) text: Color32,
    /// What is read second.
    pub(super) quiet: Color32,
    /// What moves, sounds or is chosen.
    pub(super) glow: Color32,
    /// What is wrong or too loud.
    pub(super) alarm: Color32,
    causes: [Color32; 6],
    /// From what is alike to what is not, lighter to darker; see [`super::ramp::Ramp`].
    pub(super) ramp: [Color32; 3],
}

const fn rgb(hex: u32) -> Color32 {
    Color32::from_rgb((hex >> 16) as u8, (hex >> 8) as u8, hex as u8)
}

impl Theme {
    /// For dim rooms.
    pub(super) const DARK: Self = Self {
        dark: true,
        ground: rgb(0x0012_1418),
        panel: rgb(0x001b_1e24),
        raised: rgb(0x0029_2d36),
        line: rgb(0x0036_3b46),
        text: rgb(0x00ec_e8e0),
        quiet: rgb(0x009c_a1ab),
        glow: rgb(0x00ff_b84d),
        alarm: rgb(0x00ff_5c5c),
        causes: [
            rgb(0x00ff_7a6b),
            rgb(0x00c3_92f0),
            rgb(0x008f_cc6a),
            rgb(0x0055_bdf5),
            rgb(0x00d6_a77c),
            rgb(0x008d_a0b3),
        ],
        ramp: [rgb(0x00fe_c766), rgb(0x00d6_5c88), rgb(0x003e_3d9c)],
    };

    /// For bright rooms.
    pub(super) const LIGHT: Self = Self {
        dark: false,
        ground: rgb(0x00e4_e0d8),
        panel: rgb(0x00f6_f3ed),
        raised: rgb(0x00ff_ffff),
        line: rgb(0x00cb_c5b9),
        text: rgb(0x0022_242a),
        quiet: rgb(0x0062_6670),
        glow: rgb(0x00c9_7400),
        alarm: rgb(0x00c4_2a2a),
        causes: [
            rgb(0x00d2_4a3a),
            rgb(0x0084_4cc0),
            rgb(0x004c_8a28),
            rgb(0x001a_7fbd),
            rgb(0x009a_6430),
            rgb(0x0056_6a7e),
        ],
        ramp: [rgb(0x00f0_b13f), rgb(0x00c2_4173), rgb(0x002e_277d)],
    };

    pub(super) fn cause(&self, cause: Cause) -> Color32 {
        self.causes[cause as usize]
    }

    /// A share 0…1 of the way from `from` to `to`.
    pub(super) fn mix(from: Color32, to: Color32, share: f32) -> Color32 {
        from.lerp_to_gamma(to, share.clamp(0.0, 1.0))
    }

    /// Makes egui look so.
    pub(super) fn apply(&self, ctx: &egui::Context) {
        let base = if self.dark {
            Visuals::dark()
        } else {
            Visuals::light()
        };
        let visuals = self.visuals(base);
        ctx.set_theme(if self.dark {
            egui::Theme::Dark
        } else {
            egui::Theme::Light
        });
        ctx.all_styles_mut(|style| {
            style.visuals = visuals.clone();
            style.text_styles = [
                (TextStyle::Heading, title()),
                (TextStyle::Body, body()),
                (TextStyle::Button, body()),
                (TextStyle::Small, small()),
                (
                    TextStyle::Monospace,
                    FontId::new(12.0, FontFamily::Monospace),
                ),
            ]
            .into();
            style.spacing.item_spacing = vec2(SIDE, NEAR);
            style.spacing.button_padding = vec2(SIDE, NEAR);
            style.spacing.tooltip_width = 320.0;
            style.spacing.scroll = ScrollStyle::thin();
            style.interaction.selectable_labels = false;
            style.interaction.tooltip_delay = 0.6;
        });
    }

    fn visuals(&self, base: Visuals) -> Visuals {
        let widget = |fill: Color32, edge: Color32, text: Color32| WidgetVisuals {
            bg_fill: fill,
            weak_bg_fill: fill,
            bg_stroke: Stroke::new(1.0, edge),
            corner_radius: CornerRadius::same(CORNER),
            fg_stroke: Stroke::new(1.0, text),
            expansion: 0.0,
        };
        let mut visuals = base;
        visuals.dark_mode = self.dark;
        visuals.widgets.noninteractive = widget(self.panel, self.line, self.text);
        visuals.widgets.inactive = widget(self.raised, self.raised, self.text);
        visuals.widgets.hovered = widget(self.raised, self.quiet, self.text);
        visuals.widgets.active = widget(self.raised, self.glow, self.text);
        visuals.widgets.open = widget(self.raised, self.quiet, self.text);
        visuals.selection = Selection {
            bg_fill: Self::mix(self.panel, self.glow, 0.35),
            stroke: Stroke::new(1.0, self.text),
        };
        visuals.panel_fill = self.ground;
        visuals.window_fill = self.panel;
        visuals.window_stroke = Stroke::new(1.0, self.line);
        visuals.window_corner_radius = CornerRadius::same(CORNER);
        visuals.menu_corner_radius = CornerRadius::same(CORNER);
        visuals.extreme_bg_color = self.ground;
        visuals.faint_bg_color = self.raised;
        visuals.weak_text_color = Some(self.quiet);
        visuals.popup_shadow = Shadow {
            offset: [0, 4],
            blur: 12,
            spread: 0,
            color: Color32::from_black_alpha(90),
        };
        visuals
    }
}
