//! broccoli, in two dimensions only: a kd-tree over boxes, with a sweep and prune in each node.
//!
//! Boxes are closed there as well. They lie in the tree by value, with their index. The one setting is the
//! height of the tree.

use super::contender::{Family, Setting};
use broccoli::aabb::BBox;
use broccoli::build::{DefaultSorter, TreeEmbryo};
use broccoli::{num_level, rect};

/// Boxes a leaf, of which broccoli makes the height; the third is its default. As it only takes odd heights,
/// those between would be the same.
const BOXES_A_LEAF: [usize; 4] = [5, 20, num_level::DEFAULT_NUMBER_ELEM_PER_NODE, 320];

/// broccoli at its best height.
pub(crate) fn family() -> Family<2> {
    Family::new("broccoli", BOXES_A_LEAF.map(setting))
}

fn setting(boxes_a_leaf: usize) -> Setting<2> {
    Setting::listing(format!("{boxes_a_leaf} boxes a leaf"), move || {
        let mut boxes: Vec<BBox<f32, u32>> = Vec::new();
        move |frame, pairs| {
            // The tree has put them into another order, so they are made anew.
            boxes.clear();
            boxes.extend((0..).zip(&frame.corners).map(|(index, [mins, maxs])| {
                BBox::new(rect(mins[0], maxs[0], mins[1], maxs[1]), index)
            }));
            let levels = num_level::with_num_elem_in_leaf(boxes.len(), boxes_a_leaf);
            let (mut embryo, root) = TreeEmbryo::with_num_level(&mut boxes, levels);
            embryo.recurse(root, &mut DefaultSorter);
            let mut tree = embryo.finish();
            tree.find_colliding_pairs(|a, b| pairs.push([a.inner, b.inner]));
            Ok(())
        }
    })
}
