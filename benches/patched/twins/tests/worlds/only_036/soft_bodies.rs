//! Soft bodies that tear: their pieces are new bodies with new colliders, and the shape of the rest changes.

use super::ordered::{Ordered, at_both_levels};
use super::rapier::prelude::*;
use super::twins::{at, cuboid, dynamic, fixed};

/// Where all particles of the soft bodies are.
fn particles(world: &super::World) -> Vec<Vector> {
    let soft_bodies = world.soft_bodies.iter();
    let particles = soft_bodies.flat_map(|(_, body)| body.particle_positions());
    particles.collect()
}

/// Ropes between two fixed pins, which cubes that fall on them tear.
fn ropes(worlds: &mut Ordered, strain: Real) {
    for lane in 0..4 {
        let height = 3.0 + 0.5 * lane as Real;
        let [start, end] = [0.0, 4.0].map(|x| at(5.0 * lane as Real + x, height));
        let rope = SoftBodyBuilder::rope(start, end, 13)
            .particle_mass(0.05)
            .min_piece(1)
            .tear_strain(strain)
            .pinned_particles([0, 12]);
        worlds.twins.both(|world| {
            let (bodies, colliders) = (&mut world.bodies, &mut world.colliders);
            world.soft_bodies.insert(rope.clone(), bodies, colliders)
        });
        let cube = dynamic(5.0 * lane as Real + 2.0, height + 1.0);
        let cube = cube.linvel(at(0.0, -6.0));
        worlds.twins.insert(cube, cuboid([0.4; 3]).density(20.0));
        let post = fixed(5.0 * lane as Real + 1.0, 0.5);
        worlds.twins.insert(post, cuboid([0.2, 0.5, 0.5]));
    }
}

#[test]
fn ropes_that_tear() {
    at_both_levels(|mut worlds| {
        worlds.twins.insert_floor();
        ropes(&mut worlds, 0.3);
        let (mut contacts, mut pieces) = (0, 0);
        for step in 0..120 {
            contacts += worlds.step().contacts.len();
            if step % 40 == 20 {
                // Where nothing pulls, too.
                worlds.twins.both(|world| {
                    let first = world.soft_bodies.iter().map(|(handle, _)| handle).next();
                    let first = first.expect("there are four");
                    let torn = world.soft_bodies.tear(
                        first,
                        &[2],
                        &[],
                        &mut world.islands,
                        &mut world.bodies,
                        &mut world.colliders,
                        &mut world.impulse_joints,
                        &mut world.multibody_joints,
                    );
                    torn.is_some()
                });
            }
            if worlds.are_alike() {
                let [ours, theirs] = [&worlds.twins.ours, &worlds.twins.theirs].map(particles);
                assert_eq!(ours, theirs);
            }
            pieces = worlds.twins.ours.soft_bodies.len();
        }
        assert!(pieces > 5, "only {pieces} pieces");
        assert!(contacts > 200, "only {contacts} contacts");
    });
}
