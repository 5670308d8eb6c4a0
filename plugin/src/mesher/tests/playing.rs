//! A mesh becomes an instrument while it is played: the preview first, then full quality, without a break.

use super::*;
use crate::engine::{Hit, Outputs, Settings};
use crate::factory;
use crate::shelf::{OWN, Own};
use crate::stage::Stage;
use crate::workshop::{Bench, Workshop};
use modes::Bank;
use nice_assert_no_alloc::assert_no_alloc;

const RATE_HZ: f64 = 48_000.0;
const BLOCK: usize = 512;
/// Blocks between two strikes: about a second.
const PULSE: usize = 94;
const CHORD: [u8; 3] = [60, 64, 67];
/// Ten times what a build takes on two idle cores.
const PATIENCE: Duration = Duration::from_secs(300);
/// What may be left of a difference of sums in f32, of full scale.
const ROUNDING: f32 = f32::EPSILON;

/// A stage whose blocks are heard.
struct Heard {
    stage: Stage,
    sound: Vec<f32>,
    longest_s: f64,
}

impl Heard {
    fn new(bank: &Bank) -> Self {
        let mut stage = Stage::new(0, bank, RATE_HZ);
        stage.set(&Settings {
            limiter: false,
            ..Settings::default()
        });
        Self {
            stage,
            sound: Vec::new(),
            longest_s: 0.0,
        }
    }

    /// Renders a block. Whoever comes on is struck at once, others if it is time; whether anyone has been.
    fn block(&mut self, turn: Option<(&Shelf, &Arc<Bench>)>, due: bool) -> bool {
        let (mut left, mut right) = (vec![0.0; BLOCK], vec![0.0; BLOCK]);
        let start = Instant::now();
        let struck = assert_no_alloc(|| {
            let before = self.stage.present().0;
            if let Some((shelf, bench)) = turn {
                self.stage.turn(shelf.number(OWN), bench);
            }
            let struck = due || self.stage.present().0 != before;
            if struck {
                for key in CHORD {
                    self.stage.hit(key, &Hit::plain(0.5));
                }
            }
            self.stage.render(&mut Outputs::main(&mut left, &mut right));
            struck
        });
        self.longest_s = self.longest_s.max(start.elapsed().as_secs_f64());
        self.sound.extend(left);
        struck
    }
}

/// An instrument that came on.
struct Act {
    own: Arc<Own>,
    from: usize,
    after_s: f64,
}

/// What a player hears from the order of a mesh until a second after it plays in full quality.
struct Take {
    heard: Heard,
    /// The blocks in which the chord was struck, whoever was on.
    struck: Vec<usize>,
    acts: Vec<Act>,
}

impl Take {
    fn of(mesher: &Mesher, shelf: &Arc<Shelf>) -> Self {
        let workshop = Workshop::open(Arc::clone(shelf), RATE_HZ);
        let mut take = Self {
            heard: Heard::new(factory::bank(0)),
            struck: Vec::new(),
            acts: Vec::new(),
        };
        let (start, mut last) = (Instant::now(), usize::MAX);
        for block in 0_usize.. {
            assert!(start.elapsed() < PATIENCE);
            let due_s = block as f64 * BLOCK as f64 / RATE_HZ;
            while start.elapsed().as_secs_f64() < due_s {
                thread::sleep(Duration::from_micros(500));
            }
            let before = take.heard.stage.present().0;
            let turn = Some((&**shelf, &*workshop));
            if take.heard.block(turn, block.is_multiple_of(PULSE)) {
                take.struck.push(block);
            }
            if take.heard.stage.present().0 != before {
                take.acts.push(Act {
                    own: shelf.own().unwrap(),
                    from: block,
                    after_s: start.elapsed().as_secs_f64(),
                });
            }
            let phase = mesher.state().phase;
            assert!(phase.works() || phase == Phase::Done, "{phase:?}");
            if take.acts.len() == 2 && last == usize::MAX {
                last = block + PULSE;
            }
            if block == last {
                break;
            }
        }
        take
    }

    /// The same strikes on one instrument that nobody takes the place of.
    fn alone(&self, bank: &Bank, from: usize, until: usize) -> Vec<f32> {
        let mut twin = Heard::new(bank);
        twin.sound.resize(from * BLOCK, 0.0);
        let blocks = self.heard.sound.len() / BLOCK;
        for block in from..blocks {
            twin.block(None, block < until && self.struck.contains(&block));
        }
        twin.sound
    }
}

#[test]
fn a_preview_sounds_first_and_full_quality_takes_its_place_without_a_break() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("ring.obj");
    let ring = gallery::torus(0.08, 0.03, 142);
    assert!(ring.triangles.len() >= 20_000, "{}", ring.triangles.len());
    fs::write(&file, write_obj(&ring)).unwrap();
    let places = places(None);
    let mut mesher = Mesher::default();
    mesher.build(order(&[&file]), Quality::Full, &places, || ());
    let take = Take::of(&mesher, &places.shelf);
    assert_eq!(rest(&mesher).phase, Phase::Done);
    let [preview, full] = &take.acts[..] else {
        panic!("{} came on", take.acts.len());
    };
    let blocks = take.heard.sound.len() / BLOCK;
    println!(
        "{} triangles: heard after {:.2} s, in full quality after {:.1} s, of {blocks} blocks the longest took \
         {:.2} ms",
        ring.triangles.len(),
        preview.after_s,
        full.after_s,
        1e3 * take.heard.longest_s
    );
    let modes = |act: &Act| act.own.bank().bodies[0].modes.len();
    assert!(0 < modes(preview) && modes(preview) < modes(full));
    // What sounds is all three, each as if it were alone: none is cut off, none comes twice.
    let parts = [
        take.alone(factory::bank(0), 0, preview.from),
        take.alone(preview.own.bank(), preview.from, full.from),
        take.alone(full.own.bank(), full.from, blocks),
    ];
    for (name, part) in ["chimes", "preview", "full quality"].iter().zip(&parts) {
        let level = part.iter().fold(0.0, |most: f32, x| most.max(x.abs()));
        assert!(level > 0.01 && level < 1.0, "{name}: {level}");
    }
    let off = take.heard.sound.iter().enumerate().map(|(i, heard)| {
        let sum: f32 = parts.iter().map(|part| part[i]).sum();
        (heard - sum).abs()
    });
    let off = off.fold(0.0, f32::max);
    println!("{off:.1e} of full scale from the sum of the three alone");
    assert!(off < ROUNDING, "{off}");
}
