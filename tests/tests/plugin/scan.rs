//! What a host learns before it plays anything.

use idiophone_tests::{library_file, plugin};
use std::collections::HashSet;
use xtask::host::Library;

#[test]
fn it_describes_itself() {
    let library = Library::open(&library_file().unwrap()).unwrap();
    let [plugin] = &library.descriptors()[..] else {
        panic!("one plug-in: {:?}", library.descriptors());
    };
    assert_eq!(plugin.name, "Idiophone");
    assert_eq!(plugin.version, env!("CARGO_PKG_VERSION"));
    assert!(plugin.id.contains("idiophone"), "{}", plugin.id);
    assert!(plugin.features.iter().any(|f| f == "instrument"));
    assert!(plugin.features.iter().any(|f| f == "stereo"));
    assert!(!plugin.description.is_empty());
    // CLAP's own features are plain words; all others need a namespace.
    let own = ["instrument", "synthesizer", "stereo"];
    let foreign = |f: &&String| !own.contains(&f.as_str());
    for feature in plugin.features.iter().filter(foreign) {
        assert!(feature.contains(':'), "{feature}");
    }
}

#[test]
fn every_parameter_is_on_a_page_for_remote_controls() {
    let mut plugin = plugin().unwrap();
    let pages = plugin.pages();
    let names: HashSet<_> = pages.iter().map(|(name, _)| name).collect();
    assert_eq!(names.len(), pages.len());
    let params = plugin.params();
    for param in params.iter().filter(|param| !param.hidden) {
        let there = pages.iter().any(|(_, ids)| ids.contains(&param.id));
        assert!(there, "{}", param.name);
    }
    assert_eq!(plugin.voices(), Some(128));
}

#[test]
fn instances_come_and_go() {
    let library = Library::open(&library_file().unwrap()).unwrap();
    for _ in 0..8 {
        let mut instance = library.instantiate().unwrap();
        instance.activate(48_000.0, 512).unwrap();
        instance.play(&[], 512, 512).unwrap();
    }
}

#[test]
fn a_fresh_instance_logs_nothing() {
    let mut plugin = plugin().unwrap();
    plugin.activate(48_000.0, 512).unwrap();
    plugin.play(&[], 4096, 512).unwrap();
    plugin.deactivate();
    assert_eq!(plugin.log(), Vec::<String>::new());
}

/// Without this the other tests would not notice an allocation in `process`.
#[test]
fn allocations_are_watched() {
    let bytes = std::fs::read(library_file().unwrap()).unwrap();
    let watch = b"assert_no_alloc";
    assert!(bytes.windows(watch.len()).any(|window| window == watch));
}
