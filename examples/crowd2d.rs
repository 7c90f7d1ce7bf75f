//! A crowd without a physics pipeline: walkers steer to their goals, and those that overlap push each other apart.
//!
//! ```text
//! cargo run --release --features rapier2d-036 --example crowd2d
//! ```
//!
//! The broad phase is driven by hand: `update` is given what has moved, and `pairs` says who is near whom. This needs no patched copy of
//! Rapier 0.36. Prints how long the broad phase takes. Fails if two walkers overlap that are no pair.

use std::collections::HashSet;
use std::time::{Duration, Instant};

use rapier2d_036::prelude::*; // In your project: rapier2d.
use unisize::rapier2d_036::UnisizeBroadPhase;

const WALKERS: usize = 5000;
const RADIUS: f32 = 0.3;
/// Half the width of the place.
const HALF: f32 = 60.0;
const SPEED: f32 = 1.4;
const STEPS: usize = 300;

fn main() {
    let mut random = oorandom::Rand32::new(1);
    let mut anywhere = || {
        let mut number = || HALF * (2.0 * random.rand_float() - 1.0);
        Vector::new(number(), number())
    };
    let mut colliders = ColliderSet::new();
    let walkers: Vec<_> = (0..WALKERS)
        .map(|_| {
            // Colliders without bodies count as fixed. Pairs of those must be asked for.
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
    let mut events = Vec::new();
    let mut time = Duration::ZERO;
    for _ in 0..STEPS {
        for (&walker, goal) in walkers.iter().zip(&mut goals) {
            let place = colliders[walker].translation();
            let way = *goal - place;
            if way.length() < 1.0 {
                *goal = anywhere();
            }
            let step = way.normalize_or_zero() * SPEED * params.dt;
            colliders[walker].set_translation(place + step);
        }

        let start = Instant::now();
        // All have moved; none is removed. The events say which pairs are new and which have ended. They are not needed here.
        broad_phase.update(&params, &colliders, &bodies, &walkers, &[], &mut events);
        events.clear();
        time += start.elapsed();

        for pair in broad_phase.pairs() {
            let [one, other] = [pair.collider1, pair.collider2];
            let between = colliders[other].translation() - colliders[one].translation();
            let depth = 2.0 * RADIUS - between.length();
            if depth > 0.0 {
                let push = between.normalize_or_zero() * (depth / 2.0);
                for (walker, push) in [(one, -push), (other, push)] {
                    let place = colliders[walker].translation();
                    colliders[walker].set_translation(place + push);
                }
            }
        }
    }

    broad_phase.update(&params, &colliders, &bodies, &walkers, &[], &mut events);
    check(&broad_phase, &colliders, &walkers);
    println!(
        "{WALKERS} walkers, {} pairs; {:.3} ms per step in the broad phase",
        broad_phase.stats().pairs,
        time.as_secs_f64() * 1e3 / STEPS as f64
    );
}

/// Panics if two walkers overlap that are no pair.
fn check(broad_phase: &UnisizeBroadPhase, colliders: &ColliderSet, walkers: &[ColliderHandle]) {
    let pairs = broad_phase.pairs();
    let pairs: HashSet<_> = pairs
        .flat_map(|pair| {
            [
                (pair.collider1, pair.collider2),
                (pair.collider2, pair.collider1),
            ]
        })
        .collect();
    for (i, &one) in walkers.iter().enumerate() {
        for &other in &walkers[..i] {
            let between = colliders[other].translation() - colliders[one].translation();
            let overlap = between.length() < 2.0 * RADIUS;
            assert!(
                !overlap || pairs.contains(&(one, other)),
                "a pair is missing"
            );
        }
    }
}
