//! A recipe as TOML has it: any numbers, some fields left out.

use super::error::Fault;
use serde::Deserialize;
use serde::de::DeserializeOwned;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Raw {
    pub(super) name: String,
    pub(super) title: Option<String>,
    pub(super) keys: RawKeys,
    pub(super) tuning: RawTuning,
    pub(super) body: RawBody,
    pub(super) material: RawMaterial,
    pub(super) damping: Option<RawDamping>,
    pub(super) imperfection: Option<RawImperfection>,
    pub(super) resonator: Option<RawResonator>,
    #[serde(default)]
    pub(super) listener: RawListener,
    pub(super) mesh: RawMesh,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawKeys {
    pub(super) low: i64,
    pub(super) high: i64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawTuning {
    pub(super) a4_hz: f64,
    pub(super) partial: i64,
    #[serde(default)]
    pub(super) octaves_below: i64,
    pub(super) tolerance_cents: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawBody {
    pub(super) shape: String,
    pub(super) outer_radius_m: Option<f64>,
    pub(super) wall_m: Option<f64>,
    pub(super) plug_m: Option<f64>,
    pub(super) hung_at: Option<f64>,
    pub(super) felt_at: Option<f64>,
    pub(super) second_ratio: Option<f64>,
    pub(super) third_ratio: Option<f64>,
    pub(super) thickness: Option<f64>,
    pub(super) width: Option<f64>,
    pub(super) undercut: Option<f64>,
    pub(super) rim_radius_m: Option<f64>,
    pub(super) base_radius_m: Option<f64>,
    pub(super) height_m: Option<f64>,
    pub(super) squareness: Option<f64>,
    pub(super) base_wall_m: Option<f64>,
    pub(super) rim_wall_m: Option<f64>,
    pub(super) length_m: Option<f64>,
    pub(super) second_side_m: Option<f64>,
    pub(super) width_m: Option<f64>,
    pub(super) thickness_m: Option<f64>,
    pub(super) radius_m: Option<f64>,
    pub(super) square_m: Option<f64>,
    pub(super) tension_n: Option<f64>,
    pub(super) tension_n_m: Option<f64>,
    pub(super) board_s_kg: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawImperfection {
    pub(super) mass_share: Option<f64>,
    pub(super) beat_hz: Option<f64>,
    pub(super) angle_deg: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawResonator {
    pub(super) radius_m: f64,
    pub(super) layer_m: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct RawListener {
    pub(super) distance_m: f64,
    pub(super) above_m: f64,
    pub(super) row_m: f64,
}

impl Default for RawListener {
    fn default() -> Self {
        Self {
            distance_m: 1.0,
            above_m: 0.3,
            row_m: 1.2,
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawMaterial {
    pub(super) name: Option<String>,
    pub(super) lambda_pa: Option<f64>,
    pub(super) mu_pa: Option<f64>,
    pub(super) young_pa: Option<f64>,
    pub(super) poisson: Option<f64>,
    pub(super) density_kg_m3: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawDamping {
    pub(super) alpha1_s: f64,
    pub(super) alpha2_per_s: f64,
    #[serde(default)]
    pub(super) loss_factor: f64,
    #[serde(default)]
    pub(super) support_kg_s: f64,
    #[serde(default)]
    pub(super) felt_kg_s: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawMesh {
    #[serde(default = "around")]
    pub(super) around: i64,
    pub(super) max_element_m: f64,
    #[serde(default = "highest_hz")]
    pub(super) highest_hz: f64,
    pub(super) fewest_modes: Option<i64>,
}

fn around() -> i64 {
    48
}

fn highest_hz() -> f64 {
    20_000.0
}

impl Raw {
    pub(super) fn parse(text: &str) -> Result<Self, Fault> {
        from_toml(text)
    }
}

/// What `text` says, or where in it the fault is.
pub(super) fn from_toml<T: DeserializeOwned>(text: &str) -> Result<T, Fault> {
    toml::from_str(text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        let (line, column) = place(text, at);
        Fault::Syntax {
            line,
            column,
            message: error
                .message()
                .split_whitespace()
                .collect::<Vec<_>>()
                .join(" "),
        }
    })
}

/// Line and column of the byte `at`, both counted from 1.
fn place(text: &str, at: usize) -> (usize, usize) {
    let before = text.get(..at).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let line = before.matches('\n').count() + 1;
    (line, before[line_start..].chars().count() + 1)
}

#[cfg(test)]
mod tests {
    use super::place;

    #[test]
    fn places_count_from_one_and_in_characters() {
        let text = "é = 1\nß = ?\n";
        assert_eq!(place(text, 0), (1, 1));
        assert_eq!(place(text, text.find('=').unwrap()), (1, 3));
        assert_eq!(place(text, text.find('?').unwrap()), (2, 5));
        assert_eq!(place(text, text.len()), (3, 1));
        assert_eq!(place(text, text.len() + 9), (3, 1));
    }
}
