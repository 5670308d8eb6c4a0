//! The README's pictures: each instrument of the factory in a window on a fine screen.

use crate::bench::Bench;
use crate::looks::{USUAL, draw};
use crate::palette;
use idiophone::factory;
use std::path::Path;

/// A chord that is still heard when C4 is struck last.
const BLOWS: [(u8, f32); 5] = [(48, 0.8), (55, 0.7), (64, 0.7), (67, 0.7), (60, 0.9)];
/// Time between blows, in s.
const EACH_S: f64 = 0.12;

#[test]
#[ignore = "writes docs/pictures: tests/pictures.sh runs it"]
fn every_instrument_is_pictured() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/pictures");
    for (index, (name, _)) in factory::BANKS.iter().enumerate() {
        let bench = Bench::new(name);
        let lowest = factory::bank(index).bodies[0].key;
        let up = if lowest > BLOWS[0].0 { 12 } else { 0 };
        bench.ring(
            name,
            &BLOWS.map(|(key, velocity)| (key + up, velocity)),
            EACH_S,
        );
        let pixels = draw(&bench, USUAL, 2.0, None);
        palette::write(&folder.join(format!("{name}.png")), &pixels);
    }
}
