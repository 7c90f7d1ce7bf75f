//! A trial that looks on while a world runs on Rapier's own broad phase, as it has to where Rapier is not patched.

use super::rapier::prelude::*;
use super::twins::{cuboid, dynamic};
use super::{PairFilter, Trial};

#[test]
fn pairs_are_compared_from_outside() {
    let mut world = PhysicsWorld::default();
    world.insert(RigidBodyBuilder::fixed(), cuboid([10.0, 0.5, 10.0]));
    let mut trial = Trial::new();
    let (ball, mut balls) = (ColliderBuilder::ball(0.5), Vec::new());
    for step in 0..120 {
        if step % 10 == 0 {
            // Neighbors are at two heights, so that their boxes overlap and they do not touch.
            let y = if step % 20 == 0 { 3.0 } else { 3.7 };
            let place = dynamic(0.1 * step as Real - 6.0, y);
            balls.push(world.insert(place, ball.clone()));
        }
        if step % 40 == 39 {
            // Nobody is told that they may meet others than before.
            let groups = match step {
                39 => InteractionGroups::none(),
                _ => InteractionGroups::all(),
            };
            world.colliders[balls[2].1].set_collision_groups(groups);
        }
        if step % 25 == 24 {
            // The next one gets its index.
            world.remove_body(balls.swap_remove(0).0);
        }
        world.step();
        trial.observe(
            &world.integration_parameters,
            &world.colliders,
            &world.bodies,
        );
    }
    let report = trial.report();
    assert!(report.pairs_match(), "{report}");
    assert_eq!(report.colliders, world.colliders.len());
    let [groups, shapes] =
        [PairFilter::Groups, PairFilter::Shapes].map(|level| report.level(level).pairs);
    assert!(groups > 1.0 && shapes < groups, "{report}");
    assert!(report.updates >= 120);
}
