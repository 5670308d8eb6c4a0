//! Where sound goes: a main output and others beside it.

use std::ops::Range;

/// Stereo outputs at most, the main one among them.
pub const OUTPUTS: usize = 8;

/// Buffers of as many samples for the outputs that are connected; the main one, number 0, always is.
pub struct Outputs<'a> {
    pairs: [[&'a mut [f32]; 2]; OUTPUTS],
    /// The connected ones, bit 0 for the main one.
    connected: u8,
}

impl<'a> Outputs<'a> {
    /// The main output alone, of as many samples as the shorter of the two slices holds.
    #[must_use]
    pub fn main(left: &'a mut [f32], right: &'a mut [f32]) -> Self {
        let frames = left.len().min(right.len());
        let mut pairs = [(); OUTPUTS].map(|()| [Default::default(), Default::default()]);
        pairs[0] = [&mut left[..frames], &mut right[..frames]];
        Self {
            pairs,
            connected: 1,
        }
    }

    /// Connects another output; one that is no output, or shorter than the main one, stays unconnected.
    pub fn connect(&mut self, number: usize, left: &'a mut [f32], right: &'a mut [f32]) {
        let frames = self.frames();
        if (1..OUTPUTS).contains(&number) && left.len().min(right.len()) >= frames {
            self.pairs[number] = [&mut left[..frames], &mut right[..frames]];
            self.connected |= 1 << number;
        }
    }

    /// Samples of each.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.pairs[0][0].len()
    }

    /// Some of the samples, which must be there.
    #[must_use]
    pub fn part(&mut self, range: Range<usize>) -> Outputs<'_> {
        let connected = self.connected;
        let mut number = 0;
        let pairs = self.pairs.each_mut().map(|pair| {
            let there = connected >> number & 1 == 1;
            number += 1;
            pair.each_mut().map(|side| {
                if there {
                    &mut side[range.clone()]
                } else {
                    Default::default()
                }
            })
        });
        Outputs { pairs, connected }
    }

    /// Whether an output is connected.
    pub(crate) fn has(&self, number: usize) -> bool {
        self.connected >> number & 1 == 1
    }

    /// Left and right of the connected outputs, with their numbers.
    pub(crate) fn each(&mut self) -> impl Iterator<Item = (usize, [&mut [f32]; 2])> {
        let connected = self.connected;
        let pairs = self.pairs.iter_mut().enumerate();
        pairs
            .filter(move |(number, _)| connected >> number & 1 == 1)
            .map(|(number, pair)| (number, pair.each_mut().map(|side| &mut **side)))
    }
}

/// Room for what an instrument adds to the outputs, some samples at a time.
pub(crate) struct Room<const FRAMES: usize>([[[f32; FRAMES]; 2]; OUTPUTS]);

impl<const FRAMES: usize> Room<FRAMES> {
    /// Silence.
    pub(crate) const fn new() -> Self {
        Self([[[0.0; FRAMES]; 2]; OUTPUTS])
    }

    /// As many samples of the same outputs as `other` has, which are no more than there is room for.
    pub(crate) fn like(&mut self, other: &Outputs<'_>) -> Outputs<'_> {
        let frames = other.frames().min(FRAMES);
        Outputs {
            pairs: self
                .0
                .each_mut()
                .map(|pair| pair.each_mut().map(|side| &mut side[..frames])),
            connected: other.connected,
        }
    }

    /// The samples of an output.
    pub(crate) fn pair(&self, number: usize) -> &[[f32; FRAMES]; 2] {
        &self.0[number]
    }
}

#[cfg(test)]
mod tests {
    use super::{OUTPUTS, Outputs, Room};

    #[test]
    fn parts_are_parts_of_what_is_connected() {
        let (mut sound, mut more) = ([[0.0f32; 9]; 6], [[0.0; 9]; 2]);
        let [a, b, c, d, e, f] = &mut sound;
        let mut outputs = Outputs::main(a, &mut b[..8]);
        outputs.connect(3, c, d);
        outputs.connect(4, &mut e[..7], f);
        let [g, h] = &mut more;
        outputs.connect(OUTPUTS, g, h);
        assert_eq!(outputs.frames(), 8);
        let numbers: Vec<usize> = outputs.each().map(|(number, _)| number).collect();
        assert_eq!(numbers, [0, 3]);
        let mut part = outputs.part(2..5);
        assert!(part.frames() == 3 && part.has(3) && !part.has(4));
        for (number, [left, right]) in part.each() {
            left.fill(1.0 + number as f32);
            right[0] = -1.0;
        }
        assert_eq!(sound[2], [0.0, 0.0, 4.0, 4.0, 4.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(sound[3][..4], [0.0, 0.0, -1.0, 0.0]);
        assert_eq!(sound[4], [0.0; 9]);
    }

    #[test]
    fn room_is_as_the_outputs_are() {
        let (mut left, mut right, mut more) = ([0.0; 5], [0.0; 5], [[0.0; 5]; 2]);
        let mut outputs = Outputs::main(&mut left, &mut right);
        let [a, b] = &mut more;
        outputs.connect(7, a, b);
        let mut room = Room::<32>::new();
        let mut like = room.like(&outputs);
        assert!(like.frames() == 5 && like.has(7) && !like.has(1));
        for (_, [left, _]) in like.each() {
            left.fill(1.0);
        }
        assert_eq!(room.pair(7)[0][4..6], [1.0, 0.0]);
        assert_eq!(room.pair(1)[0][0], 0.0);
    }
}
