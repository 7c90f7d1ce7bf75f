//! A program puts sets back from clones, or colliders and bodies, while the broad phase stays: what follows is the same as on Rapier's own.

use super::rapier::prelude::*;
use super::scenes::groups;
use super::twins::{Twins, at, cube, dynamic};
use super::{PairFilter, World};

const FILTERS: [PairFilter; 4] = [
    PairFilter::Off,
    PairFilter::Bodies,
    PairFilter::Groups,
    PairFilter::Shapes,
];

/// Clones of the sets of a world, and of the state of its islands and contacts.
struct Saved {
    bodies: RigidBodySet,
    colliders: ColliderSet,
    islands: IslandManager,
    narrow_phase: NarrowPhase,
}

impl Saved {
    fn of(world: &World) -> Self {
        Self {
            bodies: world.bodies.clone(),
            colliders: world.colliders.clone(),
            islands: world.islands.clone(),
            narrow_phase: world.narrow_phase.clone(),
        }
    }

    fn put_back(&self, world: &mut World) {
        world.bodies = self.bodies.clone();
        world.colliders = self.colliders.clone();
        world.islands = self.islands.clone();
        world.narrow_phase = self.narrow_phase.clone();
    }
}

/// The floor and the cube of a world.
#[derive(Clone, Copy)]
struct Handles {
    bodies: [RigidBodyHandle; 2],
    cube: ColliderHandle,
}

/// Changes of the cube after which it does not meet the floor.
const CHANGES: [fn(&mut World, Handles); 5] = [
    |world, Handles { bodies, .. }| {
        world.bodies[bodies[1]].set_body_type(RigidBodyType::Fixed, true)
    },
    |world, Handles { cube, .. }| {
        world.colliders[cube].set_collision_groups(groups(Group::NONE, Group::NONE));
    },
    |world, Handles { bodies, cube }| {
        let World {
            bodies: all,
            colliders,
            ..
        } = world;
        colliders.set_parent(cube, Some(bodies[0]), all);
    },
    |world, Handles { cube, .. }| {
        world.colliders[cube].set_active_collision_types(ActiveCollisionTypes::empty());
    },
    |world, Handles { bodies, .. }| {
        world.remove(bodies[1]);
        world.insert(dynamic(50.0, 50.0), cube());
    },
];

/// A cube that falls towards a floor.
fn falling(filter: PairFilter) -> (Twins, Handles) {
    let mut twins = Twins::with_filter(filter);
    let (floor, _) = twins.insert_floor();
    let (body, cube) = twins.insert(dynamic(0.0, 1.5), cube());
    let bodies = [floor, body];
    (twins, Handles { bodies, cube })
}

/// Steps until a cube that has not been changed would lie on the floor, and panics unless it does.
fn land(twins: &mut Twins, Handles { bodies, .. }: Handles) {
    twins.steps(60);
    let height = twins.ours.bodies[bodies[1]].translation().y;
    assert!((height - 0.5).abs() < 0.05, "the cube is at {height}");
}

#[test]
fn sets_are_put_back_while_the_broad_phase_stays() {
    for filter in FILTERS {
        for change in CHANGES {
            for (before, after) in [(5, 1), (5, 2), (5, 3), (60, 1), (60, 3)] {
                let (mut twins, handles) = falling(filter);
                twins.steps(before);
                let saved = [&twins.ours, &twins.theirs].map(Saved::of);
                twins.both(|world| change(world, handles));
                twins.steps(after);
                saved[0].put_back(&mut twins.ours);
                saved[1].put_back(&mut twins.theirs);
                land(&mut twins, handles);
            }
        }
    }
}

/// The bodies alone, in which the cube is another one.
#[test]
fn bodies_are_put_back_while_the_colliders_stay() {
    for filter in FILTERS {
        let (mut twins, handles) = falling(filter);
        twins.steps(5);
        let saved = [&twins.ours, &twins.theirs].map(Saved::of);
        twins.both(|world| CHANGES[0](world, handles));
        twins.steps(2);
        for (saved, world) in saved.into_iter().zip([&mut twins.ours, &mut twins.theirs]) {
            (world.bodies, world.islands) = (saved.bodies, saved.islands);
        }
        land(&mut twins, handles);
    }
}

/// An editor undoes a change.
#[test]
fn a_collider_is_assigned() {
    for filter in FILTERS {
        for change in [CHANGES[1], CHANGES[3]] {
            let (mut twins, handles) = falling(filter);
            twins.steps(5);
            let cube = handles.cube;
            let saved = [&twins.ours, &twins.theirs].map(|world| world.colliders[cube].clone());
            twins.both(|world| change(world, handles));
            twins.steps(2);
            let [ours, theirs] = saved;
            (twins.ours.colliders[cube], twins.theirs.colliders[cube]) = (ours, theirs);
            land(&mut twins, handles);
        }
    }
}

/// Two platforms in one place, of which the cube meets one.
#[test]
fn colliders_are_swapped() {
    for filter in FILTERS {
        let mut twins = Twins::with_filter(filter);
        let platform = |bits| cube().collision_groups(groups(bits, bits));
        let platforms = [Group::NONE, Group::ALL].map(|bits| {
            twins.both(|world| {
                world
                    .colliders
                    .insert(platform(bits).translation(at(0.0, -0.5)))
            })
        });
        let (body, cube) = twins.insert(dynamic(0.0, 1.5), cube());
        twins.steps(5);
        twins.both(|world| {
            let swapped = platforms.map(|platform| world.colliders[platform].clone());
            let [first, second] = swapped;
            world.colliders[platforms[0]] = second;
            world.colliders[platforms[1]] = first;
        });
        let bodies = [body; 2];
        land(&mut twins, Handles { bodies, cube });
    }
}
