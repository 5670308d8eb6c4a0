//! The physics against theory and published tables.

use modes::check::GROUPS;

/// Every row of a group must be within its bound; how long the machine took is told by
/// `cargo xtask check` alone.
fn hold(name: &str) {
    let group = GROUPS.iter().find(|(group, _)| *group == name);
    let (_, rows) = group.expect("a group of this name");
    let rows = rows().expect("every comparison can be made");
    assert!(!rows.is_empty());
    for row in rows.iter().filter(|row| row.unit != "s") {
        assert!(
            row.ok,
            "{}: {} {} beside {}, off by {:e} where {:e} is allowed",
            row.name, row.value, row.unit, row.reference, row.error, row.bound
        );
    }
}

#[test]
fn bending_of_a_free_tube() {
    hold("bending of a free tube");
}

#[test]
fn chimes_of_obrien_2002() {
    hold("the chimes of O'Brien 2002");
}

#[test]
fn decay_rates_of_obrien_2002() {
    hold("decay rates of O'Brien 2002");
}

#[test]
fn meshes_converge() {
    hold("meshes");
}

#[test]
fn linear_tetrahedra() {
    hold("linear tetrahedra");
}

#[test]
fn vibraphone_bars() {
    hold("vibraphone bars");
}

#[test]
fn rings_and_shells() {
    hold("rings and shells");
}

#[test]
fn clamped_bars_and_plates_and_hollow_cubes() {
    hold("clamped bars and plates, hollow cubes");
}

#[test]
fn bowls_of_obrien_2002() {
    hold("the bowls of O'Brien 2002");
}

#[test]
fn special_paths() {
    hold("special paths");
}

#[test]
fn tubes_out_of_obj_files() {
    hold("tubes out of OBJ files");
}

#[test]
fn recordings() {
    hold("recordings");
}

#[test]
fn what_is_heard() {
    hold("what is heard");
}

#[test]
fn every_instrument_converges() {
    hold("convergence");
}

#[test]
fn shapes_of_van_den_doel_1998() {
    hold("the shapes of van den Doel & Pai 1998");
}

#[test]
fn factory_banks() {
    hold("the factory banks");
}

#[test]
fn no_group_is_left_out() {
    assert_eq!(GROUPS.len(), 16);
}
