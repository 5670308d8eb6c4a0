//! A parameter as the plug-in describes it.

use clack_host::utils::ClapId;

/// A parameter's lasting identity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ParamId(pub(super) ClapId);

/// A parameter as the plug-in describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// Its identity.
    pub id: ParamId,
    /// Name shown to the user.
    pub name: String,
    /// Group it belongs to, empty if none.
    pub module: String,
    /// Least value, on the plug-in's own scale.
    pub min: f64,
    /// Greatest value, on the plug-in's own scale.
    pub max: f64,
    /// Value of a fresh instance, on the plug-in's own scale.
    pub default: f64,
    /// Whether only whole numbers count.
    pub stepped: bool,
    /// Whether hosts may automate it.
    pub automatable: bool,
    /// Whether hosts may modulate it for one note alone.
    pub modulatable: bool,
    /// Whether hosts should not show it.
    pub hidden: bool,
}
