//! Compares a broad phase with Rapier's own, and times both.
//!
//! The default broad phase drives the simulation, through a [`Tee`] that passes each update to the candidate as well. The checks after
//! each step:
//!
//! - both hold the same pairs, apart from those that the narrow phase drops anyway; a candidate that may
//!   [leave out more](Candidate::leaving_out_more) holds a subset of the default's pairs;
//! - the candidate's own list of pairs agrees with its events, and no event was redundant;
//! - two [narrow phases](contacts), each with the pairs of one broad phase, find the same contacts and intersections;
//! - every contact and intersection of the simulation is among the pairs of the candidate;
//! - [rays], if there are any, hit the same in the trees of both.
//!
//! The first difference ends the checks, not the simulation, and is kept as a sentence. Then whole steps are timed: the scene is
//! simulated on each broad phase [alone], `repeats` times, and once more on the default, which measures the part of its broad phase. In
//! each repeat, the updates of both broad phases are timed as well, in a simulation without checks.

use super::observed::{Observed, Tee};
use super::pairs::{Pairs, describe, difference, in_order, is_relevant};
use super::queries::AsQueryPipeline;
use super::rapier::prelude::*;
use super::scene::Scene;
use super::version::{self, BroadPhase, OwnBroadPhase};
use super::world::{Steppable, World};
use crate::{Both, Outcome, Rays, SceneKind, WholeSteps};
use contacts::{Follower, Placed, Touching};
use rays::RayCheck;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::thread::Scope;

mod alone;
mod contacts;
mod rays;
#[cfg(test)]
mod tests;

/// The broad phase that is compared with the default, as functions that create and query it.
pub struct Candidate<C> {
    create: Box<dyn Fn() -> C + Send + Sync>,
    pairs: Ask<C, Vec<ColliderPair>>,
    queries: AsQueryPipeline<C>,
    validate: Option<Ask<C, ()>>,
    leaves_out_more: bool,
}

/// A question to a candidate after each step.
type Ask<C, T> = Box<dyn Fn(&C) -> T + Send + Sync>;

impl<C: BroadPhase + 'static> Candidate<C> {
    /// A candidate from functions that create one, list the pairs that it holds, and query its tree.
    pub fn new(
        create: impl Fn() -> C + Send + Sync + 'static,
        pairs: impl Fn(&C) -> Vec<ColliderPair> + Send + Sync + 'static,
        queries: AsQueryPipeline<C>,
    ) -> Self {
        Self {
            create: Box::new(create),
            pairs: Box::new(pairs),
            queries,
            validate: None,
            leaves_out_more: false,
        }
    }

    /// Allows it to leave out more pairs than the default, as long as contacts and intersections are the same.
    pub fn leaving_out_more(mut self) -> Self {
        self.leaves_out_more = true;
        self
    }

    /// Checks its invariants after each step by a function that panics if one is broken. The panic is caught, and counts as a difference.
    pub fn with_validation(mut self, validate: impl Fn(&C) + Send + Sync + 'static) -> Self {
        self.validate = Some(Box::new(validate));
        self
    }
}

/// A comparison: a scene, and the extent of the checks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// The scene.
    pub kind: SceneKind,
    /// About how many bodies it has.
    pub bodies: usize,
    /// The seed of its randomness.
    pub seed: u64,
    /// The number of steps. Default: 300, five seconds.
    pub steps: usize,
    /// The number of steps before those that are checked and timed. Default: 0.
    pub before: usize,
    /// The number of rays per step in addition to those of the scene. Default: 0.
    pub rays: usize,
    /// How often the scene is simulated on each broad phase alone, with seeds that count up from `seed`. Default: 1.
    pub repeats: usize,
    /// The number of threads that share the work. Default: 1.
    pub threads: usize,
}

impl Comparison {
    /// A thorough comparison over 300 steps.
    pub fn new(kind: SceneKind, bodies: usize, seed: u64) -> Self {
        Self {
            kind,
            bodies,
            seed,
            steps: 300,
            before: 0,
            rays: 0,
            repeats: 1,
            threads: 1,
        }
    }

    /// Checks all candidates, and times the last one. Until the first timed step, all worlds are simulated side by side.
    pub fn run<C: BroadPhase + 'static>(&self, candidates: &[Candidate<C>]) -> Outcome {
        let timed = candidates.last().expect("there is a candidate");
        let (mut checked, starts) = std::thread::scope(|scope| {
            let check = |candidate| begun(scope, move || self.check(candidate));
            let checks: Vec<_> = candidates.iter().map(check).collect();
            let start = |repeat| begun(scope, move || self.start(timed, repeat));
            let starts: Vec<_> = (0..self.repeats).map(start).collect();
            (results(checks), results(starts))
        });
        let mut outcome = checked.pop().expect("a check of each candidate");
        let earlier = checked.into_iter().find_map(|check| check.first_difference);
        outcome.first_difference = earlier.or(outcome.first_difference);
        if self.repeats > 0 {
            let (mut repeats, mut updates, mut limit) = (Vec::new(), Vec::new(), None);
            for (repeat, start) in starts.iter().enumerate() {
                limit = limit.or_else(|| Some(self.run_clocked(start)));
                repeats.push(self.run_alone(timed, repeat, start));
                updates.push(self.time_updates(timed, repeat, start));
            }
            let difference = || repeats.iter().find_map(alone::difference);
            outcome.first_difference = outcome.first_difference.take().or_else(difference);
            outcome.whole_steps = limit.and_then(|limit| WholeSteps::of(repeats, limit));
            outcome.time_updates(&updates);
        }
        outcome
    }

    /// From the first step on, since contacts that have come to rest may be older than a new broad phase.
    fn check<C: BroadPhase + 'static>(&self, candidate: &Candidate<C>) -> Outcome {
        let mut scene = Scene::build(self.kind, self.bodies, self.seed);
        let mut ray_check = RayCheck::new(candidate.queries, &scene, self);
        let watched_candidate = watched((candidate.create)());
        let mut both = version::install(Tee::new(watched(OwnBroadPhase::new()), watched_candidate));
        let mut followers = Both::<Follower>::default();
        let mut outcome = Outcome {
            steps: self.steps,
            ..Outcome::default()
        };
        for step in 1..=self.before + self.steps {
            scene.prepare_asking(|| version::own_tree(&both.heard.inner));
            // A candidate that leaves out more holds only the pairs of the poses in its update.
            let before = candidate.leaves_out_more.then(|| Placed::of(&scene.world));
            scene.world.step(both.for_step(), &(), &());
            let updates = both.heard.take_updates();
            followers.default.note(&updates);
            followers.candidate.note(&both.unheard.take_updates());
            let touching = Touching::of(&scene.world.narrow_phase);
            outcome.contacts_at_end = touching.contacts.len();
            outcome.intersections_at_end = touching.intersections.len();
            if step > self.before && outcome.first_difference.is_none() {
                // In a step of several updates, the poses of the last one are unknown.
                let check_contacts = before.is_none() || updates.len() == 1;
                outcome.contact_checks += usize::from(check_contacts);
                let (world, heard, unheard) = (&scene.world, &both.heard, &both.unheard);
                outcome.first_difference = candidate
                    .difference(world, heard.held(), unheard, &touching)
                    .or_else(|| {
                        check_contacts
                            .then(|| contacts::difference(world, before.as_ref(), &mut followers))?
                    })
                    .or_else(|| {
                        let own = version::own_tree(&heard.inner);
                        ray_check.check(&scene, own, &unheard.inner)
                    })
                    .map(|difference| format!("step {step}: {difference}"));
            }
        }
        let world = &scene.world;
        outcome.bodies = world.bodies.len();
        outcome.colliders = world.colliders.len();
        let held = Both {
            default: both.heard.held(),
            candidate: both.unheard.held(),
        };
        outcome.pairs = held.map(|pairs| {
            let relevant = pairs.iter().filter(|&&pair| is_relevant(pair, world));
            relevant.count()
        });
        outcome.rays = Rays {
            a_step: self.rays,
            ..ray_check.count
        };
        outcome
    }
}

/// Waits for a result.
type Wait<'scope, T> = Box<dyn FnOnce() -> T + 'scope>;

/// Begins some work on a thread of its own, whose panic goes on in whoever waits. WebAssembly has no threads, so there the work is done once
/// its result is waited for.
fn begun<'scope, T: Send + 'scope>(
    scope: &'scope Scope<'scope, '_>,
    work: impl FnOnce() -> T + Send + 'scope,
) -> Wait<'scope, T> {
    if cfg!(target_family = "wasm") {
        return Box::new(work);
    }
    let thread = scope.spawn(work);
    Box::new(|| thread.join().unwrap_or_else(|panic| resume_unwind(panic)))
}

fn results<T>(begun: Vec<Wait<'_, T>>) -> Vec<T> {
    begun.into_iter().map(|wait| wait()).collect()
}

/// A broad phase whose events and pairs are recorded.
fn watched<B: BroadPhase>(broad_phase: B) -> Observed<B> {
    Observed::new(broad_phase).with_events().with_held()
}

impl<C: BroadPhase + 'static> Candidate<C> {
    /// The first difference in all checks but that of the two narrow phases.
    fn difference(
        &self,
        world: &World,
        default: &Pairs,
        observed: &Observed<C>,
        touching: &Touching,
    ) -> Option<String> {
        let (candidate, held) = (&observed.inner, observed.held());
        let missing = || {
            let meaning = "is held by the default and not by the candidate";
            difference(default, held, world, meaning, |pair| {
                !self.leaves_out_more && is_relevant(pair, world)
            })
        };
        let surplus = || {
            let meaning = "is held by the candidate and not by the default";
            difference(held, default, world, meaning, |pair| {
                is_relevant(pair, world)
            })
        };
        let unheld = |touching: &Pairs| {
            let meaning = "touch in the simulation, and are not held by the candidate";
            difference(touching, held, world, meaning, |_| true)
        };
        self.broken_invariant(candidate)
            .or_else(|| {
                let event = observed.held_fault()?;
                let meaning = match event.is_add() {
                    true => "new, which it holds already",
                    false => "ended, which it does not hold",
                };
                let pair = describe(event.pair(), world);
                Some(format!("the candidate reports {pair} as {meaning}"))
            })
            .or_else(missing)
            .or_else(surplus)
            .or_else(|| self.list_difference(world, candidate, held))
            .or_else(|| unheld(&touching.contacts))
            .or_else(|| unheld(&touching.intersections))
    }

    /// The difference between the candidate's own list of pairs and its events.
    fn list_difference(&self, world: &World, candidate: &C, held: &Pairs) -> Option<String> {
        let list = (self.pairs)(candidate);
        let listed: Pairs = list.iter().copied().map(in_order).collect();
        if listed.len() < list.len() {
            return Some("the candidate lists a pair twice".to_owned());
        }
        let unreported = "is listed by the candidate, which never reported it or has ended it";
        let unlisted = "was reported by the candidate, which does not list it";
        difference(&listed, held, world, unreported, |_| true)
            .or_else(|| difference(held, &listed, world, unlisted, |_| true))
    }

    fn broken_invariant(&self, candidate: &C) -> Option<String> {
        let validate = self.validate.as_ref()?;
        let panic = catch_unwind(AssertUnwindSafe(|| validate(candidate))).err()?;
        let message = panic
            .downcast_ref::<String>()
            .map(String::as_str)
            .or_else(|| panic.downcast_ref::<&str>().copied())
            .unwrap_or("no message");
        Some(format!("the candidate's validation panics: {message}"))
    }
}
