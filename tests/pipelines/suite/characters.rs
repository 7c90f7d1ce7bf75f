//! Rapier's character controller, which queries the broad phase all the time: the same movements.

use super::rapier::control::{
    CharacterAutostep, CharacterCollision, CharacterLength, EffectiveCharacterMovement,
    KinematicCharacterController,
};
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed, triple};
use super::version::{Vector, origin};

/// Half the height of the character.
const HALF: Real = 0.6;

/// How far it falls in each step, if it can.
const FALL: Real = -0.08;

/// A character that stands on a wide floor.
struct Walk {
    twins: Twins,
    body: RigidBodyHandle,
    controller: KinematicCharacterController,
    /// The colliders that it has met.
    met: Vec<ColliderHandle>,
}

impl Walk {
    /// From the height 0 at `x = 0`, with round feet.
    fn new() -> Self {
        Self::with_shape(ColliderBuilder::capsule_y(HALF - 0.3, 0.3))
    }

    fn with_shape(shape: ColliderBuilder) -> Self {
        let mut twins = Twins::heavy();
        twins.insert_floor();
        let body = RigidBodyBuilder::kinematic_position_based().translation(at(0.0, HALF + 0.05));
        let (body, _) = twins.insert(body, shape);
        let autostep = CharacterAutostep {
            max_height: CharacterLength::Absolute(0.3),
            min_width: CharacterLength::Absolute(0.2),
            include_dynamic_bodies: false,
        };
        let controller = KinematicCharacterController {
            autostep: Some(autostep),
            ..KinematicCharacterController::default()
        };
        twins.step();
        Self {
            twins,
            body,
            controller,
            met: Vec::new(),
        }
    }

    /// Moves the character as far as it can, pushes what is in its way, and steps.
    fn go(&mut self, by: Vector) -> EffectiveCharacterMovement {
        let Self {
            twins,
            body,
            controller,
            met,
        } = self;
        let filter = QueryFilter::new().exclude_rigid_body(*body);
        let (movement, collisions) = twins.both_scenes(filter, |mut scene| {
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
            controller.solve_character_collision_impulses(
                dt,
                &mut scene,
                &*shape,
                20.0,
                &collisions,
            );
            let place = origin(&pose) + movement.translation;
            scene.bodies[*body].set_next_kinematic_translation(place);
            (movement, collisions)
        });
        met.extend(collisions.iter().map(|collision| collision.handle));
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

    fn insert_fixed(&mut self, collider: ColliderBuilder) -> ColliderHandle {
        self.twins.insert(fixed(0.0, 0.0), collider).1
    }

    /// A ramp that rises to a height between two places.
    fn insert_ramp(&mut self, from: Real, to: Real, height: Real) -> ColliderHandle {
        let mut corners = Vec::new();
        for (x, y) in [(from, -0.5), (from, 0.0), (to, height), (to, -0.5)] {
            for z in [-3.0, 3.0] {
                corners.push(triple([x, y, z]).into());
            }
        }
        // In two dimensions each is there twice.
        corners.dedup();
        let ramp = ColliderBuilder::convex_hull(&corners).expect("the corners span a ramp");
        self.insert_fixed(ramp)
    }
}

#[test]
fn up_and_down_the_stairs() {
    let mut walk = Walk::with_shape(cuboid([0.3, HALF, 0.3]));
    for i in 0..3 {
        let i = i as Real;
        let step = cuboid([3.5 - i, 0.1, 3.0]).translation(at(5.0, 0.1 + 0.2 * i));
        walk.insert_fixed(step);
    }
    let highest = walk.ahead(320);
    assert!((0.6..0.7).contains(&highest), "it climbs to {highest}");
    let place = walk.place();
    assert!(place.x > 9.0 && place.y < 0.1, "it ends at {place}");
}

#[test]
fn in_the_air_and_back() {
    let mut walk = Walk::new();
    assert!(walk.go(at(0.0, FALL)).grounded);
    for _ in 0..10 {
        assert!(!walk.go(at(0.03, 0.1)).grounded);
    }
    walk.ahead(40);
    assert!(walk.go(at(0.0, FALL)).grounded);
}

#[test]
fn up_a_slope_but_not_a_steep_one() {
    let mut walk = Walk::new();
    let gentle = walk.insert_ramp(2.0, 6.0, 1.2);
    let steep = walk.insert_ramp(9.0, 10.0, 2.5);
    let highest = walk.ahead(300);
    assert!((1.2..1.3).contains(&highest), "it climbs to {highest}");
    assert!(walk.met.contains(&gentle) && walk.met.contains(&steep));
    assert!(walk.place().x < 9.5, "it ends at {}", walk.place());
}

#[test]
fn down_a_steep_slope() {
    let mut walk = Walk::new();
    walk.insert_ramp(2.0, 3.0, 2.0);
    let above = at(2.7, 2.2 + HALF);
    walk.twins
        .change_body(walk.body, |body| body.set_translation(above, true));
    walk.twins.step();
    let mut slides = false;
    for _ in 0..80 {
        slides |= walk.go(at(0.0, FALL)).is_sliding_down_slope;
    }
    let place = walk.place();
    assert!(
        slides && place.x < 2.0 && place.y < 0.1,
        "it ends at {place}"
    );
}

#[test]
fn along_a_wall() {
    let mut walk = Walk::new();
    let wall = walk.insert_fixed(cuboid([0.5, 4.0, 20.0]).translation(at(4.0, 4.0)));
    for _ in 0..200 {
        walk.go(triple([0.05, FALL, 0.04]));
    }
    assert!(walk.met.contains(&wall));
    let place = walk.place();
    assert!((3.0..3.5).contains(&place.x), "it ends at {place}");
    assert!(DIM == 2 || place[DIM - 1] > 7.0, "it ends at {place}");
}

#[test]
fn bodies_in_its_way() {
    let mut walk = Walk::new();
    let cube = (2.0, cube().density(0.5));
    let ball = (6.0, ColliderBuilder::ball(0.5));
    let pushed =
        [cube, ball].map(|(x, collider)| (x, walk.twins.insert(dynamic(x, 0.5), collider)));
    walk.twins.steps(20);
    walk.ahead(260);
    let mut has_met = false;
    for (before, (body, collider)) in pushed {
        has_met |= walk.met.contains(&collider);
        let after = walk.twins.ours.bodies[body].translation().x;
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
            let ahead = walk.place().x - walk.twins.ours.bodies[flier].translation().x;
            let velocity = at(
                60.0 * ahead.clamp(-0.06, 0.06),
                if is_down { -2.0 } else { 2.0 },
            );
            walk.twins
                .change_body(flier, |body| body.set_linvel(velocity, true));
        }
        walk.go(at(0.05, FALL));
    }
    let place = walk.twins.ours.bodies[pushed].translation();
    assert!(place.x > 2.0, "it ends at {place}");
}

#[test]
fn on_a_platform_that_moves() {
    let mut walk = Walk::new();
    let lift = RigidBodyBuilder::kinematic_velocity_based().linvel(at(1.0, 0.3));
    walk.twins
        .insert(lift, cuboid([1.0, 0.1, 1.0]).translation(at(0.0, -0.06)));
    for _ in 0..120 {
        walk.go(at(0.0, FALL));
    }
    let place = walk.place();
    assert!(place.x > 1.5 && place.y > 0.5, "it ends at {place}");
}
