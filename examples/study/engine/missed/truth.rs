//! The ground truth: which shapes touch, by exact queries of every pair with boxes near each other.

use super::scenes::World;
use super::scenes::rapier::{
    math::DIM,
    parry::{bounding_volume::BoundingVolume, query},
    prelude::*,
};
use unisize::{Aabb, BruteForce, PairFinder};

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
    /// Compares every two boxes, and every two shapes whose loosened boxes overlap. **O(n²)**.
    pub(super) fn of(world: &World, typical_size: Real) -> Self {
        let prediction = world.params.prediction_distance();
        let enabled = world.colliders.iter_enabled();
        let (handles, colliders): (Vec<_>, Vec<_>) = enabled.unzip();
        let boxes: Vec<Aabb<Real, DIM>> = colliders
            .iter()
            .map(|collider| {
                let slack = SLACK * typical_size + prediction;
                let aabb = collider.compute_aabb().loosened(slack);
                Aabb::new(aabb.mins.coords.into(), aabb.maxs.coords.into())
            })
            .collect();
        let mut pairs = Vec::new();
        let found = BruteForce.find_pairs(&boxes, &mut pairs);
        found.expect("the boxes of a sane scene are valid");

        let mut truth = Self {
            touching: Vec::new(),
            near: Vec::new(),
        };
        for [i, j] in pairs.into_iter().map(|pair| pair.map(|i| i as usize)) {
            let (a, b) = (colliders[i], colliders[j]);
            if !world.may_touch(a, b) {
                continue;
            }
            let pair = ColliderPair::new(handles[i], handles[j]);
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
