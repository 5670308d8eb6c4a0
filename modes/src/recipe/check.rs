//! The ranges of a recipe's fields.

use super::closed::{CLOSED, check_closed, closed_fields};
use super::error::Fault;
use super::material::check_material;
use super::raw::{
    Raw, RawBody, RawDamping, RawImperfection, RawKeys, RawListener, RawMaterial, RawMesh,
    RawResonator, RawTuning,
};
use super::together::check_together;
use super::{
    ImperfectionRecipe, ImperfectionSize, KeyRange, ListenerRecipe, LossRecipe, MeshRecipe, Recipe,
    ResonatorRecipe, ShapeRecipe, TuningRecipe,
};
use crate::shape::Bowl;
use crate::{Damping, Material, Rayleigh};
use std::ops::RangeInclusive;

impl Raw {
    pub(super) fn check(self, text: &str) -> Result<Recipe, Fault> {
        let (material, damping, losses) = check_matter(&self.material, self.damping.as_ref())?;
        let recipe = Recipe {
            title: check_title(self.title.unwrap_or_else(|| self.name.clone()))?,
            name: check_name(self.name)?,
            keys: check_keys(&self.keys)?,
            tuning: check_tuning(&self.tuning)?,
            shape: check_body(&self.body)?,
            material,
            damping,
            losses,
            imperfection: self
                .imperfection
                .as_ref()
                .map(check_imperfection)
                .transpose()?,
            resonator: self.resonator.as_ref().map(check_resonator).transpose()?,
            listener: check_listener(&self.listener)?,
            mesh: check_mesh(&self.mesh)?,
            text: text.to_owned(),
        };
        check_together(&recipe)?;
        Ok(recipe)
    }
}

/// The material, its inner damping and what supports and felt take.
pub(super) fn check_matter(
    material: &RawMaterial,
    damping: Option<&RawDamping>,
) -> Result<(Material, Damping, LossRecipe), Fault> {
    let (material, own_damping) = check_material(material)?;
    let losses = match damping {
        Some(given) => check_losses(given)?,
        None => LossRecipe::default(),
    };
    let damping = match (damping, own_damping) {
        (Some(given), _) => check_damping(given)?,
        (None, Some(own)) => Damping {
            rayleigh: own,
            loss_factor: 0.0,
        },
        (None, None) => {
            let allowed = "given, with alpha1_s and alpha2_per_s, because a material \
                           without a name has no damping of its own";
            return Err(Fault::field("damping", "left out", allowed));
        }
    };
    Ok((material, damping, losses))
}

pub(super) fn check_name(name: String) -> Result<String, Fault> {
    let fits = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-' || c == '_';
    if (1..=64).contains(&name.len()) && name.chars().all(fits) {
        return Ok(name);
    }
    let allowed = "1 to 64 small letters, digits, - and _, because it names a file";
    Err(Fault::field("name", format!("{name:?}"), allowed))
}

pub(super) fn check_title(title: String) -> Result<String, Fault> {
    if (1..=64).contains(&title.chars().count()) && !title.chars().any(char::is_control) {
        return Ok(title);
    }
    Err(Fault::field(
        "title",
        format!("{title:?}"),
        "1 to 64 characters of one line",
    ))
}

fn check_losses(raw: &RawDamping) -> Result<LossRecipe, Fault> {
    Ok(LossRecipe {
        support_kg_s: within("damping.support_kg_s", raw.support_kg_s, 0.0..=1e3)?,
        felt_kg_s: within("damping.felt_kg_s", raw.felt_kg_s, 0.0..=1e3)?,
    })
}

fn check_imperfection(raw: &RawImperfection) -> Result<ImperfectionRecipe, Fault> {
    let size = match (raw.mass_share, raw.beat_hz) {
        (Some(share), None) => {
            let share = within("imperfection.mass_share", share, 0.0..=0.1)?;
            ImperfectionSize::MassShare(share)
        }
        (None, Some(beat_hz)) => {
            let beat_hz = within("imperfection.beat_hz", beat_hz, 0.0..=20.0)?;
            ImperfectionSize::BeatHz(beat_hz)
        }
        (given, _) => {
            let value = match given {
                Some(_) => "given both as mass_share and as beat_hz",
                None => "given without a size",
            };
            let allowed = "given either as mass_share or as beat_hz";
            return Err(Fault::field("imperfection", value, allowed));
        }
    };
    Ok(ImperfectionRecipe {
        size,
        angle_deg: within("imperfection.angle_deg", raw.angle_deg, -360.0..=360.0)?,
    })
}

pub(super) fn check_listener(raw: &RawListener) -> Result<ListenerRecipe, Fault> {
    Ok(ListenerRecipe {
        distance_m: within("listener.distance_m", raw.distance_m, 0.3..=20.0)?,
        above_m: within("listener.above_m", raw.above_m, -5.0..=5.0)?,
        row_m: within("listener.row_m", raw.row_m, 0.0..=10.0)?,
    })
}

pub(super) fn check_keys(keys: &RawKeys) -> Result<KeyRange, Fault> {
    let low = whole("keys.low", keys.low, 0..=127)? as u8;
    let high = whole("keys.high", keys.high, 0..=127)? as u8;
    if low > high {
        let allowed = format!("no less than keys.low = {low}");
        return Err(Fault::field("keys.high", high, allowed));
    }
    Ok(KeyRange { low, high })
}

fn check_tuning(tuning: &RawTuning) -> Result<TuningRecipe, Fault> {
    Ok(TuningRecipe {
        a4_hz: within("tuning.a4_hz", tuning.a4_hz, 300.0..=600.0)?,
        partial: whole("tuning.partial", tuning.partial, 1..=16)?,
        tolerance_cents: within(
            "tuning.tolerance_cents",
            tuning.tolerance_cents,
            0.001..=50.0,
        )?,
        octaves_below: whole("tuning.octaves_below", tuning.octaves_below, 0..=4)? as u8,
    })
}

fn check_body(body: &RawBody) -> Result<ShapeRecipe, Fault> {
    let tube = [
        ("body.outer_radius_m", body.outer_radius_m),
        ("body.wall_m", body.wall_m),
        ("body.plug_m", body.plug_m),
        ("body.hung_at", body.hung_at),
        ("body.felt_at", body.felt_at),
    ];
    let bowl = [
        ("body.rim_radius_m", body.rim_radius_m),
        ("body.base_radius_m", body.base_radius_m),
        ("body.height_m", body.height_m),
        ("body.squareness", body.squareness),
        ("body.base_wall_m", body.base_wall_m),
        ("body.rim_wall_m", body.rim_wall_m),
    ];
    let bar = [
        ("body.second_ratio", body.second_ratio),
        ("body.third_ratio", body.third_ratio),
        ("body.thickness", body.thickness),
        ("body.width", body.width),
        ("body.undercut", body.undercut),
    ];
    if let Some(shape) = check_closed(body)? {
        let none = format!("left out: a {} has none", body.shape);
        none_of(&tube, &none)?;
        none_of(&bowl, &none)?;
        none_of(&bar, &none)?;
        return Ok(ShapeRecipe::Closed(shape));
    }
    let closed = closed_fields(body);
    match body.shape.as_str() {
        "tube" => {
            none_of(&bowl, "left out: a tube has none")?;
            none_of(&bar, "left out: a tube has none")?;
            none_of(&closed, "left out: a tube has none")?;
            check_tube(body)
        }
        "bowl" => {
            none_of(&tube, "left out: a bowl has none")?;
            none_of(&bar, "left out: a bowl has none")?;
            none_of(&closed, "left out: a bowl has none")?;
            check_bowl(&bowl)
        }
        "bar" => {
            none_of(&tube, "left out: a bar has none")?;
            none_of(&bowl, "left out: a bar has none")?;
            none_of(&closed, "left out: a bar has none")?;
            check_bar(body)
        }
        _ => {
            let value = format!("{:?}", body.shape);
            let closed = CLOSED.join("\", \"");
            let allowed = format!("\"tube\", \"bar\", \"bowl\", or of closed form: \"{closed}\"");
            Err(Fault::field("body.shape", value, allowed))
        }
    }
}

fn none_of(fields: &[(&'static str, Option<f64>)], allowed: &str) -> Result<(), Fault> {
    match fields.iter().find_map(|&(field, x)| x.map(|x| (field, x))) {
        Some((field, x)) => Err(Fault::field(field, x, allowed)),
        None => Ok(()),
    }
}

pub(super) fn given<T>(field: &'static str, x: Option<T>) -> Result<T, Fault> {
    x.ok_or_else(|| Fault::field(field, "left out", "given"))
}

/// Radii of a tube in thicknesses of its wall: a thinner one bends so much more easily than it stretches
/// that rounding decides.
const THINNEST: f64 = 100.0;

fn check_tube(body: &RawBody) -> Result<ShapeRecipe, Fault> {
    let outer_radius_m = given("body.outer_radius_m", body.outer_radius_m)?;
    if !(outer_radius_m > 0.0 && outer_radius_m <= 1.0) {
        let allowed = "above 0 and at most 1";
        return Err(Fault::field("body.outer_radius_m", outer_radius_m, allowed));
    }
    let wall_m = given("body.wall_m", body.wall_m)?;
    let thinnest_m = outer_radius_m / THINNEST;
    if !(wall_m >= thinnest_m && wall_m < outer_radius_m) {
        let allowed =
            format!("at least {thinnest_m} and below body.outer_radius_m = {outer_radius_m}");
        return Err(Fault::field("body.wall_m", wall_m, allowed));
    }
    Ok(ShapeRecipe::Tube {
        outer_radius_m,
        wall_m,
        plug_m: within("body.plug_m", body.plug_m.unwrap_or(0.0), 0.0..=0.2)?,
        // The node of a free beam's first mode, where a chime hangs.
        hung_at: within("body.hung_at", body.hung_at.unwrap_or(0.2242), 0.0..=1.0)?,
        felt_at: within("body.felt_at", body.felt_at.unwrap_or(0.03), 0.0..=1.0)?,
    })
}

fn check_bar(body: &RawBody) -> Result<ShapeRecipe, Fault> {
    let ratios = match (body.second_ratio, body.third_ratio) {
        (None, None) => None,
        (second, third) => {
            let second = given("body.second_ratio", second)?;
            let third = given("body.third_ratio", third)?;
            let second = within("body.second_ratio", second, 2.0..=6.0)?;
            Some([second, within("body.third_ratio", third, 4.0..=16.0)?])
        }
    };
    Ok(ShapeRecipe::Bar {
        ratios,
        thickness: within("body.thickness", body.thickness.unwrap_or(1.0), 0.25..=4.0)?,
        width: within("body.width", body.width.unwrap_or(1.0), 0.25..=4.0)?,
        undercut: within("body.undercut", body.undercut.unwrap_or(0.0), -1.0..=1.0)?,
    })
}

fn check_resonator(raw: &RawResonator) -> Result<ResonatorRecipe, Fault> {
    Ok(ResonatorRecipe {
        radius_m: within("resonator.radius_m", raw.radius_m, 0.001..=0.2)?,
        layer_m: within("resonator.layer_m", raw.layer_m, 0.0..=0.1)?,
    })
}

fn check_bowl(fields: &[(&'static str, Option<f64>); 6]) -> Result<ShapeRecipe, Fault> {
    let mut values = [0.0; 6];
    for (value, &(field, x)) in values.iter_mut().zip(fields) {
        *value = given(field, x)?;
    }
    let [
        rim_radius_m,
        base_radius_m,
        height_m,
        squareness,
        base_wall_m,
        rim_wall_m,
    ] = values;
    let bowl = Bowl {
        rim_radius_m,
        base_radius_m,
        height_m,
        squareness,
        base_wall_m,
        rim_wall_m,
    };
    bowl.check().map_err(|error| {
        let own = |&&(field, _): &&(&'static str, _)| field.ends_with(error.field);
        let field = fields.iter().find(own).map_or("body", |(field, _)| field);
        Fault::field(field, error.value, error.allowed)
    })?;
    Ok(ShapeRecipe::Bowl(bowl))
}

fn check_damping(damping: &RawDamping) -> Result<Damping, Fault> {
    Ok(Damping {
        rayleigh: Rayleigh {
            alpha1_s: within("damping.alpha1_s", damping.alpha1_s, 0.0..=1e-3)?,
            alpha2_per_s: within("damping.alpha2_per_s", damping.alpha2_per_s, 0.0..=1e4)?,
        },
        loss_factor: within("damping.loss_factor", damping.loss_factor, 0.0..=0.2)?,
    })
}

fn check_mesh(mesh: &RawMesh) -> Result<MeshRecipe, Fault> {
    if !(8..=512).contains(&mesh.around) || mesh.around % 2 != 0 {
        let allowed = "an even number from 8 to 512";
        return Err(Fault::field("mesh.around", mesh.around, allowed));
    }
    Ok(MeshRecipe {
        around: whole("mesh.around", mesh.around, 8..=512)?,
        max_element_m: within("mesh.max_element_m", mesh.max_element_m, 0.0005..=0.1)?,
        highest_hz: within("mesh.highest_hz", mesh.highest_hz, 1e3..=20e3)?,
        fewest_modes: mesh
            .fewest_modes
            .map(|count| whole("mesh.fewest_modes", count, 1..=1000))
            .transpose()?,
    })
}

pub(super) fn within(
    field: &'static str,
    x: f64,
    range: RangeInclusive<f64>,
) -> Result<f64, Fault> {
    if range.contains(&x) {
        return Ok(x);
    }
    let allowed = format!("{} to {}", range.start(), range.end());
    Err(Fault::field(field, x, allowed))
}

fn whole(field: &'static str, x: i64, range: RangeInclusive<u16>) -> Result<u16, Fault> {
    u16::try_from(x)
        .ok()
        .filter(|x| range.contains(x))
        .ok_or_else(|| {
            let allowed = format!("a whole number from {} to {}", range.start(), range.end());
            Fault::field(field, x, allowed)
        })
}
