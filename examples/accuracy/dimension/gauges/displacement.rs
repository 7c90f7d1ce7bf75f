//! How far bodies are at the end from where they should have stayed.

use super::scenes::rapier::prelude::*;
use super::space::{distance, place_of};
use super::{Gauge, Place, Reading, Tally, World};

/// The distance of bodies from where they should be, in sizes.
pub(crate) struct Displacement {
    size: f64,
    places: Vec<(RigidBodyHandle, Place)>,
    last: Tally,
}

impl Displacement {
    /// For dynamic bodies of this size, which should stay where they are.
    pub(crate) fn new(world: &World, size: f64) -> Self {
        let bodies = world.bodies.iter().filter(|(_, body)| body.is_dynamic());
        Self {
            size,
            places: bodies
                .map(|(handle, body)| (handle, place_of(body)))
                .collect(),
            last: Tally::default(),
        }
    }
}

impl Gauge for Displacement {
    fn look(&mut self, world: &World, _time: f64) {
        self.last = Tally::default();
        for &(handle, place) in &self.places {
            let way = distance(place_of(&world.bodies[handle]), place);
            self.last.add(way / self.size);
        }
    }

    fn read(&self) -> Vec<Reading> {
        vec![
            Reading {
                name: "mean distance from its place, sizes",
                value: self.last.mean(),
            },
            Reading {
                name: "largest distance from its place, sizes",
                value: self.last.largest,
            },
        ]
    }
}
