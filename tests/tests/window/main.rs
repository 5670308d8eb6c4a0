//! The editor in a real window: `tests/window.sh` gives it a screen.

#![cfg(target_os = "linux")]
#![expect(clippy::unwrap_used, reason = "tests fail by panicking")]

mod host;
mod screen;

use host::Host;
use screen::Screen;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// How often a window is closed and opened again.
const TIMES: u16 = 100;

/// The box with the instrument's name, and the first line under "Your own" in its list.
const LIST: [i16; 2] = [240, 22];
const FIRST_OWN: [i16; 2] = [200, 264];

/// The body of C4 in a new window, in points from its left top.
const C4: [i16; 2] = [440, 180];

#[test]
#[ignore = "needs a screen: tests/window.sh gives it one"]
fn a_window_opens_is_played_resized_and_opened_again_while_it_sounds() {
    let screen = Screen::open();
    let mut host = Host::new();
    let size = host.open(&screen);
    host.pump(Duration::from_secs(2));
    assert_eq!(size, [1000, 680]);
    assert_eq!(host.peak(), 0.0, "nobody has played");
    let still = screen.shoot();
    assert!(still.colours() > 100, "{} colours", still.colours());
    screen.click(C4);
    host.pump(Duration::from_millis(400));
    assert!(host.peak() > 1e-3, "the click is heard");
    let ringing = screen.shoot();
    assert_ne!(still, ringing, "and seen");
    ringing.save(&Path::new(env!("CARGO_TARGET_TMPDIR")).join("window.png"));
    for time in 0..TIMES {
        host.resize([700 + 3 * time, 420 + 2 * time]);
        host.pump(Duration::from_millis(60));
        host.close();
        host.pump(Duration::from_millis(5));
        host.open(&screen);
        if time % 10 == 0 {
            host.pump(Duration::from_millis(300));
            assert!(screen.shoot().colours() > 100, "opening {time}");
        }
    }
    host.pump(Duration::from_millis(500));
    host.close();
    assert!(
        host.blocks() > 500,
        "sound went on: {} blocks",
        host.blocks()
    );
}

#[test]
#[ignore = "needs a screen and a folder: tests/window.sh gives it both"]
fn a_bank_put_into_the_folder_is_chosen_by_two_clicks_and_goes_into_the_song() {
    let folder = PathBuf::from(std::env::var_os("XDG_DATA_HOME").unwrap());
    let banks = folder.join("idiophone").join("Banks");
    std::fs::create_dir_all(&banks).unwrap();
    let screen = Screen::open();
    let mut host = Host::new();
    host.open(&screen);
    let drawn = |_: &mut Host| screen.shoot().colours() > 100;
    assert!(soon(&mut host, drawn), "there is a window");
    let has = |host: &mut Host, what: &str| String::from_utf8_lossy(&host.state()).contains(what);
    assert!(!has(&mut host, "A bell of mine"));
    let mut bell = idiophone::factory::bank(0).clone();
    "bell".clone_into(&mut bell.name);
    "A bell of mine".clone_into(&mut bell.title);
    // While the window is open, which is to see it.
    bell.save(banks.join("bell.bank")).unwrap();
    host.pump(Duration::from_secs(4));
    screen.click(LIST);
    host.pump(Duration::from_secs(1));
    screen
        .shoot()
        .save(&Path::new(env!("CARGO_TARGET_TMPDIR")).join("list.png"));
    screen.click(FIRST_OWN);
    let kept = |host: &mut Host| has(host, "A bell of mine");
    assert!(soon(&mut host, kept), "the song has it");
    let plays = |host: &mut Host| has(host, r#""instrument":"{\"name\":\"own\""#);
    assert!(soon(&mut host, plays), "and plays it");
    host.close();
    // The window's thread ends after the window.
    host.pump(Duration::from_millis(500));
}

/// Whether something comes true within some seconds.
fn soon(host: &mut Host, is: impl Fn(&mut Host) -> bool) -> bool {
    (0..50).any(|_| {
        host.pump(Duration::from_millis(200));
        is(host)
    })
}
