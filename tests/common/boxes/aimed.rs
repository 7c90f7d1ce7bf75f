//! Boxes in an order that aims at the samples of `GridSweep`, with a few parameters, which a search for hard boxes varies.

use super::random::Random;

/// The number of parameters of an axis, and of those for all axes.
const AN_AXIS: usize = 4;
const FOR_ALL: usize = 3;

/// Boxes whose sizes grow from level to level, in an order in which a sample sees a single level, with parameters between 0 and 1.
///
/// The parameters of an axis are the size of the first level, its growth, and the place and the distance of the boxes. The others are the
/// boxes that a level takes of those that are left (the places of a sample, any, or the first), their share, and the number of levels. Any
/// numbers give boxes, so a search may vary them freely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aimed([f32; 3 * AN_AXIS + FOR_ALL]);

impl Aimed {
    /// Rods along the first axis, each on a line of its own. Each level is as large as the first sample, and five times as long as the last one.
    pub const RODS: Self = Self([
        0.9, 0.694, 0.0, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 1.0,
    ]);

    /// Random parameters.
    pub fn random(seed: u64) -> Self {
        let random = &mut Random::new(seed);
        Self([(); 3 * AN_AXIS + FOR_ALL].map(|()| random.range(0.0, 1.0)))
    }

    /// These with one or two parameters changed.
    pub fn varied(mut self, seed: u64) -> Self {
        let random = &mut Random::new(seed);
        for _ in 0..1 + random.index(2) {
            let number = &mut self.0[random.index(3 * AN_AXIS + FOR_ALL)];
            *number = match random.index(3) {
                0 => random.range(0.0, 1.0),
                _ => (*number + random.range(-0.1, 0.1)).clamp(0.0, 1.0),
            };
        }
        self
    }

    /// The mins and maxs of `count` boxes, from 1 / `most` to `most` for a scalar of some precision. Equal arguments give equal boxes.
    pub fn boxes<const D: usize>(&self, count: usize, most: f64) -> Vec<[[f64; D]; 2]> {
        let random = &mut Random::new(7);
        let levels = self.levels(count, random);
        let mut one = |i: usize| {
            let sides: [[f64; 2]; D] = std::array::from_fn(|k| {
                let axis = &self.0[k % 3 * AN_AXIS..];
                let [size, growth, place, distance] = [0, 1, 2, 3].map(|j| f64::from(axis[j]));
                let growth = power(1.0, 64.0, (2.0 * growth - 1.0).max(0.0));
                let times = growth.powi(levels[i]).min(most);
                let size = match size {
                    ..0.3 => 0.0,
                    _ => power(1e-3, 1e3, (size - 0.3) / 0.7),
                };
                let distance = power(1e-2, 1e2, distance);
                let min = match (place * 5.0) as usize {
                    0 => 0.0,
                    1 => distance * i as f64,
                    2 => distance * (i as u64 * 0x9E37_79B1 % count as u64) as f64,
                    3 => distance * (count as f64).sqrt() * random.range(0.0, 1.0),
                    _ => distance * times * random.range(0.0, 1.0),
                };
                [min, min + size * times].map(|x| (x / most).min(most))
            });
            [sides.map(|[min, _]| min), sides.map(|[_, max]| max)]
        };
        (0..count).map(&mut one).collect()
    }

    /// The level of each box.
    fn levels(&self, count: usize, random: &mut Random) -> Vec<i32> {
        let [which, share, most] = [0, 1, 2].map(|j| f64::from(self.0[3 * AN_AXIS + j]));
        let (share, most) = (
            power(1.0 / 64.0, 0.9, share),
            power(1.0, 400.0, most) as i32,
        );
        let (mut levels, mut rest) = (vec![most; count], Vec::from_iter(0..count));
        for level in 0..most {
            let taken: Vec<usize> = match (which * 4.0) as usize {
                0 => sample(rest.len(), 8, 128).collect(),
                1 => sample(rest.len(), 4, usize::MAX).collect(),
                2 => (0..rest.len())
                    .filter(|_| random.range(0.0, 1.0) < share)
                    .collect(),
                _ => (0..(share * rest.len() as f64) as usize).collect(),
            };
            taken.into_iter().for_each(|i| levels[rest[i]] = level);
            rest.retain(|&i| levels[i] == most);
        }
        levels
    }
}

fn power(least: f64, most: f64, x: f64) -> f64 {
    least * (most / least).powf(x)
}

/// The places of a sample that the kernel takes of `n` boxes, one in so many and at most so many (`sample_of` in
/// `grid_sweep/choose.rs`).
fn sample(n: usize, one_in: usize, most: usize) -> impl Iterator<Item = usize> {
    let count = (n / one_in).clamp(16, most).min(n);
    (0..count).map(move |i| {
        let [first, next] = [i, i + 1].map(|i| (i as u64 * n as u64 / count as u64) as usize);
        let hash = (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32;
        first + hash as usize % (next - first)
    })
}
