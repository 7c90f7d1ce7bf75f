//! The ground truth: which shapes touch, by exact queries of every pair with boxes near each other.

use super::scenes::World;
use super::scenes::rapier::{parry::query, prelude::*};
use super::space::near_pairs;

/// The slack of boxes in typical sizes: much more than touching pairs need.
const SLACK: Real = 0.25;

/// The error of a distance, in units in the last place.
const ROUNDING: Real = 8.0;

/// The pairs of shapes that touch at one moment, without those that the narrow phase would drop.
pub(super) struct Truth {
    pub(super) touching: Vec<ColliderPair>,
    /// The pairs nearer than the prediction distance, up to rounding; touching ones included.
    pub(super) near: Vec<ColliderPair>,
}

impl Truth {
    /// Compares every two shapes whose loosened boxes overlap.
    pub(super) fn of(world: &World, typical_size: Real) -> Self {
        let prediction = world.params.prediction_distance();
        let mut truth = Self {
            touching: Vec::new(),
            near: Vec::new(),
        };
        for [b, a] in near_pairs(world, SLACK * typical_size + prediction) {
            let pair = ColliderPair::new(a.0, b.0);
            let (a, b) = (a.1, b.1);
            let distance = query::distance(a.position(), a.shape(), b.position(), b.shape());
            let distance = distance.expect("the shapes of the scenes are supported");
            let farthest = a.translation().amax().max(b.translation().amax());
            let rounding = ROUNDING * Real::EPSILON * farthest;
            if distance <= 0.0 {
                truth.touching.push(pair);
            }
            if distance <= (prediction - rounding).max(0.0) {
                truth.near.push(pair);
            }
        }
        truth
    }
}
