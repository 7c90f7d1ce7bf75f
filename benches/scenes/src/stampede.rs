//! A herd that stampedes around a ring, each animal avoiding its neighbours.

use crate::random::Random;

/// A herd in two dimensions without an engine: animals run around in a ring, as fast as each can, and steer clear of those
/// near them.
///
/// Finding out who is near is up to the caller: boxes of [`NEIGHBOURHOOD`](Self::NEIGHBOURHOOD) on every side of an
/// animal overlap if two are within twice that distance along both axes, and the pairs of such boxes are handed to
/// [`advance`](Self::advance). This is the neighbour search of section 6 of Capannini and Larsson, *Output Sensitive
/// Collision Detection for Unisize Boxes*.
#[derive(Clone, Debug)]
pub struct Stampede {
    places: Vec<[f32; 2]>,
    velocities: Vec<[f32; 2]>,
    /// The speed that each animal would like to run at, in metres per second.
    paces: Vec<f32>,
    /// Accelerations, in metres per second squared; scratch memory.
    pushes: Vec<[f32; 2]>,
    /// The radius of the middle of the ring.
    radius: f32,
    half_width: f32,
}

/// Animals per square metre.
const DENSITY: f32 = 0.3;
/// The width of the ring as a share of its middle radius.
const WIDTH: f32 = 0.4;
/// The seconds that an animal takes to reach its pace if nothing is in its way.
const EAGERNESS: f32 = 0.5;
/// The acceleration of two animals that are nearly in one place, in metres per second squared.
const SHYNESS: f32 = 60.0;
/// The greatest acceleration of an animal, in metres per second squared.
const STRENGTH: f32 = 25.0;

impl Stampede {
    /// Half the side of the box of its neighbourhood, in metres.
    pub const NEIGHBOURHOOD: f32 = 1.0;

    /// Seconds between two frames.
    pub const STEP: f32 = 1.0 / 60.0;

    /// A herd of `count` animals. Equal arguments, and equal pairs in every frame, make an equal stampede. **O(n)**.
    pub fn new(count: usize, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let mut herd = Self::part(count, []);
        let (radius, half_width) = (herd.radius, herd.half_width);
        for _ in 0..count {
            let angle: f32 = random.range(0.0, std::f32::consts::TAU);
            // Uniform over the area.
            let [inner, outer] = [radius - half_width, radius + half_width].map(|r| r * r);
            let distance = random.range(inner, outer).sqrt();
            let (sin, cos) = angle.sin_cos();
            let pace = random.range(4.0, 8.0);
            herd.places.push([cos * distance, sin * distance]);
            herd.velocities.push([-sin * pace, cos * pace]);
            herd.paces.push(pace);
        }
        herd
    }

    /// Some animals of a herd of `count`, each with its place, velocity and pace. They move as they do in the whole herd if
    /// they are in the same order, and [`advance`](Self::advance) is given all their pairs, in the same order too. **O(n)**.
    pub fn part(
        count: usize,
        animals: impl IntoIterator<Item = ([f32; 2], [f32; 2], f32)>,
    ) -> Self {
        // The area of the ring is 2 π · radius · width.
        let area = count as f32 / DENSITY;
        let radius = (area / (std::f32::consts::TAU * WIDTH)).sqrt();
        let mut herd = Self {
            places: Vec::new(),
            velocities: Vec::new(),
            paces: Vec::new(),
            pushes: Vec::new(),
            radius,
            half_width: radius * WIDTH / 2.0,
        };
        for (place, velocity, pace) in animals {
            herd.places.push(place);
            herd.velocities.push(velocity);
            herd.paces.push(pace);
        }
        herd
    }

    /// Where the animals are.
    pub fn places(&self) -> &[[f32; 2]] {
        &self.places
    }

    /// The velocities, in metres per second.
    pub fn velocities(&self) -> &[[f32; 2]] {
        &self.velocities
    }

    /// The speeds that the animals would like to run at, in metres per second.
    pub fn paces(&self) -> &[f32] {
        &self.paces
    }

    /// Moves on to the next frame; animals avoid those that they form a pair with. Pairs that are not near have no
    /// effect, and those of animals that do not exist are ignored. **O(n + pairs)**.
    pub fn advance(&mut self, pairs: impl IntoIterator<Item = [u32; 2]>) {
        self.pushes.clear();
        self.pushes.resize(self.places.len(), [0.0; 2]);
        for [a, b] in pairs {
            let [a, b] = [a as usize, b as usize];
            if let (Some(&place_a), Some(&place_b)) = (self.places.get(a), self.places.get(b)) {
                let push = shyness(place_a, place_b);
                for axis in 0..2 {
                    self.pushes[a][axis] += push[axis];
                    self.pushes[b][axis] -= push[axis];
                }
            }
        }
        for i in 0..self.places.len() {
            let push = self.pushes[i];
            let wish = self.wish(i);
            let velocity = &mut self.velocities[i];
            let mut gain: [f32; 2] =
                std::array::from_fn(|axis| (wish[axis] - velocity[axis]) / EAGERNESS + push[axis]);
            let size = gain[0].hypot(gain[1]);
            if size > STRENGTH {
                gain = gain.map(|x| x * STRENGTH / size);
            }
            for axis in 0..2 {
                velocity[axis] += gain[axis] * Self::STEP;
                self.places[i][axis] += velocity[axis] * Self::STEP;
            }
        }
    }

    /// The velocity that an animal would like to have: along the ring, and back to it when it is outside.
    fn wish(&self, i: usize) -> [f32; 2] {
        let [x, y] = self.places[i];
        let distance = x.hypot(y).max(f32::MIN_POSITIVE);
        let [outward_x, outward_y] = [x / distance, y / distance];
        let astray = (distance - self.radius) / self.half_width;
        let back = if astray.abs() > 1.0 {
            -astray.signum()
        } else {
            0.0
        };
        let pace = self.paces[i];
        [
            (back * outward_x - outward_y) * pace,
            (back * outward_y + outward_x) * pace,
        ]
    }
}

/// The force that drives the first away from the second.
fn shyness(a: [f32; 2], b: [f32; 2]) -> [f32; 2] {
    let way = [a[0] - b[0], a[1] - b[1]];
    let distance = way[0].hypot(way[1]);
    let reach = 2.0 * Stampede::NEIGHBOURHOOD;
    if distance >= reach || distance == 0.0 {
        return [0.0; 2];
    }
    let closeness = 1.0 - distance / reach;
    let push = SHYNESS * closeness * closeness;
    way.map(|x| x / distance * push)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every pair that is no further apart than this, by brute force.
    fn pairs(herd: &Stampede, most: f32) -> Vec<[u32; 2]> {
        let places = herd.places();
        let all = (0..places.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let near = all.filter(|&(i, j)| {
            let [x, y] = [0, 1].map(|axis| places[i][axis] - places[j][axis]);
            x.hypot(y) <= most
        });
        near.map(|(i, j)| [i as u32, j as u32]).collect()
    }

    #[test]
    fn animals_that_see_each_other_keep_apart_and_stay_in_their_ring() {
        let mut blind = Stampede::new(400, 7);
        let mut herd = blind.clone();
        let mut collisions = [0, 0];
        for frame in 0..300 {
            blind.advance([]);
            let seen = pairs(&herd, 2.0 * Stampede::NEIGHBOURHOOD);
            herd.advance(seen);
            // By then the start no longer matters.
            if frame >= 120 {
                for (herd, count) in [&blind, &herd].into_iter().zip(&mut collisions) {
                    *count += pairs(herd, 0.8).len();
                }
            }
        }
        let [of_blind, of_seeing] = collisions;
        assert!(of_blind > 1000 && of_seeing < of_blind / 10);
        let [inner, outer] = [-1.0, 1.0].map(|side| herd.radius + side * herd.half_width);
        for [x, y] in herd.places() {
            assert!((0.7 * inner..=1.3 * outer).contains(&x.hypot(*y)));
        }
        let paces = herd.velocities().iter().map(|[x, y]| x.hypot(*y));
        assert!(paces.sum::<f32>() / 400.0 > 3.0);
        herd.advance([[0, 1_000_000]]);
    }
}
