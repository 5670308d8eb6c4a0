//! `bank`: what is in a bank.

use crate::table::Table;
use crate::{banks, faust, note};
use anyhow::{Result, bail};
use clap::Args;
use modes::{Body, Damping, Matter, Mode, t60_s};
use serde::Serialize;
use std::path::Path;

/// Arguments of `bank`.
#[derive(Args, Debug)]
pub struct Bank {
    /// Name of the bank, a recipe's file (.toml) or a bank's (.bank)
    #[arg(value_name = "NAME")]
    pub name: String,
    /// Only the body of this MIDI key, with its modes
    #[arg(long, value_name = "N")]
    pub key: Option<u8>,
    /// Write JSON
    #[arg(long)]
    pub json: bool,
    /// Write the body of `--key` as a program in Faust, `modalModel(n, freq, t60, gain)`
    #[arg(long, conflicts_with = "json")]
    pub faust: bool,
    /// Where along the body the Faust program strikes, in %
    #[arg(long, value_name = "%", default_value_t = 100.0 * faust::STRUCK[0])]
    pub position: f64,
    /// Where across it, in %
    #[arg(long, value_name = "%", default_value_t = 100.0 * faust::STRUCK[1])]
    pub across: f64,
}

#[derive(Serialize)]
struct BankJson {
    name: String,
    material: modes::Material,
    damping: Damping,
    keys: Vec<KeyJson>,
}

#[derive(Serialize)]
struct KeyJson {
    key: u8,
    pitch_hz: f64,
    length_m: f64,
    mass_kg: f64,
    material: modes::Material,
    damping: Damping,
    modes: Vec<ModeJson>,
}

#[derive(Serialize)]
struct ModeJson {
    hz: f64,
    decay_per_s: f64,
    t60_s: f64,
    label: String,
    /// What of the decay each cause gives, in 1/s, and what the felt would.
    material_per_s: f64,
    radiation_per_s: f32,
    support_per_s: f32,
    pipe_per_s: f32,
    felt_per_s: f32,
    coupling: f64,
    residual: f64,
}

impl Bank {
    pub(super) fn run(&self) -> Result<()> {
        let file = Path::new(&self.name);
        let bank = if file
            .extension()
            .is_some_and(|extension| extension == "bank")
        {
            modes::Bank::load(file)?.spread_out()
        } else {
            banks::precompute(&self.name, false)?.bank
        };
        print!("{}", self.text(&bank)?);
        Ok(())
    }

    fn text(&self, bank: &modes::Bank) -> Result<String> {
        let body = self.key.map(|key| banks::body(bank, key)).transpose()?;
        if self.faust {
            return self.program(bank, body);
        }
        match (body, self.json) {
            (Some(body), true) => json(&KeyJson::new(body, &bank.matter_of(body))),
            (Some(body), false) => Ok(modes_table(body, &bank.matter_of(body).damping)),
            (None, true) => json(&BankJson::new(bank)),
            (None, false) => Ok(keys_table(bank)),
        }
    }

    fn program(&self, bank: &modes::Bank, body: Option<&Body>) -> Result<String> {
        for (name, value) in [("position", self.position), ("across", self.across)] {
            if !(0.0..=100.0).contains(&value) {
                bail!("--{name} {value} is out of range: give 0…100 %");
            }
        }
        match body {
            Some(body) => {
                faust::program(bank, body, [self.position, self.across].map(|x| x / 100.0))
            }
            None => bail!("--faust needs --key N: a program has one body"),
        }
    }
}

impl BankJson {
    fn new(bank: &modes::Bank) -> Self {
        let key = |body| KeyJson::new(body, &bank.matter_of(body));
        Self {
            name: bank.name.clone(),
            material: bank.material,
            damping: bank.damping,
            keys: bank.bodies.iter().map(key).collect(),
        }
    }
}

impl KeyJson {
    fn new(body: &Body, matter: &Matter) -> Self {
        Self {
            key: body.key,
            pitch_hz: body.pitch_hz,
            length_m: body.length_m,
            mass_kg: body.mass_kg,
            material: matter.material,
            damping: matter.damping,
            modes: body
                .modes
                .iter()
                .map(|m| ModeJson::new(m, &matter.damping))
                .collect(),
        }
    }
}

impl ModeJson {
    fn new(mode: &Mode, damping: &Damping) -> Self {
        let decay_per_s = mode.decay_per_s(damping);
        Self {
            hz: mode.hz,
            decay_per_s,
            t60_s: t60_s(decay_per_s),
            label: mode.label.to_string(),
            material_per_s: damping.decay_per_s(mode.hz),
            radiation_per_s: mode.radiation_per_s,
            support_per_s: mode.support_per_s,
            pipe_per_s: mode.pipe_per_s,
            felt_per_s: mode.felt_per_s,
            coupling: mode.coupling,
            residual: mode.residual,
        }
    }
}

fn json(value: &impl Serialize) -> Result<String> {
    Ok(serde_json::to_string_pretty(value)? + "\n")
}

fn keys_table(bank: &modes::Bank) -> String {
    let mut table = Table::new(["key", "note", "Hz", "mm", "g", "modes", "longest T60 s"]);
    for body in &bank.bodies {
        table.push([
            body.key.to_string(),
            note::name(body.key),
            format!("{:.2}", body.pitch_hz),
            format!("{:.2}", 1e3 * body.length_m),
            format!("{:.1}", 1e3 * body.mass_kg),
            body.modes.len().to_string(),
            longest_t60(body, &bank.matter_of(body).damping),
        ]);
    }
    table.text(false)
}

/// T60 in s of the mode that rings longest.
fn longest_t60(body: &Body, damping: &Damping) -> String {
    let rates = body.modes.iter().map(|mode| mode.decay_per_s(damping));
    let least = rates.fold(f64::INFINITY, f64::min);
    format!("{:.2}", t60_s(least))
}

fn modes_table(body: &Body, damping: &Damping) -> String {
    let mut table = Table::new(["mode", "Hz", "decay 1/s", "T60 s", "coupling", "residual"]);
    for mode in &body.modes {
        let mode = ModeJson::new(mode, damping);
        table.push([
            mode.label,
            format!("{:.3}", mode.hz),
            format!("{:.4}", mode.decay_per_s),
            format!("{:.3}", mode.t60_s),
            format!("{:.4}", mode.coupling),
            format!("{:.1e}", mode.residual),
        ]);
    }
    table.text(false)
}

#[cfg(test)]
mod tests {
    use super::*;
    use modes::{Family, Material, Member, ModeLabel, StrikeLine};

    fn bank() -> modes::Bank {
        let label = ModeLabel {
            family: Family::Bending,
            order: 1,
            index: 1,
            member: Member::A,
        };
        let mode = Mode {
            hz: 587.33,
            coupling: 2.0,
            ears: [[0.0; 2]; 2],
            pipe_ears: [[0.0; 2]; 2],
            radiation_per_s: 0.25,
            support_per_s: 0.5,
            felt_per_s: 9.0,
            pipe_per_s: 0.125,
            residual: 1e-12,
            label,
            shape: Vec::new().into(),
        };
        let line = StrikeLine::single(Vec::new(), Vec::new());
        let body = Body {
            key: 74,
            pitch_hz: 587.33,
            length_m: 0.505,
            mass_kg: 0.2,
            matter: None,
            line,
            surface: None,
            modes: vec![mode],
        };
        modes::Bank {
            name: "chimes".to_owned(),
            title: "Wind chimes".to_owned(),
            ears_m: [[0.0; 3]; 2],
            material: Material::from_young(70e9, 0.33, 2700.0).unwrap(),
            damping: Damping {
                rayleigh: modes::Rayleigh {
                    alpha1_s: 0.0,
                    alpha2_per_s: 0.25,
                },
                loss_factor: 0.0,
            },
            provenance: modes::Provenance::default(),
            bodies: vec![body],
            spread: None,
        }
    }

    fn text(key: Option<u8>, json: bool) -> Result<String> {
        let name = "chimes".to_owned();
        let command = Bank {
            name,
            key,
            json,
            faust: false,
            position: 3.0,
            across: 0.0,
        };
        command.text(&bank())
    }

    #[test]
    fn json_has_the_shape_that_scripts_read() {
        let key: serde_json::Value = serde_json::from_str(&text(Some(74), true).unwrap()).unwrap();
        assert_eq!(key["key"], 74);
        let mode = &key["modes"][0];
        assert_eq!(mode["hz"], 587.33);
        assert_eq!(mode["decay_per_s"], 1.0);
        assert_eq!(mode["t60_s"], 1000f64.ln());
        assert_eq!(mode["label"], "bending 1 a");
        let all: serde_json::Value = serde_json::from_str(&text(None, true).unwrap()).unwrap();
        assert_eq!(all["name"], "chimes");
        assert_eq!(all["keys"][0], key);
    }

    #[test]
    fn a_key_outside_the_bank_is_refused() {
        let error = text(Some(7), false).unwrap_err().to_string();
        assert!(
            error.contains("--key 7") && error.contains("74…74"),
            "{error}"
        );
    }
}
