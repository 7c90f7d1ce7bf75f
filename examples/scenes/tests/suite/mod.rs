//! The tests of one flavour, for every flavour and for an opened Rapier.

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
            use unisize_scenes::$dim::{Steppable, access_to_own, install};

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
                    let bodies = scene.world.bodies.iter();
                    let movable = bodies.filter(|(_, body)| !body.is_fixed());
                    let movable: usize = match kind {
                        SceneKind::Ships => movable.map(|(_, body)| body.colliders().len()).sum(),
                        _ => movable.count(),
                    };
                    assert!((75..=80).contains(&movable), "{}: {movable}", kind.name());
                }
            }

            #[test]
            fn pyramid_falls_asleep() {
                let (scene, _) = run(SceneKind::Pyramid, 55, 1, 5 * STEPS);
                assert_eq!(scene.sanity().sleeping, 55);
            }

            #[test]
            fn what_is_built_stands_and_falls_asleep() {
                for kind in [SceneKind::Stacks, SceneKind::Wall, SceneKind::Pyramids] {
                    let built = Scene::build(kind, 150, 1);
                    let (scene, _) = run(kind, 150, 1, 5 * STEPS);
                    assert_eq!(scene.sanity().sleeping, 150, "{}", kind.name());
                    for (handle, body) in scene.world.bodies.iter() {
                        let [now, then] = [body, &built.world.bodies[handle]].map(place);
                        let is_there = |axis: usize| (now[axis] - then[axis]).abs() < 0.2;
                        let name = kind.name();
                        assert!(
                            (0..DIM).all(is_there),
                            "{name}: {now:?} instead of {then:?}"
                        );
                    }
                }
            }

            #[test]
            fn boxes_of_chains_overlap_and_links_do_not() {
                let (scene, _) = run(SceneKind::Chains, 400, 1, STEPS);
                let in_vain = scene.world.pairs_without_contact();
                // More than the neighbours in a chain, which are joined.
                assert!(in_vain > 2 * 400, "{in_vain}");
                // Chains that swing may meet here and there.
                let pairs = scene.world.narrow_phase.contact_pairs().count();
                assert!(100 * in_vain >= 99 * pairs, "{in_vain} of {pairs}");
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
            fn ships_are_three_bodies_with_cargo() {
                let (scene, _) = run(SceneKind::Ships, 3 * 12 * 12 * 12, 1, 1);
                assert_eq!(scene.body_count(), 6);
                assert_eq!(scene.world.colliders.len(), 3 * 12 * 12 * 12);
            }

            #[test]
            fn tiles_are_sixty_to_a_ball() {
                let (scene, _) = run(SceneKind::TileMap, 500, 1, 1);
                assert_eq!(scene.body_count(), 500);
                assert_eq!(scene.world.colliders.len(), 500 + 30_000);
            }

            #[test]
            fn balls_land_on_the_map() {
                let (scene, _) = run(SceneKind::TileMap, 60, 1, 5 * STEPS);
                for (_, body) in scene.world.bodies.iter() {
                    assert!(place(body)[1] < 4.0, "{:?}", place(body));
                }
                assert_eq!(scene.sanity().fallen_through, 0);
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
                let access = access_to_own();
                let [mut asking, mut own] =
                    [(); 2].map(|()| Scene::build(SceneKind::Player, 60, 1));
                let sorted = || install(Observed::new(OwnBroadPhase::new()).sorted());
                let [mut asked, mut other] = [sorted(), sorted()];
                // The broad phase has no tree before its first update.
                asking.step(asked.for_step(), &(), &());
                own.step(other.for_step(), &(), &());
                for _ in 1..STEPS / 2 {
                    asking.prepare_asking(&access.to(&asked.inner));
                    asking.world.step(asked.for_step(), &(), &());
                    own.step(other.for_step(), &(), &());
                }
                assert_eq!(hash(&asking), hash(&own));
            }

            #[test]
            fn everything_moves_where_it_is_said_to() {
                for kind in SceneKind::ALL.into_iter().filter(|kind| kind.all_move()) {
                    let (mut scene, _) = run(kind, 120, 1, STEPS);
                    let places = |scene: &Scene| -> Vec<_> {
                        let bodies = scene.world.bodies.iter();
                        bodies.map(|(_, body)| place(body)).collect()
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
