//! Joined bodies.

use super::hinge;
use super::rapier::prelude::*;
use super::twins::{Twins, at, cuboid, dynamic, fixed};

/// A chain that swings against a wall: of joints, and in reduced coordinates.
#[test]
fn a_chain() {
    for is_multibody in [false, true] {
        let mut twins = Twins::heavy();
        let (_, wall) = twins.insert(fixed(-1.6, -3.0), cuboid([0.5, 2.0, 3.0]));
        let (mut parent, _) = twins.insert(fixed(0.0, 0.0), ColliderBuilder::ball(0.1));
        let mut links = Vec::new();
        for i in 1..=3 {
            let (link, ball) = twins.insert(dynamic(i as Real, 0.0), ColliderBuilder::ball(0.4));
            let joint = hinge().local_anchor2(at(-1.0, 0.0).into());
            twins.both(|world| match is_multibody {
                true => {
                    let joints = &mut world.multibody_joints;
                    joints.insert(parent, link, joint, true).is_some()
                }
                false => {
                    let joints = &mut world.impulse_joints;
                    joints.insert(parent, link, joint, true).into_raw_parts().1 == 0
                }
            });
            links.push(ball);
            parent = link;
        }
        twins.step_until(|seen| links.iter().any(|&link| seen.touches(link, wall)));
        twins.steps(10);
    }
}
