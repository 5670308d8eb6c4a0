//! Texts that travel in songs: banks, scales and keyboard maps.

use super::bank::small;
use super::case::cases;
use super::mutate;
use idiophone::shelf::Own;
use modes::tuning::{KeyboardMap, Scale, Tuning};

#[test]
fn no_bank_in_a_song_panics() {
    let own = Own::new(small()).unwrap();
    cases("bank in a song", |noise| {
        let text = mutate::text(noise, own.text());
        match Own::read(&text) {
            Ok(read) => {
                assert_eq!(read.text(), text);
                true
            }
            Err(error) => {
                assert!(!error.to_string().contains('\n'), "{error}");
                false
            }
        }
    });
}

#[test]
fn no_tuning_panics() {
    let scale = "! a.scl\nA scale\n 7\n!\n 9/8\n 386.3 cents\n 4/3\n 701.955\n 5/3\n 15/8\n 2/1\n";
    let map = "7\n0\n127\n60\n69\n440.0\n7\n0\n1\nx\n3\n4\n5\n6\n";
    cases("tuning", |noise| {
        let (scale, map) = (mutate::text(noise, scale), mutate::text(noise, map));
        let scale = Scale::parse(scale.as_bytes());
        let map = KeyboardMap::parse(map.as_bytes());
        let (Ok(scale), Ok(map)) = (scale, map) else {
            return false;
        };
        let tuning = Tuning::new(&scale, &map);
        for key in 0..128 {
            assert!(tuning.hz(key).is_none_or(|hz| hz.is_finite() && hz > 0.0));
        }
        true
    });
}
