//! The scene simulated on each broad phase alone: what a whole step takes.
//!
//! The two worlds are stepped by turns, and the turn changes at each step, so that whatever else the machine does
//! slows both down. The queries of a step are part of it: the default keeps its tree up to date in every update,
//! while others may build one when they are asked.
//!
//! The worlds drift apart, since the order of events decides the order in which the solver works, and with it the
//! last bits of its result. So their end states are not compared with each other, but each with what physics
//! demands; see [`Sanity::verdict`](super::Sanity::verdict).
//!
//! Neither of the two is clocked inside of a step: to be so, Rapier 0.36's own broad phase has to be wrapped, and does not work
//! beside the solver any more. That is done in a world of its own, of which both times are taken.

use super::outcome::{Clocked, Independent};
use super::rapier::prelude::*;
use super::rays::{self, Answer, Rays};
use super::version::{self, Installed, OwnBroadPhase, Steppable};
use super::{Both, BroadPhase, Candidate, Comparison, Observed, QueryAccess, Sanity, Scene};
use std::time::{Duration, Instant};

impl Comparison {
    /// Simulates the scene on both, each alone.
    pub(super) fn run_alone<C: BroadPhase + 'static>(
        &self,
        candidate: &Candidate<C>,
        repeat: usize,
        mut on_step: impl FnMut(usize),
    ) -> Both<Independent> {
        let seed = self.seed.wrapping_add(repeat as u64);
        // Where one cannot be asked, neither is.
        let access = candidate.access.map(|_| rays::of_default());
        let mut default = Run::new(self, seed, DefaultBroadPhase::new(), access);
        let (other, access) = version::alone((candidate.create)(), candidate.access);
        let mut other = Run::new(self, seed, other, access);
        for step in 0..self.steps {
            if step % 2 == 0 {
                default.step();
                on_step(2 * step + 1);
                other.step();
            } else {
                other.step();
                on_step(2 * step + 1);
                default.step();
            }
            on_step(2 * step + 2);
        }
        Both {
            default: default.end(),
            candidate: other.end(),
        }
    }

    /// Simulates the scene on the default alone, and times its broad phase.
    pub(super) fn run_clocked<C: BroadPhase + 'static>(
        &self,
        candidate: &Candidate<C>,
        mut on_step: impl FnMut(usize),
    ) -> Clocked {
        let access = candidate.access.map(|_| access_to_clocked());
        let own = version::install(Observed::new(OwnBroadPhase::new()).clocked());
        let mut run = Run::new(self, self.seed, own, access);
        for step in 1..=self.steps {
            run.step();
            on_step(step);
        }
        Clocked {
            elapsed: run.elapsed,
            broad_phase: run.broad_phase.timing().total,
        }
    }
}

/// How the default broad phase is asked while it is clocked.
fn access_to_clocked() -> QueryAccess<Installed<Observed<OwnBroadPhase>>> {
    QueryAccess::new(
        |clocked, dispatcher, bodies, colliders, filter| {
            let own = &clocked.inner;
            own.as_query_pipeline(dispatcher, bodies, colliders, filter)
        },
        |clocked, dispatcher, bodies, colliders, filter| {
            let own = &clocked.inner;
            own.as_query_pipeline_mut(dispatcher, bodies, colliders, filter)
        },
    )
}

/// A scene on one broad phase.
struct Run<B> {
    scene: Scene,
    initial: Sanity,
    broad_phase: B,
    access: Option<QueryAccess<B>>,
    rays: Rays,
    answers: Vec<Answer>,
    elapsed: Duration,
    casting: Duration,
    seed: u64,
}

impl<B: Steppable> Run<B> {
    fn new(
        comparison: &Comparison,
        seed: u64,
        broad_phase: B,
        access: Option<QueryAccess<B>>,
    ) -> Self {
        let scene = comparison.build(seed);
        Self {
            initial: scene.sanity(),
            rays: Rays::new(&scene, comparison.rays, seed),
            scene,
            broad_phase,
            access,
            answers: Vec::new(),
            elapsed: Duration::ZERO,
            casting: Duration::ZERO,
            seed,
        }
    }

    fn step(&mut self) {
        let start = Instant::now();
        match &self.access {
            Some(access) => self.scene.prepare_asking(&access.to(&self.broad_phase)),
            None => self.scene.prepare(),
        }
        self.scene.world.step(self.broad_phase.for_step(), &(), &());
        self.elapsed += start.elapsed();
        let Some(access) = &self.access else { return };
        let rays = self.rays.draw(&self.scene);
        if rays.is_empty() {
            return;
        }
        let start = Instant::now();
        rays::cast(
            &access.to(&self.broad_phase),
            &self.scene.world,
            rays,
            &mut self.answers,
        );
        let casting = start.elapsed();
        self.elapsed += casting;
        self.casting += casting;
    }

    fn end(self) -> Independent {
        let sanity = self.scene.sanity();
        let verdict = sanity.verdict(&self.initial);
        Independent {
            sanity,
            verdict,
            pairs_without_contact: self.scene.world.pairs_without_contact(),
            elapsed: self.elapsed,
            casting: self.casting,
            seed: self.seed,
        }
    }
}

/// Says so if the candidate's run went wrong where the default's did not.
pub(super) fn difference(runs: &Both<Independent>) -> Option<String> {
    match (&runs.default.verdict, &runs.candidate.verdict) {
        (Ok(()), Err(verdict)) => Some(format!(
            "simulated on the candidate alone, with the seed {}: {verdict}, which does not happen on the default",
            runs.candidate.seed
        )),
        _ => None,
    }
}
