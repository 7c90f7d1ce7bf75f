//! Beside Rapier's own `PhysicsPipeline`: before each step ours is given what has moved, and after it, its pairs must
//! be those that the narrow phase holds.

use super::*;

struct Stepped {
    world: PhysicsWorld,
    ours: UnisizeBroadPhase,
    /// The same, but it leaves nothing out.
    unfiltered: UnisizeBroadPhase,
    removed: Vec<ColliderHandle>,
    /// The greatest numbers of pairs and of those left out so far.
    most: [usize; 2],
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
            unfiltered: UnisizeBroadPhase::with_settings(
                Settings::default().with_filter(PairFilter::Off),
            ),
            removed: Vec::new(),
            most: [0; 2],
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

    fn step(&mut self) {
        let PhysicsWorld {
            bodies, colliders, ..
        } = &self.world;
        // What has not moved has not left its box.
        let all: Vec<_> = colliders.iter().map(|(handle, _)| handle).collect();
        let params = self.world.integration_parameters;
        for broad_phase in [&mut self.ours, &mut self.unfiltered] {
            let removed = &self.removed;
            broad_phase.update(&params, colliders, bodies, &all, removed, &mut Vec::new());
        }
        self.removed.clear();
        self.world.step();

        let narrow_phase = &self.world.narrow_phase;
        let contacts = narrow_phase.contact_pairs();
        let contacts = contacts.map(|pair| raw(pair.collider1, pair.collider2));
        let meetings = narrow_phase.intersection_pairs();
        let meetings = meetings.map(|(first, second, _)| raw(first, second));
        let theirs: BTreeSet<_> = contacts.chain(meetings).collect();
        let ours = pairs(&self.ours);
        assert_eq!(ours, theirs);
        self.ours.validate();
        let unfiltered = pairs(&self.unfiltered);
        assert!(unfiltered.is_superset(&ours));
        self.most[0] = self.most[0].max(ours.len());
        self.most[1] = self.most[1].max(unfiltered.len() - ours.len());
    }
}

#[test]
fn the_same_pairs() {
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
            stepped.step();
        }
        let [held, left_out] = stepped.most;
        assert!(
            held > 60 && left_out > 20,
            "{held} pairs, {left_out} left out"
        );
    }
}
