//! Saving a world of Rapier 0.36 and continuing from the save, bit for bit.
//!
//! ```text
//! cargo run --release --bin save
//! ```
//!
//! README.md says how to make the patched copy of Rapier first. A `Cargo.toml` of yours needs these lines below `[dependencies]`, with the
//! path to your clone of unisize:
//!
//! ```toml
//! rapier3d = { version = "=0.36.1", features = ["serde-serialize"] }
//! serde_json = "1"
//! unisize = { path = "../unisize", features = ["rapier3d-036", "serde-serialize"] }
//! ```
//!
//! A saved world does not contain a custom broad phase, so unisize is saved next to it and put back. Prints the size of the save. Fails if
//! the loaded world moves differently from the saved one.

use rapier3d::prelude::*;
use unisize::rapier3d_036::UnisizeBroadPhase;

fn tower() -> PhysicsWorld {
    let mut world = PhysicsWorld::default();
    world.broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new());
    let floor = ColliderBuilder::cuboid(30.0, 1.0, 30.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.colliders.insert(floor);
    for i in 0..500 {
        // It leans, so that it collapses.
        let (x, y, z) = ((i % 8) as f32, (i / 64) as f32, (i / 8 % 8) as f32);
        let position = Vector::new(x + 0.1 * y, 0.6 + y, z) * 1.1;
        let body = RigidBodyBuilder::dynamic().translation(position);
        world.insert(body, ColliderBuilder::cuboid(0.5, 0.5, 0.5));
    }
    world
}

fn unisize(world: &PhysicsWorld) -> &UnisizeBroadPhase {
    let active = world.broad_phase.custom_ref();
    active.expect("unisize is not active")
}

fn save(world: &PhysicsWorld) -> [String; 2] {
    let broad_phase = serde_json::to_string(unisize(world));
    [serde_json::to_string(world), broad_phase].map(|json| json.expect("both can be serialized"))
}

fn load([world, broad_phase]: &[String; 2]) -> serde_json::Result<PhysicsWorld> {
    let mut world: PhysicsWorld = serde_json::from_str(world)?;
    let broad_phase: UnisizeBroadPhase = serde_json::from_str(broad_phase)?;
    // Without this line the world continues on Rapier's own broad phase.
    world.broad_phase = DefaultBroadPhase::custom(broad_phase);
    Ok(world)
}

fn main() -> serde_json::Result<()> {
    let mut world = tower();
    (0..100).for_each(|_| world.step());
    let saved = save(&world);
    let mut loaded = load(&saved)?;
    for _ in 0..100 {
        world.step();
        loaded.step();
    }
    let positions = |world: &PhysicsWorld| -> Vec<_> {
        let bodies = world.bodies.iter();
        bodies.map(|(_, body)| *body.position()).collect()
    };
    let is_equal = positions(&world) == positions(&loaded);
    assert!(is_equal, "the loaded world moves differently");
    assert_eq!(
        unisize(&world).stats().pairs,
        unisize(&loaded).stats().pairs
    );
    let [world, broad_phase] = saved.map(|json| json.len() / 1000);
    println!(
        "saved {world} kB, and {broad_phase} kB of unisize; 100 steps later both worlds are equal bit for bit"
    );
    Ok(())
}
