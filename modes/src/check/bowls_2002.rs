//! The bowls of O'Brien 2002, Table 1, by the profiles of the factory's recipes.

use super::{CheckError, Row, bowl_wall, factory};
use crate::TABLE_1;
use crate::fem::Harmonic;
use crate::solve::lowest;

const BOWLS: [(&str, &str); 2] = [("metal-bowls", "Bowl #1"), ("oak-bowls", "Bowl #2")];

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = Vec::new();
    for (name, example) in BOWLS {
        let recipe = factory(name)?;
        let table = TABLE_1.iter().find(|row| row.example == example);
        let table = table.expect("Table 1 has both bowls");
        let meridian = bowl_wall(&recipe, 1.0)?.meridian;
        let hz = lowest(&Harmonic::new(&meridian, &recipe.material, 2)?.pencil, 0)?;
        rows.push(Row::relative(
            format!("{example} as in recipes/{name}.toml, fundamental"),
            (table.base_hz, hz, "Hz"),
            0.01,
            "O'Brien 2002, Table 1",
        ));
        rows.push(Row::relative(
            format!("{example} as in recipes/{name}.toml, decay rate of the fundamental"),
            (
                table.computed_decay_per_s(),
                recipe.damping.decay_per_s(hz),
                "1/s",
            ),
            0.02,
            "O'Brien 2002, Eq. 9 at Table 1's frequency",
        ));
    }
    Ok(rows)
}
