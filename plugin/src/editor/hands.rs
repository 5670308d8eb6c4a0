//! What the user's hands are at: the knob that is held, and the value that is typed.

use super::hold::Hold;
use super::typing::Typing;

/// One pair of hands.
#[derive(Default)]
pub(super) struct Hands {
    pub(super) hold: Hold,
    pub(super) typing: Typing,
}
