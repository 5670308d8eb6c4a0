//! `Name=value` and `Name@seconds:value,…` as values of a plug-in's parameters.

mod name;
mod range;

use crate::host::{Param, ParamId, Plugin};
use anyhow::{Context, Result, bail};
pub use name::find;

/// A parameter's value at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// When, in s.
    pub seconds: f64,
    /// Which parameter.
    pub id: ParamId,
    /// Its value from then on, on the plug-in's own scale.
    pub value: f64,
}

/// Reads `Name=value`.
///
/// # Errors
///
/// If the name is unknown or the value is outside the parameter's range.
pub fn setting(plugin: &mut Plugin, text: &str) -> Result<(ParamId, f64)> {
    let (name, value) = text
        .split_once('=')
        .with_context(|| format!("--set {text}: should read \"Name=value\""))?;
    let param = find(&plugin.params(), name).with_context(|| format!("--set {text}"))?;
    let value = value_of(plugin, &param, value).with_context(|| format!("--set {text}"))?;
    Ok((param.id, value))
}

/// Reads `Name@seconds:value,seconds:value,…`.
///
/// # Errors
///
/// If the name is unknown, a time is no number of seconds from 0 on, or a value is outside the
/// parameter's range.
pub fn automation(plugin: &mut Plugin, text: &str) -> Result<Vec<Step>> {
    let (name, points) = text.split_once('@').with_context(|| {
        format!("--automate {text}: should read \"Name@seconds:value,seconds:value\"")
    })?;
    let place = || format!("--automate {text}");
    let param = find(&plugin.params(), name).with_context(place)?;
    points
        .split(',')
        .map(|point| step(plugin, &param, point))
        .collect::<Result<_>>()
        .with_context(place)
}

fn step(plugin: &mut Plugin, param: &Param, point: &str) -> Result<Step> {
    let Some((time, value)) = point.split_once(':') else {
        bail!("`{point}` should read seconds:value");
    };
    let seconds = time
        .trim()
        .parse::<f64>()
        .ok()
        .filter(|seconds| seconds.is_finite() && *seconds >= 0.0)
        .with_context(|| format!("`{time}` is no time; allowed: seconds from 0 on"))?;
    Ok(Step {
        seconds,
        id: param.id,
        value: value_of(plugin, param, value)?,
    })
}

/// What `text` means to the plug-in, which may clamp: a text from outside the range is refused.
fn value_of(plugin: &mut Plugin, param: &Param, text: &str) -> Result<f64> {
    let ends = [param.min, param.max].map(|end| {
        plugin
            .text(param.id, end)
            .unwrap_or_else(|| end.to_string())
    });
    let mut read = |text: &str| plugin.parse(param.id, text);
    match range::read(text.trim(), &mut read, [param.min, param.max], &ends) {
        Some(value) => Ok(value),
        None => bail!(
            "`{}` is no value of {}; allowed: {} … {}",
            text.trim(),
            param.name,
            ends[0],
            ends[1]
        ),
    }
}
