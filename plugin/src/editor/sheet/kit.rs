//! The bodies of a sheet: one, or several on keys of their own.

use super::piece::Piece;
use crate::mesher::{Facts, guessed_size_m};
use modes::{FreeFineness, MeshOrder};
use std::sync::Arc;

/// Lowest and highest key that bodies are given of themselves.
const KEYS: [u8; 2] = [36, 96];
/// Bodies that have keys of their own from the lowest of those on.
pub(super) const MOST: usize = 128 - KEYS[0] as usize;

/// The bodies, and which of them is looked at.
#[derive(Clone, Debug, Default)]
pub(super) struct Kit {
    pub(super) pieces: Vec<Piece>,
    pub(super) at: usize,
    /// Whether somebody has set keys: then they stay.
    pub(super) set: bool,
    /// Name of several bodies together.
    pub(super) title: String,
}

impl Kit {
    /// A further body, on keys of its own.
    pub(super) fn add(&mut self, facts: Arc<Facts>) {
        if self.pieces.is_empty() {
            self.title = format!("{} kit", facts.stem());
        }
        let keys = self.free();
        self.pieces.push(Piece::of(facts, keys));
        self.share();
    }

    /// Another body like the one that is looked at.
    pub(super) fn double(&mut self) {
        if let Some(piece) = self.pieces.get(self.at) {
            let keys = self.free();
            let double = Piece {
                keys,
                ..piece.clone()
            };
            self.pieces.push(double);
            self.share();
        }
    }

    /// A body of each object of the one that is looked at, each at its own pitch on a key of its own: a kit
    /// of drums.
    pub(super) fn split(&mut self) {
        let Some(whole) = self.pieces.get(self.at) else {
            return;
        };
        let names = whole.facts.names();
        let each = names.into_iter().zip(KEYS[0]..=127).map(|(name, key)| {
            let mut piece = whole.clone();
            piece.choose(vec![name.to_owned()]);
            piece.stand_alone(key);
            piece
        });
        self.pieces = each.collect();
        (self.at, self.set) = (0, true);
    }

    /// Makes a kit of files that came together, as [`Kit::split`] does of objects: each body at its own pitch
    /// on a key of its own, and as large beside the others as in their files.
    pub(super) fn gather(&mut self) {
        if self.pieces.len() < 2 {
            return;
        }
        let longest = self.pieces.iter().map(|piece| piece.facts.longest(&[]));
        let longest = longest.fold(f64::MIN_POSITIVE, f64::max);
        let unit_mm = 1e3 * guessed_size_m(longest) / longest;
        for (piece, key) in self.pieces.iter_mut().zip(KEYS[0]..=127) {
            piece.measure(unit_mm);
            piece.stand_alone(key);
        }
        (self.at, self.set) = (0, true);
    }

    /// Takes a body away; the last one stays.
    pub(super) fn remove(&mut self, number: usize) {
        if self.pieces.len() > 1 && number < self.pieces.len() {
            self.pieces.remove(number);
            self.at = self.at.min(self.pieces.len() - 1);
            self.share();
        }
    }

    /// The key above all that are taken, or the lowest that is free.
    fn free(&self) -> [u8; 2] {
        let taken = |key: &u8| {
            let within = |piece: &Piece| (piece.keys[0]..=piece.keys[1]).contains(key);
            self.pieces.iter().any(within)
        };
        let above = self.pieces.iter().map(|piece| piece.keys[1]).max();
        let above = above.map_or(KEYS[0], |key| key.saturating_add(1));
        let key = (above..128).chain(0..128).find(|key| !taken(key));
        [key.unwrap_or(KEYS[0]); 2]
    }

    /// The usual keys in equal parts, unless somebody has set keys.
    fn share(&mut self) {
        if self.set {
            return;
        }
        let [low, high] = KEYS.map(usize::from);
        let (all, count) = (high - low + 1, self.pieces.len());
        for (i, piece) in self.pieces.iter_mut().enumerate() {
            let first = |i: usize| low + all * i / count;
            piece.keys = [first(i), first(i + 1) - 1].map(|key| key.min(127) as u8);
        }
        self.at = count.saturating_sub(1);
    }

    /// The order of all; none if a file's name is not in Unicode.
    pub(super) fn order(&self) -> Option<MeshOrder> {
        let fineness = FreeFineness::default();
        let several = self.pieces.len() > 1;
        let named = several && !self.title.trim().is_empty();
        Some(MeshOrder {
            title: named.then(|| self.title.trim().to_owned()),
            pieces: self
                .pieces
                .iter()
                .map(Piece::order)
                .collect::<Option<_>>()?,
            nodes: fineness.nodes as u32,
            most_modes: fineness.most_modes as u32,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesher::Part;

    fn facts(names: &[&str]) -> Arc<Facts> {
        let part = |(name, size): (&&str, f64)| Part {
            name: (*name).to_owned(),
            low: [0.0; 3],
            high: [size, 0.5 * size, 1.0],
        };
        let sizes = (1..).map(|i: u8| 100.0 * f64::from(i));
        Arc::new(Facts {
            path: "shapes/set.obj".into(),
            objects: names.iter().zip(sizes).map(part).collect(),
            triangles: 12,
            up: None,
        })
    }

    fn keys(kit: &Kit) -> Vec<[u8; 2]> {
        kit.pieces.iter().map(|piece| piece.keys).collect()
    }

    #[test]
    fn bodies_share_the_keys_until_somebody_sets_them() {
        let mut kit = Kit::default();
        kit.add(facts(&["a"]));
        assert_eq!(keys(&kit), [[36, 96]]);
        kit.add(facts(&["b"]));
        kit.add(facts(&["c"]));
        assert_eq!(keys(&kit), [[36, 55], [56, 75], [76, 96]]);
        kit.remove(1);
        assert_eq!(keys(&kit), [[36, 65], [66, 96]]);
        kit.set = true;
        kit.pieces[1].keys = [70, 72];
        kit.double();
        assert_eq!(keys(&kit), [[36, 65], [70, 72], [73, 73]]);
        kit.pieces[1].keys = [70, 127];
        kit.double();
        assert_eq!(kit.pieces[3].keys, [0, 0], "the lowest free one");
        for _ in 0..9 {
            kit.remove(0);
        }
        assert_eq!(kit.pieces.len(), 1, "the last one stays");
    }

    #[test]
    fn objects_become_drums_as_large_as_in_the_file() {
        let mut kit = Kit::default();
        kit.add(facts(&["kick", "snare", "kick", ""]));
        kit.pieces[0].size_mm = 800.0;
        kit.split();
        assert_eq!(keys(&kit), [[36, 36], [37, 37]]);
        let sizes: Vec<f64> = kit.pieces.iter().map(|piece| piece.size_mm).collect();
        assert_eq!(sizes, [600.0, 400.0], "of 800 for the four");
        let order = kit.order().unwrap();
        assert_eq!(order.title.as_deref(), Some("set kit"));
        assert_eq!(order.pieces[1].objects, ["snare"]);
        assert_eq!(order.pieces[1].by, "nothing");
        assert!(order.recipe("the kit").is_ok());
    }

    #[test]
    fn files_that_come_together_become_drums_as_large_as_in_them() {
        let mut kit = Kit::default();
        // 200 units long and 15, which alone would be centimetres.
        kit.add(facts(&["kick", "snare"]));
        let mut bell = (*facts(&["bell"])).clone();
        bell.objects[0].high = [15.0, 3.0, 1.0];
        kit.add(Arc::new(bell));
        let alone = kit.clone();
        assert_eq!(alone.pieces[1].size_mm, 150.0);
        kit.gather();
        assert_eq!(keys(&kit), [[36, 36], [37, 37]]);
        let sizes: Vec<f64> = kit.pieces.iter().map(|piece| piece.size_mm).collect();
        assert_eq!(sizes, [200.0, 15.0], "both in millimetres");
        let order = kit.order().unwrap();
        assert!(order.pieces.iter().all(|piece| piece.by == "nothing"));
        assert!(order.recipe("the kit").is_ok());
        kit.remove(0);
        kit.gather();
        assert_eq!(keys(&kit), [[37, 37]], "one is no kit");
    }

    #[test]
    fn a_body_alone_is_called_as_its_file() {
        let mut kit = Kit::default();
        kit.add(facts(&["a"]));
        let order = kit.order().unwrap();
        assert_eq!((order.title.as_ref(), order.name().as_str()), (None, "set"));
    }
}
