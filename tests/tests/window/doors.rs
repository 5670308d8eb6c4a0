//! What comes into the window from other programs and goes out to them: files, texts, and the pointer's shape.

use crate::client::Client;
use crate::drag::Drag;
use crate::host::Host;
use crate::screen::Screen;
use crate::{C4, soon};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A place on which nothing is, in points from the window's left top.
const NOWHERE: [i16; 2] = [750, 640];
/// The value below the knob of the mallet's mass.
const MASS: [i16; 2] = [738, 536];

/// A place in the field that a click there opens, beside the text.
const FIELD: [u16; 2] = [770, 536];

/// Keys, by Linux's codes plus 8.
const CONTROL: u8 = 37;
const ENTER: u8 = 36;
const C: u8 = 54;
const V: u8 = 55;

fn picture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

fn open(screen: &Screen) -> Host {
    let mut host = Host::new();
    host.open(screen);
    let drawn = |_: &mut Host| screen.shoot().colours() > 100;
    assert!(soon(&mut host, drawn), "there is a window");
    host.pump(Duration::from_secs(1));
    host
}

fn close(mut host: Host) {
    host.close();
    // The window's thread ends after the window.
    host.pump(Duration::from_millis(500));
}

/// Drags a bank and a mesh over the window, and drops them.
fn bring(veil: &str, sheet: &str) {
    let folder = tempfile::tempdir().unwrap();
    let mut bank = idiophone::factory::bank(0).clone();
    bank.bodies.truncate(3);
    "zither".clone_into(&mut bank.name);
    "A zither brought by hand".clone_into(&mut bank.title);
    let bank_file = folder.path().join("zither.bank");
    bank.save(&bank_file).unwrap();
    let screen = Screen::open();
    let mut host = open(&screen);
    let still = screen.shoot();

    let drag = Drag::begin(screen.window(), &bank_file);
    assert!(drag.hover([500, 300]), "it would be taken");
    let veiled = |_: &mut Host| !screen.shoot().is_as_at(&still, [500, 30]);
    assert!(soon(&mut host, veiled), "the window says so");
    host.pump(Duration::from_millis(300));
    screen.shoot().save(&picture(veil));
    drag.leave();
    let bare = |_: &mut Host| screen.shoot().is_as_at(&still, [500, 30]);
    assert!(soon(&mut host, bare), "and no longer when it leaves");

    let drag = Drag::begin(screen.window(), &bank_file);
    assert!(drag.hover([500, 300]) && drag.hover([510, 310]));
    assert!(drag.drop_here());
    let kept = |host: &mut Host| {
        let state = host.state();
        let text = String::from_utf8_lossy(&state);
        text.contains("A zither brought by hand") && text.contains(r#"{\"name\":\"own\""#)
    };
    assert!(soon(&mut host, kept), "the song has it and plays it");

    let mesh_file = folder.path().join("star.obj");
    let star = modes::solid::write_obj(&modes::solid::gallery::star(5, 100.0, 20.0));
    std::fs::write(&mesh_file, star).unwrap();
    host.pump(Duration::from_secs(1));
    let before = screen.shoot();
    let drag = Drag::begin(screen.window(), &mesh_file);
    assert!(drag.hover([500, 300]) && drag.drop_here());
    let opened = |_: &mut Host| {
        let shot = screen.shoot();
        shot.is_as_at(&before, [500, 30]) && !shot.is_as_at(&before, [500, 340])
    };
    assert!(soon(&mut host, opened), "the sheet is there");
    host.pump(Duration::from_secs(1));
    screen.shoot().save(&picture(sheet));
    close(host);
}

/// Copies a value out of the window and pastes another into it.
fn copy_and_paste() {
    let screen = Screen::open();
    let mut host = open(&screen);
    let copy = |host: &mut Host| {
        let closed = screen.shoot();
        screen.click(MASS);
        let is_open = |_: &mut Host| !screen.shoot().is_as_at(&closed, FIELD);
        assert!(soon(host, is_open), "there is a field to type in");
        host.pump(Duration::from_millis(500));
        screen.press(&[CONTROL, C]);
        let is_copied = |_: &mut Host| !Client::new().clipboard().is_empty();
        assert!(soon(host, is_copied), "something is copied");
        Client::new().clipboard()
    };
    assert_eq!(copy(&mut host), "30.0 g");
    let before = host.state();
    let lender = Client::new();
    lender.own("CLIPBOARD");
    // It is gone from the clipboard when it has been pasted.
    let lender = std::thread::spawn(move || lender.lend("12 g"));
    screen.press(&[CONTROL, V]);
    lender.join().unwrap();
    screen.press(&[ENTER]);
    let is_set = |host: &mut Host| host.state() != before;
    assert!(soon(&mut host, is_set), "what is pasted counts");
    assert_eq!(copy(&mut host), "12.0 g");
    close(host);
}

/// Moves the pointer onto a body, where it is a hand.
fn point() {
    let screen = Screen::open();
    screen.point(NOWHERE);
    let mut host = open(&screen);
    let before = screen.pointer();
    screen.point(C4);
    let hand = |_: &mut Host| screen.pointer() != before;
    assert!(soon(&mut host, hand), "it has another shape there");
    screen.point(NOWHERE);
    let arrow = |_: &mut Host| screen.pointer() == before;
    assert!(soon(&mut host, arrow), "and the old one back");
    close(host);
}

#[test]
#[ignore = "needs a screen: tests/window.sh gives it one"]
fn a_window_takes_files_that_are_dropped() {
    bring("veil.png", "sheet.png");
}

#[test]
#[ignore = "needs a screen: tests/window.sh gives it one"]
fn a_window_copies_and_pastes() {
    copy_and_paste();
}

#[test]
#[ignore = "needs a screen: tests/window.sh gives it one"]
fn a_window_gives_the_pointer_its_shape() {
    point();
}

#[test]
#[ignore = "needs a screen without OpenGL: tests/window.sh gives it one"]
fn without_opengl_a_window_takes_files_copies_pastes_and_points_too() {
    bring("veil-plain.png", "sheet-plain.png");
    copy_and_paste();
    point();
}
