//! The tests of one flavour, for every flavour and for a patched Rapier.

/// Steps of the tests that look at a scene while it is in full motion.
pub(crate) const STEPS: usize = 60;

/// The tests of one flavour.
macro_rules! scene_tests {
    ($dim:ident) => {
        mod $dim {
            use super::suite::STEPS;
            use std::hash::{DefaultHasher, Hash, Hasher};
            use unisize_scenes::SceneKind;
            use unisize_scenes::$dim::rapier::math::{DIM, Real};
            use unisize_scenes::$dim::rapier::prelude::{DefaultBroadPhase, RigidBody};
            use unisize_scenes::$dim::{Observed, OwnBroadPhase, Sanity, Scene};
            use unisize_scenes::$dim::{Steppable, install, own_tree};

            /// Builds a scene and steps it.
            fn run(kind: SceneKind, bodies: usize, seed: u64, steps: usize) -> (Scene, Sanity) {
                let mut scene = Scene::build(kind, bodies, seed);
                let initial = scene.sanity();
                let mut broad_phase = install(Observed::new(OwnBroadPhase::new()).sorted());
                for _ in 0..steps {
                    scene.step(broad_phase.for_step(), &(), &());
                }
                (scene, initial)
            }

            /// Where a body is.
            fn place(body: &RigidBody) -> [Real; DIM] {
                std::array::from_fn(|axis| body.translation()[axis])
            }

            /// A hash of the bits of every pose.
            fn hash(scene: &Scene) -> u64 {
                let mut hasher = DefaultHasher::new();
                for (handle, body) in scene.world.bodies.iter() {
                    handle.into_raw_parts().hash(&mut hasher);
                    // Shortest decimals tell all bits of what is finite.
                    format!("{:?}", body.position()).hash(&mut hasher);
                }
                hasher.finish()
            }

            #[test]
            fn scenes_stay_sane_whatever_the_number_of_bodies() {
                for kind in SceneKind::ALL {
                    for bodies in [0, 1, 2, 3, 120] {
                        let (scene, initial) = run(kind, bodies, 1, STEPS);
                        let verdict = scene.sanity().verdict(&initial);
                        assert_eq!(verdict, Ok(()), "{} of {bodies}", kind.name());
                    }
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
            fn every_body_arrives() {
                for kind in SceneKind::ALL {
                    let (scene, _) = run(kind, 80, 1, 2 * STEPS);
                    let bodies = scene.world.bodies.iter();
                    let movable = bodies.filter(|(_, body)| !body.is_fixed());
                    let movable: usize = match kind {
                        SceneKind::Restated => scene.world.bodies.len(),
                        SceneKind::Ships | SceneKind::OneBody => {
                            movable.map(|(_, body)| body.colliders().len()).sum()
                        }
                        _ => movable.count(),
                    };
                    assert!((75..=80).contains(&movable), "{}: {movable}", kind.name());
                }
            }

            #[test]
            fn what_is_built_stands_and_falls_asleep() {
                for (kind, bodies) in [
                    (SceneKind::Pyramid, 55),
                    (SceneKind::Columns, 150),
                    (SceneKind::Stacks, 150),
                    (SceneKind::Wall, 150),
                    (SceneKind::Pyramids, 150),
                ] {
                    let built = Scene::build(kind, bodies, 1);
                    let (scene, _) = run(kind, bodies, 1, 5 * STEPS);
                    let name = kind.name();
                    assert_eq!(scene.sanity().sleeping, bodies, "{name}");
                    for (handle, body) in scene.world.bodies.iter() {
                        let [now, then] = [body, &built.world.bodies[handle]].map(place);
                        let is_there = |axis: usize| (now[axis] - then[axis]).abs() < 0.2;
                        assert!((0..DIM).all(is_there), "{name}: {now:?}, not {then:?}");
                    }
                }
            }

            #[test]
            fn scenes_are_what_they_are_called() {
                let (scene, _) = run(SceneKind::Sleeping, 120, 1, STEPS);
                assert!(scene.sanity().sleeping > 60, "{:?}", scene.sanity());
                let (scene, _) = run(SceneKind::Swarm, 120, 1, STEPS);
                let mut pairs = scene.world.narrow_phase.intersection_pairs();
                assert!(pairs.any(|(_, _, intersecting)| intersecting));
                let (scene, _) = run(SceneKind::Ships, 3 * 12 * 12 * 12, 1, 1);
                assert_eq!(scene.world.bodies.len(), 6);
                assert_eq!(scene.world.colliders.len(), 3 * 12 * 12 * 12);
                let (scene, _) = run(SceneKind::TileMap, 500, 1, 1);
                assert_eq!(scene.world.colliders.len(), 500 + 30_000);
                let (scene, _) = run(SceneKind::TileMap, 60, 1, 5 * STEPS);
                let on_map = |body: &RigidBody| (0.0..4.0).contains(&place(body)[1]);
                assert!(scene.world.bodies.iter().all(|(_, body)| on_map(body)));
                let (scene, _) = run(SceneKind::Touched, 120, 1, STEPS);
                assert_eq!(scene.sanity().sleeping, 120);
            }

            /// The pairs with a contact, and those without.
            fn pairs(scene: &Scene) -> [usize; 2] {
                let in_vain = scene.world.pairs_without_contact();
                let all = scene.world.narrow_phase.contact_pairs().count();
                [all - in_vain, in_vain]
            }

            #[test]
            fn boxes_of_chains_overlap_and_few_links_touch() {
                let mut most = 0;
                for steps in [STEPS / 3, STEPS / 2, STEPS] {
                    let (scene, _) = run(SceneKind::Chains, 400, 1, steps);
                    let [touching, in_vain] = pairs(&scene);
                    // More than the neighbours in a chain, which are joined.
                    assert!(in_vain > 2 * 400, "{in_vain}");
                    assert!(touching * 10 < in_vain, "{touching} and {in_vain}");
                    most = most.max(touching);
                }
                assert!(DIM == 2 || most > 0, "no chains touch");
            }

            #[test]
            fn grains_touch_in_a_hopper_and_every_pair_of_stacks_touches() {
                let (scene, _) = run(SceneKind::Hopper, 400, 1, STEPS);
                let [touching, in_vain] = pairs(&scene);
                assert!(touching > 50, "{touching} and {in_vain}");
                let (scene, _) = run(SceneKind::Stacks, 300, 1, STEPS);
                assert_eq!(pairs(&scene), [300, 0]);
            }

            #[test]
            fn a_crowd_stands_on_its_ground() {
                let (scene, _) = run(SceneKind::Crowd, 100, 1, STEPS);
                let [touching, _] = pairs(&scene);
                assert!(DIM == 2 || touching >= 95, "{touching}");
            }

            #[test]
            fn what_has_settled_stays() {
                for kind in [SceneKind::SettledPile, SceneKind::SettledHeap] {
                    let name = kind.name();
                    let built = Scene::build(kind, 150, 1);
                    assert_eq!(built.sanity().sleeping, 0, "{name}");
                    let (scene, _) = run(kind, 150, 1, STEPS);
                    let [touching, _] = pairs(&scene);
                    assert!(touching > 150, "{name}: {touching}");
                    let stays = |&(handle, body): &(_, &RigidBody)| {
                        let [now, then] = [body, &built.world.bodies[handle]].map(place);
                        (0..DIM).all(|axis| (now[axis] - then[axis]).abs() < 0.05)
                    };
                    // In a heap, a few bodies still slide.
                    let count = scene.world.bodies.iter().filter(stays).count();
                    assert!(count >= 145, "{name}: {count} of 150 stay");
                }
            }

            #[test]
            fn the_player_walks_and_looks_around() {
                let mut scene = Scene::build(SceneKind::Player, 120, 1);
                let (player, _) = scene.world.bodies.iter().next().expect("the player");
                let mut before = place(&scene.world.bodies[player]);
                let mut way = 0.0;
                let mut broad_phase = DefaultBroadPhase::new();
                for _ in 0..3 * STEPS {
                    scene.step(broad_phase.for_step(), &(), &());
                    let now = place(&scene.world.bodies[player]);
                    assert!(now[1] > 0.5, "{now:?}");
                    let moved = (0..DIM).map(|axis| (now[axis] - before[axis]).powi(2));
                    way += moved.sum::<Real>().sqrt();
                    before = now;
                }
                // Three seconds at a speed of 4, less what is lost where it turns.
                assert!((4.0..14.0).contains(&way), "{way}");
                assert_eq!(scene.rays().len(), 16);
            }

            #[test]
            fn the_broad_phase_answers_as_a_tree_of_its_own() {
                let [mut asking, mut own] =
                    [(); 2].map(|()| Scene::build(SceneKind::Player, 60, 1));
                let sorted = || install(Observed::new(OwnBroadPhase::new()).sorted());
                let [mut asked, mut other] = [sorted(), sorted()];
                // The broad phase has no tree before its first update.
                asking.step(asked.for_step(), &(), &());
                own.step(other.for_step(), &(), &());
                for _ in 1..STEPS / 2 {
                    asking.prepare_asking(|| own_tree(&asked.inner));
                    asking.world.step(asked.for_step(), &(), &());
                    own.step(other.for_step(), &(), &());
                }
                assert_eq!(hash(&asking), hash(&own));
            }
        }
    };
}
