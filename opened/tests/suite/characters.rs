//! Rapier's character controller, which queries the broad phase all the time: the same movements.

use super::rapier::control::{
    CharacterAutostep, CharacterCollision, CharacterLength, EffectiveCharacterMovement,
    KinematicCharacterController,
};
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};

/// Half the height of the character.
const HALF: Real = 0.6;

/// How far it falls in each step, if it can.
const FALL: Real = -0.08;

/// A character that stands on a wide floor.
struct Walk {
    twins: Twins,
    body: RigidBodyHandle,
    controller: KinematicCharacterController,
}

impl Walk {
    fn new(shape: ColliderBuilder) -> Self {
        let mut twins = Twins::heavy();
        twins.insert_floor();
        let body = RigidBodyBuilder::kinematic_position_based().translation(at(0.0, HALF + 0.05));
        let (body, _) = twins.insert(body, shape);
        let controller = KinematicCharacterController {
            autostep: Some(CharacterAutostep {
                max_height: CharacterLength::Absolute(0.3),
                min_width: CharacterLength::Absolute(0.2),
                include_dynamic_bodies: false,
            }),
            ..KinematicCharacterController::default()
        };
        twins.step();
        Self {
            twins,
            body,
            controller,
        }
    }

    /// Moves the character as far as it can, pushes what is in its way, and steps.
    fn go(&mut self, by: Vector) -> EffectiveCharacterMovement {
        let Self {
            twins,
            body,
            controller,
        } = self;
        let filter = QueryFilter::new().exclude_rigid_body(*body);
        let movement = twins.both_scenes(filter, |mut scene| {
            let dt = IntegrationParameters::default().dt;
            let character = &scene.bodies[*body];
            let pose = *character.position();
            let shape = scene.colliders[character.colliders()[0]]
                .shared_shape()
                .clone();
            let mut collisions: Vec<CharacterCollision> = Vec::new();
            let movement = controller.move_shape(dt, &scene.as_ref(), &*shape, &pose, by, |hit| {
                collisions.push(hit);
            });
            let mass = 20.0;
            controller.solve_character_collision_impulses(
                dt,
                &mut scene,
                &*shape,
                mass,
                &collisions,
            );
            let place = pose.translation + movement.translation;
            scene.bodies[*body].set_next_kinematic_translation(place);
            movement
        });
        twins.step();
        movement
    }

    /// Walks ahead for this many steps, and returns the greatest height on the way.
    fn ahead(&mut self, steps: usize) -> Real {
        let mut highest = self.place().y;
        for _ in 0..steps {
            self.go(at(0.05, FALL));
            highest = highest.max(self.place().y);
        }
        highest
    }

    /// Where it stands.
    fn place(&self) -> Vector {
        self.twins.ours.bodies[self.body].translation() - at(0.0, HALF)
    }
}

#[test]
fn up_and_down_the_stairs() {
    let mut walk = Walk::new(cuboid([0.3, HALF, 0.3]));
    for i in 0..3 {
        let i = i as Real;
        let step = cuboid([3.5 - i, 0.1, 3.0]).translation(at(5.0, 0.1 + 0.2 * i));
        walk.twins.insert(fixed(0.0, 0.0), step);
    }
    let highest = walk.ahead(320);
    assert!((0.6..0.7).contains(&highest), "it climbs to {highest}");
    let place = walk.place();
    assert!(place.x > 9.0 && place.y < 0.1, "it ends at {place}");
}

#[test]
fn in_the_air_and_against_a_cube() {
    let mut walk = Walk::new(ColliderBuilder::capsule_y(HALF - 0.3, 0.3));
    assert!(walk.go(at(0.0, FALL)).grounded);
    for _ in 0..10 {
        assert!(!walk.go(at(0.03, 0.1)).grounded);
    }
    let (pushed, _) = walk.twins.insert(dynamic(3.0, 0.5), cube());
    walk.ahead(160);
    let place = walk.twins.ours.bodies[pushed].translation();
    assert!(place.x > 3.2, "the cube is at {place}");
}
