//! The cost of a query when a step has one: updating the tree, and the quality of a tree that has degraded. One source, compiled once in
//! each dimension.
//!
//! Balls fly about in a container, all of them or a part, and there is one ray in every step. The time of the *first ray* includes the
//! update of the tree; it is measured at the beginning and at the end. A *further ray* is the mean of rays through the tree at the end.
//! Rapier's own broad phase maintains its tree in every update, so all of its rays are further ones.

use super::ours::UnisizeBroadPhase;
use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use super::world::{Driven, World};
use std::io;
use std::time::{Duration, Instant};
use unisize_report::Report;
use unisize_scenes::DriftingBoxes;

/// The part of the container that the boxes of the balls fill.
const DENSITY: f64 = 0.2;

/// The number of further rays.
const RAYS: usize = 2000;

/// Balls of which some fly straight and bounce from the walls of their container.
struct Flight {
    world: World,
    boxes: DriftingBoxes<DIM>,
    all: Vec<ColliderHandle>,
    /// One ball in this many moves.
    one_in: usize,
    side: Real,
    random: oorandom::Rand32,
}

impl Flight {
    fn new(count: usize, one_in: usize) -> Self {
        let boxes = DriftingBoxes::new(count, DENSITY, 7);
        let mut world = World::new(count);
        let mut insert = |mins: &[Real; DIM]| {
            let ball = ColliderBuilder::ball(0.5).translation(center(mins));
            world.colliders.insert(ball)
        };
        let all = boxes.mins().iter().map(&mut insert).collect();
        Self {
            world,
            boxes,
            all,
            one_in,
            side: (count as f64 / DENSITY).powf(1.0 / DIM as f64) as Real,
            random: oorandom::Rand32::new(7),
        }
    }

    fn movers(&self) -> Vec<ColliderHandle> {
        self.all.iter().copied().step_by(self.one_in).collect()
    }

    fn advance(&mut self) {
        self.boxes.advance();
        let moved = self.all.iter().zip(self.boxes.mins()).step_by(self.one_in);
        for (&handle, mins) in moved {
            self.world.colliders[handle].set_translation(center(mins));
        }
    }

    /// A ray into the container from one side.
    fn ray(&mut self) -> Ray {
        let mut from = Vector::from_fn(|_, _| self.random.rand_float() * self.side);
        from[0] = -1.0;
        Ray::new(from.into(), Vector::x())
    }
}

fn center(mins: &[Real; DIM]) -> Vector<Real> {
    Vector::from(mins.map(|x| x + 0.5))
}

/// The mean time of these rays.
fn time(scene: &QueryPipeline<'_>, rays: &[Ray]) -> Duration {
    let start = Instant::now();
    for ray in rays {
        std::hint::black_box(scene.cast_ray(ray, Real::MAX, true));
    }
    start.elapsed() / rays.len() as u32
}

/// Measures one case: balls of which one in `one_in` moves.
pub(crate) fn measure(
    count: usize,
    one_in: usize,
    steps: usize,
    report: &mut Report,
) -> io::Result<()> {
    let mut flight = Flight::new(count, one_in);
    let (all, movers) = (flight.all.clone(), flight.movers());
    let (mut ours, mut default) = (UnisizeBroadPhase::new(), DefaultBroadPhase::new());
    ours.follow(&mut flight.world, &all, &[], &[]);
    default.follow(&mut flight.world, &all, &[], &[]);
    let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
    let mut first = Vec::new();
    for _ in 0..steps {
        flight.advance();
        flight.world.events.clear();
        ours.follow(&mut flight.world, &[], &movers, &[]);
        // Its tree degrades over the same steps, without a query in between.
        default.follow(&mut flight.world, &[], &movers, &[]);
        let ray = flight.ray();
        let start = Instant::now();
        let (bodies, colliders) = (&flight.world.bodies, &flight.world.colliders);
        let scene = ours.as_query_pipeline(dispatcher, bodies, colliders, filter);
        std::hint::black_box(scene.cast_ray(&ray, Real::MAX, true));
        first.push(start.elapsed());
    }
    let rays: Vec<_> = (0..RAYS).map(|_| flight.ray()).collect();
    let (bodies, colliders) = (&flight.world.bodies, &flight.world.colliders);
    let ours = ours.as_query_pipeline(dispatcher, bodies, colliders, filter);
    let default = default.as_query_pipeline(dispatcher, bodies, colliders, filter);
    // In turns, so that both have the machine at the same times.
    let mut best = [Duration::MAX; 2];
    for _ in 0..5 {
        for (best, scene) in best.iter_mut().zip([&ours, &default]) {
            *best = time(scene, &rays).min(*best);
        }
    }
    let mean = |times: &[Duration]| micros(times.iter().sum::<Duration>()) / times.len() as f64;
    let few = steps.min(100);
    let [ours, default] = best.map(micros);
    report.row(&[
        ("dim", DIM.into()),
        ("balls", count.into()),
        ("moving", movers.len().into()),
        ("first_ray_us", mean(&first[..few]).into()),
        (
            "first_ray_of_last_100_us",
            mean(&first[steps - few..]).into(),
        ),
        ("further_ray_us", ours.into()),
        ("default_ray_us", default.into()),
    ])
}

fn micros(time: Duration) -> f64 {
    time.as_secs_f64() * 1e6
}
