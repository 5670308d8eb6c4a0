//! From a file to an instrument.

use super::super::{MadeError, make};
use super::lamb::exact_hz;
use super::worst;
use crate::FreeRecipe;
use crate::factory::{Progress, Silent};
use crate::solid::gallery::{cuboid, sphere};
use crate::solid::{MeshError, Soup, write_obj};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// A folder with `soup` in `shape.obj`, gone with this.
pub(super) struct Folder(pub(super) PathBuf);

impl Folder {
    pub(super) fn with(name: &str, soup: &Soup) -> Self {
        let name = format!("idiophone-made-{name}-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("shape.obj"), write_obj(soup)).unwrap();
        Self(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // A folder left behind harms nobody.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Of the material of these tests.
pub(super) fn recipe(folder: &Path, body: &str, nodes: usize) -> FreeRecipe {
    let text = format!(
        "name = \"shape\"\n[keys]\nlow = 60\nhigh = 72\n[tuning]\nby = \"nothing\"\n\
         [body]\nshape = \"mesh\"\nfile = \"shape.obj\"\n{body}\n\
         [material]\nyoung_pa = 70e9\npoisson = 0.33\ndensity_kg_m3 = 2700.0\n\
         [damping]\nalpha1_s = 1e-7\nalpha2_per_s = 0.0\n[mesh]\nnodes = {nodes}\nmost_modes = 60"
    );
    FreeRecipe::parse(&text, "shape.toml", folder).unwrap()
}

pub(super) fn hz(recipe: &FreeRecipe) -> Vec<f64> {
    let made = make(recipe, &Silent).unwrap();
    assert_eq!(made.bank.check(), Ok(()));
    let modes = &made.bank.bodies[0].modes;
    modes.iter().map(|mode| mode.hz).collect()
}

#[test]
fn a_ball_out_of_a_file_has_lamb_s_modes() {
    let folder = Folder::with("ball", &sphere(1.0, 5));
    let exact = exact_hz(0.0, 0.25, 20e3);
    let at = |nodes| worst(&hz(&recipe(&folder.0, "size_m = 0.5", nodes)), &exact, 10);
    let (coarse, fine) = (at(1500), at(6000));
    println!("ball from a file: {coarse:.2e}, {fine:.2e}");
    assert!(coarse < 0.01 && fine < 0.003, "{coarse} {fine}");
}

#[test]
fn a_hollow_ball_out_of_a_file_has_its_modes() {
    let folder = Folder::with("hollow", &sphere(1.0, 5));
    let exact = exact_hz(0.2, 0.25, 20e3);
    let made = hz(&recipe(&folder.0, "size_m = 0.5\nwall_m = 0.05", 12_000));
    let found = worst(&made, &exact, 10);
    println!("hollow ball from a file: {found:.2e}");
    assert!(found < 0.01, "{found}");
}

#[test]
fn what_is_no_solid_is_refused_by_the_name_of_its_file() {
    let mut open = cuboid([1.0; 3]);
    open.triangles.truncate(6);
    open.objects[0].triangles = 0..6;
    let folder = Folder::with("open", &open);
    let error = make(&recipe(&folder.0, "", 1000), &Silent).unwrap_err();
    let text = error.to_string();
    assert!(text.contains("shape.obj: the surface is open"), "{text}");
    let missing = recipe(Path::new("nowhere"), "", 1000);
    assert!(matches!(make(&missing, &Silent), Err(MadeError::Obj(_))));
}

#[test]
fn making_can_be_cancelled() {
    struct Once;
    impl Progress for Once {
        fn advance(&self, _: usize, _: usize) -> ControlFlow<()> {
            ControlFlow::Break(())
        }
    }
    let folder = Folder::with("cancelled", &cuboid([1.0; 3]));
    let error = make(&recipe(&folder.0, "", 1000), &Once).unwrap_err();
    let cancelled = MeshError::Cancelled;
    assert!(matches!(error, MadeError::Mesh { error, .. } if error == cancelled));
}
