//! Contacts that reach farther from one step to the next, because a user has changed a skin, a soft-CCD prediction, the prediction
//! distance or a shape while two bodies are about to meet. None may be lost that Rapier's own broad phase finds.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cuboid, dynamic};
use super::{PairFilter, UnisizeBroadPhase};

/// A body that flies at a wall.
struct Flight {
    twins: Twins,
    wall: ColliderHandle,
    body: RigidBodyHandle,
    collider: ColliderHandle,
}

impl Flight {
    /// Where `gap` is left after five steps.
    fn new(filter: PairFilter, shape: ColliderBuilder, speed: Real, gap: Real) -> Self {
        let mut twins = Twins::with_filter(filter).without_gravity();
        twins.both(|world| world.params.normalized_contact_recycle_distance = 0.0);
        let wall = cuboid([0.05, 3.0, 3.0]);
        let (_, wall) = twins.insert(dynamic(0.0, 0.0).can_sleep(false), wall);
        let start = -0.25 - (speed / 60.0 * 5.0 + gap);
        let body = dynamic(start, 0.0).linvel(at(speed, 0.0));
        let (body, collider) = twins.insert(body, shape);
        twins.steps(5);
        Self {
            twins,
            wall,
            body,
            collider,
        }
    }
}

/// What makes contacts reach farther.
const CHANGES: [fn(&mut Flight); 5] = [
    |flight| {
        let body = flight.body;
        let change = |body: &mut RigidBody| body.set_soft_ccd_prediction(3.0);
        flight.twins.change_body(body, change);
    },
    |flight| {
        let collider = flight.collider;
        flight.twins.change(collider, |it| it.set_contact_skin(0.5));
    },
    |flight| {
        let wall = flight.wall;
        flight.twins.change(wall, |it| it.set_contact_skin(0.5));
    },
    |flight| {
        let params =
            |params: &mut IntegrationParameters| params.normalized_prediction_distance = 1.0;
        flight.twins.both(|world| params(&mut world.params));
    },
    |flight| {
        flight.twins.both(|world| world.params.length_unit = 30.0);
    },
];

#[test]
fn what_reaches_farther_stops_at_the_wall() {
    let mut stopped = 0;
    for filter in [PairFilter::Groups, PairFilter::Shapes] {
        for shape in [
            ColliderBuilder::ball(0.2),
            cuboid([0.2; 3]),
            ColliderBuilder::capsule_x(0.1, 0.1),
        ] {
            for change in CHANGES {
                for speed in [12.0, 20.0, 27.0] {
                    for gap in [0.021, 0.03, 0.04, 0.05, 0.06] {
                        let mut flight = Flight::new(filter, shape.clone(), speed, gap);
                        change(&mut flight);
                        let seen = flight.twins.steps(15);
                        let [wall, body] = [flight.wall, flight.collider].map(|collider| {
                            let collider = &flight.twins.ours.colliders[collider];
                            collider.translation().x
                        });
                        stopped += usize::from(body < wall);
                        drop(seen);
                    }
                }
            }
        }
    }
    assert!(stopped > 200, "{stopped}");
}

/// Where a ball is that flies at a thin wall and gets a soft-CCD prediction before collisions are detected without a step.
fn flight_on(broad_phase: DefaultBroadPhase, gap: Real) -> Real {
    let mut world = PhysicsWorld {
        broad_phase,
        gravity: Vector::ZERO,
        ..PhysicsWorld::default()
    };
    let speed = 12.0;
    let start = -0.25 - (speed / 60.0 * 5.0 + gap);
    world.insert(RigidBodyBuilder::fixed(), cuboid([0.05, 3.0, 3.0]));
    let body = dynamic(start, 0.0).linvel(at(speed, 0.0));
    let (body, _) = world.insert(body, ColliderBuilder::ball(0.2));
    for _ in 0..5 {
        world.step();
    }
    world.bodies[body].set_soft_ccd_prediction(3.0);
    // Takes the list of changed bodies.
    world.detect_collisions(&(), &());
    for _ in 0..15 {
        world.step();
    }
    world.bodies[body].translation().x
}

#[test]
fn a_prediction_counts_although_collisions_were_detected_before_the_step() {
    for gap in [0.021, 0.03, 0.04, 0.05, 0.06] {
        let ours = DefaultBroadPhase::custom(UnisizeBroadPhase::new());
        let [own, ours] = [DefaultBroadPhase::new(), ours].map(|it| flight_on(it, gap));
        assert!(
            own < 0.0,
            "the ball is at {own} on Rapier's own broad phase"
        );
        assert_eq!(ours, own);
    }
}
