//! Boxes of several populations with a few parameters, which a search for hard boxes varies.

use super::random::Random;

/// The number of populations in a mixture.
const POPULATIONS: usize = 3;

/// The number of parameters of a population.
const NUMBERS: usize = 9;

/// Boxes of three populations, with parameters between 0 and 1.
///
/// The parameters of a population are its share of the boxes, their size, the variation of sizes, the ratio of length to width and the long
/// axis, the density and the shape of the space that they fill, and their distance. Any numbers give a mixture, so a search may vary them
/// freely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mixture(pub(super) [[f32; NUMBERS]; POPULATIONS]);

/// The parameters of one population.
struct Population<const D: usize> {
    share: f32,
    size: f32,
    /// The ratio of the largest to the smallest size.
    variety: f32,
    aspect: f32,
    /// The long axis; if it is `D`, each axis in turn.
    long_axis: usize,
    /// Whether the axis is the only short one instead.
    is_flat: bool,
    /// The extent of the space along each axis.
    spread: [f32; D],
    /// The offset along each axis.
    offset: [f32; D],
}

impl Mixture {
    /// A random mixture.
    pub fn random(seed: u64) -> Self {
        let random = &mut Random::new(seed);
        Self([[(); NUMBERS]; POPULATIONS].map(|numbers| numbers.map(|()| random.range(0.0, 1.0))))
    }

    /// This mixture with one or two parameters changed.
    pub fn varied(mut self, seed: u64) -> Self {
        let random = &mut Random::new(seed);
        for _ in 0..1 + random.index(2) {
            let number = &mut self.0[random.index(POPULATIONS)][random.index(NUMBERS)];
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
        let populations: Vec<Population<D>> = self
            .0
            .iter()
            .map(|numbers| Population::of(numbers, count))
            .collect();
        let all: f32 = populations.iter().map(|population| population.share).sum();
        let mut boxes = Vec::with_capacity(count);
        for (i, population) in populations.iter().enumerate() {
            let end = match i + 1 == populations.len() {
                true => count,
                false => {
                    let share = (population.share / all * count as f32) as usize;
                    (boxes.len() + share).min(count)
                }
            };
            while boxes.len() < end {
                boxes.push(population.draw(boxes.len(), random));
            }
        }
        boxes
    }
}

impl<const D: usize> Population<D> {
    fn of(numbers: &[f32; NUMBERS], count: usize) -> Self {
        let &[
            share,
            size,
            variety,
            aspect,
            axis,
            density,
            shape,
            distance,
            direction,
        ] = numbers;
        let power = |least: f32, most: f32, x: f32| least * (most / least).powf(x);
        let size = power(0.01, 100.0, size);
        let long_axis = (axis * 2.0 * (D + 1) as f32) as usize % (D + 1);
        // The sum of their volumes, times a factor.
        let each = size * power(0.2, 100.0, density);
        let length = each * (count as f32).powf(1.0 / D as f32);
        // A line along one axis, a plane across one, or a cube.
        let which = (shape * (2 * D + 2) as f32) as usize;
        let spread = std::array::from_fn(|k| match which {
            w if w < D && k == w => each * count as f32,
            w if w < D => size,
            w if w < 2 * D && k == w - D => size,
            _ => length,
        });
        let away = match distance {
            ..0.5 => 0.0,
            _ => power(1.0, 1e12, 2.0 * distance - 1.0),
        };
        let offset =
            std::array::from_fn(|k| match (direction * (1 << D) as f32) as usize >> k & 1 {
                0 => 0.0,
                _ => away,
            });
        Self {
            share: power(0.001, 1.0, share),
            size,
            variety: power(1.0, 1e4, (variety * 2.0 - 1.0).max(0.0)),
            aspect: power(1.0, 1e4, (aspect * 1.5 - 0.5).max(0.0)),
            long_axis,
            is_flat: axis >= 0.5,
            spread,
            offset,
        }
    }

    fn draw(&self, i: usize, random: &mut Random) -> [[f32; D]; 2] {
        let size = self.size * self.variety.powf(random.range(0.0, 1.0));
        let long_axis = match self.long_axis == D {
            true => i % D,
            false => self.long_axis,
        };
        let mins: [f32; D] =
            std::array::from_fn(|k| self.offset[k] + random.range(0.0, self.spread[k]));
        let sides = std::array::from_fn(|k| match (k == long_axis) ^ self.is_flat {
            true => size * self.aspect,
            false => size,
        });
        [mins, add(mins, sides)]
    }
}

fn add<const D: usize>(a: [f32; D], b: [f32; D]) -> [f32; D] {
    std::array::from_fn(|k| a[k] + b[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<const D: usize>(mixture: &Mixture, count: usize) {
        let boxes = mixture.boxes::<D>(count, 7);
        assert_eq!(boxes.len(), count, "{mixture:?}");
        for [mins, maxs] in boxes {
            assert!((0..D).all(|k| mins[k] <= maxs[k]), "{mixture:?}: {mins:?}");
        }
    }

    #[test]
    fn any_parameters_give_a_mixture() {
        let extremes = [0.0, 1.0].map(|x| Mixture([[x; NUMBERS]; POPULATIONS]));
        let random = (0..200).map(|seed| Mixture::random(seed).varied(seed));
        for mixture in extremes.into_iter().chain(random) {
            for count in [0, 1, 1000] {
                check::<2>(&mixture, count);
                check::<3>(&mixture, count);
            }
        }
    }
}
