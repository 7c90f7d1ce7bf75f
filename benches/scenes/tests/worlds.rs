//! Every scene, in every flavour whose feature is on: it stays sane on Rapier's default broad phase with any number of bodies, and its
//! seed determines it.

#[macro_use]
mod suite;

use unisize_scenes::SceneKind;
use unisize_scenes::dim3::{Observed, OwnBroadPhase, Scene};

scene_tests!(dim2);
scene_tests!(dim3);
#[cfg(feature = "rapier2d-f64-027")]
scene_tests!(dim2_f64);
#[cfg(feature = "rapier3d-f64-027")]
scene_tests!(dim3_f64);

/// Of a broad phase that reports all pairs. Later versions leave these out themselves.
#[test]
fn the_narrow_phase_drops_nearly_all_pairs_of_ships_tiles_and_ghosts() {
    // Of few ghosts, many are at the walls.
    for (kind, bodies, most) in [
        (SceneKind::Ships, 240, 0.05),
        (SceneKind::TileMap, 240, 0.05),
        (SceneKind::Ghosts, 600, 0.25),
    ] {
        let mut scene = Scene::build(kind, bodies, 1);
        let mut broad_phase = Observed::new(OwnBroadPhase::new()).with_held();
        for _ in 0..suite::STEPS {
            scene.step(&mut broad_phase, &(), &());
        }
        let colliders = &scene.world.colliders;
        let relevant = broad_phase.held().iter().filter(|pair| {
            let (a, b) = (&colliders[pair.collider1], &colliders[pair.collider2]);
            scene.world.may_touch(a, b)
        });
        let share = relevant.count() as f64 / broad_phase.held().len() as f64;
        assert!(share > 0.0 && share < most, "{}: {share}", kind.name());
    }
}
