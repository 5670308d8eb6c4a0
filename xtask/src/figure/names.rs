//! Where to write names so that they cover neither dots nor each other.

/// A rectangle of pixels: left, top, right, bottom.
pub(super) type Frame = [i32; 4];

/// Places that are taken.
#[derive(Clone, Debug)]
pub(super) struct Taken {
    inside: Frame,
    frames: Vec<Frame>,
}

impl Taken {
    /// Nothing yet, in a picture where all names must be `inside`.
    pub(super) fn none(inside: Frame) -> Self {
        let frames = Vec::new();
        Self { inside, frames }
    }

    /// Takes the place of a dot.
    pub(super) fn dot(&mut self, [x, y]: [i32; 2], radius: i32) {
        self.frames
            .push([x - radius, y - radius, x + radius, y + radius]);
    }

    /// Takes a free place for a name of this `width` and `height` beside a dot; returns its left
    /// top corner, or nothing if there is no room.
    ///
    /// Above is best, then below, then beside, then towards the corners.
    pub(super) fn name(
        &mut self,
        [x, y]: [i32; 2],
        radius: i32,
        [width, height]: [i32; 2],
    ) -> Option<[i32; 2]> {
        /// Between dot and name.
        const GAP: i32 = 4;
        let (centred, reach) = (x - width / 2, radius + GAP);
        let near = [
            [centred, y - reach - height],
            [centred, y + reach],
            [x + reach, y - height / 2],
            [x - reach - width, y - height / 2],
        ];
        let corners = [
            [x + radius / 2, y - reach - height / 2],
            [x - radius / 2 - width, y - reach - height / 2],
            [x + radius / 2, y + reach - height / 2],
            [x - radius / 2 - width, y + reach - height / 2],
        ];
        let frame = |[left, top]: [i32; 2]| [left, top, left + width, top + height];
        let place = near
            .into_iter()
            .chain(corners)
            .find(|place| self.is_free(frame(*place)))?;
        self.frames.push(frame(place));
        Some(place)
    }

    fn is_free(&self, frame: Frame) -> bool {
        let [left, top, right, bottom] = self.inside;
        frame[0] >= left
            && frame[1] >= top
            && frame[2] <= right
            && frame[3] <= bottom
            && !self.frames.iter().any(|taken| overlap(*taken, frame))
    }
}

fn overlap(a: Frame, b: Frame) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROOM: Frame = [0, 0, 400, 400];

    #[test]
    fn a_name_alone_stands_above_its_dot() {
        let mut taken = Taken::none(ROOM);
        taken.dot([200, 200], 10);
        assert_eq!(taken.name([200, 200], 10, [60, 16]), Some([170, 170]));
    }

    #[test]
    fn names_avoid_dots_edges_and_each_other() {
        let mut taken = Taken::none(ROOM);
        let dots = [[200, 10], [230, 14], [180, 12]];
        for dot in dots {
            taken.dot(dot, 8);
        }
        let mut frames: Vec<Frame> = dots
            .iter()
            .filter_map(|dot| taken.name(*dot, 8, [60, 16]))
            .map(|[x, y]| [x, y, x + 60, y + 16])
            .collect();
        assert!(frames.len() >= 2 && frames.iter().all(|frame| frame[1] >= 0));
        frames.extend(dots.map(|[x, y]| [x - 8, y - 8, x + 8, y + 8]));
        let names = frames.len() - dots.len();
        for (i, a) in frames[..names].iter().enumerate() {
            assert!(!frames[i + 1..].iter().any(|b| overlap(*a, *b)));
        }
    }

    #[test]
    fn a_name_without_room_is_left_out() {
        let mut taken = Taken::none([0, 0, 50, 50]);
        assert_eq!(taken.name([25, 25], 4, [60, 16]), None);
    }
}
