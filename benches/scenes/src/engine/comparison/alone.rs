//! The scene simulated on each broad phase alone, which times whole steps.
//!
//! The two worlds are stepped even/odd interleaved, so that other work of the machine slows both down. The queries of a step are a part
//! of it: the default maintains its tree in every update, while others may build one for the first query.
//!
//! The worlds diverge, since the order of events decides the order in which the solver works, and with it the last bits of its result.
//! So their end states are not compared with each other; each is checked by [`Sanity::verdict`].
//!
//! If whole steps are timed [later](Comparison::before), both worlds get there on the candidate, which does the same in either, so that
//! both begin with the same piles and as many sleeping bodies. Then each gets a new broad phase, and all colliders are listed for it.
//!
//! Neither broad phase is timed inside of a step: Rapier 0.36's own would have to be wrapped, and a wrapped one does not work next to the
//! solver. A world of its own has both times.

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

    /// Makes the steps before the timed ones.
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
        run.elapsed = Duration::ZERO;
    }
}

/// The number of steps after the exchange of a broad phase that are not timed.
const SETTLING: usize = 10;

/// A scene on one broad phase.
struct Run<B> {
    scene: Scene,
    initial: Sanity,
    broad_phase: B,
    queries: AsQueryPipeline<B>,
    rays: SomeRays,
    elapsed: Duration,
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
