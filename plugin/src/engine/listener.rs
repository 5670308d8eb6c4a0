//! Where the listener is beside the place that the bank was made for.

use super::range;
use super::settings::within;
use super::source::Way;

/// The place of the listener.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Listener {
    /// Distance over that of the bank.
    pub distance: f64,
    /// How far the head is turned to the left, in degrees: the instrument moves to the right.
    pub angle_deg: f64,
    /// 0 for both ears alike, 1 for each its own.
    pub width: f64,
}

impl Listener {
    /// Where the bank has it.
    pub const AS_BUILT: Self = Self {
        distance: 1.0,
        angle_deg: 0.0,
        width: 1.0,
    };

    /// The same with every value in its range, and what is not a number as built.
    pub(super) fn sane(self) -> Self {
        Self {
            distance: within(self.distance, range::DISTANCE, 1.0),
            angle_deg: within(self.angle_deg, range::ANGLE_DEG, 0.0),
            width: within(self.width, range::WIDTH, 1.0),
        }
    }

    /// The ways to the ears, which the bank has at `ears_m` beside an instrument at the origin: the nearer
    /// an ear, the louder and the sooner (O'Brien, Cook & Essl 2001, Eq. 10).
    ///
    /// Turning the head turns the ears about the middle between them; how far away that is only changes
    /// the level and no time, lest moving it bend the pitch.
    pub(crate) fn ways(&self, ears_m: &[[f64; 3]; 2]) -> [Way; 2] {
        let middle = [0, 1, 2].map(|a| 0.5 * (ears_m[0][a] + ears_m[1][a]));
        let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let (sin, cos) = self.angle_deg.to_radians().sin_cos();
        ears_m.map(|ear| {
            let [x, y, z] = [0, 1, 2].map(|a| ear[a] - middle[a]);
            let turned = [cos * x - sin * y, sin * x + cos * y, z];
            let old = length(ear);
            let new = length([0, 1, 2].map(|a| middle[a] + turned[a]));
            if !(old > 0.0 && new > 0.0) {
                return Way::AS_BUILT;
            }
            Way {
                gain: old / new / self.distance,
                longer_m: new - old,
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EARS_M: [[f64; 3]; 2] = [[-0.1, -1.0, 0.0], [0.1, -1.0, 0.0]];

    #[test]
    fn where_the_bank_has_it_nothing_changes() {
        for way in Listener::AS_BUILT.ways(&EARS_M) {
            assert!((way.gain - 1.0).abs() < 1e-15 && way.longer_m.abs() < 1e-15);
        }
    }

    #[test]
    fn twice_as_far_is_half_as_loud() {
        let far = Listener {
            distance: 2.0,
            ..Listener::AS_BUILT
        };
        for way in far.ways(&EARS_M) {
            assert!((way.gain - 0.5).abs() < 1e-15);
        }
    }

    #[test]
    fn a_head_turned_to_the_left_hears_the_instrument_on_its_right() {
        let turned = Listener {
            angle_deg: 90.0,
            ..Listener::AS_BUILT
        };
        let [left, right] = turned.ways(&EARS_M);
        // The left ear is now 0.1 m behind the middle and the right one 0.1 m before it.
        assert!((left.longer_m - (1.1 - 1.01f64.sqrt())).abs() < 1e-12);
        assert!((right.longer_m - (0.9 - 1.01f64.sqrt())).abs() < 1e-12);
        assert!(right.gain > left.gain);
    }
}
