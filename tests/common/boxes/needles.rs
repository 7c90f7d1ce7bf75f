//! Blocks of parallel needles with a few parameters, which a search for hard boxes varies.

use super::random::Random;

/// The number of blocks.
const BLOCKS: usize = 4;

/// The number of parameters of a block.
const NUMBERS: usize = 10;

/// Blocks of parallel needles, with parameters between 0 and 1. Most needles pass each other without touching.
///
/// The parameters of a block are its share of the needles, their direction, length and thickness, and for each axis the place and the
/// extent of the block. Any numbers give boxes, so a search may vary them freely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Needles([[f32; NUMBERS]; BLOCKS]);

impl Needles {
    /// Needles on which look-ups alone take thousands of comparisons for each box: with 2¹⁴ boxes, with more, and in double precision.
    pub const WORST: [Self; 3] = [
        Self([
            [
                0.2804, 0.0803, 0.8838, 0.8253, 0.0279, 0.0043, 1.0, 0.2284, 0.5936, 0.2072,
            ],
            [
                0.1275, 0.7609, 1.0, 1.0, 0.9988, 0.0766, 0.5477, 0.3878, 0.7344, 0.5739,
            ],
            [
                0.6136, 0.2800, 0.7156, 1.0, 0.1850, 0.0692, 0.9180, 0.4478, 0.1517, 0.9540,
            ],
            [
                0.1756, 0.4500, 0.7850, 1.0, 0.7712, 0.1540, 0.9671, 0.9018, 0.6916, 0.8119,
            ],
        ]),
        Self([
            [
                0.4372, 0.5287, 0.9503, 1.0, 0.9173, 0.4086, 0.8073, 0.0066, 0.2705, 0.4509,
            ],
            [
                0.8444, 0.2554, 0.7968, 0.3304, 0.3739, 0.4457, 0.3260, 0.8118, 0.6396, 0.1329,
            ],
            [
                0.2842, 0.7986, 0.7866, 1.0, 0.7303, 0.7838, 0.9896, 0.0111, 0.5144, 0.1951,
            ],
            [
                0.3270, 0.5251, 0.4115, 0.8979, 0.8747, 0.4708, 0.5396, 0.5122, 0.0045, 0.4645,
            ],
        ]),
        Self([
            [
                0.18482248, 0.5776112, 0.7841021, 1.0, 0.16880196, 0.0, 0.74603206, 0.5196791,
                0.28629458, 0.32634687,
            ],
            [
                0.5906404, 0.22092986, 0.25291038, 1.0, 0.8595932, 0.24454626, 0.22349948,
                0.5687754, 0.35030532, 0.36015242,
            ],
            [
                0.5087548, 0.17182851, 0.35353357, 0.24761441, 0.42128545, 0.73260176, 0.23290306,
                0.7273115, 0.45023945, 0.501833,
            ],
            [
                0.9501352, 0.6909276, 0.79389083, 0.8762148, 0.7522, 0.0, 1.0, 0.294652, 0.545047,
                0.24548449,
            ],
        ]),
    ];

    /// Random blocks.
    pub fn random(seed: u64) -> Self {
        let random = &mut Random::new(seed);
        Self([[(); NUMBERS]; BLOCKS].map(|numbers| numbers.map(|()| random.range(0.0, 1.0))))
    }

    /// These blocks with one or two parameters changed.
    pub fn varied(mut self, seed: u64) -> Self {
        let random = &mut Random::new(seed);
        for _ in 0..1 + random.index(2) {
            let number = &mut self.0[random.index(BLOCKS)][random.index(NUMBERS)];
            *number = match random.index(3) {
                0 => random.range(0.0, 1.0),
                _ => (*number + random.range(-0.1, 0.1)).clamp(0.0, 1.0),
            };
        }
        self
    }

    /// The mins and maxs of `count` boxes. Equal arguments give equal boxes. **O(n)**.
    pub fn boxes<const D: usize>(&self, count: usize, seed: u64) -> Vec<[[f32; D]; 2]> {
        let random = &mut Random::new(seed);
        let all: f32 = self.0.iter().map(|&[share, ..]| share).sum();
        let mut boxes = Vec::with_capacity(count);
        for (i, numbers) in self.0.iter().enumerate() {
            let end = match i + 1 == BLOCKS {
                true => count,
                false => (boxes.len() + (numbers[0] / all * count as f32) as usize).min(count),
            };
            while boxes.len() < end {
                boxes.push(needle(numbers, random));
            }
        }
        boxes
    }
}

fn needle<const D: usize>(numbers: &[f32; NUMBERS], random: &mut Random) -> [[f32; D]; 2] {
    let &[_, direction, length, thickness, ref block @ ..] = numbers;
    let direction = (direction * D as f32) as usize % D;
    let center: [f32; D] = std::array::from_fn(|k| {
        let [place, extent] = [block[k % 3], block[3 + k % 3]];
        // Half of the blocks are as large as the world.
        let extent = 1e-4_f32.powf((2.0 * extent - 1.0).max(0.0));
        (4.0 * place).floor() / 4.0 + extent * random.range(-0.5, 0.5)
    });
    let half = |k: usize| match k == direction {
        true => 0.05 * 30_f32.powf(length),
        false => 0.005 * 1e-4_f32.powf(thickness),
    };
    let mins = std::array::from_fn(|k| center[k] - half(k));
    [mins, std::array::from_fn(|k| center[k] + half(k))]
}
