//! Saving a world of Rapier 0.36 on unisize, and going on from it, bit for bit.
//!
//! A saved world does not contain a custom broad phase, so unisize is saved next to it and put back. Fails if the world that was loaded moves
//! differently from the one that was saved.

use rapier3d::prelude::*;
use unisize::rapier3d_036::UnisizeBroadPhase;

fn tower() -> PhysicsWorld {
    let mut world = PhysicsWorld::default();
    world.broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new());
    let floor = ColliderBuilder::cuboid(30.0, 1.0, 30.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.colliders.insert(floor);
    for i in 0..500 {
        let (x, y, z) = (i % 8, i / 64, i / 8 % 8);
        let place = Vector::new(x as f32 + 0.1 * y as f32, 0.6 + y as f32, z as f32) * 1.1;
        let body = RigidBodyBuilder::dynamic().translation(place);
        world.insert(body, ColliderBuilder::cuboid(0.5, 0.5, 0.5));
    }
    world
}

fn unisize(world: &PhysicsWorld) -> &UnisizeBroadPhase {
    let active = world.broad_phase.custom_ref();
    active.expect("the world was built with it")
}

fn save(world: &PhysicsWorld) -> [String; 2] {
    let broad_phase = serde_json::to_string(unisize(world));
    [serde_json::to_string(world), broad_phase]
        .map(|json| json.expect("all of it can be serialized"))
}

fn load([world, broad_phase]: &[String; 2]) -> serde_json::Result<PhysicsWorld> {
    let mut world: PhysicsWorld = serde_json::from_str(world)?;
    let broad_phase: UnisizeBroadPhase = serde_json::from_str(broad_phase)?;
    // Without this line the world goes on with Rapier's own broad phase.
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
    let poses = |world: &PhysicsWorld| -> Vec<_> {
        world
            .bodies
            .iter()
            .map(|(_, body)| *body.position())
            .collect()
    };
    assert!(
        poses(&world) == poses(&loaded),
        "the world that was loaded moves differently"
    );
    assert_eq!(
        unisize(&world).stats().pairs,
        unisize(&loaded).stats().pairs
    );
    let [whole, part] = saved.map(|json| json.len() / 1000);
    println!(
        "saved {whole} kB, and {part} kB of unisize; 100 steps later both worlds are equal to the bit"
    );
    Ok(())
}
