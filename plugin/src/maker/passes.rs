//! From coarse to fine: the passes over the bodies of one drawing.

use super::order::{Order, Wanted};
use super::{Solved, recipe_of};
use crate::engine::Engine;
use crate::shelf::{Own, Shelf, Shelved};
use modes::bar::TunedBar;
use modes::factory::{Builder, Finished, coarse};
use modes::{Bank, Body, Recipe};
use rayon::prelude::*;
use std::sync::Arc;

/// What the maker remembers from one drawing to the next.
pub(super) struct Passes {
    shelf: Arc<Shelf>,
    solved: Arc<Solved>,
    rate_hz: f64,
    present: Option<Present>,
}

/// An instrument whose drawing is changed.
struct Present {
    number: usize,
    base: Shelved,
    /// None for what is not drawn by dimensions.
    recipe: Option<Recipe>,
    /// The bodies as they were last delivered.
    bank: Bank,
    /// What the bars were tuned to last, key by key.
    tuned: Vec<Option<TunedBar>>,
}

impl Present {
    fn new(shelf: &Shelf, number: usize) -> Self {
        let base = shelf.bank(number);
        Self {
            number,
            recipe: recipe_of(&base),
            bank: (*base).clone(),
            tuned: vec![None; 128],
            base,
        }
    }

    /// Puts a body in the place of the one of its key.
    fn put(&mut self, body: Body) {
        let place = self.bank.bodies.iter_mut().find(|old| old.key == body.key);
        if let Some(old) = place {
            *old = body;
        }
    }
}

impl Passes {
    pub(super) fn new(shelf: Arc<Shelf>, solved: Arc<Solved>, rate_hz: f64) -> Self {
        Self {
            shelf,
            solved,
            rate_hz,
            present: None,
        }
    }

    /// Delivers what is wanted, better and better, until something else is.
    pub(super) fn follow(&mut self, wanted: &Wanted, order: &Order) {
        let fresh = self
            .present
            .as_ref()
            .is_none_or(|present| present.number != wanted.number);
        if fresh {
            self.present = Some(Present::new(&self.shelf, wanted.number));
        }
        let Some(present) = &mut self.present else {
            return;
        };
        let Some(Ok(recipe)) = present.recipe.as_ref().map(|own| wanted.drawing.apply(own)) else {
            return;
        };
        if recipe.text == present.base.provenance.recipe {
            // A fresh instrument is as its recipe draws it.
            if !fresh {
                present.bank = (*present.base).clone();
                deliver(present, self.rate_hz, order);
            }
            return;
        }
        if let Some(own) = self.solved.of(&recipe.text) {
            present.bank = own.bank().clone();
            deliver(present, self.rate_hz, order);
            return;
        }
        if !sketch(present, &recipe, self.rate_hz, order, wanted.turn) {
            return;
        }
        let Some(bank) = whole(present, &recipe, order, wanted.turn) else {
            return;
        };
        present.bank = bank;
        deliver(present, self.rate_hz, order);
        // One too large for a song is solved again there.
        if let Ok(own) = Own::new(present.bank.clone()) {
            self.solved.put(own);
        }
    }
}

/// Drafts of what sounds, which are always delivered, then of the rest; whether nothing else is wanted yet.
fn sketch(present: &mut Present, recipe: &Recipe, rate_hz: f64, order: &Order, turn: u64) -> bool {
    let draft = coarse(recipe);
    let Ok(builder) = Builder::draft(&draft) else {
        return !order.is_past(turn);
    };
    let awake = order.awake();
    let (first, rest): (Vec<u8>, Vec<u8>) =
        recipe.keys.iter().partition(|key| awake >> key & 1 == 1);
    let drawn = redraw(present, &builder, &first, || false);
    if drawn {
        deliver(present, rate_hz, order);
    }
    let drawn = redraw(present, &builder, &rest, || order.is_past(turn));
    if order.is_past(turn) {
        return false;
    }
    if drawn {
        deliver(present, rate_hz, order);
    }
    true
}

/// Draws some keys anew; one that cannot be stays as it is. Whether any was drawn.
fn redraw(
    present: &mut Present,
    builder: &Builder<'_>,
    keys: &[u8],
    stop: impl Fn() -> bool + Sync,
) -> bool {
    let tuned = &present.tuned;
    let drawn: Vec<_> = keys
        .par_iter()
        .with_max_len(1)
        .filter_map(|&key| {
            if stop() {
                return None;
            }
            builder.redraw(key, tuned[usize::from(key)].as_ref()).ok()
        })
        .collect();
    let any = !drawn.is_empty();
    for (body, tuned) in drawn {
        present.tuned[usize::from(body.key)] = tuned;
        present.put(body);
    }
    any
}

/// The bank as it is precomputed, the bodies that sound first; none once something else is wanted. A key
/// that cannot be built, which precomputing refuses, keeps the body that it has.
fn whole(present: &Present, recipe: &Recipe, order: &Order, turn: u64) -> Option<Bank> {
    let builder = Builder::new(recipe).ok()?;
    let awake = order.awake();
    let mut keys: Vec<u8> = recipe.keys.iter().collect();
    keys.sort_by_key(|key| awake >> key & 1 == 0);
    let mut finished: Vec<(u8, Finished)> = keys
        .par_iter()
        .with_max_len(1)
        .filter_map(|&key| {
            let body = || builder.body_within(key).ok();
            let body = (!order.is_past(turn)).then(body).flatten();
            Some((key, body?))
        })
        .collect();
    if order.is_past(turn) {
        return None;
    }
    finished.sort_by_key(|(key, _)| *key);
    let mut bank = builder.bank(finished.into_iter().map(|(_, body)| body).collect());
    let built: Vec<u8> = bank.bodies.iter().map(|body| body.key).collect();
    let others = present.bank.bodies.iter();
    let others = others.filter(|body| !built.contains(&body.key)).cloned();
    bank.bodies.extend(others);
    bank.bodies.sort_by_key(|body| body.key);
    Some(bank)
}

fn deliver(present: &Present, rate_hz: f64, order: &Order) {
    let engine = Box::new(Engine::new(&present.bank, rate_hz));
    order.deliver((present.number, engine));
}
