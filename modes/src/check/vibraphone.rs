//! Bars against what they are tuned to, the quarter models against the whole mesh.

use super::{CheckError, Row, aluminium, cents, greater};
use crate::bar::{
    BarFineness, BarPartials, BarTuning, bar_modes, bar_partials, tune_bar, vibraphone_ratios,
    vibraphone_stock,
};
use crate::equal_temperament_hz;
use crate::fem::{TetMass, assemble};
use crate::mesh::{BarPart, bar_hex20};
use crate::shape::Bar;
use crate::solve::{Band, modes_in_band};

/// The mesh of the factory's bars.
const SHIPPED: BarFineness = BarFineness {
    max_element_m: 0.007,
    across: 3,
    through: 2,
};

/// F♯3, the bar of O'Brien 2001.
const F_SHARP_3: u8 = 54;

/// Its pitch there, in Hz (Fig. 8).
const O_BRIEN_HZ: f64 = 187.0;

pub(super) fn rows() -> Result<Vec<Row>, CheckError> {
    let mut rows = curve()?;
    rows.extend(o_brien()?);
    rows.push(whole()?);
    Ok(rows)
}

fn tuned(key: u8, pitch_hz: f64, ratios: [f64; 2]) -> Result<Bar, CheckError> {
    let tuning = BarTuning {
        pitch_hz,
        ratios,
        tolerance_cents: 1.0,
    };
    Ok(tune_bar(&vibraphone_stock(key), &aluminium(), SHIPPED, &tuning)?.bar)
}

fn partials(bar: &Bar) -> Result<BarPartials, CheckError> {
    Ok(bar_partials(bar, &aluminium(), SHIPPED)?)
}

/// The second and third partial that makers name: 4 and 10 up to F5 (key 77), then by equal steps to
/// 3.5 and 6.5 at F6.
fn named_ratios(key: u8) -> [f64; 2] {
    let top = f64::from(key.saturating_sub(77)) / 12.0;
    [4.0 - 0.5 * top, 10.0 - 3.5 * top]
}

fn curve() -> Result<Vec<Row>, CheckError> {
    let mut worst = [0.0; 3];
    let mut torsion = f64::INFINITY;
    for key in 53..=89 {
        let hz = equal_temperament_hz(key, 440.0);
        let partials = partials(&tuned(key, hz, vibraphone_ratios(key))?)?;
        let [second, third] = named_ratios(key);
        for (i, ratio) in [1.0, second, third].into_iter().enumerate() {
            worst[i] = greater(worst[i], cents(partials.bending_hz[i], ratio * hz));
        }
        for clearance in partials.torsion_clearance_cents() {
            torsion = torsion.min(clearance.abs());
        }
    }
    let source = "1 : 4 : 10 to F5, 1 : 3.5 : 6.5 at F6: Musser M55 and Ross sets (wyndorps.de)";
    let mut rows: Vec<Row> = ["pitch", "second bending mode", "third bending mode"]
        .into_iter()
        .zip(worst)
        .zip([1.0, 10.0, 30.0])
        .map(|((name, worst), bound)| {
            Row::absolute(
                format!("bars of keys 53–89, {name}: farthest off"),
                (0.0, worst, "cents"),
                bound,
                source,
            )
        })
        .collect();
    let short = (100.0 - torsion).max(0.0);
    rows.push(Row::absolute(
        format!(
            "bars of keys 53–89: what the first torsion mode lacks of a semitone from the second \
             and third bending modes (nearest: {torsion:.0} cents)"
        ),
        (0.0, short, "cents"),
        0.0,
        "makers keep torsion clear of bending (La Favre, for marimbas)",
    ));
    Ok(rows)
}

fn o_brien() -> Result<Vec<Row>, CheckError> {
    let partials = partials(&tuned(F_SHARP_3, O_BRIEN_HZ, [4.0, 10.0])?)?;
    let rows = ["fundamental", "second bending mode", "third bending mode"];
    Ok(rows
        .into_iter()
        .zip([1.0, 4.0, 10.0])
        .zip(partials.bending_hz)
        .map(|((name, ratio), hz)| {
            Row::relative(
                format!("0.360 m bar of F♯3, {name}"),
                (ratio * O_BRIEN_HZ, hz, "Hz"),
                1e-3,
                "O'Brien 2001, Fig. 8: 1 : 4 : 10 over 187 Hz",
            )
        })
        .collect())
}

fn whole() -> Result<Row, CheckError> {
    let bar = tuned(F_SHARP_3, O_BRIEN_HZ, [4.0, 10.0])?;
    let band = Band {
        high_hz: 12_000.0,
        ..Band::AUDIBLE
    };
    let mesh = bar_hex20(&bar, SHIPPED.grid(&bar), BarPart::Whole);
    let judge = modes_in_band(&assemble(&mesh, &aluminium(), TetMass::Consistent)?, band)?;
    let quarters = bar_modes(&bar, &aluminium(), SHIPPED, band)?;
    let pairs = quarters.modes.iter().zip(&judge.modes).take(20);
    let compared = pairs.len();
    let worst = pairs.fold(0.0, |worst, (mode, judge)| {
        greater(worst, cents(mode.hz, judge.hz))
    });
    Ok(Row::absolute(
        format!("bar of F♯3 by quarters, first {compared} modes: greatest difference"),
        (0.0, worst, "cents"),
        1.0,
        "the same mesh whole, general sparse path",
    ))
}
