//! Collision events: beads fly through a sensor, and Rapier reports each bead that enters or leaves it.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example collision_events
//! ```
//!
//! Events arrive as they do without unisize, from `CollisionPipeline`, as here, and from `PhysicsPipeline`. This is Rapier 0.27;
//! `examples/patched/src/bin/collision_events.rs` does the same in 0.36. Prints how many beads entered and left. Fails if, after any step,
//! the beads that entered and have not left are not the beads that Parry finds in the sensor.

use std::collections::HashSet;
use std::sync::mpsc::channel;

use rapier3d::parry::query::intersection_test;
use rapier3d::prelude::*;
use unisize::rapier3d_027::UnisizeBroadPhase;

const BEADS: usize = 2000;
/// Half the width of the space in which the beads fly.
const HALF: f32 = 4.0;
const STEPS: usize = 200;

fn main() {
    let mut random = oorandom::Rand32::new(36);
    let mut vector = |limit: f32| Vector::from_fn(|_, _| limit * (2.0 * random.rand_float() - 1.0));
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    let sensor = ColliderBuilder::cuboid(1.0, 1.0, 1.0)
        .sensor(true)
        .active_events(ActiveEvents::COLLISION_EVENTS)
        // By default Rapier ignores pairs of kinematic and fixed colliders.
        .active_collision_types(ActiveCollisionTypes::all());
    let sensor = colliders.insert(sensor);
    let mut velocities = Vec::new();
    let mut beads = Vec::new();
    for _ in 0..BEADS {
        velocities.push(vector(4.0));
        let body = RigidBodyBuilder::kinematic_position_based().translation(vector(HALF));
        let body = bodies.insert(body);
        let bead = ColliderBuilder::ball(0.1);
        beads.push(colliders.insert_with_parent(bead, body, &mut bodies));
    }

    let dt = 1.0 / 60.0;
    let mut pipeline = CollisionPipeline::new();
    let mut broad_phase = UnisizeBroadPhase::new();
    let mut narrow_phase = NarrowPhase::new();
    let (sender, events) = channel();
    let event_handler = ChannelEventCollector::new(sender, channel().0);
    let mut inside = HashSet::new();
    let [mut entered, mut left] = [0; 2];
    for step in 0..STEPS {
        pipeline.step(
            0.0,
            &mut broad_phase,
            &mut narrow_phase,
            &mut bodies,
            &mut colliders,
            &(),
            &event_handler,
        );
        for event in events.try_iter() {
            let (collider1, collider2) = (event.collider1(), event.collider2());
            let bead = if collider1 == sensor {
                collider2
            } else {
                collider1
            };
            if event.started() {
                assert!(inside.insert(bead), "a bead entered twice");
                entered += 1;
            } else {
                assert!(inside.remove(&bead), "a bead left that was not inside");
                left += 1;
            }
        }

        let zone = &colliders[sensor];
        let is_inside = |bead: &&ColliderHandle| {
            let bead = &colliders[**bead];
            let test =
                intersection_test(bead.position(), bead.shape(), zone.position(), zone.shape());
            test.expect("Parry tests balls and cuboids")
        };
        let expected: HashSet<_> = beads.iter().filter(is_inside).copied().collect();
        assert!(inside == expected, "the events of step {step} are wrong");

        for ((_, body), velocity) in bodies.iter_mut().zip(&mut velocities) {
            let mut position = body.translation() + *velocity * dt;
            for axis in 0..3 {
                if position[axis].abs() > HALF {
                    position[axis] = position[axis].clamp(-HALF, HALF);
                    velocity[axis] = -velocity[axis];
                }
            }
            body.set_translation(position, true);
        }
        bodies.propagate_modified_body_positions_to_colliders(&mut colliders);
    }
    println!("{BEADS} beads: {entered} entered the sensor and {left} left it");
    assert!(left > 0, "no bead left the sensor");
}
