//! Meshes.

use super::case::cases;
use super::mutate;
use modes::factory::Silent;
use modes::solid::{
    Meshing, Repair, Resolution, gallery, mesh_solid, parse_obj, repair, write_obj,
};

/// A box with faces of all kinds, and what else a file may have.
const BOX: &str = "mtllib a.mtl\no box\nv -0.5 -0.5 -0.5\nv 0.5 -0.5 -0.5\nv -0.5 0.5 -0.5\nv 0.5 0.5 -0.5\n\
    v -0.5 -0.5 0.5\nv 0.5 -0.5 0.5\nv -0.5 0.5 0.5\nv 0.5 0.5 0.5\nvt 0 1\nvn 0 0 1\ng a b\nusemtl red\ns 1\n\
    f 1 3 4 2\nf -4 -3 -1 -2\nf 1/1 2/1 6/1\nf 1//1 6//1 5//1\nf 3/1/1 7/1/1 8/1/1 4/1/1\nf 1 5 7 \\\n3\n\
    f 2 4 8 6\nl 1 2\n";

/// Few cases are filled, which takes a thousand times as long as reading.
const FILLED: u64 = 64;

#[test]
fn no_mesh_panics() {
    let goods = [
        BOX.to_owned(),
        write_obj(&gallery::star(5, 0.1, 0.02)),
        write_obj(&gallery::stack(2, 0.1)),
    ];
    let meshing = Meshing {
        wall_m: None,
        resolution: Resolution::Nodes(300),
        most_nodes: 4_000,
    };
    cases("mesh", |noise| {
        let good = &goods[noise.below(goods.len() as u64) as usize];
        let bytes = match noise.below(4) {
            0 => mutate::bytes(noise, good.as_bytes()),
            _ => mutate::text(noise, good).into_bytes(),
        };
        let file = match parse_obj(&bytes, "fuzz.obj", None) {
            Ok(file) => file,
            Err(error) => {
                assert!(error.to_string().contains("fuzz.obj"), "{error}");
                return false;
            }
        };
        let Ok(surface) = repair(&file.soup, &Repair::default()) else {
            return false;
        };
        let filled = noise.below(FILLED) == 0;
        !filled || mesh_solid(&surface, &meshing, &Silent).is_ok()
    });
}
