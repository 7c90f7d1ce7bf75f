//! How long broad phases take to follow moving cubes, and how many bytes they hold: Rapier's own and unisize. One source, compiled once
//! for each engine and dimension.
//!
//! *Work* is the mean number of cubes, held pairs and events together, the least that a broad phase has to process. Moving the cubes and
//! listing them is not timed.

use super::engine;
use super::ours::{Settings, UnisizeBroadPhase};
use super::rapier::prelude::*;
use super::world::{Driven, World};
use crate::bytes_held;
use crate::growth::{self, Figures};
use crate::worlds::Case;
use serde_json::Value;
use std::collections::HashSet;
use std::io;
use std::time::Duration;
use unisize_report::Report;
use unisize_scenes::{HardFrames, HardMotion};

/// Numbers of cubes.
const COUNTS: [usize; 3] = [1 << 12, 1 << 14, 1 << 16];

/// A case stops after 60 updates, or after this time, and is not tried with more cubes then.
const FRAMES: u32 = 60;
const LONG: Duration = Duration::from_secs(4);

/// Measures how update time grows with the number of cubes, on every motion.
pub(crate) fn measure(is_small: bool, report: &mut Report) -> io::Result<()> {
    let counts = if is_small { &[1 << 8][..] } else { &COUNTS };
    for motion in HardMotion::ALL {
        let version = engine::RAPIER;
        let mut grow = |method: String, run: &dyn Fn(usize) -> Course| {
            let [name, method] = [motion.name().into(), method.into()];
            let case = [("dim", DIM.into()), ("motion", name), ("method", method)];
            growth::measure(&case, counts, |count| Some(run(count).figures()), report)
        };
        let case = |count| Case {
            motion,
            count,
            settling: 0,
            frames: FRAMES,
            longest: LONG,
            on_bodies: false,
        };
        let default = |count| follow(&case(count), DefaultBroadPhase::new());
        grow(format!("Rapier {version}"), &default)?;
        for &level in engine::LEVELS {
            let settings = Settings::default().with_filter(level);
            let broad_phase = || UnisizeBroadPhase::with_settings(settings);
            let ours = |count| follow(&case(count), broad_phase());
            grow(format!("unisize for {version}, {level:?}"), &ours)?;
        }
    }
    Ok(())
}

/// The nanoseconds and the bytes per collider of both broad phases.
pub(crate) fn compare(case: &Case) -> Vec<(&'static str, Value)> {
    let ours = follow(case, UnisizeBroadPhase::new());
    let default = follow(case, DefaultBroadPhase::new());
    let each = |sum: f64| Value::from(sum / case.count as f64);
    let ns_each = |seconds: f64| each(seconds * 1e9);
    vec![
        ("rapier", engine::RAPIER.into()),
        ("dim", DIM.into()),
        ("motion", case.motion.name().into()),
        ("bodies", case.on_bodies.into()),
        ("count", case.count.into()),
        ("pairs", ours.pairs.into()),
        ("default_ns", ns_each(default.seconds)),
        ("default_longest_ns", ns_each(default.longest)),
        ("default_bytes", each(default.bytes as f64)),
        ("ours_ns", ns_each(ours.seconds)),
        ("ours_longest_ns", ns_each(ours.longest)),
        ("ours_bytes", each(ours.bytes as f64)),
    ]
}

/// One broad phase on one case.
struct Course {
    count: usize,
    updates: u32,
    /// The mean time of an update, and the longest one.
    seconds: f64,
    longest: f64,
    is_long: bool,
    /// The pairs held at the end, and the mean number of events of an update.
    pairs: usize,
    events: f64,
    /// The bytes that the broad phase holds at the end, without events, which go into the list of the caller.
    bytes: usize,
}

impl Course {
    fn figures(self) -> Figures {
        Figures {
            count: self.count,
            work: (self.count + self.pairs) as f64 + self.events,
            seconds: self.seconds,
            is_long: self.is_long,
            others: vec![
                ("updates", self.updates.into()),
                ("pairs", self.pairs.into()),
                ("events", self.events.into()),
                ("mean_ms", (self.seconds * 1e3).into()),
                ("worst_ms", (self.longest * 1e3).into()),
            ],
        }
    }
}

fn follow(case: &Case, mut broad_phase: impl Driven) -> Course {
    let mut frames = HardFrames::<DIM>::new(case.motion, case.count, 7);
    let mut world = World::new(case.count);
    let insert = |i| insert(&mut world, &frames, i, case.on_bodies);
    let mut handles: Vec<_> = (0..case.count).map(insert).collect();
    broad_phase.follow(&mut world, &handles, &[], &[]);
    let (mut held, mut updates, mut events) = (HashSet::new(), 0, 0);
    let (mut all, mut longest) = (Duration::ZERO, Duration::ZERO);
    note(&world.events, &mut held);
    for frame in 0..case.settling + case.frames {
        if all >= case.longest {
            break;
        }
        frames.advance();
        let mut moved = Vec::new();
        for &i in frames.moved() {
            place(&mut world, handles[i], center(&frames, i));
            moved.push(handles[i]);
        }
        let removed: Vec<_> = frames.replaced().iter().map(|&i| handles[i]).collect();
        for &handle in &removed {
            engine::remove(handle, &mut world);
        }
        let mut inserted = Vec::new();
        for &i in frames.replaced() {
            handles[i] = self::insert(&mut world, &frames, i, case.on_bodies);
            inserted.push(handles[i]);
        }
        world.events.clear();
        let time = broad_phase.follow(&mut world, &inserted, &moved, &removed);
        note(&world.events, &mut held);
        if frame >= case.settling {
            updates += 1;
            all += time;
            longest = longest.max(time);
            events += world.events.len();
        }
    }
    // Pairs of a removed collider end without an event.
    let is_there = |collider| world.colliders.contains(collider);
    held.retain(|pair| is_there(pair.collider1) && is_there(pair.collider2));
    Course {
        count: case.count,
        updates,
        seconds: all.as_secs_f64() / f64::from(updates),
        longest: longest.as_secs_f64(),
        is_long: all >= case.longest,
        pairs: held.len(),
        events: events as f64 / f64::from(updates),
        bytes: bytes_held(broad_phase),
    }
}

fn note(events: &[BroadPhasePairEvent], held: &mut HashSet<ColliderPair>) {
    for event in events {
        match event {
            BroadPhasePairEvent::AddPair(pair) => held.insert(*pair),
            BroadPhasePairEvent::DeletePair(pair) => held.remove(pair),
        };
    }
}

/// Inserts a box with a shape of its own, as different things have, on a dynamic body or without one.
fn insert(
    world: &mut World,
    frames: &HardFrames<DIM>,
    i: usize,
    is_on_body: bool,
) -> ColliderHandle {
    let halves = frames.sides(i).map(|side| side / 2.0);
    let shape = SharedShape::new(Cuboid::new(Vector::from(halves)));
    let center = Vector::from(center(frames, i));
    // Without these types, the narrow phase would drop the pairs of colliders without bodies.
    let collider = ColliderBuilder::new(shape).active_collision_types(ActiveCollisionTypes::all());
    if !is_on_body {
        return world.colliders.insert(collider.translation(center));
    }
    let body = RigidBodyBuilder::dynamic().translation(center);
    let body = world.bodies.insert(body);
    let bodies = &mut world.bodies;
    world.colliders.insert_with_parent(collider, body, bodies)
}

/// Moves a box, and its body if it has one.
fn place(world: &mut World, handle: ColliderHandle, center: [Real; DIM]) {
    let center = Vector::from(center);
    let collider = &mut world.colliders[handle];
    collider.set_translation(center);
    if let Some(parent) = collider.parent() {
        world.bodies[parent].set_translation(center, false);
    }
}

fn center(frames: &HardFrames<DIM>, i: usize) -> [Real; DIM] {
    let (mins, sides) = (frames.mins()[i], frames.sides(i));
    std::array::from_fn(|k| mins[k] + sides[k] / 2.0)
}
