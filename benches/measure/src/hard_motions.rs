//! Motions on which broad phases break down: how update time grows, for Rapier's own broad phase and for unisize. One source, compiled
//! once for each engine and dimension.
//!
//! Times are for one update: the mean and the worst of 60, or of as many as fit in four seconds. *Work* is the mean number of cubes,
//! held pairs and events together, the least that a broad phase has to process.

use super::engine::{self, Driven};
use super::frames::World;
use super::ours::UnisizeBroadPhase;
use super::rapier::prelude::*;
use crate::growth::{self, Figures};
use unisize_report::Report;
use std::collections::HashSet;
use std::io;
use std::time::Duration;
use unisize_scenes::{HardFrames, HardMotion};

/// Numbers of cubes.
const COUNTS: [usize; 3] = [1 << 12, 1 << 14, 1 << 16];

const FRAMES: u32 = 60;

/// A case stops after this time, whatever its number of frames, and is not tried with more cubes.
const LONG: Duration = Duration::from_secs(4);

/// Measures this engine in this dimension.
pub(crate) fn measure(is_small: bool, report: &mut Report) -> io::Result<()> {
    let counts = if is_small { &[1 << 8][..] } else { &COUNTS };
    for motion in HardMotion::ALL {
        let version = engine::RAPIER;
        let mut grow = |method: String, run: &dyn Fn(usize) -> Option<Figures>| {
            let [name, method] = [motion.name().into(), method.into()];
            let case = [("dim", DIM.into()), ("motion", name), ("method", method)];
            growth::measure(&case, counts, run, report)
        };
        let default = |count| follow(motion, count, DefaultBroadPhase::new());
        grow(format!("Rapier {version}"), &default)?;
        let ours = |count| follow(motion, count, UnisizeBroadPhase::new());
        grow(format!("unisize for {version}"), &ours)?;
    }
    Ok(())
}

/// Measures one broad phase on one motion.
fn follow(motion: HardMotion, count: usize, mut broad_phase: impl Driven) -> Option<Figures> {
    let mut frames = HardFrames::<DIM>::new(motion, count, 7);
    let mut world = World::new(count);
    let mut islands = IslandManager::new();
    let insert = |i| world.colliders.insert(cuboid(&frames, i));
    let mut handles: Vec<_> = (0..count).map(insert).collect();
    broad_phase.follow(&mut world, &handles, &[], &[]);
    let (mut held, mut updates, mut events) = (HashSet::new(), 0, 0);
    let (mut all, mut worst) = (Duration::ZERO, Duration::ZERO);
    note(&world.events, &mut held);
    while updates < FRAMES && all < LONG {
        updates += 1;
        frames.advance();
        let mut moved = Vec::new();
        for &i in frames.moved() {
            world.colliders[handles[i]].set_translation(Vector::from(center(&frames, i)));
            moved.push(handles[i]);
        }
        let removed: Vec<_> = frames.replaced().iter().map(|&i| handles[i]).collect();
        for &handle in &removed {
            engine::remove(handle, &mut islands, &mut world);
        }
        let mut inserted = Vec::new();
        for &i in frames.replaced() {
            handles[i] = world.colliders.insert(cuboid(&frames, i));
            inserted.push(handles[i]);
        }
        world.events.clear();
        let time = broad_phase.follow(&mut world, &inserted, &moved, &removed);
        all += time;
        worst = worst.max(time);
        events += world.events.len();
        note(&world.events, &mut held);
    }
    // Pairs of a removed collider end without an event.
    let is_there = |collider| world.colliders.contains(collider);
    held.retain(|pair| is_there(pair.collider1) && is_there(pair.collider2));
    let seconds = all.as_secs_f64() / f64::from(updates);
    let events = events as f64 / f64::from(updates);
    Some(Figures {
        count,
        work: (count + held.len()) as f64 + events,
        seconds,
        is_long: all >= LONG,
        others: vec![
            ("updates", updates.into()),
            ("pairs", held.len().into()),
            ("events", events.into()),
            ("mean_ms", (seconds * 1e3).into()),
            ("worst_ms", (worst.as_secs_f64() * 1e3).into()),
        ],
    })
}

fn note(events: &[BroadPhasePairEvent], held: &mut HashSet<ColliderPair>) {
    for event in events {
        match event {
            BroadPhasePairEvent::AddPair(pair) => held.insert(*pair),
            BroadPhasePairEvent::DeletePair(pair) => held.remove(pair),
        };
    }
}

fn cuboid(frames: &HardFrames<DIM>, i: usize) -> Collider {
    let halves = frames.sides(i).map(|side| side / 2.0);
    let shape = SharedShape::new(Cuboid::new(Vector::from(halves)));
    ColliderBuilder::new(shape)
        .active_collision_types(ActiveCollisionTypes::all())
        .translation(Vector::from(center(frames, i)))
        .build()
}

fn center(frames: &HardFrames<DIM>, i: usize) -> [Real; DIM] {
    let (mins, sides) = (frames.mins()[i], frames.sides(i));
    std::array::from_fn(|k| mins[k] + sides[k] / 2.0)
}
