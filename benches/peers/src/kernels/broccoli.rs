//! broccoli, in two dimensions only: a kd-tree over boxes, with a sweep and prune in each node.
//!
//! Boxes are closed there as well. They lie in the tree by value, with their index. The one setting is the
//! height of the tree.

use super::contender::{Family, Kernel, Setting};
use super::frame::Frame;
use anyhow::Result;
use broccoli::aabb::BBox;
use broccoli::build::{DefaultSorter, TreeEmbryo};
use broccoli::{num_level, rect};

/// Boxes a leaf, of which broccoli makes the height; the third is its default. As it only takes odd heights,
/// those between would be the same.
const BOXES_A_LEAF: [usize; 4] = [5, 20, num_level::DEFAULT_NUMBER_ELEM_PER_NODE, 320];

/// broccoli at its best height.
pub(crate) fn family() -> Family<2> {
    let setting = |boxes_a_leaf| {
        Setting::new(format!("{boxes_a_leaf} boxes a leaf"), move || {
            Ok(Broccoli {
                boxes_a_leaf,
                boxes: Vec::new(),
                pairs: Vec::new(),
            })
        })
    };
    Family::new("broccoli", BOXES_A_LEAF.map(setting))
}

struct Broccoli {
    boxes_a_leaf: usize,
    boxes: Vec<BBox<f32, u32>>,
    pairs: Vec<[u32; 2]>,
}

impl Kernel<2> for Broccoli {
    fn find_pairs(&mut self, frame: &Frame<2>) -> Result<()> {
        let bbox = |(index, &[mins, maxs]): (usize, &[[f32; 2]; 2])| {
            BBox::new(rect(mins[0], maxs[0], mins[1], maxs[1]), index as u32)
        };
        // The tree has put them into another order, so they are made anew.
        self.boxes.clear();
        self.boxes
            .extend(frame.corners.iter().enumerate().map(bbox));
        let levels = num_level::with_num_elem_in_leaf(self.boxes.len(), self.boxes_a_leaf);
        let (mut embryo, root) = TreeEmbryo::with_num_level(&mut self.boxes, levels);
        embryo.recurse(root, &mut DefaultSorter);
        let mut tree = embryo.finish();

        let pairs = &mut self.pairs;
        pairs.clear();
        tree.find_colliding_pairs(|a, b| pairs.push([a.inner, b.inner]));
        Ok(())
    }

    fn pairs(&self) -> &[[u32; 2]] {
        &self.pairs
    }
}
