//! A recipe of meshes as the text has it, ranges unchecked.

use super::super::raw::{RawDamping, RawKeys, RawListener, RawMaterial};
use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Raw {
    pub(super) name: String,
    pub(super) title: Option<String>,
    pub(super) keys: Option<RawKeys>,
    #[serde(default)]
    pub(super) tuning: RawTuning,
    #[serde(default)]
    pub(super) body: RawBody,
    pub(super) material: Option<RawMaterial>,
    pub(super) damping: Option<RawDamping>,
    #[serde(default)]
    pub(super) listener: RawListener,
    #[serde(default)]
    pub(super) mesh: RawMesh,
    #[serde(default)]
    pub(super) piece: Vec<RawPiece>,
}

/// A piece of several; what it leaves out is as the recipe says outside its pieces.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RawPiece {
    pub(super) keys: RawKeys,
    #[serde(default)]
    pub(super) tuning: RawPieceTuning,
    #[serde(default)]
    pub(super) body: RawBody,
    pub(super) material: Option<RawMaterial>,
    pub(super) damping: Option<RawDamping>,
    #[serde(default)]
    pub(super) mesh: RawMesh,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct RawTuning {
    pub(super) a4_hz: Option<f64>,
    pub(super) by: Option<String>,
    pub(super) mode: Option<RawMode>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct RawPieceTuning {
    pub(super) by: Option<String>,
    pub(super) mode: Option<RawMode>,
}

#[derive(Clone, Deserialize)]
#[serde(untagged)]
pub(super) enum RawMode {
    Number(i64),
    Name(String),
}

#[derive(Clone, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct RawBody {
    pub(super) shape: Option<String>,
    pub(super) file: Option<String>,
    pub(super) object: Option<String>,
    pub(super) objects: Option<Vec<String>>,
    pub(super) size_m: Option<f64>,
    pub(super) unit_m: Option<f64>,
    pub(super) wall_m: Option<f64>,
    pub(super) up: Option<String>,
}

#[derive(Clone, Copy, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct RawMesh {
    pub(super) nodes: Option<i64>,
    pub(super) highest_hz: Option<f64>,
    pub(super) most_modes: Option<i64>,
}

impl RawPieceTuning {
    /// The same with what it leaves out as in `common`.
    pub(super) fn or(self, common: &RawTuning) -> Self {
        Self {
            by: self.by.or_else(|| common.by.clone()),
            mode: self.mode.or_else(|| common.mode.clone()),
        }
    }
}

impl RawBody {
    /// The same with what it leaves out as in `common`. Objects and size are told in two ways each: what
    /// is told in one is not left out in the other.
    pub(super) fn or(self, common: &Self) -> Self {
        let (chosen, sized) = (
            self.object.is_some() || self.objects.is_some(),
            self.size_m.is_some() || self.unit_m.is_some(),
        );
        let objects = if chosen { &self } else { common };
        let scale = if sized { &self } else { common };
        Self {
            object: objects.object.clone(),
            objects: objects.objects.clone(),
            size_m: scale.size_m,
            unit_m: scale.unit_m,
            shape: self.shape.or_else(|| common.shape.clone()),
            file: self.file.or_else(|| common.file.clone()),
            wall_m: self.wall_m.or(common.wall_m),
            up: self.up.or_else(|| common.up.clone()),
        }
    }
}

impl RawMesh {
    /// The same with what it leaves out as in `common`.
    pub(super) fn or(self, common: Self) -> Self {
        Self {
            nodes: self.nodes.or(common.nodes),
            highest_hz: self.highest_hz.or(common.highest_hz),
            most_modes: self.most_modes.or(common.most_modes),
        }
    }
}
