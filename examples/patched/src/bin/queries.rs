//! Scene queries in Rapier 0.36: rays, a shape cast, and a character that walks among balls. They are called as they are without unisize.
//!
//! ```text
//! cargo run --release --bin queries
//! ```
//!
//! README.md says how to make the patched copy of Rapier first. A `Cargo.toml` of yours needs these lines below `[dependencies]`, with the
//! path to your clone of unisize:
//!
//! ```toml
//! rapier3d = "=0.36.1"
//! unisize = { path = "../unisize", features = ["rapier3d-036"] }
//! ```
//!
//! Prints what the queries found. Fails if a ray misses the floor, if Rapier's own broad phase finds something else, or if the character
//! makes no progress.

use rapier3d::control::KinematicCharacterController;
use rapier3d::parry::query::ShapeCastOptions;
use rapier3d::prelude::*;
use unisize::rapier3d_036::UnisizeBroadPhase;

const STEPS: usize = 240;

/// The collider that each ray hits and at what distance, in the same order, and then the same of a ball that is cast along the floor.
fn find(world: &PhysicsWorld, filter: QueryFilter<'_>) -> Vec<(ColliderHandle, f32)> {
    // The first query after a step brings the tree up to date. The others use it as it is.
    let queries = world.query_pipeline_with_filter(filter);
    let rays = (0..100).map(|i| {
        let (x, z) = ((i % 10) as f32, (i / 10) as f32);
        let origin = Vector::new(x * 4.0 - 18.0, 5.0, z * 4.0 - 18.0);
        let hit = queries.cast_ray(&Ray::new(origin, Vector::NEG_Y), 10.0, true);
        hit.expect("the floor is below each ray")
    });
    let mut hits: Vec<_> = rays.collect();
    let hit = queries.cast_shape(
        &Pose::translation(-25.0, 0.3, 0.0),
        Vector::X,
        &Ball::new(0.25),
        ShapeCastOptions::with_max_time_of_impact(50.0),
    );
    // The speed is 1, so the time is a distance.
    hits.extend(hit.map(|(collider, hit)| (collider, hit.time_of_impact)));
    hits
}

fn main() {
    let mut world = PhysicsWorld::default();
    // The only line that changes.
    world.broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new());
    let floor = ColliderBuilder::cuboid(30.0, 1.0, 30.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.colliders.insert(floor);
    for i in 0..400 {
        let (x, z) = ((i % 20) as f32, (i / 20) as f32);
        let position = Vector::new(x * 1.5 - 14.0, 1.0, z * 1.5 - 14.0);
        let body = RigidBodyBuilder::dynamic().translation(position);
        world.insert(body, ColliderBuilder::ball(0.3));
    }
    let shape = SharedShape::capsule_y(0.5, 0.3);
    let start = Vector::new(-20.0, 0.9, 0.0);
    let character = RigidBodyBuilder::kinematic_position_based().translation(start);
    let (character, _) = world.insert(character, ColliderBuilder::new(shape.clone()));

    let dt = world.integration_parameters.dt;
    let filter = QueryFilter::default().exclude_rigid_body(character);
    let controller = KinematicCharacterController::default();
    let mut collisions = 0;
    for _ in 0..STEPS {
        world.step();

        // The character walks along the x axis, and pushes the balls in its way.
        let position = *world.bodies[character].position();
        let desired = Vector::new(4.0, -2.0, 0.0) * dt;
        let mut hits = Vec::new();
        let queries = world.query_pipeline_with_filter(filter);
        let on_hit = |hit| hits.push(hit);
        let movement = controller.move_shape(dt, &queries, &*shape, &position, desired, on_hit);
        collisions += hits.len();
        // `PhysicsWorld` has no method for queries that change bodies.
        let mut queries = world.broad_phase.as_query_pipeline_mut(
            world.narrow_phase.query_dispatcher(),
            &mut world.bodies,
            &mut world.colliders,
            filter,
        );
        let mass = 2.0;
        controller.solve_character_collision_impulses(dt, &mut queries, &*shape, mass, &hits);
        let next = position.translation + movement.translation;
        world.bodies[character].set_next_kinematic_translation(next);
    }
    let walked = world.bodies[character].translation().x - start.x;
    println!("the character walked {walked:.2} and collided {collisions} times");
    assert!(walked > 2.0, "the character is stuck");

    let found = find(&world, filter);
    let rays = found[..100].iter();
    let on_floor = rays.filter(|hit| (hit.1 - 5.0).abs() < 1e-3).count();
    println!("100 rays: {on_floor} hit the floor, the others a ball");
    match found.get(100) {
        Some((_, distance)) => println!("a ball cast along the floor travels {distance:.2}"),
        None => println!("a ball cast along the floor hits nothing"),
    }

    // Rapier's own broad phase takes over, and receives the colliders without a step.
    world.broad_phase = DefaultBroadPhase::new();
    world.detect_collisions(&(), &());
    let own = find(&world, filter);
    assert_eq!(found.len(), own.len(), "the cast ball misses");
    for ((collider, distance), (own_collider, own_distance)) in found.into_iter().zip(own) {
        assert_eq!(collider, own_collider, "a query finds something else");
        let is_equal = (distance - own_distance).abs() < 1e-3;
        assert!(is_equal, "a query finds another distance");
    }
}
