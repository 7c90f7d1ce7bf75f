//! Where the colliders are in each frame.

use super::motion::Motion;
use super::sizes::Sizes;
use unisize::Aabb;
use unisize_scenes::DriftingBoxes;

/// So much farther than any margin that every box is renewed.
const LEAP: f32 = 0.1;

/// Half of the smallest margin, which is 0.01 in Rapier 0.27.
const NUDGE: f32 = 0.005;

/// Cubes that drift about, or those of them that do. Equal arguments make equal frames.
#[derive(Clone)]
pub(crate) struct Choreography<const D: usize> {
    boxes: DriftingBoxes<D>,
    motion: Motion,
    sizes: Sizes,
    sides: Vec<f32>,
    frame: usize,
    centers: Vec<[f32; D]>,
}

impl<const D: usize> Choreography<D> {
    /// Before the first frame.
    pub(crate) fn new(count: usize, density: f64, motion: Motion, sizes: Sizes) -> Self {
        let sides = sizes.sides(count);
        // As if all were cubes of side 1, but in as much more space as they fill.
        let volume: f64 = sides
            .iter()
            .map(|&side| f64::from(side).powi(D as i32))
            .sum();
        let boxes = DriftingBoxes::new(count, density * count as f64 / volume, 7);
        let centers = boxes.mins().iter().map(center).collect();
        Self {
            boxes,
            motion,
            sizes,
            sides,
            frame: 0,
            centers,
        }
    }

    pub(crate) fn motion(&self) -> Motion {
        self.motion
    }

    /// What moves, and how large it is, in words.
    pub(crate) fn title(&self) -> String {
        format!("{}{}", self.motion, self.sizes)
    }

    /// Whether some are a hundred times as large as others.
    pub(crate) fn has_large(&self) -> bool {
        self.sizes == Sizes::FewLarge
    }

    /// The side of each cube.
    pub(crate) fn sides(&self) -> &[f32] {
        &self.sides
    }

    pub(crate) fn centers(&self) -> &[[f32; D]] {
        &self.centers
    }

    /// On to the next frame. Those that are not listed stay where they were.
    pub(crate) fn advance(&mut self) {
        let (stride, offset) = match self.motion {
            Motion::OneIn(stride) => {
                self.boxes.advance();
                (stride, 0.0)
            }
            Motion::AllForLong => {
                self.boxes.advance();
                (1, 0.0)
            }
            // The first frame takes boxes out of their place, for only then do they get a margin.
            Motion::InMargin => (1, LEAP + NUDGE * (self.frame % 2) as f32),
            Motion::Nothing => return,
        };
        self.frame += 1;
        let places = self.centers.iter_mut().zip(self.boxes.mins());
        for (place, min) in places.step_by(stride) {
            *place = center(min);
            place[0] += offset;
        }
    }

    /// The boxes themselves, without any margin, and this part of their size smaller.
    pub(crate) fn boxes(&self, smaller: f32) -> Vec<Aabb<f32, D>> {
        let around = |(center, side): (&[f32; D], &f32)| {
            let half = side * (1.0 - smaller) / 2.0;
            Aabb::new(center.map(|x| x - half), center.map(|x| x + half))
        };
        self.centers.iter().zip(&self.sides).map(around).collect()
    }
}

fn center<const D: usize>(min: &[f32; D]) -> [f32; D] {
    min.map(|x| x + DriftingBoxes::<D>::SIZE / 2.0)
}
