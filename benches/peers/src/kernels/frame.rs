//! The boxes of one moment, as plain arrays.

use unisize::Aabb;
use unisize_scenes::DriftingBoxes;

/// What a kernel is given. Whatever else it needs is built from this, as a part of its time.
pub(crate) struct Frame<const D: usize> {
    /// For unisize.
    pub(crate) boxes: Vec<Aabb<f32, D>>,
    /// For all others, the same: the least coordinates of each box, then the greatest.
    pub(crate) corners: Vec<[[f32; D]; 2]>,
}

impl<const D: usize> Frame<D> {
    pub(crate) fn new() -> Self {
        Self {
            boxes: Vec::new(),
            corners: Vec::new(),
        }
    }

    /// Shows the boxes as they are now.
    pub(crate) fn show(&mut self, drifting: &DriftingBoxes<D>) {
        let corners = |mins: &[f32; D]| [*mins, mins.map(|x| x + DriftingBoxes::<D>::SIZE)];
        self.corners.clear();
        self.corners.extend(drifting.mins().iter().map(corners));
        self.boxes.clear();
        let aabb = |&[mins, maxs]: &[[f32; D]; 2]| Aabb::new(mins, maxs);
        self.boxes.extend(self.corners.iter().map(aabb));
    }
}
