//! Whether a broad phase does the same as Rapier's own, and how fast.
//!
//! The default broad phase drives the simulation, through a [`Tee`] that gives each update to the
//! candidate as well. After each step it is checked that
//!
//! - both hold the same pairs, apart from those that the narrow phase drops anyway, or the candidate holds no others than the
//!   default, if it may [leave out more](Candidate::leaving_out_more);
//! - the candidate's own list of pairs is what its events amount to, and none of them was redundant;
//! - two [narrow phases](contacts), each fed with the pairs of one, find the same contacts and intersections;
//! - every contact and intersection of the simulation is among the pairs of the candidate;
//! - [rays], if there are any, hit the same in the trees of both.
//!
//! The first difference ends the checks, not the simulation, and is kept as a sentence. Afterwards whole steps are
//! timed: the scene is simulated on each broad phase [alone](independent), as often as is asked for, and once more on the
//! default, to tell what part of a step its broad phase takes.

use super::observed::{Observed, PairEvent, Tee, Timing, Update};
use super::queries::{Queries, QueryAccess};
use super::rapier::{self, prelude::*};
use super::sanity::Sanity;
use super::scene::Scene;
use super::space::{self, components, direction, largest, vector};
use super::version::{self, BroadPhase, Steppable};
use super::world::World;
use crate::SceneKind;
use crate::random::Random;
use both::Side;
use contacts::{ContactCheck, Placed, Touching};
use ledger::Ledger;
use rays::RayCheck;
use std::panic::{AssertUnwindSafe, catch_unwind};

mod both;
mod contacts;
mod held_pairs;
mod independent;
mod journal;
mod ledger;
mod outcome;
mod pair;
mod rays;
#[cfg(test)]
mod tests;

pub use both::Both;
pub use outcome::{Clocked, Independent, Outcome, RayCount, Tally};

/// The broad phase that is compared with the default: how to make one, and what it can be asked.
///
/// ```
/// # #[cfg(feature = "rapier3d-027")]
/// # {
/// use unisize_scenes::dim3::{Candidate, rapier::prelude::DefaultBroadPhase};
///
/// let itself = Candidate::new(DefaultBroadPhase::new);
/// # }
/// ```
pub struct Candidate<C> {
    create: Box<dyn Fn() -> C>,
    pairs: Option<Ask<C, Vec<ColliderPair>>>,
    validate: Option<Ask<C, ()>>,
    access: Option<QueryAccess<C>>,
    leaves_out_more: bool,
}

/// What a candidate is asked after each step.
type Ask<C, T> = Box<dyn Fn(&C) -> T>;

impl<C: BroadPhase + 'static> Candidate<C> {
    /// A candidate that can only be updated.
    pub fn new(create: impl Fn() -> C + 'static) -> Self {
        Self {
            create: Box::new(create),
            pairs: None,
            validate: None,
            access: None,
            leaves_out_more: false,
        }
    }

    /// Lets it leave out more pairs than the default, as long as contacts and intersections are the same.
    pub fn leaving_out_more(mut self) -> Self {
        self.leaves_out_more = true;
        self
    }

    /// Has the list of the pairs that it holds compared with its events after each step.
    pub fn with_pairs(mut self, pairs: impl Fn(&C) -> Vec<ColliderPair> + 'static) -> Self {
        self.pairs = Some(Box::new(pairs));
        self
    }

    /// Lets it be asked by rays and by scenes with controllers. No rays are cast otherwise, and scenes ask a tree of
    /// their own.
    pub fn with_queries(mut self, access: QueryAccess<C>) -> Self {
        self.access = Some(access);
        self
    }

    /// Has its invariants checked after each step by a function that panics where one is broken. The panic
    /// is caught, and counts as a difference.
    pub fn with_validation(mut self, validate: impl Fn(&C) + 'static) -> Self {
        self.validate = Some(Box::new(validate));
        self
    }
}

/// What is to be compared: a scene, and how closely to look.
///
/// ```
/// # #[cfg(feature = "rapier2d-027")]
/// # {
/// use unisize_scenes::SceneKind;
/// use unisize_scenes::dim2::{Candidate, Comparison, rapier::prelude::DefaultBroadPhase};
///
/// let comparison = Comparison {
///     steps: 20,
///     ..Comparison::new(SceneKind::FallingBalls, 50, 7)
/// };
/// let outcome = comparison.run(&Candidate::new(DefaultBroadPhase::new), |_| {});
/// assert_eq!(outcome.first_difference, None);
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// The scene.
    pub kind: SceneKind,
    /// About how many bodies it has.
    pub bodies: usize,
    /// The seed of its randomness.
    pub seed: u64,
    /// How many steps to simulate. Default: 300, five seconds.
    pub steps: usize,
    /// The contacts are compared once in this many steps, and at the last. Default: 1, at every step;
    /// 0 counts as 1. The comparison copies the world and computes every contact twice, which takes longer
    /// than the simulation itself.
    pub contacts_every: usize,
    /// How many rays are cast after each step, beside those of the scene. Default: 0.
    pub rays: usize,
    /// How often the scene is simulated on each broad phase alone as well, with seeds that count up from `seed`.
    /// Default: 1.
    pub repeats: usize,
}

impl Comparison {
    /// A thorough comparison over 300 steps.
    pub fn new(kind: SceneKind, bodies: usize, seed: u64) -> Self {
        Self {
            kind,
            bodies,
            seed,
            steps: 300,
            contacts_every: 1,
            rays: 0,
            repeats: 1,
        }
    }

    /// Compares, and calls `on_step` after each simulated step with the number of steps done: `steps` of
    /// them, twice as many again for each repeat of the independent runs, and as many after these for the clocked run.
    pub fn run<C: BroadPhase + 'static>(
        &self,
        candidate: &Candidate<C>,
        mut on_step: impl FnMut(usize),
    ) -> Outcome {
        let mut outcome = self.run_together(candidate, &mut on_step);
        for repeat in 0..self.repeats {
            let done = self.steps * (1 + 2 * repeat);
            let runs = self.run_alone(candidate, repeat, |step| on_step(done + step));
            if outcome.first_difference.is_none() {
                outcome.first_difference = independent::difference(&runs);
            }
            outcome.independent.push(runs);
        }
        if self.repeats > 0 {
            let done = self.steps * (1 + 2 * self.repeats);
            outcome.clocked = Some(self.run_clocked(candidate, |step| on_step(done + step)));
        }
        outcome
    }

    fn build(&self, seed: u64) -> Scene {
        Scene::build(self.kind, self.bodies, seed)
    }

    fn run_together<C: BroadPhase + 'static>(
        &self,
        candidate: &Candidate<C>,
        on_step: &mut impl FnMut(usize),
    ) -> Outcome {
        let mut scene = self.build(self.seed);
        let mut ray_check = RayCheck::new(candidate.access, &scene, self);
        let mut ledger = Ledger::new((candidate.create)());
        let mut contact_check = ContactCheck::default();
        let mut outcome = Outcome {
            steps: self.steps,
            ..Outcome::default()
        };
        for step in 1..=self.steps {
            scene.prepare_asking(&version::access_to_own().to(&ledger.tee.heard.inner));
            let is_due = step % self.contacts_every.max(1) == 0 || step == self.steps;
            // A candidate that leaves out more has the pairs of the poses that its update has seen, and no others.
            let before = (is_due && candidate.leaves_out_more).then(|| Placed::of(&scene.world));
            scene.world.step(ledger.tee.for_step(), &(), &());
            let updates = ledger.enter_step();
            let touching = Touching::of(&scene.world.narrow_phase);
            outcome.contacts.record(touching.contacts.len());
            outcome.intersections.record(touching.intersections.len());
            if outcome.first_difference.is_none() {
                // In a step of several updates, the poses of the last one are not to be had.
                let check_contacts = is_due && (before.is_none() || updates == 1);
                outcome.contact_checks += usize::from(check_contacts);
                outcome.first_difference = candidate
                    .difference(&mut ledger, &scene.world, &touching)
                    .or_else(|| {
                        let journals = &mut ledger.journals;
                        check_contacts.then(|| {
                            contact_check.check(&scene.world, before.as_ref(), journals, &())
                        })?
                    })
                    .or_else(|| ray_check.as_mut()?.check(&scene, &ledger))
                    .map(|difference| format!("step {step}: {difference}"));
            }
            on_step(step);
        }
        outcome.bodies = scene.world.bodies.len();
        outcome.colliders = scene.world.colliders.len();
        outcome.pairs = Both::of(|side| ledger.held.count_relevant(side, &scene.world));
        outcome.pairs_with_dropped = Both::of(|side| ledger.held.count(side));
        outcome.redundant_events = ledger.redundant;
        outcome.rays = ray_check.map(|check| check.count).unwrap_or_default();
        outcome.timing = Both {
            default: ledger.tee.heard.timing(),
            candidate: ledger.tee.unheard.timing(),
        };
        outcome
    }
}

impl<C: BroadPhase + 'static> Candidate<C> {
    /// The first difference in what is held, all checks but that of the two narrow phases.
    fn difference(
        &self,
        ledger: &mut Ledger<C>,
        world: &World,
        touching: &Touching,
    ) -> Option<String> {
        self.broken_invariant(ledger.candidate())
            .or_else(|| ledger.first_redundant.take())
            .or_else(|| {
                let (side, pair, count) = ledger.held.difference(world, self.leaves_out_more)?;
                Some(format!(
                    "{} is held by {} and not by {} ({count} such in all)",
                    pair.describe(world),
                    side.name(),
                    side.other().name(),
                ))
            })
            .or_else(|| {
                let list = self.pairs.as_ref()?(ledger.candidate());
                ledger.held.check_list(&list)
            })
            .or_else(|| {
                let missing = touching
                    .all()
                    .find(|&pair| !ledger.held.holds(Side::Candidate, pair))?;
                Some(format!(
                    "{} touch in the simulation, and are not held by the candidate",
                    missing.describe(world)
                ))
            })
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
