//! The motions: one source, compiled once in each dimension.

use super::ours::{Kernel, Settings, UnisizeBroadPhase};
use super::rapier::prelude::*;
use crate::{ALLOCATOR, COUNTS, FRAMES, Figures, SMALL_COUNT, common, print_head, print_row};
use std::collections::HashSet;
use std::time::{Duration, Instant};
use unisize_scenes::{HardFrames, HardMotion};

/// Prints the table of this dimension.
pub(crate) fn print() {
    let counts = if common::is_smoke_test() {
        &[SMALL_COUNT][..]
    } else {
        &COUNTS
    };
    print_head(DIM);
    let mut drifting = [None; 3];
    for motion in HardMotion::ALL {
        let [default, ours, paper] = &mut drifting;
        let name = motion.name();
        let figures = for_counts(counts, |count| {
            follow(motion, count, DefaultBroadPhase::new())
        });
        print_row(name, "default", &figures, default);
        let figures = for_counts(counts, |count| {
            follow(motion, count, UnisizeBroadPhase::new())
        });
        print_row(name, "unisize", &figures, ours);
        let settings = Settings::default().with_kernel(Kernel::RankSweep);
        let figures = for_counts(counts, |count| {
            follow(motion, count, UnisizeBroadPhase::with_settings(settings))
        });
        print_row(name, "unisize, RankSweep", &figures, paper);
    }
    println!();
}

fn for_counts(counts: &[usize], measure: impl Fn(usize) -> Figures) -> Vec<Figures> {
    let mut all: Vec<Figures> = Vec::new();
    for &count in counts {
        if !all.last().is_some_and(Figures::is_long) {
            all.push(measure(count));
        }
    }
    all
}

/// Measures one broad phase on one motion.
fn follow<B: BroadPhase>(motion: HardMotion, count: usize, mut broad_phase: B) -> Figures {
    let mut frames = HardFrames::<DIM>::new(motion, count, 7);
    let params = IntegrationParameters::default();
    let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
    let mut islands = IslandManager::new();
    let mut handles: Vec<_> = frames
        .mins()
        .iter()
        .map(|&mins| colliders.insert(cube(mins)))
        .collect();
    let mut events = Vec::new();
    broad_phase.update(&params, &colliders, &bodies, &handles, &[], &mut events);
    let mut figures = Figures {
        count,
        frames: 0,
        pairs: 0,
        events: 0,
        all: Duration::ZERO,
        worst: Duration::ZERO,
        bytes: 0,
    };
    let mut held = HashSet::new();
    note(&events, &mut held);
    while figures.frames < FRAMES && !figures.is_long() {
        figures.frames += 1;
        frames.advance();
        let mut listed = Vec::new();
        for &i in frames.moved() {
            colliders[handles[i]].set_translation(Vector::from(frames.mins()[i]));
            listed.push(handles[i]);
        }
        let removed: Vec<_> = frames.replaced().iter().map(|&i| handles[i]).collect();
        for &handle in &removed {
            colliders.remove(handle, &mut islands, &mut bodies, false);
        }
        for &i in frames.replaced() {
            handles[i] = colliders.insert(cube(frames.mins()[i]));
            listed.push(handles[i]);
        }
        events.clear();
        let start = Instant::now();
        broad_phase.update(&params, &colliders, &bodies, &listed, &removed, &mut events);
        let time = start.elapsed();
        figures.all += time;
        figures.worst = figures.worst.max(time);
        figures.events += events.len();
        note(&events, &mut held);
    }
    // Pairs of a removed collider end without an event.
    let is_there = |collider| colliders.contains(collider);
    held.retain(|pair| is_there(pair.collider1) && is_there(pair.collider2));
    figures.pairs = held.len();
    let before = ALLOCATOR.stats();
    drop(broad_phase);
    figures.bytes = (ALLOCATOR.stats() - before).bytes_deallocated;
    figures
}

fn note(events: &[BroadPhasePairEvent], held: &mut HashSet<ColliderPair>) {
    for event in events {
        match event {
            BroadPhasePairEvent::AddPair(pair) => held.insert(*pair),
            BroadPhasePairEvent::DeletePair(pair) => held.remove(pair),
        };
    }
}

fn cube(mins: [Real; DIM]) -> Collider {
    let half = SharedShape::new(Cuboid::new(Vector::repeat(0.5)));
    ColliderBuilder::new(half)
        .active_collision_types(ActiveCollisionTypes::all())
        .translation(Vector::from(mins))
        .build()
}
