//! Boxes of one size that drift about: what the kernels are measured on, without any engine.

use crate::random::Random;

/// The most that a box moves between two frames, along each axis: a tenth of its side, like a body of one metre
/// at six metres per second. So most boxes leave the margin of a broad phase in every frame.
const MAX_SPEED: f32 = 0.1;

/// Boxes of side 1 that drift about in a square or cube and bounce from its borders, after the first
/// experiment of Capannini and Larsson, *Output Sensitive Collision Detection for Unisize Boxes*.
///
/// Places and velocities are uniform, and bouncing keeps them so: every frame has about as many overlapping
/// pairs as any other, some `2ᴰ / 2 · density` for each box.
#[derive(Clone, Debug)]
pub struct DriftingBoxes<const D: usize> {
    mins: Vec<[f32; D]>,
    velocities: Vec<[f32; D]>,
    /// The greatest lower corner.
    reach: [f32; D],
}

impl<const D: usize> DriftingBoxes<D> {
    /// The side of every box.
    pub const SIZE: f32 = 1.0;

    /// `count` boxes, in an environment of which they would fill the share `density` if they did not overlap.
    /// Equal arguments give equal boxes in every frame. **O(n)**.
    ///
    /// The paper has densities between 0.1 and 1; any positive one will do. Where the environment would be
    /// smaller than a box, it is as large as one.
    pub fn new(count: usize, density: f64, seed: u64) -> Self {
        let side = (count as f64 / density).powf(1.0 / D as f64);
        Self::within([side; D], count, seed)
    }

    /// The same in a layer of this thickness, along the last axis: at 1, no box can move along it. The other sides of the
    /// environment are so long that its density is as given. **O(n)**.
    pub fn in_layer(count: usize, density: f64, thickness: f64, seed: u64) -> Self {
        let area = count as f64 / (density * thickness);
        let mut sides = [area.powf(1.0 / (D - 1) as f64); D];
        sides[D - 1] = thickness;
        Self::within(sides, count, seed)
    }

    fn within(sides: [f64; D], count: usize, seed: u64) -> Self {
        let reach = sides.map(|side| (side as f32 - Self::SIZE).max(0.0));
        let mut random = Random::new(seed);
        let mut corners = |lo: [f32; D], hi: [f32; D]| {
            let corner = |_| std::array::from_fn(|axis| random.range(lo[axis], hi[axis]));
            (0..count).map(corner).collect()
        };
        Self {
            mins: corners([0.0; D], reach),
            velocities: corners([-MAX_SPEED; D], [MAX_SPEED; D]),
            reach,
        }
    }

    /// Moves every box on to the next frame. **O(n)**.
    pub fn advance(&mut self) {
        for (min, velocity) in self.mins.iter_mut().zip(&mut self.velocities) {
            for ((x, v), reach) in min.iter_mut().zip(velocity).zip(self.reach) {
                *x += *v;
                if *x < 0.0 {
                    *x = -*x;
                    *v = -*v;
                } else if *x > reach {
                    *x = 2.0 * reach - *x;
                    *v = -*v;
                }
                // In an environment that is hardly larger than a box, one bounce may not be enough.
                *x = x.clamp(0.0, reach);
            }
        }
    }

    /// The lower corner of each box in this frame. The upper one is [`SIZE`](Self::SIZE) further on every
    /// axis.
    pub fn mins(&self) -> &[[f32; D]] {
        &self.mins
    }
}

#[cfg(test)]
mod tests {
    use super::DriftingBoxes;

    #[test]
    fn as_many_pairs_overlap_as_chance_has_it() {
        const COUNT: usize = 1 << 12;
        let mut boxes = DriftingBoxes::<2>::new(COUNT, 0.5, 7);
        // Of two numbers in 0..reach, the chance to be no more than 1 apart: (2 · reach - 1) / reach².
        let reach = (COUNT as f64 / 0.5).sqrt() - 1.0;
        let chance = ((2.0 * reach - 1.0) / (reach * reach)).powi(2);
        let expected = (COUNT * (COUNT - 1) / 2) as f64 * chance;
        // Pairs are nearly independent of each other, so their number is nearly Poisson distributed.
        let allowed = 5.0 * expected.sqrt();
        for _ in 0..3 {
            let mins = boxes.mins();
            let overlap =
                |i: usize, j: usize| (0..2).all(|k| (mins[i][k] - mins[j][k]).abs() <= 1.0);
            let before = |i: usize| (0..i).filter(|&j| overlap(i, j)).count();
            let found = (0..COUNT).map(before).sum::<usize>() as f64;
            assert!(
                (found - expected).abs() < allowed,
                "{found}, not {expected}"
            );
            (0..1000).for_each(|_| boxes.advance());
        }
    }

    #[test]
    fn boxes_stay_inside_whatever_the_density() {
        for density in [1e-3, 0.5, 50.0, 99.9, 100.0, 1e9] {
            let mut boxes = DriftingBoxes::<3>::new(100, density, 7);
            let reach = boxes.reach;
            for _ in 0..100 {
                boxes.advance();
                let inside = |x: &f32| (0.0..=reach[0]).contains(x);
                assert!(boxes.mins().iter().flatten().all(inside), "{density}");
            }
        }
    }

    #[test]
    fn a_layer_has_its_thickness_and_density() {
        for thickness in [1.0, 2.5, 8.0] {
            let mut boxes = DriftingBoxes::<3>::in_layer(10_000, 0.2, thickness, 7);
            (0..50).for_each(|_| boxes.advance());
            let extent = |axis| {
                let along = boxes.mins().iter().map(|mins| f64::from(mins[axis]));
                1.0 + along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
            };
            let [x, y, z] = [0, 1, 2].map(extent);
            assert!((z - thickness).abs() < 0.01 * thickness, "{z}");
            let density = 10_000.0 / (x * y * z);
            assert!((density - 0.2).abs() < 0.01, "{density}");
        }
    }
}
