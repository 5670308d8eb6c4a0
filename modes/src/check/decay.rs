//! Eq. 9 against Table 1 of O'Brien 2002.

use super::{CheckError, Row};
use crate::TABLE_1;

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    Ok(TABLE_1
        .iter()
        .filter(|row| row.self_consistent())
        .map(|row| {
            let value = row.computed_decay_per_s();
            let allowed = row.allowed_decay_per_s();
            // Digits may have been cut as well as rounded: more room above than below.
            let bound = if value < row.decay_per_s {
                row.decay_per_s - allowed.start()
            } else {
                allowed.end() - row.decay_per_s
            };
            Row::absolute(
                format!("{}, decay rate by Eq. 9", row.example),
                (row.decay_per_s, value, "1/s"),
                bound,
                "O'Brien 2002, Table 1",
            )
        })
        .collect())
}
