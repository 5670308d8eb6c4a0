//! Finding a parameter by what a user calls it.

use crate::host::Param;
use anyhow::{Result, bail};

/// The parameter called `name`: case, spaces and punctuation do not count, Greek letters may be
/// spelt out, and the beginning of one name alone is enough.
///
/// # Errors
///
/// If none or several are meant.
pub fn find(params: &[Param], name: &str) -> Result<Param> {
    let wanted = plain(name);
    if let Some(param) = params.iter().find(|param| plain(&param.name) == wanted) {
        return Ok(param.clone());
    }
    let begin: Vec<_> = params
        .iter()
        .filter(|param| !param.hidden && plain(&param.name).starts_with(&wanted))
        .collect();
    let names = |params: &[&Param]| {
        let names: Vec<_> = params.iter().map(|param| param.name.as_str()).collect();
        names.join(", ")
    };
    match begin[..] {
        [only] => Ok(only.clone()),
        ref several if !wanted.is_empty() && several.len() > 1 => {
            bail!("`{name}` could be any of: {}", names(several))
        }
        _ => {
            let shown: Vec<_> = params.iter().filter(|param| !param.hidden).collect();
            bail!("no parameter `{name}`; allowed: {}", names(&shown))
        }
    }
}

/// The letters and digits of a name, in small Latin letters.
fn plain(name: &str) -> String {
    let mut plain = String::new();
    for c in name.chars().flat_map(char::to_lowercase) {
        match c {
            'α' => plain.push_str("alpha"),
            'β' => plain.push_str("beta"),
            'μ' | 'µ' => plain.push_str("mu"),
            'ρ' => plain.push_str("rho"),
            'φ' => plain.push_str("phi"),
            '₀'..='₉' => plain.extend(char::from_digit(c as u32 - '₀' as u32, 10)),
            c if c.is_alphanumeric() => plain.push(c),
            _ => {}
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_leniently() {
        for name in ["Alpha 1", "alpha1", "ALPHA-1", "α1", "α₁", " α 1 "] {
            assert_eq!(plain(name), "alpha1", "{name}");
        }
        assert_ne!(plain("Alpha 1"), plain("Alpha 2"));
    }
}
