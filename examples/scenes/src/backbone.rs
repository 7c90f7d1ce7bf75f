//! The backbone of a protein: a long chain of links of one size, folded into a globule.

use crate::random::Random;

/// Cubes of side 1 around the links of a chain that is folded into a ball and trembles: a kinematic chain in three
/// dimensions without an engine, after the protein structures of section 6 of Capannini and Larsson, *Output Sensitive
/// Collision Detection for Unisize Boxes*.
///
/// A link is 0.76 of a cube long: 3.8 of the 5 ångströms within which two alpha carbons are said to be in contact. The
/// chain turns at random and stays within a ball of which the cubes fill [`DENSITY`](Self::DENSITY).
///
/// ```
/// use unisize_scenes::Backbone;
///
/// let mut chain = Backbone::new(1000, 7);
/// chain.advance();
/// assert_eq!(chain.mins().len(), 1000);
/// ```
#[derive(Clone, Debug)]
pub struct Backbone {
    rest: Vec<[f32; 3]>,
    mins: Vec<[f32; 3]>,
    phases: Vec<[f32; 3]>,
    frame: usize,
}

/// The length of a link.
const LINK: f32 = 0.76;

/// How far a cube trembles from its place, along each axis.
const TREMBLING: f32 = 0.1;

/// How fast, in radians per frame.
const PACE: f32 = 0.3;

impl Backbone {
    /// The part of the ball that the cubes would fill if they did not overlap.
    pub const DENSITY: f32 = 0.7;

    /// A chain of `count` cubes. Equal arguments give equal cubes in every frame. **O(n)**.
    pub fn new(count: usize, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let volume = count as f32 / Self::DENSITY;
        let radius = (volume * 3.0 / (4.0 * std::f32::consts::PI)).cbrt();
        let mut rest = Vec::with_capacity(count);
        let mut place = [0.0_f32; 3];
        for _ in 0..count {
            rest.push(place.map(|x| x - 0.5));
            place = loop {
                let turn = [0; 3].map(|_| random.range(-1.0, 1.0_f32));
                let length = norm(turn);
                let next: [f32; 3] =
                    std::array::from_fn(|axis| place[axis] + turn[axis] / length * LINK);
                // Uniform over directions; the first link fits in any ball.
                if (1e-3..=1.0).contains(&length) && norm(next) <= radius.max(LINK) {
                    break next;
                }
            };
        }
        let phases = (0..count)
            .map(|_| [0; 3].map(|_| random.range(0.0, std::f32::consts::TAU)))
            .collect();
        Self {
            mins: rest.clone(),
            rest,
            phases,
            frame: 0,
        }
    }

    /// Moves every cube on to the next frame. **O(n)**.
    pub fn advance(&mut self) {
        self.frame += 1;
        let angle = PACE * self.frame as f32;
        for ((mins, rest), phases) in self.mins.iter_mut().zip(&self.rest).zip(&self.phases) {
            *mins =
                std::array::from_fn(|axis| rest[axis] + TREMBLING * (angle + phases[axis]).sin());
        }
    }

    /// The lower corner of each cube in this frame, along the chain.
    pub fn mins(&self) -> &[[f32; 3]] {
        &self.mins
    }
}

fn norm([x, y, z]: [f32; 3]) -> f32 {
    x.hypot(y).hypot(z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_hold_and_the_chain_stays_in_its_ball() {
        let mut chain = Backbone::new(3000, 7);
        let radius = (3000.0 / Backbone::DENSITY * 3.0 / (4.0 * std::f32::consts::PI)).cbrt();
        let slack = 2.0 * norm([TREMBLING; 3]);
        for _ in 0..10 {
            for pair in chain.mins().windows(2) {
                let length = norm(std::array::from_fn(|axis| pair[1][axis] - pair[0][axis]));
                assert!((length - LINK).abs() <= slack, "{length}");
            }
            let far = chain.mins().iter().map(|mins| norm(mins.map(|x| x + 0.5)));
            assert!(far.fold(0.0, f32::max) <= radius + slack);
            let before = chain.mins().to_vec();
            chain.advance();
            assert!(chain.mins() != before);
        }
        let [mut short, one] = [2, 1].map(|count| Backbone::new(count, 7));
        short.advance();
        assert_eq!([short.mins().len(), one.mins().len()], [2, 1]);
    }
}
