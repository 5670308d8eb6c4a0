//! The editor in a real window: `tests/window.sh` gives it a screen.

#![cfg(target_os = "linux")]
#![expect(clippy::unwrap_used, reason = "tests fail by panicking")]

mod host;
mod screen;

use host::Host;
use screen::Screen;
use std::path::Path;
use std::time::Duration;

/// How often a window is closed and opened again.
const TIMES: u16 = 100;

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
