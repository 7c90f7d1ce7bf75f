//! A crowd without a pipeline: walkers steer to their goals, and those that overlap push each other apart.
//!
//! ```text
//! cargo run --release --features rapier2d-036 --example crowd2d
//! ```
//!
//! The program drives the broad phase: `update` takes the colliders that have moved, reports which pairs begin and end, and `pairs` returns
//! the present pairs. This needs no patched copy of Rapier 0.36; in 0.27 the calls are the same. Prints the time of an update. Fails if
//! the events do not add up to the pairs, or if two overlapping walkers are not reported as a pair.

use std::collections::HashSet;
use std::time::{Duration, Instant};

use rapier2d_036::prelude::*; // In your project: rapier2d.
use unisize::rapier2d_036::UnisizeBroadPhase;

const WALKERS: usize = 5000;
const RADIUS: f32 = 0.3;
/// Half the width of the square.
const HALF: f32 = 60.0;
const SPEED: f32 = 1.4;
const STEPS: usize = 300;

fn main() {
    let mut random = oorandom::Rand32::new(1);
    let mut anywhere = || {
        let mut coordinate = || HALF * (2.0 * random.rand_float() - 1.0);
        Vector::new(coordinate(), coordinate())
    };
    let mut colliders = ColliderSet::new();
    let walkers: Vec<_> = (0..WALKERS)
        .map(|_| {
            // A collider without a body counts as fixed, and by default two fixed colliders form no pair.
            let walker = ColliderBuilder::ball(RADIUS)
                .active_collision_types(ActiveCollisionTypes::all())
                .translation(anywhere());
            colliders.insert(walker)
        })
        .collect();
    let mut goals: Vec<_> = walkers.iter().map(|_| anywhere()).collect();

    let params = IntegrationParameters::default();
    let bodies = RigidBodySet::new();
    let mut broad_phase = UnisizeBroadPhase::new();
    let mut pairs = HashSet::new();
    let mut events = Vec::new();
    let mut time = Duration::ZERO;
    for _ in 0..STEPS {
        for (&walker, goal) in walkers.iter().zip(&mut goals) {
            let position = colliders[walker].translation();
            let to_goal = *goal - position;
            if to_goal.length() < 1.0 {
                *goal = anywhere();
            }
            let step = to_goal.normalize_or_zero() * SPEED * params.dt;
            colliders[walker].set_translation(position + step);
        }

        let start = Instant::now();
        // All walkers have moved, and none was removed.
        broad_phase.update(&params, &colliders, &bodies, &walkers, &[], &mut events);
        time += start.elapsed();
        for event in events.drain(..) {
            match event {
                BroadPhasePairEvent::AddPair(pair) => {
                    pairs.insert((pair.collider1, pair.collider2))
                }
                BroadPhasePairEvent::DeletePair(pair) => {
                    pairs.remove(&(pair.collider1, pair.collider2))
                }
            };
        }
        assert_eq!(pairs.len(), broad_phase.pairs().count());

        for pair in broad_phase.pairs() {
            let (walker1, walker2) = (pair.collider1, pair.collider2);
            let between = colliders[walker2].translation() - colliders[walker1].translation();
            let depth = 2.0 * RADIUS - between.length();
            if depth > 0.0 {
                let push = between.normalize_or_zero() * (depth / 2.0);
                for (walker, push) in [(walker1, -push), (walker2, push)] {
                    let position = colliders[walker].translation();
                    colliders[walker].set_translation(position + push);
                }
            }
        }
    }
    let ms = time.as_secs_f64() * 1e3 / STEPS as f64;
    println!(
        "{WALKERS} walkers, {} pairs; {ms:.3} ms per update",
        pairs.len()
    );

    // Every two walkers that overlap must be a pair after an update.
    broad_phase.update(&params, &colliders, &bodies, &walkers, &[], &mut events);
    let pairs = broad_phase.pairs();
    let pairs: HashSet<_> = pairs.map(|pair| (pair.collider1, pair.collider2)).collect();
    for (i, &walker1) in walkers.iter().enumerate() {
        for &walker2 in &walkers[..i] {
            let between = colliders[walker2].translation() - colliders[walker1].translation();
            let is_pair =
                pairs.contains(&(walker1, walker2)) || pairs.contains(&(walker2, walker1));
            let is_apart = between.length() >= 2.0 * RADIUS;
            assert!(is_apart || is_pair, "a pair is missing");
        }
    }
}
