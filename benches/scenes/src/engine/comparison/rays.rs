//! Rays through a scene, and whether they hit the same in the trees of two broad phases.
//!
//! The rays of a step are random, from a generator of their own that starts anew with each scene, and go through the
//! box around all colliders of usual size. Those of the scene's script come on top.

use super::super::queries::{AsQueryPipeline, tree_of};
use super::super::rapier::parry::partitioning::Bvh;
use super::super::rapier::prelude::*;
use super::super::scene::Scene;
use super::super::space::{Point, Vector, direction, largest, vector};
use super::super::world::World;
use super::Comparison;
use crate::Rays;
use crate::random::Random;

/// What a ray hits first, and at which distance.
pub(super) type Answer = Option<(ColliderHandle, Real)>;

/// The extent from which a collider does not count towards the region of the rays: it is a half-space.
const ENDLESS: Real = 1e5;

/// How far rays go at most: through any region.
const REACH: Real = 2.0 * ENDLESS;

/// Casts rays.
pub(super) fn cast(tree: &Bvh, world: &World, rays: &[Ray]) -> Vec<Answer> {
    let queries = world.queries(tree, QueryFilter::default());
    let answers = rays.iter().map(|ray| queries.cast_ray(ray, REACH, true));
    answers.collect()
}

/// The rays of a scene.
pub(super) struct SomeRays {
    random: Random,
    region: Aabb,
    count: usize,
    drawn: Vec<Ray>,
}

impl SomeRays {
    /// This many random rays a step, through the scene as it is now.
    pub(super) fn new(scene: &Scene, count: usize, seed: u64) -> Self {
        let colliders = scene.world.colliders.iter();
        let region = colliders
            .map(|(_, collider)| collider.compute_aabb())
            .filter(|aabb| largest(aabb.extents()) < ENDLESS)
            .reduce(|region, aabb| region.merged(&aabb));
        Self {
            random: Random::new(seed),
            region: region.unwrap_or_else(|| {
                Aabb::from_half_extents(Point::from(Vector::default()), vector(|_| 1.0))
            }),
            count,
            drawn: Vec::new(),
        }
    }

    /// Draws the rays of a step.
    pub(super) fn draw(&mut self, scene: &Scene) -> &[Ray] {
        let Self { random, region, .. } = self;
        let mut somewhere = || vector(|axis| random.range(region.mins[axis], region.maxs[axis]));
        self.drawn.clear();
        for _ in 0..self.count {
            let (from, to) = (somewhere(), somewhere());
            self.drawn
                .push(Ray::new(Point::from(from), direction(to - from)));
        }
        self.drawn.extend(scene.rays());
        &self.drawn
    }
}

/// Rays that are cast in the trees of two broad phases, which have seen the same updates.
pub(super) struct RayCheck<C> {
    queries: AsQueryPipeline<C>,
    rays: SomeRays,
    /// How many were cast so far.
    pub(super) count: Rays,
}

impl<C> RayCheck<C> {
    /// A check of the rays of a comparison.
    pub(super) fn new(queries: AsQueryPipeline<C>, scene: &Scene, comparison: &Comparison) -> Self {
        Self {
            queries,
            rays: SomeRays::new(scene, comparison.rays, comparison.seed),
            count: Rays::default(),
        }
    }

    /// Casts the rays of a step, and says which one hits something else in the candidate's tree, if one does.
    pub(super) fn check(&mut self, scene: &Scene, own: &Bvh, candidate: &C) -> Option<String> {
        let rays = self.rays.draw(scene);
        if rays.is_empty() {
            return None;
        }
        let world = &scene.world;
        let default = cast(own, world, rays);
        let candidate = cast(tree_of(candidate, self.queries), world, rays);
        self.count.cast += rays.len();
        self.count.hits += default.iter().flatten().count();
        let mut answers = rays.iter().zip(default.into_iter().zip(candidate));
        let (ray, (default, candidate)) = answers
            .find(|&(ray, (default, candidate))| !is_equal(default, candidate, ray, world))?;
        Some(format!(
            "the ray from {:?} along {:?} hits {} by the default, and {} by the candidate",
            ray.origin,
            ray.dir,
            describe(default),
            describe(candidate),
        ))
    }
}

/// Whether two answers are equal, or name two colliders that are hit at the very same distance.
fn is_equal(default: Answer, candidate: Answer, ray: &Ray, world: &World) -> bool {
    match (default, candidate) {
        (Some((first, distance)), Some((second, same))) if first != second => {
            let at = |handle: ColliderHandle| {
                let collider = &world.colliders[handle];
                collider
                    .shape()
                    .cast_ray(collider.position(), ray, REACH, true)
            };
            distance == same && at(first) == at(second)
        }
        _ => default == candidate,
    }
}

fn describe(answer: Answer) -> String {
    answer.map_or_else(
        || "nothing".to_owned(),
        |(handle, distance)| {
            let (index, generation) = handle.into_raw_parts();
            format!("{index}:{generation} at a distance of {distance}")
        },
    )
}
