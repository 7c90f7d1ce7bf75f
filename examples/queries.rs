//! Scene queries: rays, a shape cast, and a character that walks among balls. They are called as they are without unisize.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example queries
//! ```
//!
//! This is Rapier 0.27; `examples/patched/src/bin/queries.rs` does the same in 0.36. Prints what the queries found. Fails if a ray misses
//! the floor, or if the character makes no progress.

use rapier3d::control::KinematicCharacterController;
use rapier3d::parry::query::{DefaultQueryDispatcher, ShapeCastOptions};
use rapier3d::prelude::*;
use unisize::rapier3d_027::UnisizeBroadPhase;

const STEPS: usize = 240;

fn main() {
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    let floor = ColliderBuilder::cuboid(30.0, 1.0, 30.0).translation(vector![0.0, -1.0, 0.0]);
    colliders.insert(floor);
    for i in 0..400 {
        let (x, z) = ((i % 20) as f32, (i / 20) as f32);
        let position = vector![x * 1.5 - 14.0, 1.0, z * 1.5 - 14.0];
        let body = bodies.insert(RigidBodyBuilder::dynamic().translation(position));
        colliders.insert_with_parent(ColliderBuilder::ball(0.3), body, &mut bodies);
    }
    let shape = SharedShape::capsule_y(0.5, 0.3);
    let start = vector![-20.0, 0.9, 0.0];
    let character = RigidBodyBuilder::kinematic_position_based().translation(start);
    let character = bodies.insert(character);
    colliders.insert_with_parent(ColliderBuilder::new(shape.clone()), character, &mut bodies);

    let params = IntegrationParameters::default();
    let mut broad_phase = UnisizeBroadPhase::new();
    let mut pipeline = PhysicsPipeline::new();
    let mut islands = IslandManager::new();
    let mut narrow_phase = NarrowPhase::new();
    let mut impulse_joints = ImpulseJointSet::new();
    let mut multibody_joints = MultibodyJointSet::new();
    let mut ccd_solver = CCDSolver::new();
    let dispatcher = DefaultQueryDispatcher;
    let filter = QueryFilter::default().exclude_rigid_body(character);
    let controller = KinematicCharacterController::default();
    let mut collisions = 0;
    for _ in 0..STEPS {
        pipeline.step(
            &vector![0.0, -9.81, 0.0],
            &params,
            &mut islands,
            &mut broad_phase,
            &mut narrow_phase,
            &mut bodies,
            &mut colliders,
            &mut impulse_joints,
            &mut multibody_joints,
            &mut ccd_solver,
            &(),
            &(),
        );

        // The character walks along the x axis, and pushes the balls in its way.
        let position = *bodies[character].position();
        let desired = vector![4.0, -2.0, 0.0] * params.dt;
        let mut hits = Vec::new();
        let queries = broad_phase.as_query_pipeline(&dispatcher, &bodies, &colliders, filter);
        let on_hit = |hit| hits.push(hit);
        let movement =
            controller.move_shape(params.dt, &queries, &*shape, &position, desired, on_hit);
        collisions += hits.len();
        let (dt, mass) = (params.dt, 2.0);
        let mut queries =
            broad_phase.as_query_pipeline_mut(&dispatcher, &mut bodies, &mut colliders, filter);
        controller.solve_character_collision_impulses(dt, &mut queries, &*shape, mass, &hits);
        let next = position.translation.vector + movement.translation;
        bodies[character].set_next_kinematic_translation(next);
    }

    // The first query after a step brings the tree up to date. The others use it as it is.
    let queries = broad_phase.as_query_pipeline(&dispatcher, &bodies, &colliders, filter);
    let mut on_floor = 0;
    for i in 0..100 {
        let (x, z) = ((i % 10) as f32, (i / 10) as f32);
        let origin = point![x * 4.0 - 18.0, 5.0, z * 4.0 - 18.0];
        let ray = Ray::new(origin, -Vector::y());
        let hit = queries.cast_ray(&ray, 10.0, true);
        let (_, distance) = hit.expect("the floor is below each ray");
        on_floor += usize::from((distance - 5.0).abs() < 1e-3);
    }
    println!("100 rays: {on_floor} hit the floor, the others a ball");

    let hit = queries.cast_shape(
        &Isometry::translation(-25.0, 0.3, 0.0),
        &vector![1.0, 0.0, 0.0],
        &Ball::new(0.25),
        ShapeCastOptions::with_max_time_of_impact(50.0),
    );
    match hit {
        Some((_, hit)) => println!(
            "a ball cast along the floor travels {:.2}",
            hit.time_of_impact
        ),
        None => println!("a ball cast along the floor hits nothing"),
    }
    let walked = bodies[character].translation().x - start.x;
    println!("the character walked {walked:.2} and collided {collisions} times");
    assert!(walked > 2.0, "the character is stuck");
}
