//! The editor in a real window: `tests/window.sh` gives it a screen.

#![cfg(target_os = "linux")]
#![expect(clippy::unwrap_used, reason = "tests fail by panicking")]

mod client;
mod doors;
mod drag;
mod host;
mod screen;

use host::Host;
use screen::Screen;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// How often a window is closed and opened again, and after how many times it has come to rest.
const TIMES: u16 = 100;
const RESTING: u16 = 20;

/// The box with the instrument's name, and the first line under "Your own" in its list.
const LIST: [i16; 2] = [240, 22];
const FIRST_OWN: [i16; 2] = [200, 472];

/// The body of C4 in a new window, in points from its left top.
const C4: [i16; 2] = [440, 125];

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
    let heard = |host: &mut Host| host.peak() > 1e-3;
    let is_heard = soon(&mut host, heard);
    screen
        .shoot()
        .save(&Path::new(env!("CARGO_TARGET_TMPDIR")).join("clicked.png"));
    assert!(is_heard, "the click is heard");
    let ringing = screen.shoot();
    assert_ne!(still, ringing, "and seen");
    ringing.save(&Path::new(env!("CARGO_TARGET_TMPDIR")).join("window.png"));
    let played = host.blocks();
    let since = Instant::now();
    let mut before = held();
    for time in 0..TIMES {
        host.resize([700 + 3 * time, 420 + 2 * time]);
        host.pump(Duration::from_millis(60));
        host.close();
        host.pump(Duration::from_millis(5));
        host.open(&screen);
        if time == RESTING {
            before = held();
        }
        if time % 10 == 0 {
            host.pump(Duration::from_millis(300));
            assert!(screen.shoot().colours() > 100, "opening {time}");
        }
    }
    let blocks = host.blocks() - played;
    let took_ms = since.elapsed().as_millis() as u64;
    assert!(blocks * 40 > took_ms, "{blocks} blocks in {took_ms} ms");
    host.pump(Duration::from_millis(500));
    host.close();
    host.pump(Duration::from_millis(500));
    let after = held();
    // The last window that was counted was open.
    assert!(
        after
            .iter()
            .zip(before)
            .all(|(after, before)| *after <= before),
        "threads and files: {before:?} after {RESTING} windows, {after:?} after {TIMES}"
    );
}

/// How many threads and open files there are.
fn held() -> [usize; 2] {
    ["/proc/self/task", "/proc/self/fd"].map(|list| std::fs::read_dir(list).unwrap().count())
}

#[test]
#[ignore = "needs a screen: tests/window.sh gives it one"]
fn a_window_on_a_fine_screen_is_as_large_as_the_host_says() {
    let screen = Screen::open();
    let mut host = Host::new();
    for opening in 0..3 {
        // Some say it once.
        let size = host.open_scaled(&screen, (opening < 2).then_some(2.0));
        assert_eq!(size, [2000, 1360], "opening {opening}");
        let corner = |_: &mut Host| {
            let shot = screen.shoot();
            shot.is_drawn([1990, 1350]) && shot.colours() > 100
        };
        assert!(soon(&mut host, corner), "opening {opening} fills it");
        let name = format!("fine-{opening}.png");
        screen
            .shoot()
            .save(&Path::new(env!("CARGO_TARGET_TMPDIR")).join(name));
        host.close();
        host.pump(Duration::from_millis(300));
    }
}

#[test]
#[ignore = "needs a screen: tests/window.sh gives it one"]
fn a_window_on_a_fine_screen_that_says_so_is_as_large_too() {
    let screen = Screen::open();
    screen.set_dpi(192);
    let mut host = Host::new();
    for opening in 0..2 {
        assert_eq!(host.open(&screen), [2000, 1360], "opening {opening}");
        let corner = |_: &mut Host| screen.shoot().is_drawn([1990, 1350]);
        assert!(soon(&mut host, corner), "opening {opening} fills it");
        host.close();
        host.pump(Duration::from_millis(300));
    }
    screen.set_dpi(96);
}

#[test]
#[ignore = "needs a screen without OpenGL: tests/window.sh gives it one"]
fn without_opengl_the_window_is_drawn_and_played_all_the_same() {
    let screen = Screen::open();
    let mut host = Host::new();
    for opening in 0..3 {
        assert_eq!(host.open(&screen), [1000, 680]);
        let drawn = |_: &mut Host| screen.shoot().colours() > 100;
        assert!(soon(&mut host, drawn), "opening {opening}");
        screen.click(C4);
        let heard = |host: &mut Host| host.peak() > 1e-3;
        assert!(soon(&mut host, heard), "the click is heard");
        host.resize([800, 500]);
        host.pump(Duration::from_millis(300));
        screen
            .shoot()
            .save(&Path::new(env!("CARGO_TARGET_TMPDIR")).join("plain.png"));
        host.close();
        host.pump(Duration::from_millis(100));
    }
}

#[test]
#[ignore = "needs a screen: tests/window.sh gives it one"]
fn a_window_in_which_nothing_moves_takes_less_than_a_tenth_of_a_core() {
    let screen = Screen::open();
    let mut host = Host::new();
    let spent = |host: &mut Host| {
        let (before_s, since) = (cpu_s(), Instant::now());
        host.pump(Duration::from_secs(3));
        (cpu_s() - before_s) / since.elapsed().as_secs_f64()
    };
    host.pump(Duration::from_secs(1));
    let without = spent(&mut host);
    host.open(&screen);
    host.pump(Duration::from_secs(2));
    assert!(screen.shoot().colours() > 100, "it is drawn");
    let with = spent(&mut host);
    host.close();
    println!(
        "{:.1} % of a core without a window, {:.1} % with",
        1e2 * without,
        1e2 * with
    );
    assert!(
        with - without < 0.1,
        "{without} without a window, {with} with"
    );
}

/// Time in s that this process has been given so far, on all cores.
fn cpu_s() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap();
    // Behind the name in brackets; user and system time, in hundredths of a second.
    let fields = stat.rsplit(')').next().unwrap().split_whitespace();
    fields
        .skip(11)
        .take(2)
        .map(|ticks| ticks.parse::<f64>().unwrap() / 100.0)
        .sum()
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
