//! What kind of body it is, and what it is called.

use super::flat::is_flat;
use modes::Family;

/// What kind of body it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Lies, and is struck from above along its length.
    Bar,
    /// Hangs, and is struck from the side along its length.
    Tube,
    /// Stands, and is struck from the rim to the middle of its base.
    Bowl,
    /// Of any shape, and struck anywhere.
    Other,
}

impl Kind {
    /// That of a bank's body: one that is drawn is of any shape; of others a bowl's line turns, a tube's
    /// runs upwards, a bar's along.
    #[must_use]
    pub fn of(body: &modes::Body) -> Self {
        if body.surface.is_some() {
            return Self::Other;
        }
        let (Some(first), Some(last)) = (body.line.points_m.first(), body.line.points_m.last())
        else {
            return Self::Bar;
        };
        let dot = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let normals = &body.line.normals;
        let turns = normals
            .first()
            .is_some_and(|a| normals.iter().any(|b| dot(a, b) < 0.9));
        if turns {
            return Self::Bowl;
        }
        let [x, _, z] = [0, 1, 2].map(|k| (last[k] - first[k]).abs());
        if z > x { Self::Tube } else { Self::Bar }
    }

    /// Its name for people.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Bar => "bar",
            Self::Tube => "tube",
            Self::Bowl => "bowl",
            Self::Other => "body",
        }
    }

    /// Where 0 and 1 of its line are.
    pub(super) fn ends(self) -> [&'static str; 2] {
        match self {
            Self::Bar => ["the middle", "an end"],
            Self::Tube => ["the upper end", "the lower end"],
            Self::Bowl => ["the rim", "the middle"],
            Self::Other => ["one end", "the other end"],
        }
    }
}

/// What a body is called, and along what it is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Noun {
    pub(super) name: &'static str,
    /// What follows its greatest measure.
    pub(super) measured: &'static str,
}

impl Noun {
    const fn long(name: &'static str) -> Self {
        Self {
            name,
            measured: "long",
        }
    }

    const fn across(name: &'static str) -> Self {
        Self {
            name,
            measured: "across",
        }
    }

    /// That of a bank's body.
    pub(super) fn of(body: &modes::Body) -> Self {
        let kind = Kind::of(body);
        let family = body.modes.first().map(|mode| mode.label.family);
        match (kind, family) {
            (Kind::Bar | Kind::Tube, _) => Self::long(kind.name()),
            (Kind::Other, Some(Family::Plate)) => Self::across("plate"),
            (Kind::Other, Some(Family::Bending)) if is_thread(body) => Self::long("string"),
            (Kind::Other, Some(Family::Bending)) if is_flat(body) => Self::long("bar"),
            (Kind::Other, _) if is_flat(body) => Self::across("membrane"),
            (Kind::Bowl | Kind::Other, _) => Self::across(kind.name()),
        }
    }
}

/// Whether a flat body is a hundred times as long as wide.
pub(super) fn is_thread(body: &modes::Body) -> bool {
    body.surface.as_ref().is_some_and(|surface| {
        let widest = surface
            .points_m
            .iter()
            .fold(0.0, |most: f32, p| most.max(p[1].abs()));
        surface.length_m > 200.0 * f64::from(widest)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::factory;

    #[test]
    fn kinds_are_those_of_the_recipes() {
        for (name, kind) in [
            ("chimes", Kind::Tube),
            ("tubular-bells", Kind::Tube),
            ("vibraphone", Kind::Bar),
            ("singing-bowls", Kind::Bowl),
            ("oak-bowls", Kind::Bowl),
        ] {
            let index = factory::BANKS.iter().position(|(other, _)| *other == name);
            let bank = factory::bank(index.unwrap());
            assert!(
                bank.bodies.iter().all(|body| Kind::of(body) == kind),
                "{name}"
            );
        }
    }

    #[test]
    fn bodies_are_called_by_their_names() {
        let name = |bank: &str| {
            let index = factory::BANKS.iter().position(|(other, _)| *other == bank);
            Noun::of(&factory::bank(index.unwrap()).bodies[0]).name
        };
        let all = ["strings", "tines", "l-drums", "round-plates", "chimes"];
        let names = ["string", "bar", "membrane", "plate", "tube"];
        assert_eq!(all.map(name), names);
    }
}
