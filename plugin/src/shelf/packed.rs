//! A bank as a song keeps it: JSON around its file, sorted, deflated, in base 64.

use super::OwnError;
use super::own::MOST_BYTES;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use modes::fnv1a;
use serde::{Deserialize, Serialize};

/// The layout written, and the newest read.
const LAYOUT: u32 = 1;
/// Of deflate: higher levels take several times as long and save a few per cent of what floats are.
const LEVEL: u8 = 4;
/// More than what stands around the file takes for a name of usual length, in bytes.
const FRAME: usize = 512;
/// Name of a bank of which not even the name can be read.
const UNKNOWN: &str = "an instrument";

/// What stands in the song.
#[derive(Serialize, Deserialize)]
struct Packed {
    layout: u32,
    #[serde(default)]
    name: String,
    #[serde(default)]
    title: String,
    /// Of the bank's file, before it was packed.
    #[serde(default)]
    bytes: usize,
    /// FNV-1a of the bank's file, 64 bits, in base 16.
    #[serde(default)]
    hash: String,
    /// The file, [`sorted`], deflated, in base 64.
    #[serde(default)]
    deflated: String,
}

/// A bank's file packed for a song.
///
/// # Errors
///
/// [`OwnError::Large`].
pub(super) fn pack(name: &str, title: &str, file: &[u8]) -> Result<String, OwnError> {
    let deflated = miniz_oxide::deflate::compress_to_vec_zlib(&sorted(file), LEVEL);
    let packed = Packed {
        layout: LAYOUT,
        name: name.to_owned(),
        title: title.to_owned(),
        bytes: file.len(),
        hash: hash(file),
        deflated: STANDARD.encode(deflated),
    };
    let large = |bytes: usize| OwnError::Large {
        title: title.to_owned(),
        found_mib: bytes.div_ceil(1 << 20),
        most_mib: MOST_BYTES >> 20,
    };
    // A text that grew as it is written would have twice its size, and is kept for long.
    let mut text = Vec::with_capacity(packed.deflated.len() + FRAME);
    // Strings and numbers always make JSON, which is UTF-8.
    serde_json::to_writer(&mut text, &packed).map_err(|_| large(file.len()))?;
    drop(packed);
    text.shrink_to_fit();
    let text = String::from_utf8(text).map_err(|_| large(file.len()))?;
    if text.len() > MOST_BYTES {
        return Err(large(text.len()));
    }
    Ok(text)
}

/// What a song calls a bank, and its file.
///
/// Takes no more memory than [`super::own::MOST_FILE`], whatever the text says.
///
/// # Errors
///
/// If the text is damaged or of a later layout.
pub(super) fn unpack(text: &str, most: usize) -> Result<(String, Vec<u8>), OwnError> {
    let damaged = |title: &str, what: &str| OwnError::Damaged {
        title: title.to_owned(),
        what: what.to_owned(),
    };
    let packed: Packed = serde_json::from_str(text).map_err(|_| damaged(UNKNOWN, "no JSON"))?;
    let title = [&packed.title, &packed.name]
        .into_iter()
        .find(|name| !name.is_empty())
        .map_or_else(|| UNKNOWN.to_owned(), |name| line(name));
    if packed.layout > LAYOUT {
        return Err(OwnError::Newer {
            title,
            found: packed.layout,
            newest: LAYOUT,
        });
    }
    let deflated = STANDARD
        .decode(&packed.deflated)
        .map_err(|_| damaged(&title, "no base 64"))?;
    let limit = most.min(packed.bytes);
    let inflated = miniz_oxide::inflate::decompress_to_vec_zlib_with_limit(&deflated, limit)
        .map_err(|_| damaged(&title, "it does not inflate to its length"))?;
    let file = unsorted(&inflated);
    if file.len() != packed.bytes || hash(&file) != packed.hash {
        return Err(damaged(&title, "its hash is another"));
    }
    Ok((title, file))
}

/// Bytes of a single float, which most of a bank consists of.
const FLOAT: usize = size_of::<f32>();

/// All first bytes of floats, then all second ones and so on: those with the exponents, which are alike,
/// deflate better for themselves.
fn sorted(file: &[u8]) -> Vec<u8> {
    let mut sorted = Vec::with_capacity(file.len());
    for plane in 0..FLOAT {
        sorted.extend(file.iter().skip(plane).step_by(FLOAT));
    }
    sorted
}

/// What [`sorted`] was given.
fn unsorted(sorted: &[u8]) -> Vec<u8> {
    let mut file = vec![0; sorted.len()];
    let places = (0..FLOAT).flat_map(|of| (of..sorted.len()).step_by(FLOAT));
    for (place, byte) in places.zip(sorted) {
        file[place] = *byte;
    }
    file
}

/// FNV-1a in base 16.
fn hash(file: &[u8]) -> String {
    format!("{:016x}", fnv1a(file))
}

/// A name of anyone's making, fit for one line.
fn line(name: &str) -> String {
    name.chars()
        .filter(|letter| !letter.is_control())
        .take(60)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_packed_unpacks() {
        let file: Vec<u8> = (0..100_000_u32).map(|i| (i >> 4) as u8).collect();
        let text = pack("bell", "Bell", &file).unwrap();
        assert!(text.len() < file.len() / 2, "{}", text.len());
        assert_eq!(text.capacity(), text.len(), "it is kept for long");
        let (title, back) = unpack(&text, file.len()).unwrap();
        assert!(title == "Bell" && back == file);
        let error = unpack(&text, file.len() - 1).unwrap_err().to_string();
        assert!(error.starts_with("\"Bell\" is damaged"), "{error}");
    }

    #[test]
    fn what_is_sorted_comes_back_at_any_length() {
        for len in 0..20 {
            let file: Vec<u8> = (0..len).collect();
            assert_eq!(unsorted(&sorted(&file)), file);
        }
        assert_eq!(sorted(&[0, 1, 2, 3, 4, 5]), [0, 4, 1, 5, 2, 3]);
    }

    #[test]
    fn what_says_more_than_it_holds_takes_no_room() {
        let zeros = vec![0; 64 << 20];
        let text = pack("bomb", "Bomb", &zeros).unwrap();
        assert!(text.len() < 200_000);
        assert!(unpack(&text, 1 << 20).is_err());
    }

    #[test]
    fn every_kind_of_damage_is_told_by_name() {
        let text = pack("bell", "Bell \u{7}of\nmine", b"a file").unwrap();
        let said = |text: &str| unpack(text, 1 << 20).unwrap_err().to_string();
        for (from, to, expected) in [
            ("\"layout\":1", "\"layout\":7", "layout 7"),
            ("\"bytes\":6", "\"bytes\":7", "damaged"),
            ("\"bytes\":6", "\"bytes\":-7", "no JSON"),
            ("\"hash\":\"", "\"hash\":\"0", "hash"),
            ("\"deflated\":\"", "\"deflated\":\"*", "base 64"),
        ] {
            let broken = text.replace(from, to);
            assert_ne!(broken, text);
            let error = said(&broken);
            assert!(error.contains(expected), "{error}");
            assert!(
                error.contains("Bell of") == (expected != "no JSON"),
                "{error}"
            );
            assert!(!error.contains('\n'), "{error}");
        }
        for len in 0..text.len() {
            if text.is_char_boundary(len) {
                said(&text[..len]);
            }
        }
    }
}
