//! Collision events in Rapier 0.36: beads fly through a sensor, and Rapier reports each bead that enters or leaves it.
//!
//! ```text
//! cargo run --release --bin collision_events
//! ```
//!
//! README.md says how to make the patched copy of Rapier first. A `Cargo.toml` of yours needs these lines below `[dependencies]`, with the
//! path to your clone of unisize:
//!
//! ```toml
//! oorandom = "11"
//! rapier3d = "=0.36.1"
//! unisize = { path = "../unisize", features = ["rapier3d-036"] }
//! ```
//!
//! Events arrive as they do without unisize, from `detect_collisions`, as here, and from `step_with_events`. Prints how many beads entered
//! and left. Fails if, after any step, the beads that entered and have not left are not the beads that Parry finds in the sensor.

use std::collections::HashSet;
use std::sync::mpsc::channel;

use rapier3d::parry::query::intersection_test;
use rapier3d::prelude::*;
use unisize::rapier3d_036::UnisizeBroadPhase;

const BEADS: usize = 2000;
/// Half the width of the space in which the beads fly.
const HALF: f32 = 4.0;
const STEPS: usize = 200;

fn main() {
    let mut random = oorandom::Rand32::new(36);
    let mut vector = |limit: f32| {
        let mut coordinate = || limit * (2.0 * random.rand_float() - 1.0);
        Vector::new(coordinate(), coordinate(), coordinate())
    };
    let mut world = PhysicsWorld::default();
    // The only line that changes.
    world.broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new());
    let sensor = ColliderBuilder::cuboid(1.0, 1.0, 1.0)
        .sensor(true)
        .active_events(ActiveEvents::COLLISION_EVENTS)
        // By default Rapier ignores pairs of kinematic and fixed colliders.
        .active_collision_types(ActiveCollisionTypes::all());
    let sensor = world.colliders.insert(sensor);
    let mut velocities = Vec::new();
    let mut beads = Vec::new();
    for _ in 0..BEADS {
        velocities.push(vector(4.0));
        let body = RigidBodyBuilder::kinematic_position_based().translation(vector(HALF));
        let (_, bead) = world.insert(body, ColliderBuilder::ball(0.1));
        beads.push(bead);
    }

    let dt = world.integration_parameters.dt;
    let (sender, events) = channel();
    // Events of other kinds go nowhere: of contact forces, and of soft bodies that tear.
    let event_handler = ChannelEventCollector::new(sender, channel().0, channel().0);
    let mut inside = HashSet::new();
    let [mut entered, mut left] = [0; 2];
    for step in 0..STEPS {
        // The program moves the beads, so the world only looks for collisions.
        world.detect_collisions(&(), &event_handler);
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

        let zone = &world.colliders[sensor];
        let is_inside = |bead: &&ColliderHandle| {
            let bead = &world.colliders[**bead];
            let test =
                intersection_test(zone.position(), zone.shape(), bead.position(), bead.shape());
            test.expect("Parry tests balls and cuboids").intersecting
        };
        let expected: HashSet<_> = beads.iter().filter(is_inside).copied().collect();
        assert!(inside == expected, "the events of step {step} are wrong");

        for ((_, body), velocity) in world.bodies.iter_mut().zip(&mut velocities) {
            let mut position = body.translation() + *velocity * dt;
            for axis in 0..3 {
                if position[axis].abs() > HALF {
                    position[axis] = position[axis].clamp(-HALF, HALF);
                    velocity[axis] = -velocity[axis];
                }
            }
            body.set_translation(position, true);
        }
    }
    println!("{BEADS} beads: {entered} entered the sensor and {left} left it");
    assert!(left > 0, "no bead left the sensor");
}
