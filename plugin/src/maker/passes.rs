//! From coarse to fine: the passes over the bodies of one drawing.

use super::order::{Order, Wanted};
use super::shortfall::{Shortfall, refused};
use super::{Stores, recipe_of};
use crate::engine::Engine;
use crate::notices::{Notice, Subject};
use crate::shelf::{Own, Shelf, Shelved, spread_out};
use modes::bar::TunedBar;
use modes::factory::{Builder, Finished, Silent, build, coarse};
use modes::{Bank, Body, Recipe, ShapeRecipe};
use rayon::prelude::*;
use std::sync::Arc;

/// What the maker remembers from one drawing to the next.
pub(super) struct Passes {
    stores: Stores,
    rate_hz: f64,
    present: Option<Present>,
    /// What was to be told of the drawing that was solved last, by the text of its recipe.
    told: Option<(String, Option<Notice>)>,
}

/// An instrument whose drawing is changed.
struct Present {
    number: usize,
    base: Shelved,
    /// None for what is not drawn by dimensions.
    recipe: Option<Recipe>,
    /// The bodies as they were last delivered.
    bank: Arc<Bank>,
    /// What the bars were tuned to last, key by key.
    tuned: Vec<Option<TunedBar>>,
}

/// Whom drawings are delivered to.
struct Customer<'a> {
    stores: &'a Stores,
    rate_hz: f64,
    order: &'a Order,
    turn: u64,
}

impl Present {
    fn new(shelf: &Shelf, number: usize) -> Self {
        let base = shelf.bank(number);
        Self {
            number,
            recipe: recipe_of(&base),
            bank: Arc::new((*base).clone()),
            tuned: vec![None; 128],
            base,
        }
    }

    /// Puts a body in the place of the one of its key.
    fn put(&mut self, body: Body) {
        let bodies = &mut Arc::make_mut(&mut self.bank).bodies;
        if let Some(old) = bodies.iter_mut().find(|old| old.key == body.key) {
            *old = body;
        }
    }
}

impl Customer<'_> {
    fn deliver(&self, present: &Present) {
        self.stores.drawn.put(present.number, &present.bank);
        let engine = Box::new(Engine::new(&present.bank, self.rate_hz));
        self.order.deliver((present.number, engine));
    }

    /// Whether something else is wanted by now.
    fn is_past(&self) -> bool {
        self.order.is_past(self.turn)
    }
}

impl Passes {
    pub(super) fn new(stores: Stores, rate_hz: f64) -> Self {
        Self {
            stores,
            rate_hz,
            present: None,
            told: None,
        }
    }

    /// Delivers what is wanted, better and better, until something else is.
    pub(super) fn follow(&mut self, wanted: &Wanted, order: &Order) {
        let stores = self.stores.clone();
        let customer = Customer {
            stores: &stores,
            rate_hz: self.rate_hz,
            order,
            turn: wanted.turn,
        };
        stores.notices.clear(Subject::Drawing);
        let present = self.present.take();
        let known = present.filter(|present| present.number == wanted.number);
        let fresh = known.is_none();
        if fresh {
            stores.drawn.clear();
        }
        let present = known.unwrap_or_else(|| Present::new(&stores.shelf, wanted.number));
        let present = self.present.insert(present);
        let Some(own) = &present.recipe else {
            return;
        };
        let recipe = match wanted.drawing.apply(own) {
            Ok(recipe) => recipe,
            Err(error) => {
                stores.notices.post(refused(&wanted.drawing, &error));
                return;
            }
        };
        if recipe.text == present.base.provenance.recipe {
            // A fresh instrument is as its recipe draws it.
            if !fresh {
                present.bank = Arc::new((*present.base).clone());
                customer.deliver(present);
            }
            return;
        }
        if let Some(own) = stores.solved.of(&recipe.text) {
            present.bank = own.share();
            customer.deliver(present);
        } else {
            let Some((bank, short)) = solve(present, &recipe, &customer) else {
                return;
            };
            self.told = Some((recipe.text.clone(), short.notice(&wanted.drawing)));
            let bank = Arc::new(bank);
            present.bank = spread_out(Arc::clone(&bank));
            customer.deliver(present);
            // One too large for a song is solved again there; one that is past by now is not wanted there.
            if !customer.is_past() {
                stores.solved.clear();
                if let Ok(own) = Own::new(bank) {
                    stores.solved.put(own);
                }
            }
        }
        let told = self.told.as_ref().filter(|(text, _)| *text == recipe.text);
        if let Some((_, Some(notice))) = told {
            stores.notices.post(notice.clone());
        }
    }
}

/// The bank as it is precomputed, after drafts that are delivered on the way; none once something else is
/// wanted.
fn solve(
    present: &mut Present,
    recipe: &Recipe,
    customer: &Customer<'_>,
) -> Option<(Bank, Shortfall)> {
    if matches!(recipe.shape, ShapeRecipe::Closed(_)) {
        // Done before a draft would be.
        let bank = build(recipe, &Silent).ok()?;
        return Some((bank, Shortfall::default()));
    }
    if !sketch(present, recipe, customer) {
        return None;
    }
    customer.order.drafted(customer.turn);
    whole(present, recipe, customer)
}

/// Drafts of what sounds, which are always delivered, then of the rest; whether nothing else is wanted yet.
fn sketch(present: &mut Present, recipe: &Recipe, customer: &Customer<'_>) -> bool {
    let draft = coarse(recipe);
    let Ok(builder) = Builder::draft(&draft) else {
        return !customer.is_past();
    };
    let awake = customer.order.awake();
    let (first, rest): (Vec<u8>, Vec<u8>) =
        recipe.keys.iter().partition(|key| awake >> key & 1 == 1);
    let drawn = redraw(present, &builder, &first, || false);
    if drawn {
        customer.deliver(present);
    }
    let drawn = redraw(present, &builder, &rest, || customer.is_past());
    if customer.is_past() {
        return false;
    }
    if drawn {
        customer.deliver(present);
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

/// The bank as it is precomputed, the bodies that sound first; none once something else is wanted. Of a key
/// that cannot be built, which precomputing refuses, the nearest body to it, or else the one that it has.
fn whole(present: &Present, recipe: &Recipe, customer: &Customer<'_>) -> Option<(Bank, Shortfall)> {
    let builder = Builder::new(recipe).ok()?;
    let awake = customer.order.awake();
    let mut keys: Vec<u8> = recipe.keys.iter().collect();
    keys.sort_by_key(|key| awake >> key & 1 == 0);
    let mut finished: Vec<(u8, Finished, f64)> = keys
        .par_iter()
        .with_max_len(1)
        .filter_map(|&key| {
            let body = || builder.body_within(key).ok();
            let (body, share) = (!customer.is_past()).then(body).flatten()?;
            Some((key, body, share))
        })
        .collect();
    if customer.is_past() {
        return None;
    }
    finished.sort_by_key(|(key, ..)| *key);
    let partly = finished.iter().filter(|(.., share)| *share < 1.0);
    let partly = partly.map(|(key, ..)| *key).collect();
    let mut bank = builder.bank(finished.into_iter().map(|(_, body, _)| body).collect());
    let built: Vec<u8> = bank.bodies.iter().map(|body| body.key).collect();
    let others = present.bank.bodies.iter();
    let others: Vec<Body> = others
        .filter(|body| !built.contains(&body.key))
        .cloned()
        .collect();
    let not = others.iter().map(|body| body.key).collect();
    bank.bodies.extend(others);
    bank.bodies.sort_by_key(|body| body.key);
    Some((bank, Shortfall { partly, not }))
}
