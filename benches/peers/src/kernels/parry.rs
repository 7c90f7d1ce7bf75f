//! Parry's bounding volume hierarchy by itself, without what Rapier's broad phase does around it: one source,
//! compiled once in each dimension.
//!
//! Two ways to use it: a new tree for each frame, as for boxes out of nowhere; and a tree that is kept, whose
//! leaves are moved. All trees are traversed against themselves.

use super::parry;
use crate::kernels::contender::{Family, Setting};
use parry::bounding_volume::Aabb;
use parry::math::{DIM, Point};
use parry::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};

/// A tree built for each frame, and a tree that is kept, each in the best of several ways.
pub(crate) fn families() -> Vec<Family<DIM>> {
    let built = [
        setting("binned", Upkeep::Build(BvhBuildStrategy::Binned)),
        setting("PLOC", Upkeep::Build(BvhBuildStrategy::Ploc)),
    ];
    let kept = [8, 16, MAX_PERIOD].map(|frames| {
        let name = format!("rebuilt one frame in {frames}");
        setting(&name, Upkeep::RebuildOneIn(frames))
    });
    let mut kept = Family::new("Parry Bvh, kept", kept);
    kept.least_frames = MAX_PERIOD;
    vec![Family::new("Parry Bvh, new", built), kept]
}

/// Frames between two rebuilds at most. Without any, the tree would be twenty times slower after some hundred
/// frames than at first.
const MAX_PERIOD: usize = 32;

/// What is done to the tree before it is traversed.
#[derive(Clone, Copy)]
enum Upkeep {
    /// It is thrown away and built anew.
    Build(BvhBuildStrategy),
    /// Its leaves are moved and its inner nodes are built anew, in the same memory, in one of so many frames; in
    /// the others they are fitted.
    RebuildOneIn(usize),
}

fn setting(name: &str, upkeep: Upkeep) -> Setting<DIM> {
    Setting::listing(name, move || {
        let (mut tree, mut workspace) = (Bvh::new(), BvhWorkspace::default());
        let mut frames = 0_usize;
        move |frame, pairs| {
            let build = |strategy| {
                let leaves = frame.corners.iter().map(aabb).enumerate();
                Bvh::from_iter(strategy, leaves)
            };
            match upkeep {
                Upkeep::Build(strategy) => tree = build(strategy),
                _ if tree.is_empty() => tree = build(BvhBuildStrategy::Binned),
                Upkeep::RebuildOneIn(period) => {
                    move_leaves(&mut tree, &frame.corners);
                    if frames.is_multiple_of(period) {
                        tree.rebuild(&mut workspace, BvhBuildStrategy::Binned);
                    }
                    // Puts the nodes into the order in which they are visited.
                    tree.refit(&mut workspace);
                }
            }
            frames += 1;
            let push = &mut |a, b| pairs.push([a, b]);
            tree.traverse_bvtt_single_tree::<false>(&mut workspace, push);
            Ok(())
        }
    })
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
