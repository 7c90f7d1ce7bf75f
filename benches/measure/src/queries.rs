//! What a query costs when a step has one: the kept tree brought up to date, and its quality once it has aged. One source, compiled
//! once in each dimension.
//!
//! Balls fly about in a container, all of them or a part, and there is one ray in every step. The *first ray* is timed with all that
//! it takes to bring the tree up to date, at the beginning and at the end. A *further ray* is the mean of rays through the tree as it
//! is at the end. Rapier's own broad phase keeps its tree up to date in every update, so its rays are all further ones.

use unisize_report::Report;
use std::io;
use std::time::{Duration, Instant};

use super::engine::Driven;
use super::frames::World;
use super::ours::UnisizeBroadPhase;
use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;

/// The part of the container that the balls fill.
const DENSITY: f64 = 0.2;

/// Radii a step.
const SPEED: Real = 0.2;

/// Rays of one measurement.
const RAYS: usize = 2000;

/// Balls that fly straight and turn at the walls of their container.
struct Flight {
    world: World,
    /// Those that move, and how far in a step.
    movers: Vec<(ColliderHandle, Vector<Real>)>,
    side: Real,
    random: oorandom::Rand32,
}

impl Flight {
    fn new(count: usize, one_in: usize) -> Self {
        let side = (count as f64 / DENSITY).powf(1.0 / DIM as f64) as Real;
        let mut flight = Self {
            world: World::new(count),
            movers: Vec::new(),
            side,
            random: oorandom::Rand32::new(7),
        };
        for i in 0..count {
            let place = flight.any() * side;
            let ball = ColliderBuilder::ball(0.5).translation(place);
            let handle = flight.world.colliders.insert(ball);
            let velocity = (flight.any() - Vector::repeat(0.5)) * SPEED;
            if i % one_in == 0 {
                flight.movers.push((handle, velocity));
            }
        }
        flight
    }

    /// Any point of the unit cube.
    fn any(&mut self) -> Vector<Real> {
        Vector::from_fn(|_, _| self.random.rand_float())
    }

    fn advance(&mut self) {
        for (handle, velocity) in &mut self.movers {
            let ball = &mut self.world.colliders[*handle];
            let place = ball.translation() + *velocity;
            for k in 0..DIM {
                if !(0.0..self.side).contains(&place[k]) {
                    velocity[k] = (self.side / 2.0 - place[k]).signum() * velocity[k].abs();
                }
            }
            ball.set_translation(place);
        }
    }

    /// A ray into the container from one side.
    fn ray(&mut self) -> Ray {
        let mut from = self.any() * self.side;
        from[0] = -1.0;
        Ray::new(from.into(), Vector::x())
    }
}

/// The time of rays, each.
fn time(scene: &QueryPipeline<'_>, rays: &[Ray]) -> Duration {
    let start = Instant::now();
    for ray in rays {
        std::hint::black_box(scene.cast_ray(ray, Real::MAX, true));
    }
    start.elapsed() / rays.len() as u32
}

/// Measures one case: balls, of which one in so many moves.
pub(crate) fn measure(
    count: usize,
    one_in: usize,
    steps: usize,
    report: &mut Report,
) -> io::Result<()> {
    let mut flight = Flight::new(count, one_in);
    let all = flight.world.colliders.iter().map(|(handle, _)| handle);
    let all: Vec<_> = all.collect();
    let movers: Vec<_> = flight.movers.iter().map(|&(handle, _)| handle).collect();
    let (mut ours, mut default) = (UnisizeBroadPhase::new(), DefaultBroadPhase::new());
    ours.follow(&mut flight.world, &all, &[], &[]);
    default.follow(&mut flight.world, &all, &[], &[]);
    let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
    let mut first = Vec::new();
    for _ in 0..steps {
        flight.advance();
        flight.world.events.clear();
        ours.follow(&mut flight.world, &[], &movers, &[]);
        // Its tree ages over the same steps, but it need not be looked at in between.
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
    // In turns, so that both see the same machine.
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
