//! Boxes whose motion makes broad phases break down: frame by frame, without an engine.

use crate::random::Random;

named! {
    /// How boxes move: cubes of side 1, and at times a few that are larger.
    HardMotion {
        Drifting "drifting" "Not hard: all drift and bounce from the borders. The baseline for the others."
        Explosion "explosion" "All fly apart from a ball in which they are packed."
        Implosion "implosion" "All fly towards the centre."
        Teleporting "teleporting" "All are somewhere else in each frame."
        HalfAsleep "half asleep" "Every other one drifts."
        Churn "churn of a tenth" "One in ten is taken away and comes back somewhere else as another; the rest drift."
        WallsAlongFirst "walls along the first axis move" "64 walls as long as the world drift among cubes at rest."
        WallsAlongSecond "walls along the second axis move" "The same along the second axis."
        WallsAlongLast "walls along the last axis move" "The same along the last axis."
        Lift "a lift" "A platform an eighth as wide as the world goes up and down among cubes at rest."
        Sensors "100 large sensors" "100 cubes a tenth as wide as the world drift among cubes at rest."
        Alternating "alternating modes" "All drift, then one in a hundred, then all stay about where they are, then one in ten is teleported."
    }
}

/// The most that a cube moves between two frames, along each axis.
const SPEED: f32 = 0.1;
/// The share of the way to or from the centre that cubes cover in a frame.
const PULL: f32 = 0.02;
/// Overlapping pairs per cube, where they are uniform.
const PAIRS: f64 = 0.8;

/// How many of the first boxes are walls, and sensors.
const WALLS: usize = 64;
const SENSORS: usize = 100;

/// Boxes in motion. Equal arguments make equal frames.
#[derive(Clone, Debug)]
pub struct HardFrames<const D: usize> {
    motion: HardMotion,
    random: Random,
    frame: usize,
    reach: f32,
    mins: Vec<[f32; D]>,
    /// How many of the first ones are larger, and their sides.
    large: usize,
    sides: [f32; D],
    velocities: Vec<[f32; D]>,
    moved: Vec<usize>,
    replaced: Vec<usize>,
}

impl<const D: usize> HardFrames<D> {
    /// `count` boxes before the first frame. **O(n)**.
    pub fn new(motion: HardMotion, count: usize, seed: u64) -> Self {
        let density = PAIRS * 2.0 / f64::from(1 << D);
        let reach = (count as f64 / density).powf(1.0 / D as f64) as f32;
        let mut frames = Self {
            motion,
            random: Random::new(seed),
            frame: 0,
            reach,
            mins: vec![[0.0; D]; count],
            large: 0,
            sides: [1.0; D],
            velocities: vec![[0.0; D]; count],
            moved: Vec::new(),
            replaced: Vec::new(),
        };
        for i in 0..count {
            frames.mins[i] = frames.anywhere();
            frames.velocities[i] = std::array::from_fn(|_| frames.random.range(-SPEED, SPEED));
        }
        let wall = |along: usize| {
            let side = |k: usize| if k == along.min(D - 1) { reach } else { 1.0 };
            (WALLS, std::array::from_fn(side))
        };
        let platform = |k: usize| if k == D - 1 { 1.0 } else { reach / 8.0 };
        (frames.large, frames.sides) = match motion {
            HardMotion::WallsAlongFirst => wall(0),
            HardMotion::WallsAlongSecond => wall(1),
            HardMotion::WallsAlongLast => wall(D - 1),
            HardMotion::Lift => (1, std::array::from_fn(platform)),
            HardMotion::Sensors => (SENSORS, [reach / 10.0; D]),
            _ => (0, [1.0; D]),
        };
        frames.large = frames.large.min(count);
        for i in 0..frames.large {
            for k in 0..D {
                if frames.sides[k] == reach {
                    (frames.mins[i][k], frames.velocities[i][k]) = (0.0, 0.0);
                }
            }
        }
        if motion == HardMotion::Lift {
            frames.velocities[0] = std::array::from_fn(|k| if k == D - 1 { SPEED } else { 0.0 });
        }
        if motion == HardMotion::Explosion {
            // Half as large: 2ᴰ times as dense.
            frames.scale(0.5);
        }
        frames
    }

    /// The lower corner of each box in this frame.
    pub fn mins(&self) -> &[[f32; D]] {
        &self.mins
    }

    /// The sides of a box, the same in all frames.
    pub fn sides(&self, i: usize) -> [f32; D] {
        match i < self.large {
            true => self.sides,
            false => [1.0; D],
        }
    }

    /// The boxes that are not where they were in the last frame, ascending.
    pub fn moved(&self) -> &[usize] {
        &self.moved
    }

    /// The boxes that were taken away after the last frame and are others now, ascending; none of them is among the
    /// [moved](Self::moved).
    pub fn replaced(&self) -> &[usize] {
        &self.replaced
    }

    /// Moves on to the next frame. **O(n)**.
    pub fn advance(&mut self) {
        self.moved.clear();
        self.replaced.clear();
        match self.motion {
            HardMotion::WallsAlongFirst
            | HardMotion::WallsAlongSecond
            | HardMotion::WallsAlongLast
            | HardMotion::Lift
            | HardMotion::Sensors => self.drift_among(0..self.large, 1),
            HardMotion::Drifting => self.drift(1),
            HardMotion::HalfAsleep => self.drift(2),
            HardMotion::Explosion => self.scale(1.0 + PULL),
            HardMotion::Implosion => self.scale(1.0 - PULL),
            HardMotion::Teleporting => self.teleport(1),
            HardMotion::Churn => {
                let turn = self.frame % 10;
                self.drift(1);
                self.moved.retain(|i| i % 10 != turn);
                self.replaced.extend((turn..self.mins.len()).step_by(10));
                for k in 0..self.replaced.len() {
                    self.mins[self.replaced[k]] = self.anywhere();
                }
            }
            HardMotion::Alternating => match self.frame % 4 {
                0 => self.drift(1),
                1 => self.drift(100),
                2 => self.tremble(),
                _ => self.teleport(10),
            },
        }
        self.frame += 1;
    }

    fn anywhere(&mut self) -> [f32; D] {
        std::array::from_fn(|_| self.random.range(0.0, self.reach))
    }

    /// Moves one box in `stride` on.
    fn drift(&mut self, stride: usize) {
        self.drift_among(0..self.mins.len(), stride);
    }

    /// Moves one in `stride` of these boxes on.
    fn drift_among(&mut self, boxes: std::ops::Range<usize>, stride: usize) {
        for i in boxes.step_by(stride) {
            for (x, v) in self.mins[i].iter_mut().zip(&mut self.velocities[i]) {
                if !(0.0..=self.reach).contains(&(*x + *v)) {
                    *v = -*v;
                }
                *x += *v;
            }
            self.moved.push(i);
        }
    }

    /// Moves all by less than any margin, there or back.
    fn tremble(&mut self) {
        let way = if self.frame % 8 < 4 { 1e-3 } else { -1e-3 };
        for (i, mins) in self.mins.iter_mut().enumerate() {
            mins[0] += way;
            self.moved.push(i);
        }
    }

    /// Puts one cube in `stride` at a random place.
    fn teleport(&mut self, stride: usize) {
        for i in (0..self.mins.len()).step_by(stride) {
            self.mins[i] = self.anywhere();
            self.moved.push(i);
        }
    }

    /// Moves all towards the centre or away from it.
    fn scale(&mut self, factor: f32) {
        let centre = self.reach / 2.0;
        for (i, mins) in self.mins.iter_mut().enumerate() {
            *mins = mins.map(|x| centre + (x - centre) * factor);
            self.moved.push(i);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_listed_has_not_moved() {
        for motion in HardMotion::ALL {
            let mut frames = HardFrames::<2>::new(motion, 300, 7);
            for _ in 0..20 {
                let before = frames.mins().to_vec();
                frames.advance();
                let [moved, replaced] = [frames.moved(), frames.replaced()];
                assert!(moved.is_sorted() && replaced.is_sorted());
                assert!(!moved.is_empty(), "{motion:?}");
                for (i, mins) in before.iter().enumerate() {
                    let is_listed = [moved, replaced].map(|list| list.binary_search(&i).is_ok());
                    assert_ne!(is_listed, [true, true]);
                    assert_eq!(
                        frames.mins()[i] != *mins,
                        is_listed.contains(&true),
                        "{motion:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn an_implosion_gathers_cubes_and_an_explosion_scatters_them() {
        for (motion, gathers) in [
            (HardMotion::Explosion, false),
            (HardMotion::Implosion, true),
        ] {
            let mut frames = HardFrames::<2>::new(motion, 1000, 7);
            let extent = |frames: &HardFrames<2>| {
                let places = frames.mins().iter().map(|mins| mins[0]);
                places.clone().fold(f32::MIN, f32::max) - places.fold(f32::MAX, f32::min)
            };
            let before = extent(&frames);
            (0..20).for_each(|_| frames.advance());
            let growth = extent(&frames) / before;
            let expected = if gathers { 0.6..0.7 } else { 1.4..1.6 };
            assert!(expected.contains(&growth), "{motion:?}: {growth}");
        }
    }
}
