//! Parry's bounding volume hierarchy by itself, without what Rapier's broad phase does around it: one source,
//! compiled once in each dimension.
//!
//! Two ways to use it: a new tree for each frame, as for boxes out of nowhere; and a tree that is kept, whose
//! leaves are moved. All trees are traversed against themselves.

use super::parry;
use crate::kernels::contender::{Family, Kernel, Setting};
use crate::kernels::frame::Frame;
use anyhow::Result;
use parry::bounding_volume::Aabb;
use parry::math::{DIM, Point};
use parry::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};

/// A tree built for each frame, and a tree that is kept, each in the best of several ways.
pub(crate) fn families() -> Vec<Family<DIM>> {
    let setting =
        |(name, upkeep): (String, Upkeep)| Setting::new(name, move || Ok(Tree::new(upkeep)));
    let built = [
        ("binned".to_owned(), Upkeep::Build(BvhBuildStrategy::Binned)),
        ("PLOC".to_owned(), Upkeep::Build(BvhBuildStrategy::Ploc)),
    ];
    let period = |frames| {
        (
            format!("rebuilt one frame in {frames}"),
            Upkeep::RebuildOneIn(frames),
        )
    };
    let kept = [4, 8, MAX_PERIOD].map(period);
    let built = Family::new("Parry Bvh, new", built.map(setting));
    let mut kept = Family::new("Parry Bvh, kept", kept.map(setting));
    kept.least_frames = MAX_PERIOD;
    vec![built, kept]
}

/// Frames between two rebuilds at most. Without any, the tree would be twenty times slower after some hundred
/// frames than at first.
const MAX_PERIOD: usize = 16;

/// What is done to the tree before it is traversed.
#[derive(Clone, Copy)]
enum Upkeep {
    /// It is thrown away and built anew.
    Build(BvhBuildStrategy),
    /// Its leaves are moved and its inner nodes are built anew, in the same memory, in one of so many frames; in
    /// the others they are fitted.
    RebuildOneIn(usize),
}

struct Tree {
    upkeep: Upkeep,
    frame: usize,
    tree: Bvh,
    workspace: BvhWorkspace,
    pairs: Vec<[u32; 2]>,
}

impl Tree {
    fn new(upkeep: Upkeep) -> Self {
        Self {
            upkeep,
            frame: 0,
            tree: Bvh::new(),
            workspace: BvhWorkspace::default(),
            pairs: Vec::new(),
        }
    }
}

fn aabb(&[mins, maxs]: &[[f32; DIM]; 2]) -> Aabb {
    Aabb::new(Point::from(mins), Point::from(maxs))
}

fn move_leaves(tree: &mut Bvh, corners: &[[[f32; DIM]; 2]]) {
    for (index, corners) in corners.iter().enumerate() {
        // Without a margin: the boxes are to be these very ones.
        tree.insert_or_update_partially(aabb(corners), index as u32, 0.0);
    }
}

impl Kernel<DIM> for Tree {
    fn find_pairs(&mut self, frame: &Frame<DIM>) -> Result<()> {
        let (corners, tree, workspace) = (&frame.corners, &mut self.tree, &mut self.workspace);
        let build = |strategy| {
            let leaves = corners.iter().map(aabb).enumerate();
            Bvh::from_iter(strategy, leaves)
        };
        match self.upkeep {
            Upkeep::Build(strategy) => *tree = build(strategy),
            _ if tree.is_empty() => *tree = build(BvhBuildStrategy::Binned),
            Upkeep::RebuildOneIn(period) => {
                move_leaves(tree, corners);
                if self.frame.is_multiple_of(period) {
                    tree.rebuild(workspace, BvhBuildStrategy::Binned);
                }
                // Puts the nodes into the order in which they are visited.
                tree.refit(workspace);
            }
        }
        self.frame += 1;
        let pairs = &mut self.pairs;
        pairs.clear();
        tree.traverse_bvtt_single_tree::<false>(workspace, &mut |a, b| pairs.push([a, b]));
        Ok(())
    }

    fn pairs(&self) -> &[[u32; 2]] {
        &self.pairs
    }
}
