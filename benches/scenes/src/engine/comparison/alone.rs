//! The scene simulated on each broad phase alone, which times whole steps; and on the default with the candidate beside it, which times
//! the updates of both.
//!
//! The two worlds are stepped even/odd interleaved, so that other work of the machine slows both down. The queries of a step are a part
//! of it: the default maintains its tree in every update, while others may build one for the first query.
//!
//! The worlds diverge, since the order of events decides the order in which the solver works, and with it the last bits of its result.
//! So their end states are not compared with each other; each is checked by [`Sanity::verdict`].
//!
//! If whole steps are timed [later](Comparison::before), a world gets there on the candidate, and both begin with clones of it: with the same
//! piles. Then each gets a new broad phase, and all colliders are listed for it, which wakes their bodies.
//!
//! Neither broad phase is timed inside of a step: Rapier 0.36's own would have to be wrapped, and a wrapped one does not work next to the
//! solver. A world of its own has both times.

use super::super::observed::{Observed, Tee};
use super::super::queries::{AsQueryPipeline, tree_of};
use super::super::rapier::prelude::*;
use super::super::sanity::Sanity;
use super::super::scene::Scene;
use super::super::version::{self, BroadPhase, OwnBroadPhase};
use super::super::world::Steppable;
use super::rays::{self, SomeRays};
use super::{Candidate, Comparison};
use crate::{Both, Clock, End, Limit, Repeat, Times, milliseconds};
use std::time::Duration;

impl Comparison {
    /// Simulates the scene on both, each alone.
    pub(super) fn run_alone<C: BroadPhase + 'static>(
        &self,
        candidate: &Candidate<C>,
        repeat: usize,
        start: &Start,
    ) -> Repeat {
        let seed = self.seed_of(repeat);
        let (other, queries) = version::alone((candidate.create)(), candidate.queries);
        let own = DefaultBroadPhase::new();
        let mut default = Run::new(self, seed, start, own, DefaultBroadPhase::as_query_pipeline);
        let mut other = Run::new(self, seed, start, other, queries);
        for step in 0..self.steps {
            if step % 2 == 0 {
                default.step();
                other.step();
            } else {
                other.step();
                default.step();
            }
        }
        let end = Both {
            default: default.end(self.steps),
            candidate: other.end(self.steps),
        };
        let ratio = end.default.ms_per_step / end.candidate.ms_per_step;
        Repeat { seed, ratio, end }
    }

    /// Simulates the scene on the default alone, and times its broad phase.
    pub(super) fn run_clocked(&self, start: &Start) -> Limit {
        let own = version::install(Observed::new(OwnBroadPhase::new()).clocked(self.clock()));
        let mut run = Run::new(
            self,
            self.seed,
            start,
            own,
            |clocked, of, bodies, colliders, filter| {
                let own = &clocked.inner;
                own.as_query_pipeline(of, bodies, colliders, filter)
            },
        );
        let before = run.broad_phase.timing().total;
        for _ in 0..self.steps {
            run.step();
        }
        let [step, broad_phase] = [run.elapsed, run.broad_phase.timing().total - before]
            .map(|time| milliseconds(time) / self.steps as f64);
        Limit::of(step, broad_phase)
    }

    /// Simulates the scene on the default, passes each update to the candidate as well, and times both. Which of them is first in the first
    /// update changes from repeat to repeat.
    pub(super) fn time_updates<C: BroadPhase + 'static>(
        &self,
        candidate: &Candidate<C>,
        repeat: usize,
        start: &Start,
    ) -> Both<Times> {
        let own = Observed::new(OwnBroadPhase::new()).clocked(self.clock());
        let other = Observed::new((candidate.create)()).clocked(self.clock());
        let mut both = Tee::new(own, other);
        if repeat % 2 == 1 {
            both = both.with_unheard_first();
        }
        let mut run = Run::new(
            self,
            self.seed_of(repeat),
            start,
            version::install(both),
            |both, of, bodies, colliders, filter| {
                let own = &both.heard.inner;
                own.as_query_pipeline(of, bodies, colliders, filter)
            },
        );
        if self.before > 0 {
            run.broad_phase.heard.restart_timing();
            run.broad_phase.unheard.restart_timing();
        }
        for _ in 0..self.steps {
            run.step();
        }
        Both {
            default: run.broad_phase.heard.timing().over(self.steps),
            candidate: run.broad_phase.unheard.timing().over(self.steps),
        }
    }

    /// The scene of a repeat, after the steps on the candidate alone, with all colliders listed for the broad phase that comes next.
    pub(super) fn start<C: BroadPhase + 'static>(
        &self,
        candidate: &Candidate<C>,
        repeat: usize,
    ) -> Start {
        let mut scene = Scene::build(self.kind, self.bodies, self.seed_of(repeat));
        let initial = scene.sanity();
        let (mut broad_phase, queries) = version::alone((candidate.create)(), candidate.queries);
        for _ in 0..self.before.saturating_sub(SETTLING) {
            scene.prepare_asking(|| tree_of(&broad_phase, queries));
            scene.world.step(broad_phase.for_step(), &(), &());
        }
        if self.before > 0 {
            scene.world.touch_all();
        }
        Start { scene, initial }
    }

    fn seed_of(&self, repeat: usize) -> u64 {
        self.seed.wrapping_add(repeat as u64)
    }

    fn clock(&self) -> Clock {
        Clock::of_threads(self.threads)
    }
}

/// The number of steps after the exchange of a broad phase that are not timed.
const SETTLING: usize = 10;

/// What all simulations of a repeat begin with: clones of one scene, and how it was when it was built.
#[derive(Clone)]
pub(super) struct Start {
    scene: Scene,
    initial: Sanity,
}

/// A scene on one broad phase.
struct Run<B> {
    scene: Scene,
    initial: Sanity,
    broad_phase: B,
    queries: AsQueryPipeline<B>,
    rays: SomeRays,
    clock: Clock,
    elapsed: Duration,
}

impl<B: Steppable> Run<B> {
    /// A run whose next step is the first to be timed.
    fn new(
        comparison: &Comparison,
        seed: u64,
        start: &Start,
        broad_phase: B,
        queries: AsQueryPipeline<B>,
    ) -> Self {
        let Start { scene, initial } = start.clone();
        let mut run = Self {
            initial,
            rays: SomeRays::new(&scene, comparison.rays, seed),
            scene,
            broad_phase,
            queries,
            clock: comparison.clock(),
            elapsed: Duration::ZERO,
        };
        for _ in 0..SETTLING.min(comparison.before) {
            run.step();
        }
        run.elapsed = Duration::ZERO;
        run
    }

    fn step(&mut self) {
        let start = self.clock.start();
        let tree = || tree_of(&self.broad_phase, self.queries);
        self.scene.prepare_asking(tree);
        self.scene.world.step(self.broad_phase.for_step(), &(), &());
        self.elapsed += start.elapsed();
        let rays = self.rays.draw(&self.scene);
        if rays.is_empty() {
            return;
        }
        let start = self.clock.start();
        let tree = tree_of(&self.broad_phase, self.queries);
        std::hint::black_box(rays::cast(tree, &self.scene.world, rays));
        self.elapsed += start.elapsed();
    }

    fn end(self, steps: usize) -> End {
        let sanity = self.scene.sanity();
        End {
            complaint: sanity.verdict(&self.initial).err(),
            bodies: sanity.bodies,
            asleep: sanity.sleeping,
            energy: sanity.energy(),
            pairs_without_contact: self.scene.world.pairs_without_contact(),
            ms_per_step: milliseconds(self.elapsed) / steps as f64,
        }
    }
}

/// The complaint about the candidate's run, if there is none about the default's.
pub(super) fn difference(repeat: &Repeat) -> Option<String> {
    let Repeat { seed, end, .. } = repeat;
    let complaint = end.candidate.complaint.as_ref()?;
    end.default.complaint.is_none().then(|| {
        format!("simulated on the candidate alone, with the seed {seed}: {complaint}, which does not happen on the default")
    })
}
