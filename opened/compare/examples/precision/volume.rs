//! A sum of a point, a ball and segments, whose interval along any axis is known.

/// A vector of `D` numbers.
pub(crate) type Vector<const D: usize> = [f64; D];

/// A ball, a capsule, or a box, turned in some way.
pub(crate) struct Volume<const D: usize> {
    pub(crate) center: Vector<D>,
    pub(crate) radius: f64,
    pub(crate) half_axes: Vec<Vector<D>>,
}

impl<const D: usize> Volume<D> {
    fn reach(&self, axis: &Vector<D>) -> f64 {
        let segments = self.half_axes.iter().map(|half| dot(half, axis).abs());
        self.radius * dot(axis, axis).sqrt() + segments.sum::<f64>()
    }

    /// Whether the balls around two volumes are apart.
    pub(crate) fn is_apart_by_balls(&self, other: &Self) -> bool {
        // The longest of the segments' sums: they are at right angles.
        let longest = |volume: &Self| {
            let squared = volume.half_axes.iter().map(|half| dot(half, half));
            volume.radius + squared.sum::<f64>().sqrt()
        };
        let between = self.to(other);
        dot(&between, &between).sqrt() > longest(self) + longest(other)
    }

    /// From one centre to the other.
    pub(crate) fn to(&self, other: &Self) -> Vector<D> {
        std::array::from_fn(|k| other.center[k] - self.center[k])
    }

    /// The point of its segments' sum that is nearest to another point.
    fn nearest(&self, point: &Vector<D>) -> Vector<D> {
        let from_center: Vector<D> = std::array::from_fn(|k| point[k] - self.center[k]);
        self.half_axes.iter().fold(self.center, |nearest, half| {
            let squared = dot(half, half);
            let part = if squared > 0.0 {
                (dot(&from_center, half) / squared).clamp(-1.0, 1.0)
            } else {
                0.0
            };
            std::array::from_fn(|k| nearest[k] + part * half[k])
        })
    }

    /// From a point to one of the other's that is nearly as near as any.
    pub(crate) fn shortest_to(&self, other: &Self) -> Vector<D> {
        let (mut here, mut there) = (self.center, other.center);
        for _ in 0..4 {
            here = self.nearest(&there);
            there = other.nearest(&here);
        }
        std::array::from_fn(|k| there[k] - here[k])
    }

    /// Whether the intervals of two volumes do not meet along one of these axes.
    pub(crate) fn is_apart<'a>(
        &self,
        other: &Self,
        axes: impl IntoIterator<Item = &'a Vector<D>>,
    ) -> bool {
        let between = self.to(other);
        let is_apart =
            |axis: &Vector<D>| dot(&between, axis).abs() > self.reach(axis) + other.reach(axis);
        axes.into_iter().any(is_apart)
    }
}

fn dot<const D: usize>(a: &Vector<D>, b: &Vector<D>) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The directions of a k-DOP with this many coordinates that are not zero: 1 for the axes of the world, 2 for the edges of a cube
/// or the corners of a square, 3 for the corners of a cube.
pub(crate) fn directions<const D: usize>(count: usize) -> Vec<Vector<D>> {
    let all = (0..3_usize.pow(D as u32))
        .map(|number| std::array::from_fn(|k| (number / 3_usize.pow(k as u32) % 3) as f64 - 1.0));
    let first = |direction: &Vector<D>| direction.iter().copied().find(|&x| x != 0.0);
    all.filter(|direction| direction.iter().filter(|&&x| x != 0.0).count() == count)
        .filter(|direction| first(direction) == Some(1.0))
        .collect()
}
