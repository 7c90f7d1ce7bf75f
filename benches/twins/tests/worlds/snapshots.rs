//! Whole simulations: Rapier's sets are saved and restored together with the broad phase.

use unisize_scenes::SceneKind;

use super::UnisizeBroadPhase;
use super::rapier::prelude::*;
use super::scenes::{Observed, Scene};

const BODIES: usize = 100;

/// The steps before which everything is saved and restored.
const SNAPSHOTS: [usize; 5] = [0, 1, 10, 45, 120];

/// The number of steps after the last one.
const STEPS_AFTER: usize = 300;

/// Saves everything that a step depends on and restores it.
fn renew(scene: &mut Scene, broad_phase: &mut Observed<UnisizeBroadPhase>) {
    let world = &mut scene.world;
    let bytes = postcard::to_stdvec(&(
        (&world.islands, &world.narrow_phase, &world.ccd_solver),
        (&world.bodies, &world.colliders),
        (&world.impulse_joints, &world.multibody_joints),
        &broad_phase.inner,
    ));
    let bytes = bytes.expect("all of it can be written");
    (
        (world.islands, world.narrow_phase, world.ccd_solver),
        (world.bodies, world.colliders),
        (world.impulse_joints, world.multibody_joints),
        broad_phase.inner,
    ) = postcard::from_bytes(&bytes).expect("all of it can be read");
    world.pipeline = PhysicsPipeline::new();
    broad_phase.inner.validate();
}

/// The bits of the pose and velocity of every body.
fn motion(scene: &Scene) -> Vec<u8> {
    let bodies = scene.world.bodies.iter();
    let motion = bodies.map(|(_, body)| (body.position(), body.linvel(), body.angvel()));
    postcard::to_stdvec(&motion.collect::<Vec<_>>()).expect("numbers can be written")
}

#[test]
fn a_restored_simulation_goes_on_as_the_saved_one() {
    for kind in SceneKind::ALL {
        let [mut saved, mut restored] = [(); 2].map(|()| Scene::build(kind, BODIES, 11));
        let [mut ours, mut twin] =
            [(); 2].map(|()| Observed::new(UnisizeBroadPhase::new()).with_events());
        let last = SNAPSHOTS[SNAPSHOTS.len() - 1];
        let mut events = 0;
        for step in 0..last + STEPS_AFTER {
            if SNAPSHOTS.contains(&step) {
                renew(&mut restored, &mut twin);
            }
            saved.step(&mut ours, &(), &());
            restored.step(&mut twin, &(), &());
            let name = kind.name();
            let reported = ours.take_events();
            assert!(
                reported == twin.take_events(),
                "events of {name}, step {step}"
            );
            assert!(motion(&saved) == motion(&restored), "{name}, step {step}");
            events += usize::from(!reported.is_empty());
        }
        assert!(events > 0, "nothing happens in {}", kind.name());
    }
}
