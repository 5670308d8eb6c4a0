//! Instruments of the user's own: the list, the folder, and what is said when something is missing.

use crate::bench::Bench;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use idiophone::factory;
use idiophone::notices::{Cure, Notice, Subject};
use idiophone::shelf::Library;
use modes::Bank;
use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

/// A folder of banks, which goes with this.
pub(crate) struct Folder(PathBuf);

impl Folder {
    /// With a bank called bell and a file that is none.
    pub(crate) fn new(name: &str) -> Self {
        let name = format!("idiophone-own-{name}-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        fs::create_dir_all(&folder).unwrap();
        bell().save(folder.join("bell.bank")).unwrap();
        fs::write(folder.join("broken.bank"), "RIFF").unwrap();
        Self(folder)
    }

    /// The library over it, given to an editor.
    pub(crate) fn give(&self, bench: &Bench) -> Arc<Library> {
        let library = Library::new(Some(self.0.clone()));
        library.refresh();
        let mut ui = bench.ui.borrow_mut();
        ui.instruments().set_library(library);
        Arc::clone(ui.instruments().library())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Three of the chimes under another name.
fn bell() -> Bank {
    let chimes = factory::bank(0);
    Bank {
        name: "bell".to_owned(),
        title: "A bell of mine".to_owned(),
        bodies: chimes.bodies[23..26].to_vec(),
        ..chimes.clone()
    }
}

fn click(harness: &mut Harness<'_>, label: &str) {
    harness.get_by_label(label).click();
    harness.run_steps(3);
}

#[test]
fn a_bank_of_the_folder_is_chosen_and_plays() {
    let (bench, folder) = (Bench::new("oak-bowls"), Folder::new("choose"));
    let library = folder.give(&bench);
    let mut harness = bench.harness();
    click(&mut harness, "Instrument");
    assert!(harness.query_by_label("broken.bank").is_some());
    click(&mut harness, "A bell of mine");
    let shelf = bench.controls.shelf();
    assert!(
        bench.text("instr") == "Oak bowls" && shelf.own().is_none(),
        "it is loading"
    );
    assert!(library.serve(shelf).unwrap().is_ok());
    harness.run_steps(3);
    assert_eq!(bench.text("instr"), "Your own");
    assert!(!bench.host.said().is_empty(), "the host knows of it");
    assert!(
        harness.query_by_label("E4").is_none(),
        "its bodies are shown"
    );
    assert!(harness.query_by_label("B3").is_some());
    let list = harness.get_by_label("Instrument");
    assert_eq!(list.value().as_deref(), Some("A bell of mine"));
    drop(harness);
    assert!(bench.controls.notices().all().is_empty());
}

#[test]
fn an_own_instrument_that_is_not_there_is_told_with_the_folder_as_its_cure() {
    let (bench, folder) = (Bench::new("oak-bowls"), Folder::new("missing"));
    let _library = folder.give(&bench);
    bench.set("instr", 1.0);
    let mut harness = bench.harness();
    harness.run_steps(2);
    assert!(
        harness
            .query_by_label_contains("no instrument of your own")
            .is_some()
    );
    assert!(harness.query_by_label("Dismiss").is_none(), "it stays true");
    harness.get_by_label("Show the folder").click();
    harness.step();
    let asked = |command: &egui::OutputCommand| match command {
        egui::OutputCommand::OpenUrl(open) => open.url == folder.0.display().to_string(),
        _ => false,
    };
    let commands = &harness.output().platform_output.commands;
    assert!(commands.iter().any(asked), "{commands:?}");
}

#[test]
fn a_notice_is_mended_by_its_button_or_dismissed() {
    let (bench, folder) = (Bench::new("chimes"), Folder::new("notice"));
    let library = folder.give(&bench);
    let notices = Arc::clone(bench.controls.notices());
    let post = |subject, cure| {
        notices.post(Notice {
            subject,
            text: "The song's own instrument is damaged".to_owned(),
            cure,
        });
    };
    let mut harness = bench.harness();
    post(Subject::Bank, Some(Cure::Load("bell".to_owned())));
    harness.run_steps(2);
    click(&mut harness, "Load it from your folder");
    assert!(library.serve(bench.controls.shelf()).unwrap().is_ok());
    harness.run_steps(3);
    assert_eq!(notices.all(), [], "it has come");
    assert_eq!(bench.text("instr"), "Your own");
    post(Subject::Instrument, Some(Cure::Stay));
    harness.run_steps(2);
    click(&mut harness, "Keep what plays");
    assert_eq!(notices.all(), []);
    post(Subject::Song, None);
    harness.run_steps(2);
    click(&mut harness, "Dismiss");
    assert_eq!(notices.all(), []);
}
