//! The motions: one source, compiled once in each dimension.

use super::ours::{Kernel, Settings, UnisizeBroadPhase};
use super::rapier::prelude::*;
use super::version::{self, Driven};
use crate::{ALLOCATOR, COUNTS, FRAMES, Figures, SMALL_COUNT, common, print_row};
use std::collections::HashSet;
use std::time::Duration;
use unisize_scenes::{HardFrames, HardMotion};

/// Prints the lines of this dimension and version, with those of the kernel of the paper if they are wanted.
pub(crate) fn print(with_paper: bool) {
    let counts = if common::is_smoke_test() {
        &[SMALL_COUNT][..]
    } else {
        &COUNTS
    };
    let mut drifting = [None; 3];
    for motion in HardMotion::ALL {
        let [default, ours, paper] = &mut drifting;
        let name = motion.name();
        let figures = for_counts(counts, |count| {
            follow(motion, count, DefaultBroadPhase::new())
        });
        print_row(name, version::DEFAULT, &figures, default);
        let figures = for_counts(counts, |count| {
            follow(motion, count, UnisizeBroadPhase::new())
        });
        print_row(name, version::OURS, &figures, ours);
        if !with_paper {
            continue;
        }
        let settings = Settings::default().with_kernel(Kernel::RankSweep);
        let figures = for_counts(counts, |count| {
            follow(motion, count, UnisizeBroadPhase::with_settings(settings))
        });
        let with_kernel = format!("{}, RankSweep", version::OURS);
        print_row(name, &with_kernel, &figures, paper);
    }
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
fn follow<B: Driven>(motion: HardMotion, count: usize, mut broad_phase: B) -> Figures {
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
    let first = [&handles[..], &[], &[]];
    broad_phase.follow(&params, &colliders, &bodies, first, &mut events);
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
        let mut moved = Vec::new();
        for &i in frames.moved() {
            colliders[handles[i]].set_translation(Vector::from(frames.mins()[i]));
            moved.push(handles[i]);
        }
        let removed: Vec<_> = frames.replaced().iter().map(|&i| handles[i]).collect();
        for &handle in &removed {
            version::remove(handle, &mut colliders, &mut islands, &mut bodies);
        }
        let mut inserted = Vec::new();
        for &i in frames.replaced() {
            handles[i] = colliders.insert(cube(frames.mins()[i]));
            inserted.push(handles[i]);
        }
        events.clear();
        let lists = [&inserted[..], &moved, &removed];
        let time = broad_phase.follow(&params, &colliders, &bodies, lists, &mut events);
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
    let half = SharedShape::new(Cuboid::new(Vector::from([0.5; DIM])));
    ColliderBuilder::new(half)
        .active_collision_types(ActiveCollisionTypes::all())
        .translation(Vector::from(mins))
        .build()
}
