//! Joined bodies.

use super::hinge;
use super::ordered::at_both_levels;
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

/// Figures of six jointed bodies that fall on each other.
#[test]
fn a_heap_of_ragdolls() {
    at_both_levels(|mut worlds| {
        let twins = &mut worlds.twins;
        twins.insert_floor();
        let mut limbs = Vec::new();
        for figure in 0..5 {
            let [x, y] = [0.3 * (figure % 3) as Real, 1.2 + 2.2 * figure as Real];
            let (torso, _) = twins.insert(dynamic(x, y), cuboid([0.25, 0.4, 0.2]));
            let limb = || ColliderBuilder::capsule_y(0.25, 0.1);
            for (hip, shape) in [
                (at(0.0, 0.4), ColliderBuilder::ball(0.2)),
                (at(0.35, 0.3), limb()),
                (at(-0.35, 0.3), limb()),
                (at(0.15, -0.4), limb()),
                (at(-0.15, -0.4), limb()),
            ] {
                let end = at(0.0, if hip.x == 0.0 { -0.25 } else { 0.35 });
                let place = at(x, y) + hip - end;
                let (limb, collider) = twins.insert(dynamic(place.x, place.y), shape);
                let joint = hinge()
                    .local_anchor1(hip.into())
                    .local_anchor2(end.into())
                    .contacts_enabled(false);
                twins.both(|world| {
                    world.impulse_joints.insert(torso, limb, joint, true);
                });
                limbs.push(collider);
            }
        }
        let mut contacts = 0;
        for _ in 0..120 {
            let seen = worlds.step();
            contacts = contacts.max(seen.contacts.len());
        }
        assert!(contacts > 12, "only {contacts} contacts");
    });
}
