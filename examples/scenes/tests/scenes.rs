//! Every scene, in every flavour: it stays sane under Rapier's default broad phase, whatever the number
//! of bodies, and it is determined by its seed.

#[macro_use]
mod suite;

scene_tests!(dim2);
scene_tests!(dim3);
scene_tests!(dim2_f64);
scene_tests!(dim3_f64);

/// The tests of one flavour whose broad phase reports all pairs. Later versions leave these out themselves.
macro_rules! pair_tests {
    ($name:ident, $dim:ident) => {
        mod $name {
            use super::suite::STEPS;
            use unisize_scenes::SceneKind;
            use unisize_scenes::$dim::{Observed, OwnBroadPhase, Scene};

            /// The pairs of colliders whose boxes overlap, and how many of them the narrow phase looks at.
            fn pairs(kind: SceneKind, bodies: usize) -> [usize; 2] {
                let mut scene = Scene::build(kind, bodies, 1);
                let mut broad_phase = Observed::new(OwnBroadPhase::new()).with_held();
                for _ in 0..STEPS {
                    scene.step(&mut broad_phase, &(), &());
                }
                let colliders = &scene.world.colliders;
                let may_touch = broad_phase.held().iter().filter(|pair| {
                    let (a, b) = (&colliders[pair.collider1], &colliders[pair.collider2]);
                    scene.world.may_touch(a, b)
                });
                [broad_phase.held().len(), may_touch.count()]
            }

            #[test]
            fn the_narrow_phase_drops_nearly_all_pairs_of_ships_tiles_and_ghosts() {
                for kind in [SceneKind::Ships, SceneKind::TileMap] {
                    let [all, relevant] = pairs(kind, 240);
                    assert!(relevant > 0, "{}", kind.name());
                    assert!(20 * relevant < all, "{}: {relevant} of {all}", kind.name());
                }
                // Of few ghosts, many are at the walls.
                let [all, relevant] = pairs(SceneKind::Ghosts, 600);
                assert!(relevant > 0 && 4 * relevant < all, "{relevant} of {all}");
            }
        }
    };
}

pair_tests!(pairs2, dim2);
pair_tests!(pairs3, dim3);
pair_tests!(pairs2_f64, dim2_f64);
pair_tests!(pairs3_f64, dim3_f64);
