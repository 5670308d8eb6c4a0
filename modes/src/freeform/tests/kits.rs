//! Kits out of files: each piece as in a bank of its own.

use super::super::make;
use super::made::Folder;
use crate::factory::{Progress, Silent};
use crate::solid::gallery::{cuboid, cylinder, sphere, stack};
use crate::solid::write_obj;
use crate::{Bank, Body, FreeRecipe, Material, Mode, equal_temperament_hz};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Mutex;

/// A piece of a kit: keys, what changes from key to key, the shape, the material's density.
type Given = ([u8; 2], &'static str, &'static str, f64);

/// A ball by size, a cube by density and a tube with a wall by stiffness; glass is lighter.
const PIECES: [Given; 3] = [
    (
        [36, 47],
        "size",
        "file = \"ball.obj\", size_m = 0.2",
        8700.0,
    ),
    (
        [48, 59],
        "density",
        "file = \"cube.obj\", unit_m = 0.1",
        8700.0,
    ),
    (
        [60, 72],
        "stiffness",
        "file = \"tube.obj\", size_m = 0.3, wall_m = 0.01, up = \"x\"",
        2500.0,
    ),
];

fn folder(name: &str) -> Folder {
    let folder = Folder::with(name, &stack(4, 0.05));
    for (file, soup) in [
        ("ball.obj", sphere(1.0, 4)),
        ("cube.obj", cuboid([1.0; 3])),
        ("tube.obj", cylinder(0.2, 1.0, 24)),
    ] {
        std::fs::write(folder.0.join(file), write_obj(&soup)).unwrap();
    }
    folder
}

/// One place for all bodies, so that ears do not tell one bank from another.
const HEAD: &str =
    "name = \"kit\"\n[listener]\nrow_m = 0.0\n[mesh]\nnodes = 900\nmost_modes = 20\n";

fn tables((keys, by, body, density): Given, within: &str) -> String {
    let [low, high] = keys;
    format!(
        "[{within}keys]\nlow = {low}\nhigh = {high}\n[{within}tuning]\nby = \"{by}\"\n\
         [{within}material]\nyoung_pa = 70e9\npoisson = 0.33\ndensity_kg_m3 = {density:?}\n\
         [{within}damping]\nalpha1_s = {density:?}e-11\nalpha2_per_s = 0.5\nsupport_kg_s = 0.01\n\
         [{within}body]\nshape = \"mesh\"\n{}\n",
        body.replace(", ", "\n")
    )
}

fn bank(text: &str, folder: &Path) -> Bank {
    let recipe = FreeRecipe::parse(text, "kit.toml", folder).unwrap();
    let made = make(&recipe, &Silent).unwrap();
    assert_eq!(made.bank.check(), Ok(()));
    made.bank
}

fn kit(folder: &Path) -> Bank {
    let pieces = PIECES.map(|given| format!("[[piece]]\n{}", tables(given, "piece.")));
    bank(&format!("{HEAD}{}", pieces.concat()), folder)
}

#[test]
fn a_kit_of_three_is_three_banks() {
    let folder = folder("kit");
    let kit = kit(&folder.0);
    assert_eq!(Bank::read(&kit.write()), Ok(kit.clone()));
    let whole = kit.spread_out();
    let mut bodies = whole.bodies.iter();
    for given in PIECES {
        let alone = bank(&format!("{HEAD}{}", tables(given, "")), &folder.0).spread_out();
        for expected in &alone.bodies {
            let found = bodies.next().unwrap();
            assert_eq!(whole.matter_of(found), alone.matter_of(expected));
            let matter = expected.matter;
            assert_eq!(
                Body {
                    matter,
                    ..found.clone()
                },
                *expected
            );
        }
    }
    assert!(bodies.next().is_none());
    let density = |body: &Body| whole.matter_of(body).material.density_kg_m3;
    assert_eq!(density(&whole.bodies[0]), 8700.0);
    assert_eq!(density(&whole.bodies[36]), 2500.0);
}

/// Every key of every piece has its pitch on the mode that is tuned, also a picked one.
#[test]
fn picked_partials_land_on_the_keys() {
    let folder = folder("picked");
    for mode in [1, 3, 7] {
        let given = tables(PIECES[1], "").replace("by =", &format!("mode = {mode}\nby ="));
        let bank = bank(&format!("{HEAD}{given}"), &folder.0).spread_out();
        assert_eq!(bank.bodies.len(), 12);
        for body in &bank.bodies {
            let hz = body.modes[mode - 1].hz;
            let off = 1200.0 * (hz / equal_temperament_hz(body.key, 440.0)).log2();
            assert!(off.abs() < 1e-6, "mode {mode} of key {}: {off}", body.key);
        }
    }
}

/// A body solved anew of what a key's body is made of, or as large as it is, has that key's modes.
#[test]
fn what_a_key_s_body_is_said_to_be_has_its_modes() {
    let folder = folder("anew");
    for rule in ["size", "density", "stiffness"] {
        let given = ([40, 64], rule, "file = \"cube.obj\", size_m = 0.1", 2700.0);
        let spread = bank(&format!("{HEAD}{}", tables(given, "")), &folder.0).spread_out();
        let body = &spread.bodies[20];
        let Material { density_kg_m3, .. } = spread.matter_of(body).material;
        let young_pa = spread.matter_of(body).material.young_pa();
        // Lengths of bodies are along their own axes, which are not those of the file's box.
        let size_m = 0.1 * body.length_m / spread_length(&spread, rule, body);
        let again = tables(
            ([60, 60], "nothing", "file = \"cube.obj\"", density_kg_m3),
            "",
        )
        .replace("70e9", &format!("{young_pa:?}"))
        .replace(
            "\"cube.obj\"",
            &format!("\"cube.obj\"\nsize_m = {size_m:?}"),
        );
        let own = bank(&format!("{HEAD}{again}"), &folder.0);
        let solved = &own.bodies[0];
        assert!((body.mass_kg / solved.mass_kg - 1.0).abs() < 1e-6, "{rule}");
        let count = body.modes.len().min(solved.modes.len());
        assert!(count >= 6, "{count}");
        let off = |(p, q): (&Mode, &Mode)| (p.hz / q.hz - 1.0).abs();
        let worst = body.modes.iter().zip(&solved.modes).map(off);
        let worst = worst.fold(0.0, f64::max);
        println!("a cube by {rule}, solved anew: {worst:.1e}");
        assert!(worst < 1e-6, "{rule}: {worst}");
    }
}

/// Length of the body as it was solved, of which `body` is one at another size.
fn spread_length(bank: &Bank, rule: &str, body: &Body) -> f64 {
    if rule != "size" {
        return body.length_m;
    }
    let surface = bank.bodies[0].surface.as_ref().unwrap();
    surface.length_m
}

/// Keys of their own without a pitch asked: the body as it is, on all of them.
#[test]
fn drums_keep_their_own_pitch() {
    let folder = folder("drums");
    let text = format!(
        "{HEAD}[tuning]\nby = \"nothing\"\n[body]\nfile = \"shape.obj\"\nunit_m = 1.0\n\
         [material]\nname = \"bell bronze\"\n\
         [[piece]]\nkeys = {{ low = 36, high = 36 }}\nbody = {{ object = \"box 4\" }}\n\
         [[piece]]\nkeys = {{ low = 38, high = 40 }}\nbody = {{ object = \"box 1\" }}\n"
    );
    let bank = bank(&text, &folder.0).spread_out();
    let keys: Vec<u8> = bank.bodies.iter().map(|body| body.key).collect();
    assert_eq!(keys, [36, 38, 39, 40]);
    // The fourth box is of 1.3 times the edge; the mesh inside is not quite the same.
    let [low, high] = [0, 1].map(|i| bank.bodies[i].modes[0].hz);
    assert!((high / low / 1.3 - 1.0).abs() < 5e-3, "{high} {low}");
    assert_eq!(bank.bodies[1].modes, bank.bodies[3].modes);
    assert!(bank.spread.is_none());
}

#[test]
fn progress_goes_through_all_pieces_and_errors_name_the_object() {
    struct Told(Mutex<Vec<(usize, usize)>>);
    impl Progress for Told {
        fn advance(&self, done: usize, total: usize) -> ControlFlow<()> {
            self.0.lock().unwrap().push((done, total));
            ControlFlow::Continue(())
        }
    }
    let folder = folder("progress");
    let text = format!(
        "{HEAD}[body]\nfile = \"shape.obj\"\n[material]\nname = \"bell bronze\"\n\
         [[piece]]\nkeys = {{ low = 36, high = 40 }}\nbody = {{ objects = [\"box 1\"] }}\n\
         [[piece]]\nkeys = {{ low = 41, high = 44 }}\nbody = {{ objects = [\"box 2\", \"box 9\"] }}\n"
    );
    let told = Told(Mutex::default());
    let recipe = FreeRecipe::parse(&text, "kit.toml", &folder.0).unwrap();
    let error = make(&recipe, &told).unwrap_err().to_string();
    assert!(
        error.contains(
            "shape.obj (box 2, box 9): there is no object \"box 9\"; there are \"box 1\""
        ),
        "{error}"
    );
    let told = told.0.into_inner().unwrap();
    // The second piece fails before its first step.
    let half = |(done, total): &(usize, usize)| 2 * done <= *total;
    assert!(told.len() > 3 && told.iter().all(half), "{told:?}");
}
