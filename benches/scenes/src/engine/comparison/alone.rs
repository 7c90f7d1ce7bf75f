//! The scene simulated on each broad phase alone: what a whole step takes.
//!
//! The two worlds are stepped by turns, and the turn changes at each step, so that whatever else the machine does
//! slows both down. The queries of a step are part of it: the default keeps its tree up to date in every update,
//! while others may build one when they are asked.
//!
//! The worlds drift apart, since the order of events decides the order in which the solver works, and with it the
//! last bits of its result. So their end states are not compared with each other, but each with what physics
//! demands; see [`Sanity::verdict`].
//!
//! If whole steps are timed [later](Comparison::before), both worlds are brought there on the candidate, which does the same in either, so
//! that both begin with the same piles, and as many asleep. Then each gets a broad phase that is new, and hears of all colliders.
//!
//! Neither of the two is clocked inside of a step: to be so, Rapier 0.36's own broad phase has to be wrapped, and does not work
//! beside the solver any more. That is done in a world of its own, of which both times are taken.

use super::super::observed::Observed;
use super::super::queries::{AsQueryPipeline, tree_of};
use super::super::rapier::prelude::*;
use super::super::sanity::Sanity;
use super::super::scene::Scene;
use super::super::version::{self, BroadPhase, OwnBroadPhase};
use super::super::world::Steppable;
use super::rays::{self, SomeRays};
use super::{Candidate, Comparison};
use crate::{Both, End, Limit, Repeat, milliseconds};
use std::time::{Duration, Instant};

impl Comparison {
    /// Simulates the scene on both, each alone.
    pub(super) fn run_alone<C: BroadPhase + 'static>(
        &self,
        candidate: &Candidate<C>,
        repeat: usize,
    ) -> Repeat {
        let seed = self.seed.wrapping_add(repeat as u64);
        let (other, queries) = version::alone((candidate.create)(), candidate.queries);
        let own = DefaultBroadPhase::new();
        let mut default = Run::new(self, seed, own, DefaultBroadPhase::as_query_pipeline);
        let mut other = Run::new(self, seed, other, queries);
        self.bring_there(&mut default, candidate);
        self.bring_there(&mut other, candidate);
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
    pub(super) fn run_clocked<C: BroadPhase + 'static>(&self, candidate: &Candidate<C>) -> Limit {
        let own = version::install(Observed::new(OwnBroadPhase::new()).clocked());
        let mut run = Run::new(
            self,
            self.seed,
            own,
            |clocked, of, bodies, colliders, filter| {
                let own = &clocked.inner;
                own.as_query_pipeline(of, bodies, colliders, filter)
            },
        );
        self.bring_there(&mut run, candidate);
        let before = run.broad_phase.timing().total;
        for _ in 0..self.steps {
            run.step();
        }
        let [step, broad_phase] = [run.elapsed, run.broad_phase.timing().total - before]
            .map(|time| milliseconds(time) / self.steps as f64);
        Limit::of(step, broad_phase)
    }

    /// Makes the steps before those that are timed.
    fn bring_there<B: Steppable, C: BroadPhase + 'static>(
        &self,
        run: &mut Run<B>,
        candidate: &Candidate<C>,
    ) {
        if self.before == 0 {
            return;
        }
        let (mut broad_phase, queries) = version::alone((candidate.create)(), candidate.queries);
        for _ in 0..self.before.saturating_sub(SETTLING) {
            run.scene.prepare_asking(|| tree_of(&broad_phase, queries));
            run.scene.world.step(broad_phase.for_step(), &(), &());
        }
        run.scene.world.touch_all();
        for _ in 0..SETTLING.min(self.before) {
            run.step();
        }
        (run.elapsed, run.casting) = Default::default();
    }
}

/// Steps that are not timed, after a broad phase has been exchanged.
const SETTLING: usize = 10;

/// A scene on one broad phase.
struct Run<B> {
    scene: Scene,
    initial: Sanity,
    broad_phase: B,
    queries: AsQueryPipeline<B>,
    rays: SomeRays,
    elapsed: Duration,
    casting: Duration,
}

impl<B: Steppable> Run<B> {
    fn new(
        comparison: &Comparison,
        seed: u64,
        broad_phase: B,
        queries: AsQueryPipeline<B>,
    ) -> Self {
        let scene = Scene::build(comparison.kind, comparison.bodies, seed);
        Self {
            initial: scene.sanity(),
            rays: SomeRays::new(&scene, comparison.rays, seed),
            scene,
            broad_phase,
            queries,
            elapsed: Duration::ZERO,
            casting: Duration::ZERO,
        }
    }

    fn step(&mut self) {
        let start = Instant::now();
        let tree = || tree_of(&self.broad_phase, self.queries);
        self.scene.prepare_asking(tree);
        self.scene.world.step(self.broad_phase.for_step(), &(), &());
        self.elapsed += start.elapsed();
        let rays = self.rays.draw(&self.scene);
        if rays.is_empty() {
            return;
        }
        let start = Instant::now();
        let tree = tree_of(&self.broad_phase, self.queries);
        std::hint::black_box(rays::cast(tree, &self.scene.world, rays));
        let casting = start.elapsed();
        self.elapsed += casting;
        self.casting += casting;
    }

    fn end(self, steps: usize) -> End {
        let sanity = self.scene.sanity();
        let ms_per_step = |time: Duration| milliseconds(time) / steps as f64;
        End {
            complaint: sanity.verdict(&self.initial).err(),
            bodies: sanity.bodies,
            asleep: sanity.sleeping,
            outside: sanity.fallen_through,
            not_finite: sanity.not_finite,
            energy: sanity.energy(),
            max_rope_stretch: sanity.max_rope_stretch,
            pairs_without_contact: self.scene.world.pairs_without_contact(),
            ms_per_step: ms_per_step(self.elapsed),
            ms_of_rays: ms_per_step(self.casting),
        }
    }
}

/// Says so if the candidate's run went wrong where the default's did not.
pub(super) fn difference(repeat: &Repeat) -> Option<String> {
    let Repeat { seed, end, .. } = repeat;
    let complaint = end.candidate.complaint.as_ref()?;
    end.default.complaint.is_none().then(|| {
        format!("simulated on the candidate alone, with the seed {seed}: {complaint}, which does not happen on the default")
    })
}
