//! What a graphics card draws: many bodies of a few shapes, each with a place and a brightness.

/// The shape of a batch, in a size of its own that the places scale.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Shape {
    /// A ball or disc of radius 1.
    Ball,
    /// A cube or square from -1 to 1.
    Cuboid,
    /// A capsule of radius 1 along the second axis, with a straight part of this length.
    Capsule(f32),
    /// A fixed ball or disc of radius 1.
    Rock,
    /// A fixed cuboid, which must not hide what is behind it.
    Wall,
}

impl Shape {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Ball => "ball",
            Self::Cuboid => "cuboid",
            Self::Capsule(_) => "capsule",
            Self::Rock => "rock",
            Self::Wall => "wall",
        }
    }

    pub(crate) fn length(self) -> f32 {
        match self {
            Self::Capsule(length) => length,
            _ => 0.0,
        }
    }
}

/// All bodies of one shape.
pub(crate) struct Batch {
    pub(crate) shape: Shape,
    /// Sixteen numbers for each body: the images of the three unit vectors, each and a zero, and where it is, with its brightness.
    pub(crate) places: Vec<f32>,
}

/// A picture of a world.
#[derive(Default)]
pub(crate) struct Drawing {
    pub(crate) batches: Vec<Batch>,
}

impl Drawing {
    /// Empties all batches. They stay, so that the page can keep what belongs to them.
    pub(crate) fn clear(&mut self) {
        for batch in &mut self.batches {
            batch.places.clear();
        }
    }

    /// Adds a body: the images of the three unit vectors, and its place.
    pub(crate) fn add(&mut self, shape: Shape, axes: [[f32; 3]; 3], place: [f32; 3], shade: f32) {
        let batch = self.batch(shape);
        for axis in axes {
            batch.places.extend(axis);
            batch.places.push(0.0);
        }
        batch.places.extend(place);
        batch.places.push(shade);
    }

    fn batch(&mut self, shape: Shape) -> &mut Batch {
        let found = self.batches.iter().position(|batch| batch.shape == shape);
        let index = found.unwrap_or_else(|| {
            self.batches.push(Batch {
                shape,
                places: Vec::new(),
            });
            self.batches.len() - 1
        });
        &mut self.batches[index]
    }
}
