//! Rapier's character controller, which queries the broad phase all the time: the same movements.

use super::rapier::control::{CharacterCollision, KinematicCharacterController};
use super::rapier::prelude::*;
use super::scenes::Vector;
use super::twins::{Twins, at, cube, dynamic};
use super::version::origin;

/// Half the height of the character.
const HALF: Real = 0.6;

/// A character that walks ahead on a wide floor.
struct Walk {
    twins: Twins,
    body: RigidBodyHandle,
    /// The colliders that it has met.
    met: Vec<ColliderHandle>,
}

impl Walk {
    fn new() -> Self {
        let mut twins = Twins::heavy();
        twins.insert_floor();
        let body = RigidBodyBuilder::kinematic_position_based().translation(at(0.0, HALF + 0.05));
        let (body, _) = twins.insert(body, ColliderBuilder::capsule_y(HALF - 0.3, 0.3));
        twins.step();
        let met = Vec::new();
        Self { twins, body, met }
    }

    /// Moves the character as far as it can, pushes what is in its way, and steps.
    fn go(&mut self) {
        let body = self.body;
        let filter = QueryFilter::new().exclude_rigid_body(body);
        let (_, met) = self.twins.both_scenes(filter, |mut scene| {
            let controller = KinematicCharacterController::default();
            let dt = IntegrationParameters::default().dt;
            let character = &scene.bodies[body];
            let (pose, collider) = (*character.position(), character.colliders()[0]);
            let shape = scene.colliders[collider].shared_shape().clone();
            let mut met: Vec<CharacterCollision> = Vec::new();
            let ahead = at(0.05, -0.08);
            let meet = |collision| met.push(collision);
            let moved = controller.move_shape(dt, &scene.as_ref(), &*shape, &pose, ahead, meet);
            controller.solve_character_collision_impulses(dt, &mut scene, &*shape, 20.0, &met);
            let place = origin(&pose) + moved.translation;
            scene.bodies[body].set_next_kinematic_translation(place);
            (moved, met)
        });
        self.met
            .extend(met.iter().map(|collision| collision.handle));
        self.twins.step();
    }

    fn place(&self, body: RigidBodyHandle) -> Vector {
        origin(self.twins.ours.bodies[body].position())
    }
}

#[test]
fn bodies_in_its_way() {
    let mut walk = Walk::new();
    let cube = (2.0, cube().density(0.5));
    let ball = (6.0, ColliderBuilder::ball(0.5));
    let pushed =
        [cube, ball].map(|(x, collider)| (x, walk.twins.insert(dynamic(x, 0.5), collider)));
    walk.twins.steps(20);
    (0..260).for_each(|_| walk.go());
    let mut has_met = false;
    for (before, (body, collider)) in pushed {
        has_met |= walk.met.contains(&collider);
        let after = walk.place(body).x;
        assert!(after > before + 1.0, "from {before} to {after}");
    }
    // One may push the other.
    assert!(has_met);
}

/// The controller forgets the contacts of a body that it pushes whenever it finds a later one in its box, whether or not
/// that one touches it. So what is found must be what Rapier's own broad phase finds: not what is on its way there.
#[test]
fn what_is_only_near_takes_no_push_away() {
    let mut walk = Walk::new();
    let (pushed, _) = walk.twins.insert(dynamic(1.0, 0.5), cube().density(0.5));
    // They fly along above its head, down and up again.
    let fliers: Vec<_> = (0..6)
        .map(|i| {
            let place = at(0.0, 2.0 + 0.1 * i as Real);
            let body = RigidBodyBuilder::dynamic().translation(place);
            let flier = ColliderBuilder::ball(0.1).collision_groups(InteractionGroups::none());
            walk.twins.insert(body.gravity_scale(0.0), flier).0
        })
        .collect();
    for step in 0..160 {
        for (i, &flier) in fliers.iter().enumerate() {
            let is_down = (step + 3 * i) % 32 < 16;
            let ahead = walk.place(walk.body).x - walk.place(flier).x;
            let velocity = at(
                60.0 * ahead.clamp(-0.06, 0.06),
                if is_down { -2.0 } else { 2.0 },
            );
            walk.twins
                .change_body(flier, |body| body.set_linvel(velocity, true));
        }
        walk.go();
    }
    let place = walk.place(pushed);
    assert!(place.x > 2.0, "it ends at {place}");
}
