//! What is played in the editor: bodies, not keys.

use super::Player;
use crate::editor::Touch;
use crate::engine::{Hit, Hold};
use crate::params::bow::Keys;

impl Player {
    /// Touches a body of the present instrument, now.
    pub(crate) fn touch(&mut self, touch: Touch) {
        self.look_at = 0;
        match touch {
            Touch::Strike {
                key,
                velocity,
                position,
                across,
            } => {
                let velocity = f64::from(velocity);
                let bow_pressure = match self.keys {
                    Keys::Rub => velocity,
                    Keys::Strike | Keys::Both => 0.0,
                };
                let hold = Hold {
                    bow_pressure,
                    ..Hold::FREE
                };
                self.stage.hold(key, &hold);
                let hit = Hit {
                    // A bow presses as it is held.
                    velocity: if self.keys == Keys::Rub {
                        0.0
                    } else {
                        velocity
                    },
                    position: f64::from(position) - self.settings.strike_position,
                    across: f64::from(across) - self.settings.strike_across,
                    ..Hit::plain(velocity)
                };
                self.stage.hit(key, &hit);
            }
            Touch::Release { key } => {
                self.stage.each(|engine| engine.release(key));
                self.tell(key);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::{Outputs, Struck};
    use crate::params::Controls;
    use crate::stage::Stage;
    use crate::tuner::Tuner;
    use modes::tuning::Tuning;
    use std::sync::Arc;

    fn player() -> Player {
        let tuner = Tuner::new(Tuning::default(), None);
        Player::new(
            Stage::new(0, crate::factory::bank(0), 48e3),
            tuner,
            Arc::new(Controls::default()),
            48e3,
        )
    }

    fn render(player: &mut Player, frames: usize) -> f32 {
        let (mut left, mut right) = (vec![0.0; frames], vec![0.0; frames]);
        player
            .stage()
            .render(&mut Outputs::main(&mut left, &mut right));
        left.iter().fold(0.0, |most, x| x.abs().max(most))
    }

    #[test]
    fn a_click_strikes_its_body_where_it_was_made() {
        let mut player = player();
        player.touch(Touch::Strike {
            key: 60,
            velocity: 0.8,
            position: 0.3,
            across: 0.6,
        });
        let struck = player.stage().present().1.struck();
        let Some(Struck {
            key: 60,
            position,
            across,
            velocity,
            ..
        }) = struck
        else {
            panic!("{struck:?}");
        };
        assert!((across - 0.6).abs() < 1e-6);
        assert!((position - 0.3).abs() < 1e-6 && (velocity - 0.8).abs() < 1e-6);
        assert!(render(&mut player, 480) > 1e-3);
        assert_eq!(player.stage().awake(), 1 << 60);
    }

    #[test]
    fn bodies_that_are_not_there_are_not_struck() {
        let mut player = player();
        for key in [0, 127, 255] {
            player.touch(Touch::Strike {
                key,
                velocity: 1.0,
                position: 0.5,
                across: 0.0,
            });
            player.touch(Touch::Release { key });
        }
        assert_eq!(player.stage().awake(), 0);
    }
}
