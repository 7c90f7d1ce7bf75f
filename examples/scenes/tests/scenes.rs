//! Every scene, in every flavour: it stays sane under Rapier's default broad phase, whatever the number
//! of bodies, and it is determined by its seed.

use unisize_scenes::SceneKind;

/// Steps of the tests that look at a scene while it is in full motion.
const STEPS: usize = 60;

/// The tests of one flavour.
macro_rules! scene_tests {
    ($dim:ident) => {
        mod $dim {
            use super::{STEPS, SceneKind};
            use std::hash::{DefaultHasher, Hash, Hasher};
            use unisize_scenes::$dim::rapier::prelude::*;
            use unisize_scenes::$dim::{Observed, Sanity, Scene};

            /// Builds a scene and steps it.
            fn run(kind: SceneKind, bodies: usize, seed: u64, steps: usize) -> (Scene, Sanity) {
                let mut scene = Scene::build(kind, bodies, seed);
                let initial = scene.sanity();
                let mut broad_phase = Observed::new(DefaultBroadPhase::new()).sorted();
                for _ in 0..steps {
                    scene.step(&mut broad_phase, &(), &());
                }
                (scene, initial)
            }

            /// A hash of the bits of every pose.
            fn hash(scene: &Scene) -> u64 {
                let mut hasher = DefaultHasher::new();
                for (handle, body) in scene.world.bodies.iter() {
                    handle.into_raw_parts().hash(&mut hasher);
                    for entry in body.position().to_homogeneous().iter() {
                        entry.to_bits().hash(&mut hasher);
                    }
                }
                hasher.finish()
            }

            #[test]
            fn scenes_stay_sane() {
                for kind in SceneKind::ALL {
                    let (scene, initial) = run(kind, 120, 1, STEPS);
                    let name = kind.name();
                    assert_eq!(scene.sanity_verdict(&initial), Ok(()), "{name}");
                    assert_eq!(scene.kind(), kind);
                    assert!(scene.body_count() > 0, "{name}");
                }
            }

            #[test]
            fn scenes_are_determined_by_their_seed() {
                for kind in SceneKind::ALL {
                    let [first, second, other] =
                        [5, 5, 6].map(|seed| hash(&run(kind, 80, seed, STEPS).0));
                    assert_eq!(first, second, "{}", kind.name());
                    assert_ne!(first, other, "{}", kind.name());
                }
            }

            #[test]
            fn scenes_may_be_tiny() {
                for kind in SceneKind::ALL {
                    for bodies in 0..4 {
                        let (scene, initial) = run(kind, bodies, 1, STEPS / 2);
                        let verdict = scene.sanity_verdict(&initial);
                        assert_eq!(verdict, Ok(()), "{} of {bodies}", kind.name());
                    }
                }
            }

            #[test]
            fn every_body_arrives() {
                for kind in SceneKind::ALL {
                    let (scene, _) = run(kind, 80, 1, 2 * STEPS);
                    let dynamic = scene.world.bodies.iter();
                    let movable = dynamic.filter(|(_, body)| !body.is_fixed()).count();
                    assert!((75..=80).contains(&movable), "{}: {movable}", kind.name());
                }
            }

            #[test]
            fn pyramid_falls_asleep() {
                let (scene, _) = run(SceneKind::Pyramid, 55, 1, 5 * STEPS);
                assert_eq!(scene.sanity().sleeping, 55);
            }

            #[test]
            fn most_of_sleeping_stays_asleep() {
                let (scene, _) = run(SceneKind::Sleeping, 120, 1, STEPS);
                assert!(scene.sanity().sleeping > 60, "{:?}", scene.sanity());
            }

            #[test]
            fn swarm_has_intersections() {
                let (scene, _) = run(SceneKind::Swarm, 120, 1, STEPS);
                let narrow_phase = &scene.world.narrow_phase;
                let pairs = narrow_phase.intersection_pairs();
                assert!(pairs.filter(|(_, _, intersecting)| *intersecting).count() > 0);
            }

            #[test]
            fn everything_moves_where_it_is_said_to() {
                for kind in SceneKind::ALL.into_iter().filter(|kind| kind.all_move()) {
                    let (mut scene, _) = run(kind, 120, 1, STEPS);
                    let places = |scene: &Scene| -> Vec<_> {
                        let bodies = scene.world.bodies.iter();
                        bodies.map(|(_, body)| *body.translation()).collect()
                    };
                    let before = places(&scene);
                    scene.step(&mut DefaultBroadPhase::new(), &(), &());
                    let after = places(&scene);
                    assert!(before.iter().zip(&after).all(|(old, new)| old != new));
                }
            }
        }
    };
}

scene_tests!(dim2);
scene_tests!(dim3);
scene_tests!(dim2_f64);
scene_tests!(dim3_f64);
