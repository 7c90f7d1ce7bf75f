//! How far apart the two ends are that a joint holds together.

use super::scenes::rapier::prelude::*;
use super::space::{distance, place};
use super::version::joined;
use super::{Gauge, Reading, Tally, World};

/// The stretch of all joints, in lengths of a link.
pub(crate) struct Stretch {
    link: f64,
    gaps: Tally,
}

impl Stretch {
    /// For links of this length.
    pub(crate) fn new(link: f64) -> Self {
        Self {
            link,
            gaps: Tally::default(),
        }
    }
}

impl Gauge for Stretch {
    fn look(&mut self, world: &World, _time: f64) {
        for (_, joint) in world.impulse_joints.iter() {
            let [first, second]: [&RigidBody; 2] = joined(joint).map(|body| &world.bodies[body]);
            let first = first.position() * joint.data.local_anchor1();
            let second = second.position() * joint.data.local_anchor2();
            let first = place(|axis| f64::from(first[axis]));
            let second = place(|axis| f64::from(second[axis]));
            self.gaps.add(distance(first, second) / self.link);
        }
    }

    fn read(&self) -> Vec<Reading> {
        vec![
            Reading {
                name: "mean stretch, links",
                value: self.gaps.mean(),
            },
            Reading {
                name: "largest stretch, links",
                value: self.gaps.largest,
            },
        ]
    }
}
