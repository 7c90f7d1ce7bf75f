//! Collision events without a physics pipeline: beads fly through a zone, and each that enters or leaves it is reported.
//!
//! ```text
//! cargo run --release --features rapier3d-036 --example collision_events
//! ```
//!
//! The broad phase reports which pairs begin and end; Parry tells which of them touch. This needs no patched copy of Rapier 0.36. Rapier's
//! own `CollisionPipeline` sees the same beads, and the program fails if its events differ.

use std::collections::BTreeMap;
use std::sync::mpsc::channel;

use rapier3d_036::parry::query::intersection_test;
use rapier3d_036::prelude::*; // In your project: rapier3d.
use unisize::rapier3d_036::UnisizeBroadPhase;

const BEADS: usize = 2000;
const RADIUS: f32 = 0.1;
/// Half the width of the box in which the beads fly.
const HALF: f32 = 4.0;
const STEPS: usize = 200;

fn main() {
    let params = IntegrationParameters::default();
    let mut random = oorandom::Rand32::new(36);
    let mut vector = |most: f32| {
        let mut number = || most * (2.0 * random.rand_float() - 1.0);
        Vector::new(number(), number(), number())
    };
    let mut colliders = ColliderSet::new();
    let zone = colliders.insert(sensor(ColliderBuilder::cuboid(1.0, 1.0, 1.0)));
    let mut velocities = Vec::new();
    let beads: Vec<_> = (0..BEADS)
        .map(|_| {
            velocities.push(vector(4.0));
            let bead = ColliderBuilder::ball(RADIUS).translation(vector(HALF));
            colliders.insert(sensor(bead))
        })
        .collect();

    let mut ours = Detector::default();
    let mut rapiers = RapiersOwn::new(&colliders);
    let [mut entered, mut left] = [0; 2];
    // The zone does not move, so it is listed in the first step only.
    let mut modified = beads.clone();
    modified.push(zone);
    for step in 0..STEPS {
        let mut events = ours.step(&params, &colliders, &modified);
        modified.truncate(BEADS);
        for event in &events {
            if [event.collider1(), event.collider2()].contains(&zone) {
                *(if event.started() {
                    &mut entered
                } else {
                    &mut left
                }) += 1;
            }
        }
        let mut expected = rapiers.step(&params, &colliders, &beads);
        events.sort_by_key(key);
        expected.sort_by_key(key);
        assert!(
            events.iter().map(key).eq(expected.iter().map(key)),
            "step {step}"
        );

        for (&bead, velocity) in beads.iter().zip(&mut velocities) {
            let place = colliders[bead].translation() + *velocity * params.dt;
            let inside = place.clamp(Vector::splat(-HALF), Vector::splat(HALF));
            for axis in 0..3 {
                if place[axis] != inside[axis] {
                    velocity[axis] = -velocity[axis];
                }
            }
            colliders[bead].set_translation(inside);
        }
    }
    println!(
        "{BEADS} beads: {entered} entered the zone and {left} left it; all events are Rapier's own"
    );
}

/// A collider that only notices others. Pairs of colliders without bodies must be asked for.
fn sensor(collider: ColliderBuilder) -> ColliderBuilder {
    collider
        .sensor(true)
        .active_collision_types(ActiveCollisionTypes::all())
        .active_events(ActiveEvents::COLLISION_EVENTS)
}

/// unisize, and for each of its pairs whether they touch: a narrow phase without forces.
#[derive(Default)]
struct Detector {
    broad_phase: UnisizeBroadPhase,
    pairs: BTreeMap<[(u32, u32); 2], (ColliderPair, bool)>,
}

impl Detector {
    fn step(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        modified: &[ColliderHandle],
    ) -> Vec<CollisionEvent> {
        let (bodies, mut changes) = (RigidBodySet::new(), Vec::new());
        self.broad_phase
            .update(params, colliders, &bodies, modified, &[], &mut changes);
        let mut events = Vec::new();
        for change in changes {
            match change {
                BroadPhasePairEvent::AddPair(pair) => {
                    self.pairs.insert(handles(pair), (pair, false));
                }
                BroadPhasePairEvent::DeletePair(pair) => {
                    if let Some((pair, true)) = self.pairs.remove(&handles(pair)) {
                        events.push(event(pair, false));
                    }
                }
            }
        }
        for (pair, touch) in self.pairs.values_mut() {
            let [one, other] = [pair.collider1, pair.collider2].map(|handle| &colliders[handle]);
            let test =
                intersection_test(one.position(), one.shape(), other.position(), other.shape());
            let touched = std::mem::replace(touch, test.is_ok_and(|test| test.intersecting));
            if *touch != touched {
                events.push(event(*pair, *touch));
            }
        }
        events
    }
}

fn event(
    ColliderPair {
        collider1,
        collider2,
    }: ColliderPair,
    starts: bool,
) -> CollisionEvent {
    match starts {
        true => CollisionEvent::Started(collider1, collider2, CollisionEventFlags::SENSOR),
        false => CollisionEvent::Stopped(collider1, collider2, CollisionEventFlags::SENSOR),
    }
}

fn handles(pair: ColliderPair) -> [(u32, u32); 2] {
    let mut handles = [pair.collider1, pair.collider2].map(|handle| handle.into_raw_parts());
    handles.sort_unstable();
    handles
}

fn key(event: &CollisionEvent) -> (bool, [(u32, u32); 2]) {
    let pair = ColliderPair::new(event.collider1(), event.collider2());
    (event.started(), handles(pair))
}

/// The same colliders in Rapier's own collision pipeline, to compare with.
struct RapiersOwn {
    colliders: ColliderSet,
    broad_phase: DefaultBroadPhase,
    narrow_phase: NarrowPhase,
}

impl RapiersOwn {
    fn new(colliders: &ColliderSet) -> Self {
        Self {
            colliders: colliders.clone(),
            broad_phase: DefaultBroadPhase::new(),
            narrow_phase: NarrowPhase::new(),
        }
    }

    fn step(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        beads: &[ColliderHandle],
    ) -> Vec<CollisionEvent> {
        for &bead in beads {
            self.colliders[bead].set_translation(colliders[bead].translation());
        }
        let (sender, events) = channel();
        CollisionPipeline::new().step(
            params.prediction_distance(),
            &mut IslandManager::new(),
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut RigidBodySet::new(),
            &mut self.colliders,
            &(),
            &ChannelEventCollector::new(sender, channel().0, channel().0),
        );
        events.try_iter().collect()
    }
}
