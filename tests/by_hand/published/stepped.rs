//! Runs next to Rapier's own `PhysicsPipeline`. Before each step unisize receives all colliders; after the step its pairs must be those of the
//! narrow phase.

use std::collections::BTreeSet;

use oorandom::Rand32;

use super::*;

/// Two colliders, by index and generation, the smaller index first.
type Pair = [(u32, u32); 2];

fn raw(first: ColliderHandle, second: ColliderHandle) -> Pair {
    let mut pair = [first, second].map(|handle| handle.into_raw_parts());
    pair.sort_unstable();
    pair
}

/// A vector with each coordinate within this distance of 0.
fn within(random: &mut Rand32, distance: Real) -> Vector {
    Vector::from(std::array::from_fn(|_| {
        distance * Real::from(2.0 * random.rand_float() - 1.0)
    }))
}

fn shape(random: &mut Rand32) -> SharedShape {
    let mut length = || Real::from(0.2 + 0.6 * random.rand_float());
    let lengths = [(); 2].map(|()| length());
    match random.rand_range(0..3) {
        0 => SharedShape::ball(lengths[0]),
        1 => SharedShape::new(Cuboid::new(
            Vector::splat(lengths[0]) + Vector::X * lengths[1],
        )),
        _ => SharedShape::capsule_x(lengths[0], lengths[1]),
    }
}

fn groups(random: &mut Rand32) -> InteractionGroups {
    let groups = [Group::ALL, Group::ALL, Group::GROUP_1, Group::GROUP_2];
    let mut group = || groups[random.rand_range(0..4) as usize];
    InteractionGroups::new(group(), group(), InteractionTestMode::And)
}

/// A collider whose shape, groups, collision types and sensor flag are random.
fn collider(random: &mut Rand32) -> ColliderBuilder {
    let types = match random.rand_range(0..5) {
        0 => ActiveCollisionTypes::all(),
        1 => ActiveCollisionTypes::empty(),
        _ => ActiveCollisionTypes::default(),
    };
    ColliderBuilder::new(shape(random))
        .sensor(random.rand_range(0..4) == 0)
        .collision_groups(groups(random))
        .active_collision_types(types)
}

fn body(random: &mut Rand32) -> RigidBodyBuilder {
    match random.rand_range(0..6) {
        0 => RigidBodyBuilder::fixed(),
        1 => RigidBodyBuilder::kinematic_velocity_based().linvel(within(random, 2.0)),
        _ => RigidBodyBuilder::dynamic(),
    }
}

struct Stepped {
    world: PhysicsWorld,
    ours: UnisizeBroadPhase,
    removed: Vec<ColliderHandle>,
    /// The largest number of pairs so far.
    most: usize,
}

impl Stepped {
    fn new() -> Self {
        let mut world = PhysicsWorld::default();
        let floor = SharedShape::new(Cuboid::new(Vector::ONE * 20.0));
        world.insert(
            RigidBodyBuilder::fixed().translation(Vector::Y * -20.0),
            ColliderBuilder::new(floor),
        );
        Self {
            world,
            ours: UnisizeBroadPhase::with_settings(
                Settings::default().with_filter(PairFilter::Groups),
            ),
            removed: Vec::new(),
            most: 0,
        }
    }

    fn insert(&mut self, random: &mut Rand32) {
        let place = within(random, 3.0) + Vector::Y * 4.0;
        let (body, _) = self
            .world
            .insert(body(random).translation(place), collider(random));
        for _ in 0..random.rand_range(0..2) {
            let second = collider(random).translation(within(random, 0.5));
            let PhysicsWorld {
                bodies, colliders, ..
            } = &mut self.world;
            colliders.insert_with_parent(second, body, bodies);
        }
    }

    fn remove(&mut self, random: &mut Rand32) {
        let count = self.world.bodies.len() as u32;
        let nth = random.rand_range(1..count) as usize;
        let Some((body, data)) = self.world.bodies.iter().nth(nth) else {
            return;
        };
        self.removed.extend_from_slice(data.colliders());
        self.world.remove_body(body);
    }

    /// Changes the groups of a collider, which may be at rest.
    fn regroup(&mut self, random: &mut Rand32) {
        let colliders = &mut self.world.colliders;
        let nth = random.rand_range(0..colliders.len() as u32) as usize;
        let nth = colliders.iter().nth(nth).map(|(handle, _)| handle);
        let collider = nth.and_then(|handle| colliders.get_mut(handle));
        if let Some(collider) = collider {
            collider.set_collision_groups(groups(random));
        }
    }

    fn step(&mut self) {
        let PhysicsWorld {
            bodies, colliders, ..
        } = &self.world;
        // A collider that has not moved keeps its box.
        let all: Vec<_> = colliders.iter().map(|(handle, _)| handle).collect();
        let params = self.world.integration_parameters;
        let removed = std::mem::take(&mut self.removed);
        let events = &mut Vec::new();
        self.ours
            .update(&params, colliders, bodies, &all, &removed, events);
        self.world.step();

        let narrow_phase = &self.world.narrow_phase;
        let contacts = narrow_phase.contact_pairs();
        let contacts = contacts.map(|pair| raw(pair.collider1, pair.collider2));
        let meetings = narrow_phase.intersection_pairs();
        let meetings = meetings.map(|(first, second, _)| raw(first, second));
        let theirs: BTreeSet<_> = contacts.chain(meetings).collect();
        let ours = self.ours.pairs();
        let ours = ours.map(|pair| raw(pair.collider1, pair.collider2));
        let ours: BTreeSet<_> = ours.collect();
        assert_eq!(ours, theirs);
        self.ours.validate();
        self.most = self.most.max(ours.len());
    }
}

#[test]
fn pairs_are_those_of_the_narrow_phase() {
    for seed in 0..6 {
        let mut random = Rand32::new(seed);
        let mut stepped = Stepped::new();
        for _ in 0..60 {
            stepped.insert(&mut random);
        }
        for step in 0..200 {
            if step % 10 == 9 {
                stepped.insert(&mut random);
                stepped.remove(&mut random);
            }
            if step % 3 == 0 {
                stepped.regroup(&mut random);
            }
            stepped.step();
        }
        assert!(stepped.most > 60, "{} pairs", stepped.most);
    }
}
