//! Squares that all fly through the centre: the second experiment of the paper.

use crate::random::Random;

/// Squares of side 1 that lie about uniformly in a square, fly to its centre at one speed, through each other, and spread out
/// again on the other side: what Figure 4 of Capannini and Larsson, *Output Sensitive Collision Detection for Unisize
/// Boxes*, is measured on.
///
/// The paper specifies no more than that. Here the squares fill a fifth of the area at first, and a square from the
/// middle of a side reaches the centre in frame [`HALF_WAY`](Self::HALF_WAY) of 500. They are densest around then, since those that
/// start at one distance arrive at one time: at a distance of r from the centre there are about 1/r times as many as
/// at first.
#[derive(Clone, Debug)]
pub struct ConvergingBoxes {
    mins: Vec<[f32; 2]>,
    velocities: Vec<[f32; 2]>,
}

/// The part of the area that the squares would fill at first, if they did not overlap.
const DENSITY: f64 = 0.2;

impl ConvergingBoxes {
    /// The frame in which a square from the middle of a side reaches the centre.
    pub const HALF_WAY: usize = 250;

    /// `count` squares around the origin. Equal arguments give equal squares in every frame. **O(n)**.
    pub fn new(count: usize, seed: u64) -> Self {
        let half_side = (count as f64 / DENSITY).sqrt() as f32 / 2.0;
        let speed = half_side / Self::HALF_WAY as f32;
        let mut random = Random::new(seed);
        let mut boxes = Self {
            mins: Vec::with_capacity(count),
            velocities: Vec::with_capacity(count),
        };
        for _ in 0..count {
            let centre = [0; 2].map(|_| random.range(-half_side, half_side));
            let distance = centre[0].hypot(centre[1]).max(f32::MIN_POSITIVE);
            boxes.mins.push(centre.map(|x| x - 0.5));
            boxes.velocities.push(centre.map(|x| -x / distance * speed));
        }
        boxes
    }

    /// Moves every square on to the next frame. **O(n)**.
    pub fn advance(&mut self) {
        for (min, velocity) in self.mins.iter_mut().zip(&self.velocities) {
            for (x, v) in min.iter_mut().zip(velocity) {
                *x += v;
            }
        }
    }

    /// The lower corner of each square in this frame.
    pub fn mins(&self) -> &[[f32; 2]] {
        &self.mins
    }
}

#[cfg(test)]
mod tests {
    use super::{ConvergingBoxes, DENSITY};

    #[test]
    fn they_gather_and_spread_out_again() {
        let mut boxes = ConvergingBoxes::new(5000, 7);
        let half_side = (5000.0 / DENSITY).sqrt() as f32 / 2.0;
        let mut frames = Vec::new();
        for _ in 0..=2 * ConvergingBoxes::HALF_WAY {
            let distance = |[x, y]: &[f32; 2]| (x + 0.5).hypot(y + 0.5);
            let sum: f32 = boxes.mins().iter().map(distance).sum();
            frames.push(sum / 5000.0 / half_side);
            boxes.advance();
        }
        // The mean over a uniform square is 0.765 of half its side.
        assert!((frames[0] - 0.765).abs() < 0.02, "{}", frames[0]);
        assert!(frames.iter().any(|&mean| mean < 0.35));
        assert!(*frames.last().unwrap() > 1.0);
    }
}
