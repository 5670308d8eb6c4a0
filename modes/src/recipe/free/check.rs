//! The ranges of the fields of a recipe of meshes.

use super::super::check::{
    check_keys, check_listener, check_matter, check_name, check_title, given, within,
};
use super::super::error::Fault;
use super::super::raw::{RawDamping, RawMaterial};
use super::raw::{Raw, RawBody, RawMesh, RawMode, RawPiece, RawPieceTuning};
use super::{FreeFineness, FreeRecipe, FreeTuning, MeshScale, MeshShape, Piece, TunedMode, Up};
use crate::SpreadRule;
use std::path::Path;

/// Pitch of key 69 where none is given, in Hz.
const A4_HZ: f64 = 440.0;
/// The longest side of a mesh, in m.
const SIZE_M: [f64; 2] = [0.001, 10.0];
/// What one of a file's units may be, in m: from a micrometre to a kilometre.
const UNIT_M: [f64; 2] = [1e-6, 1e3];

impl Raw {
    pub(super) fn check(mut self, text: &str, folder: &Path) -> Result<FreeRecipe, Fault> {
        let a4_hz = self.tuning.a4_hz.unwrap_or(A4_HZ);
        let pieces = std::mem::take(&mut self.piece);
        Ok(FreeRecipe {
            title: check_title(self.title.clone().unwrap_or_else(|| self.name.clone()))?,
            name: check_name(self.name.clone())?,
            a4_hz: within("tuning.a4_hz", a4_hz, 300.0..=600.0)?,
            listener: check_listener(&self.listener)?,
            pieces: if pieces.is_empty() {
                vec![self.only(folder)?]
            } else {
                self.each(pieces, folder)?
            },
            text: text.to_owned(),
        })
    }

    /// The only piece of a recipe without pieces.
    fn only(self, folder: &Path) -> Result<Piece, Fault> {
        let piece = RawPiece {
            keys: given("keys", self.keys)?,
            tuning: RawPieceTuning {
                by: self.tuning.by,
                mode: self.tuning.mode,
            },
            body: self.body,
            material: self.material,
            damping: self.damping,
            mesh: self.mesh,
        };
        given("body.shape", piece.body.shape.as_ref())?;
        let (material, damping) = (piece.material.as_ref(), piece.damping.as_ref());
        check_piece(&piece, (material, damping), folder)
    }

    /// `pieces`, by rising keys.
    fn each(self, pieces: Vec<RawPiece>, folder: &Path) -> Result<Vec<Piece>, Fault> {
        if self.keys.is_some() {
            let allowed = "left out beside pieces: each has its own";
            return Err(Fault::field("keys", "given", allowed));
        }
        let mut checked = Vec::with_capacity(pieces.len());
        for (piece, number) in pieces.into_iter().zip(1..) {
            let piece = self
                .piece(piece, folder)
                .map_err(|fault| fault.within(format!("piece {number}")))?;
            checked.push((number, piece));
        }
        checked.sort_by_key(|(number, piece)| (piece.keys.low, *number));
        for pair in checked.windows(2) {
            let [(lower, before), (upper, after)] = pair else {
                continue;
            };
            if after.keys.low <= before.keys.high {
                let high = before.keys.high;
                let allowed = format!(
                    "above {high}, the highest key of piece {lower}: no two pieces share a key"
                );
                let fault = Fault::field("keys.low", after.keys.low, allowed);
                return Err(fault.within(format!("piece {upper}")));
            }
        }
        Ok(checked.into_iter().map(|(_, piece)| piece).collect())
    }

    fn piece(&self, piece: RawPiece, folder: &Path) -> Result<Piece, Fault> {
        let whole = RawPiece {
            tuning: piece.tuning.or(&self.tuning),
            body: piece.body.or(&self.body),
            mesh: piece.mesh.or(self.mesh),
            ..piece
        };
        // Another material has other damping.
        let matter = match (&whole.material, &whole.damping) {
            (None, None) => (self.material.as_ref(), self.damping.as_ref()),
            (None, damping) => (self.material.as_ref(), damping.as_ref()),
            (material, damping) => (material.as_ref(), damping.as_ref()),
        };
        check_piece(&whole, matter, folder)
    }
}

fn check_piece(
    raw: &RawPiece,
    (material, damping): (Option<&RawMaterial>, Option<&RawDamping>),
    folder: &Path,
) -> Result<Piece, Fault> {
    let (material, damping, losses) = check_matter(given("material", material)?, damping)?;
    Ok(Piece {
        keys: check_keys(&raw.keys)?,
        tuning: check_tuning(&raw.tuning)?,
        shape: check_body(&raw.body, folder)?,
        material,
        damping,
        losses,
        fineness: check_mesh(raw.mesh)?,
    })
}

fn check_tuning(raw: &RawPieceTuning) -> Result<FreeTuning, Fault> {
    let rule = match raw.by.as_deref() {
        None | Some("size") => SpreadRule::Size,
        Some("density") => SpreadRule::Density,
        Some("stiffness") => SpreadRule::Stiffness,
        Some("nothing") => SpreadRule::Fixed,
        Some(other) => {
            let allowed = "\"size\", \"density\", \"stiffness\" or \"nothing\"";
            return Err(Fault::field("tuning.by", format!("{other:?}"), allowed));
        }
    };
    let refused = |value: String| {
        let allowed = "\"lowest\", \"loudest\" or a number from 1 to 1000";
        Err(Fault::field("tuning.mode", value, allowed))
    };
    let mode = match &raw.mode {
        None => TunedMode::Lowest,
        Some(RawMode::Name(name)) => match name.as_str() {
            "lowest" => TunedMode::Lowest,
            "loudest" => TunedMode::Loudest,
            other => return refused(format!("{other:?}")),
        },
        Some(RawMode::Number(number)) => match u32::try_from(*number) {
            Ok(number @ 1..=1000) => TunedMode::Number(number),
            _ => return refused(number.to_string()),
        },
    };
    Ok(FreeTuning { rule, mode })
}

fn check_body(raw: &RawBody, folder: &Path) -> Result<MeshShape, Fault> {
    if let Some(shape) = raw.shape.as_deref().filter(|shape| *shape != "mesh") {
        let allowed = "\"mesh\" in a recipe of a mesh";
        return Err(Fault::field("body.shape", format!("{shape:?}"), allowed));
    }
    let file = given("body.file", raw.file.as_ref())?;
    let wall_m = raw.wall_m;
    let wall_m = wall_m.map(|wall_m| within("body.wall_m", wall_m, 0.0002..=1.0));
    Ok(MeshShape {
        file: folder.join(file),
        objects: check_objects(raw)?,
        scale: check_scale(raw)?,
        wall_m: wall_m.transpose()?,
        up: check_up(raw.up.as_deref())?,
    })
}

fn check_objects(raw: &RawBody) -> Result<Vec<String>, Fault> {
    match (&raw.object, &raw.objects) {
        (None, None) => Ok(Vec::new()),
        (Some(object), None) => Ok(vec![object.clone()]),
        (None, Some(objects)) if objects.is_empty() => {
            let allowed = "left out for all objects, or a list of at least one";
            Err(Fault::field("body.objects", "empty", allowed))
        }
        (None, Some(objects)) => Ok(objects.clone()),
        (Some(_), Some(_)) => {
            let allowed = "left out where body.object names one";
            Err(Fault::field("body.objects", "given", allowed))
        }
    }
}

fn check_scale(raw: &RawBody) -> Result<MeshScale, Fault> {
    match (raw.size_m, raw.unit_m) {
        (None, None) => Ok(MeshScale::Unit(1.0)),
        (Some(size_m), None) => {
            let [least, most] = SIZE_M;
            within("body.size_m", size_m, least..=most).map(MeshScale::Longest)
        }
        (None, Some(unit_m)) => {
            let [least, most] = UNIT_M;
            within("body.unit_m", unit_m, least..=most).map(MeshScale::Unit)
        }
        (Some(_), Some(unit_m)) => {
            let allowed = "left out where body.size_m tells the size";
            Err(Fault::field("body.unit_m", unit_m, allowed))
        }
    }
}

fn check_up(name: Option<&str>) -> Result<Up, Fault> {
    let Some(name) = name else {
        return Ok(Up::default());
    };
    Up::named(name)
        .ok_or_else(|| Fault::field("body.up", format!("{name:?}"), "\"x\", \"y\" or \"z\""))
}

fn check_mesh(raw: RawMesh) -> Result<FreeFineness, Fault> {
    let usual = FreeFineness::default();
    let count = |field, x: Option<i64>, usual: usize, least: i64, most: i64| match x {
        None => Ok(usual),
        Some(x) if (least..=most).contains(&x) => Ok(usize::try_from(x).unwrap_or_default()),
        Some(x) => {
            let allowed = format!("a whole number from {least} to {most}");
            Err(Fault::field(field, x, allowed))
        }
    };
    let highest_hz = raw.highest_hz.unwrap_or(usual.highest_hz);
    Ok(FreeFineness {
        nodes: count("mesh.nodes", raw.nodes, usual.nodes, 500, 200_000)?,
        highest_hz: within("mesh.highest_hz", highest_hz, 1e3..=20e3)?,
        most_modes: count("mesh.most_modes", raw.most_modes, usual.most_modes, 1, 1000)?,
    })
}
