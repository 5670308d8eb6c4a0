//! Files looked into, built, given up and refused.

mod playing;

use super::*;
use crate::notices::{Cure, Notice};
use modes::PieceOrder;
use modes::solid::{gallery, write_obj};
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// One body, or several with keys from 36 up, an octave each.
fn order(files: &[&Path]) -> MeshOrder {
    let alone = files.len() == 1;
    let pieces = files
        .iter()
        .zip((36..96).step_by(12))
        .map(|(file, low)| PieceOrder {
            file: file.to_str().unwrap().to_owned(),
            material: "bell bronze".to_owned(),
            size_m: Some(0.2),
            keys: if alone { [36, 96] } else { [low, low + 11] },
            by: "size".to_owned(),
            tuned: "lowest".to_owned(),
            ..PieceOrder::default()
        });
    MeshOrder {
        pieces: pieces.collect(),
        ..MeshOrder::default()
    }
}

/// A song without a bank, and a folder of banks.
fn places(folder: Option<&Path>) -> Places {
    Places {
        library: Arc::new(Library::new(folder.map(Path::to_path_buf))),
        shelf: Arc::default(),
        notices: Arc::default(),
    }
}

/// A folder with a star's mesh in it, and where its banks would go.
struct Bed {
    _folder: tempfile::TempDir,
    file: PathBuf,
    banks: PathBuf,
    places: Places,
}

/// A star of so many units across.
fn bed(radius: f64) -> Bed {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("star.obj");
    fs::write(&file, write_obj(&gallery::star(5, radius, 0.2 * radius))).unwrap();
    let banks = folder.path().join("Banks");
    Bed {
        places: places(Some(&banks)),
        _folder: folder,
        file,
        banks,
    }
}

/// How it stands when no thread is at work.
fn rest(mesher: &Mesher) -> State {
    let start = Instant::now();
    while mesher.state().phase.works() {
        assert!(start.elapsed() < Duration::from_secs(120));
        thread::sleep(Duration::from_millis(5));
    }
    mesher.state()
}

#[test]
fn a_star_is_looked_into_built_kept_and_played() {
    let Bed {
        file,
        banks,
        places,
        ..
    } = &bed(100.0);
    let mut mesher = Mesher::default();
    mesher.look(file.clone(), || ());
    let facts = rest(&mesher).facts.unwrap();
    let longest = facts.longest(&[]);
    assert!((longest - 190.2).abs() < 10.0, "{longest}");
    assert!((guessed_size_m(longest) - 1e-3 * longest).abs() < 1e-12);
    for _ in 0..2 {
        let mut order = order(&[file]);
        order.pieces[0].size_m = Some(if banks.exists() { 0.3 } else { 0.2 });
        mesher.build(order, Quality::Preview, places, || ());
        assert_eq!(rest(&mesher).phase, Phase::Done);
        assert!(places.library.arrived());
    }
    assert_eq!(places.shelf.own().unwrap().title(), "star");
    assert_eq!(
        places.shelf.own().unwrap().bank().bodies.len(),
        61,
        "a body to a key"
    );
    for name in ["star.bank", "star-2.bank"] {
        assert!(banks.join(name).is_file(), "{name}");
    }
}

#[test]
fn a_kit_is_built_and_its_notes_say_of_which_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let star = folder.path().join("star.obj");
    fs::write(&star, write_obj(&gallery::star(5, 0.1, 0.02))).unwrap();
    let ball = folder.path().join("ball.obj");
    let inside_out: String = write_obj(&gallery::sphere(0.1, 2))
        .lines()
        .map(
            |line| match line.split_whitespace().collect::<Vec<_>>()[..] {
                ["f", a, b, c] => format!("f {a} {c} {b}\n"),
                _ => format!("{line}\n"),
            },
        )
        .collect();
    fs::write(&ball, inside_out).unwrap();
    let banks = folder.path().join("Banks");
    let places = places(Some(&banks));
    let mut mesher = Mesher::default();
    let order = order(&[&star, &ball]);
    mesher.build(order, Quality::Preview, &places, || ());
    let state = rest(&mesher);
    assert_eq!(state.phase, Phase::Done);
    assert!(
        state
            .notes
            .contains(&"ball.obj: turned 1 pieces that were inside out".to_owned()),
        "{:?}",
        state.notes
    );
    let bank = places.shelf.own().unwrap();
    assert_eq!(bank.bank().bodies.len(), 24, "two octaves");
    assert!(banks.join("star.bank").is_file());
}

#[test]
fn what_is_given_up_leaves_nothing() {
    let Bed {
        file,
        banks,
        places,
        ..
    } = &bed(0.1);
    let mut mesher = Mesher::default();
    mesher.build(order(&[file]), Quality::Full, places, || ());
    mesher.cancel();
    assert_eq!(rest(&mesher).phase, Phase::Cancelled);
    assert!(places.shelf.own().is_none() && !banks.exists());
    // The window closes in the midst of it.
    mesher.build(order(&[file]), Quality::Full, places, || ());
    drop(mesher);
    assert!(!banks.exists());
    assert_eq!(Arc::strong_count(&places.shelf), 1, "no thread is left");
}

#[test]
fn a_preview_whose_full_quality_is_given_up_plays_on_and_says_so() {
    let Bed {
        file,
        banks,
        places,
        ..
    } = &bed(0.1);
    let mut mesher = Mesher::default();
    mesher.build(order(&[file]), Quality::Full, places, || ());
    let start = Instant::now();
    while mesher.state().phase != Phase::Full {
        assert!(start.elapsed() < Duration::from_secs(120));
        thread::sleep(Duration::from_millis(1));
    }
    mesher.cancel();
    assert_eq!(rest(&mesher).phase, Phase::Stopped);
    assert_eq!(places.shelf.own().unwrap().title(), "star");
    assert!(!banks.exists(), "what is not asked for is not kept");
    let Some(Notice { text, cure, .. }) = places.notices.first() else {
        panic!("nobody is told");
    };
    assert_eq!(text, "star plays as a preview: full quality was given up.");
    let Some(Cure::Finish(again)) = cure else {
        panic!("{cure:?}");
    };
    assert_eq!(*again, order(&[file]));
    mesher.build(*again, Quality::Preview, places, || ());
    assert_eq!(places.notices.first(), None);
    assert_eq!(rest(&mesher).phase, Phase::Done);
    assert_eq!(places.notices.first(), None);
    assert!(banks.join("star.bank").is_file());
}

#[test]
fn what_is_no_solid_is_refused_with_its_reason() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("sheet.obj");
    fs::write(&file, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").unwrap();
    let places = places(None);
    let mut mesher = Mesher::default();
    mesher.build(order(&[&file]), Quality::Preview, &places, || ());
    let Phase::Refused(reason) = rest(&mesher).phase else {
        panic!("{:?}", mesher.state());
    };
    assert!(reason.contains("sheet.obj"), "{reason}");
    mesher.look(folder.path().join("nothing.obj"), || ());
    let Phase::Refused(reason) = rest(&mesher).phase else {
        panic!("{:?}", mesher.state());
    };
    assert!(reason.contains("nothing.obj"), "{reason}");
}
