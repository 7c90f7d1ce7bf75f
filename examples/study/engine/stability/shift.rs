//! A whole world is moved by one vector between two steps, as games do when the player is far from the origin.
//!
//! Both broad phases are in one world, which Rapier's drives, so they get the very same updates. A twin that is not moved shows
//! whether the move changes more than rounding does.

use super::ours::{Settings, UnisizeBroadPhase};
use super::scenes::rapier::prelude::*;
use super::scenes::{Installed, Observed, OwnBroadPhase, Scene, Steppable, Tee, World, install};
use super::space::{components, place, plus, vector};
use super::together;
use super::version::{self, Vector};
use crate::stability::shift::{Kept, Scenery, Shift, Step};
use std::borrow::Borrow;
use std::collections::BTreeSet;

/// Steps before the first shift, and from each one on.
const EVERY: usize = 30;

/// The shift in units on each axis; the next one takes it back.
const BY: [f64; 3] = [-1000.0, 500.0, 2000.0];

/// What the places of two colliders are rounded by, at most, in units.
const ROUNDING: Real = 2.0 * 2000.0 * Real::EPSILON;

type Both = Tee<Observed<OwnBroadPhase>, Observed<UnisizeBroadPhase>>;

/// Measures shifts of a scene of so many bodies.
pub(crate) fn shift(scenery: Scenery, bodies: usize, seed: u64, shifts: usize) -> Shift {
    let [mut world, mut twin] = [(), ()].map(|()| Shifted::build(scenery, bodies, seed));
    let mut steps = Vec::new();
    let mut difference = None;
    let mut kept = Kept::default();
    for number in 0..(shifts + 1) * EVERY {
        let index = number / EVERY;
        let is_shift = index > 0 && number % EVERY == 0;
        if is_shift {
            world.shift(if index % 2 == 1 { 1.0 } else { -1.0 });
        }
        steps.push(world.step(is_shift));
        if difference.is_none() {
            let tee: &Both = &world.broad_phases;
            difference = together::between(&world.scene.world, &tee.heard, &tee.unheard)
                .map(|difference| format!("step {}: {difference}", number + 1));
        }
        if number <= EVERY {
            twin.step(false);
        }
        if is_shift && index == 1 {
            kept = Kept::of(
                |depth| world.touching(depth),
                |depth| twin.touching(depth),
                f64::from(ROUNDING),
            );
        }
    }
    Shift {
        scenery,
        bodies: world.scene.body_count(),
        steps,
        kept,
        difference,
    }
}

/// A world that is shifted.
struct Shifted {
    scene: Scene,
    broad_phases: Installed<Both>,
    /// What both have taken, and the full runs of unisize, up to the last step.
    ms: [f64; 2],
    full_runs: u64,
}

impl Shifted {
    fn build(scenery: Scenery, bodies: usize, seed: u64) -> Self {
        let mut scene = Scene::build(scenery.kind, bodies, seed);
        if scenery.is_moving {
            // Scripts steer to places that are not shifted: all that they do here is to start the motion.
            for _ in 0..EVERY {
                scene.prepare();
            }
        } else {
            for (_, body) in scene.world.bodies.iter_mut() {
                body.set_linvel(Vector::default(), true);
            }
        }
        // With events in order, the twin takes the same course.
        let default = Observed::new(OwnBroadPhase::new()).clocked().with_held();
        let settings = Settings::default().with_filter(crate::FILTER_OF_DEFAULT);
        let ours = UnisizeBroadPhase::with_settings(settings);
        let ours = Observed::new(ours).clocked().with_held();
        Self {
            scene,
            broad_phases: install(Tee::new(default.sorted(), ours)),
            ms: [0.0; 2],
            full_runs: 0,
        }
    }

    /// Moves all bodies, and the colliders that have none.
    fn shift(&mut self, sign: f64) {
        let World {
            bodies, colliders, ..
        } = &mut self.scene.world;
        for (_, body) in bodies.iter_mut() {
            let place = moved(body.translation(), sign);
            body.set_translation(place, true);
        }
        for (_, collider) in colliders.iter_mut() {
            if collider.parent().is_none() {
                let place = moved(collider.translation(), sign);
                collider.set_translation(place);
            }
        }
    }

    fn step(&mut self, is_shift: bool) -> Step {
        let world = &mut self.scene.world;
        world.step(self.broad_phases.for_step(), &(), &());
        let tee: &Both = &self.broad_phases;
        let total = [tee.heard.timing(), tee.unheard.timing()];
        let total = total.map(|timing| timing.total.as_secs_f64() * 1e3);
        let stats = tee.unheard.inner.stats();
        let step = Step {
            is_shift,
            ms: [0, 1].map(|side| total[side] - self.ms[side]),
            full_runs: stats.full_runs - self.full_runs,
        };
        (self.ms, self.full_runs) = (total, stats.full_runs);
        step
    }

    /// The pairs that overlap by this depth or more, at the step's search for contacts.
    fn touching(&self, depth: f64) -> BTreeSet<[(u32, u32); 2]> {
        let pairs = self.scene.world.narrow_phase.contact_pairs();
        let touching = pairs.filter(|pair| {
            let mut points = version::manifolds(pair)
                .iter()
                .flat_map(|manifold| &manifold.points);
            points.any(|point| f64::from(point.dist) <= -depth)
        });
        let handles = touching.map(|pair| {
            let mut handles = [pair.collider1, pair.collider2].map(ColliderHandle::into_raw_parts);
            handles.sort_unstable();
            handles
        });
        handles.collect()
    }
}

/// A place by one shift further on.
fn moved(from: impl Borrow<Vector>, sign: f64) -> Vector {
    vector(plus(components(from), place(|axis| sign * BY[axis])))
}
