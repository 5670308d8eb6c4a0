//! Bodies of any shape: from a mesh to modes, strike grid, surface and bank.

mod air;
mod axes;
mod bank;
mod body;
mod grid;
mod made;
mod outside;
mod skin;
mod solve;
#[cfg(test)]
mod tests;

pub use bank::{FreeError, SolvedPiece, free_bank, solved_piece};
pub use body::{FreeBody, free_body};
pub use made::{Made, MadeError, Noted, make};
pub use solve::Limits;
