//! The suite: one source for every flavour, which the module that includes it names as `rapier`.

use super::{UnisizeBroadPhase, rapier, version};
use crate::in_a_process;
use crowd::Crowd;
use rapier::prelude::*;
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::Mutex;

#[path = "../common/crowd/mod.rs"]
mod crowd;

/// Colliders whose updates are worth several threads.
const MANY: usize = if cfg!(debug_assertions) {
    4_000
} else {
    20_000
};

/// Colliders whose updates stay on one thread.
const FEW: usize = 20;

/// A world, and the events of its steps.
struct World {
    crowd: Crowd,
    broad_phase: UnisizeBroadPhase,
    events: Vec<Vec<(bool, ColliderPair)>>,
}

impl World {
    fn new(count: usize) -> Self {
        // About one overlapping pair for each collider.
        let side = (1..).find(|side: &usize| side.pow(DIM as u32) > 2 * count);
        Self {
            crowd: Crowd::new(count, side.expect("there is one") as Real, 0.1),
            broad_phase: UnisizeBroadPhase::default(),
            events: Vec::new(),
        }
    }

    fn step(&mut self) {
        self.events.push(self.crowd.update(&mut self.broad_phase));
        // All are listed, so that most of a step is work for several threads.
        self.crowd.advance(10);
        self.crowd.modified.clone_from(&self.crowd.handles);
    }

    /// Panics unless so many steps were made, with the events of a world that is stepped on one thread.
    fn check(&self, steps: usize) {
        let mut alone = Self::new(self.crowd.handles.len());
        pool(1).install(|| (0..steps).for_each(|_| alone.step()));
        assert!(self.events == alone.events, "other events");
    }
}

/// Worlds that jobs share, and the number of steps of each.
struct Shared {
    worlds: [Mutex<World>; 2],
    steps: usize,
}

impl Shared {
    fn new() -> Self {
        Self {
            worlds: [MANY, MANY].map(|count| Mutex::new(World::new(count))),
            steps: 200,
        }
    }

    fn step(&self, i: usize) {
        let world = self.worlds[i % 2].lock();
        world.expect("no step panics").step();
    }

    fn check(&self) {
        for world in &self.worlds {
            let world = world.lock().expect("no step panics");
            world.check(self.steps);
        }
    }
}

fn pool(threads: usize) -> ThreadPool {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    pool.expect("there are threads to be had")
}

#[test]
fn jobs_that_lock_a_world_do_not_wait_for_themselves() {
    let test = "jobs_that_lock_a_world_do_not_wait_for_themselves";
    in_a_process(module_path!(), test, || {
        let shared = Shared::new();
        let step = |i| shared.step(i);
        pool(2).in_place_scope(|scope| {
            for i in 0..2 * shared.steps {
                scope.spawn(move |_| step(i));
            }
        });
        shared.check();
    });
}

/// The thread is in no pool; the jobs are in the global one.
#[test]
fn a_thread_beside_jobs_that_lock_its_world_does_not_wait_for_them() {
    let test = "a_thread_beside_jobs_that_lock_its_world_does_not_wait_for_them";
    in_a_process(module_path!(), test, || {
        let two = ThreadPoolBuilder::new().num_threads(2).build_global();
        two.expect("it is the first");
        let shared = Shared::new();
        let step = |i| shared.step(i);
        rayon::in_place_scope(|scope| {
            for i in 0..shared.steps {
                scope.spawn(move |_| step(i));
            }
            (0..shared.steps).for_each(step);
        });
        shared.check();
    });
}

#[test]
fn small_steps_start_no_pool() {
    in_a_process(module_path!(), "small_steps_start_no_pool", || {
        let mut world = World::new(FEW);
        (0..20).for_each(|_| world.step());
        let global = ThreadPoolBuilder::new().build_global();
        global.expect("it is the first");
        world.check(20);
    });
}

#[test]
fn worlds_step_alike_within_any_pool() {
    in_a_process(module_path!(), "worlds_step_alike_within_any_pool", || {
        for threads in [1, 2, 3] {
            let (pool, mut world) = (pool(threads), World::new(MANY));
            world.step();
            pool.install(|| world.step());
            pool.scope(|_| world.step());
            pool.scope(|scope| scope.spawn(|_| world.step()));
            world.check(4);
            let mut worlds: Vec<_> = (0..500).map(|_| World::new(FEW)).collect();
            // Some are worth several threads while others step.
            worlds[..4].fill_with(|| World::new(MANY));
            for _ in 0..4 {
                pool.install(|| worlds.par_iter_mut().for_each(World::step));
            }
            worlds.iter().for_each(|world| world.check(4));
        }
    });
}
