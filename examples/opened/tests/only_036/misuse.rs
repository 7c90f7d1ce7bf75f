//! What a user may do wrong, or may not be sure about.

use super::physics_world::{unisize, world_with};
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic};
use super::{Settings, UnisizeBroadPhase, install};

#[path = "../../../../tests/told/mod.rs"]
mod told;
use told::told;

/// A world in which balls bounce about.
fn lively(broad_phase: UnisizeBroadPhase) -> PhysicsWorld {
    let mut world = world_with(broad_phase);
    let floor = cuboid([50.0, 1.0, 50.0]).translation(at(0.0, -1.0));
    world.insert_collider(floor, None);
    for i in 0..20 {
        let ball = ColliderBuilder::ball(0.5).restitution(0.7);
        world.insert(dynamic(3.0 * i as Real, 1.0 + 0.1 * i as Real), ball);
    }
    world
}

fn heights(world: &PhysicsWorld) -> Vec<Real> {
    let bodies = world.bodies.iter();
    bodies.map(|(_, body)| body.translation().y).collect()
}

/// The world, which leaves it out, and it by itself.
#[test]
fn a_snapshot_of_it_goes_on_as_it_was() {
    let mut saved = lively(UnisizeBroadPhase::new());
    for step in 0..120 {
        saved.step();
        if step % 40 != 20 {
            continue;
        }
        // Boxes were handed over at the end of the step.
        let ours = postcard::to_stdvec(unisize(&saved)).unwrap();
        let rest = postcard::to_stdvec(&saved).unwrap();

        let mut restored: PhysicsWorld = postcard::from_bytes(&rest).unwrap();
        let ours: UnisizeBroadPhase = postcard::from_bytes(&ours).unwrap();
        ours.validate();
        assert_eq!(told(&ours.stats()), told(&unisize(&saved).stats()));
        restored.broad_phase = DefaultBroadPhase::custom(ours);
        let mut expected = saved.broad_phase.clone();
        std::mem::swap(&mut expected, &mut saved.broad_phase);
        for _ in 0..60 {
            saved.step();
            restored.step();
            assert_eq!(heights(&saved), heights(&restored));
            assert_eq!(
                told(&unisize(&saved).stats()),
                told(&unisize(&restored).stats())
            );
        }
    }
}

#[test]
fn a_clone_goes_its_own_way() {
    let mut world = lively(UnisizeBroadPhase::new());
    for _ in 0..10 {
        world.step();
    }
    let clone = world.broad_phase.clone();
    let ours: &UnisizeBroadPhase = clone.custom_ref().unwrap();
    let before = ours.stats();
    assert_eq!(before, unisize(&world).stats());
    for _ in 0..60 {
        world.step();
    }
    assert_eq!(ours.stats(), before);
    assert_ne!(unisize(&world).stats(), before);
    ours.validate();
    // A world that goes on with the clone.
    let mut other = lively(UnisizeBroadPhase::new());
    for _ in 0..10 {
        other.step();
    }
    other.broad_phase = clone;
    for _ in 0..60 {
        other.step();
    }
    assert_eq!(heights(&other), heights(&world));
}

#[test]
fn two_worlds_with_one_broad_phase_each() {
    let mut worlds = [0.01, 0.2].map(|margin| {
        let settings = Settings::default().with_margin(margin);
        lively(UnisizeBroadPhase::with_settings(settings))
    });
    let extra = worlds[1].insert(dynamic(-9.0, 0.5), cube()).0;
    for step in 0..60 {
        worlds[step % 2].step();
        for world in &worlds {
            unisize(world).validate();
        }
    }
    let [first, second] = worlds.each_ref().map(|world| unisize(world).stats());
    assert_eq!([first.proxies, second.proxies], [21, 22]);
    assert_eq!([first.updates, second.updates], [30, 30]);
    assert!(worlds[1].bodies.contains(extra));
}

#[test]
fn it_is_found_by_its_own_type_only() {
    #[derive(Clone)]
    struct Other;

    impl CustomBroadPhase for Other {
        fn update(
            &mut self,
            _: &IntegrationParameters,
            _: &ColliderSet,
            _: &RigidBodySet,
            _: &[ColliderHandle],
            _: &[ColliderHandle],
            _: &mut Vec<BroadPhasePairEvent>,
        ) {
        }

        fn set_aabb(&mut self, _: &IntegrationParameters, _: ColliderHandle, _: Aabb) {}

        fn bvh(&self) -> &Bvh {
            unreachable!("nobody asks")
        }

        fn clone_box(&self) -> Box<dyn CustomBroadPhase> {
            Box::new(self.clone())
        }
    }

    let mut ours = DefaultBroadPhase::custom(UnisizeBroadPhase::new());
    assert!(ours.custom_ref::<UnisizeBroadPhase>().is_some());
    assert!(ours.custom_mut::<UnisizeBroadPhase>().is_some());
    assert!(ours.custom_ref::<Other>().is_none());
    assert!(ours.custom_mut::<Other>().is_none());
    let mut theirs = DefaultBroadPhase::new();
    assert!(theirs.custom_ref::<UnisizeBroadPhase>().is_none());
    assert!(theirs.custom_mut::<UnisizeBroadPhase>().is_none());
}

/// Another one in the midst of a simulation knows no collider, as another one of Rapier's does not: those that are handed over
/// it gets to know, and the others when they are listed.
#[test]
fn another_one_in_the_midst_of_a_simulation() {
    let mut twins = Twins::heavy();
    twins.insert_floor();
    twins.insert(dynamic(0.0, 3.0), cube());
    twins.steps(5);
    twins.unisize = install(UnisizeBroadPhase::new());
    twins.default = DefaultBroadPhase::new();
    twins.steps(20);
    twins.both(|world| {
        for (_, collider) in world.colliders.iter_mut() {
            collider.set_friction(0.4);
            collider.set_shape(collider.shared_shape().clone());
        }
    });
    twins.steps(120);
}
