//! Bodies of about as many colliders as have volumes of their own.

use super::ordered::{Ordered, at_both_levels};
use super::random::Random;
use super::rapier::prelude::*;
use super::scenes::own;
use super::twins::{at, cuboid};

/// How many cubes a ship has in a row.
const ROW: usize = 8;

struct Fleet {
    worlds: Ordered,
    random: Random,
    ships: Vec<RigidBodyHandle>,
    cubes: Vec<ColliderHandle>,
}

impl Fleet {
    /// Ships of 32, 33 and 34 cubes that fly at each other.
    fn new(mut worlds: Ordered) -> Self {
        worlds.twins = worlds.twins.without_gravity();
        let (mut ships, mut cubes) = (Vec::new(), Vec::new());
        for (i, count) in [32, 33, 34].into_iter().enumerate() {
            let side = i as Real - 1.0;
            let ship = RigidBodyBuilder::dynamic()
                .translation(at(2.2 * side, 5.0 * side))
                .linvel(at(-0.3 * side, -2.0 * side))
                .can_sleep(false);
            let ship = worlds.twins.both(|world| world.bodies.insert(ship.clone()));
            for cube in 0..count {
                let [x, y] = [cube % ROW, cube / ROW].map(|i| 0.5 * i as Real);
                let cube = cuboid([0.25; 3]).translation(at(x, y));
                cubes.push(worlds.twins.insert_part(ship, cube));
            }
            ships.push(ship);
        }
        Self {
            worlds,
            random: Random::new(8),
            ships,
            cubes,
        }
    }

    fn size(&self, ship: RigidBodyHandle) -> usize {
        self.worlds.twins.ours.bodies[ship].colliders().len()
    }

    /// Has a cube go on where it is as a part of another body: of a new one, or of a ship.
    fn reassign(&mut self) {
        let size = |&&ship: &&RigidBodyHandle| self.size(ship);
        let largest = *self.ships.iter().max_by_key(size).expect("there are three");
        let ship = self.random.pick(&self.ships);
        let cubes = match self.random.below(2) {
            0 => self.worlds.twins.ours.bodies[largest].colliders(),
            _ => &self.cubes,
        };
        let cube = self.random.pick(cubes);
        let is_broken_off = self.random.below(8) == 0;
        self.worlds.twins.both(|world| {
            let bodies = &mut world.bodies;
            let former = world.colliders[cube].parent().expect("a part");
            let place = *bodies[former].position()
                * *world.colliders[cube].position_wrt_parent().expect("a part");
            let body = match is_broken_off {
                true => {
                    let velocity = own(bodies[former].linvel());
                    let piece = RigidBodyBuilder::dynamic().linvel(velocity);
                    let piece = bodies.insert(piece.can_sleep(false));
                    bodies[piece].set_position(place, true);
                    piece
                }
                false => ship,
            };
            let inside = bodies[body].position().inverse() * place;
            world.colliders.set_parent(cube, Some(body), bodies);
            world.colliders[cube].set_position_wrt_parent(inside);
        });
    }
}

/// Whether a body's colliders have volumes depends on how many there are, and so changes without any of the others being changed.
#[test]
fn ships_that_break_and_are_welded() {
    at_both_levels(|worlds| {
        let mut fleet = Fleet::new(worlds);
        let sizes = |fleet: &Fleet| [0, 1, 2].map(|i| fleet.size(fleet.ships[i]) > 32);
        let (mut crossings, mut contacts, mut former) = (0, 0, sizes(&fleet));
        for step in 0..80 {
            for _ in 0..step % 4 {
                fleet.reassign();
            }
            contacts += fleet.worlds.step().contacts.len();
            let sizes = sizes(&fleet);
            crossings += (0..3).filter(|&i| sizes[i] != former[i]).count();
            former = sizes;
        }
        assert!(crossings > 5, "only {crossings} crossings");
        assert!(contacts > 200, "only {contacts} contacts");
    });
}
