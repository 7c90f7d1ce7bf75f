//! Rays through a scene, and whether they hit the same in the trees of two broad phases.
//!
//! The rays of a step are random, from a generator of their own that starts anew with each scene, and go through the
//! box around all colliders of usual size. Those of the scene's script come on top.

use super::ledger::Ledger;
use super::rapier::prelude::*;
use super::space::Point;
use super::{
    Both, BroadPhase, Comparison, Queries, QueryAccess, Random, RayCount, Scene, World, components,
    direction, largest, vector, version,
};

/// What a ray hits first, and at which distance.
pub(super) type Answer = Option<(ColliderHandle, Real)>;

/// The extent from which a collider does not count towards the region of the rays: it is a half-space.
const ENDLESS: Real = 1e5;

/// How far rays go at most: through any region.
const REACH: Real = 2.0 * ENDLESS;

/// How the default broad phase is asked.
pub(super) fn of_default() -> QueryAccess<DefaultBroadPhase> {
    QueryAccess::new(
        DefaultBroadPhase::as_query_pipeline,
        DefaultBroadPhase::as_query_pipeline_mut,
    )
}

/// Casts rays, and replaces `answers` by theirs.
pub(super) fn cast(queries: &dyn Queries, world: &World, rays: &[Ray], answers: &mut Vec<Answer>) {
    let pipeline = queries.pipeline(&world.bodies, &world.colliders, QueryFilter::default());
    answers.clear();
    answers.extend(rays.iter().map(|ray| pipeline.cast_ray(ray, REACH, true)));
}

/// The rays of a scene.
pub(super) struct Rays {
    random: Random,
    region: Aabb,
    count: usize,
    drawn: Vec<Ray>,
}

impl Rays {
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
    access: QueryAccess<C>,
    rays: Rays,
    answers: Both<Vec<Answer>>,
    /// How many were cast so far.
    pub(super) count: RayCount,
}

impl<C: BroadPhase + 'static> RayCheck<C> {
    /// A check of the rays of a comparison, if the candidate can be asked.
    pub(super) fn new(
        access: Option<QueryAccess<C>>,
        scene: &Scene,
        comparison: &Comparison,
    ) -> Option<Self> {
        Some(Self {
            access: access?,
            rays: Rays::new(scene, comparison.rays, comparison.seed),
            answers: Both::default(),
            count: RayCount::default(),
        })
    }

    /// Casts the rays of a step, and says which one hits something else in the candidate's tree, if one does.
    pub(super) fn check(&mut self, scene: &Scene, ledger: &Ledger<C>) -> Option<String> {
        let rays = self.rays.draw(scene);
        if rays.is_empty() {
            return None;
        }
        let (world, answers) = (&scene.world, &mut self.answers);
        let tee = &ledger.tee;
        cast(
            &version::access_to_own().to(&tee.heard.inner),
            world,
            rays,
            &mut answers.default,
        );
        cast(
            &self.access.to(&tee.unheard.inner),
            world,
            rays,
            &mut answers.candidate,
        );

        self.count.cast += rays.len();
        self.count.hits += answers.default.iter().flatten().count();
        let answers = answers.default.iter().zip(&answers.candidate);
        let mut both = rays.iter().zip(answers);
        let (ray, (default, candidate)) =
            both.find(|(ray, (default, candidate))| !is_equal(**default, **candidate, ray, world))?;
        Some(format!(
            "the ray from {:?} along {:?} hits {} by the default, and {} by the candidate",
            components(version::coordinates(ray.origin)),
            components(ray.dir),
            describe(*default),
            describe(*candidate),
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

#[cfg(test)]
mod tests {
    use super::super::Candidate;
    use super::super::version::OwnBroadPhase;
    use super::*;
    use crate::SceneKind;
    use std::time::Duration;

    fn comparison(kind: SceneKind) -> Comparison {
        Comparison {
            steps: 20,
            rays: 10,
            repeats: 2,
            ..Comparison::new(kind, 60, 3)
        }
    }

    #[test]
    fn rays_hit_the_same_in_equal_trees() {
        for kind in SceneKind::ALL {
            let candidate =
                Candidate::new(OwnBroadPhase::new).with_queries(version::access_to_own());
            let outcome = comparison(kind).run(&candidate, |_| {});
            assert_eq!(outcome.first_difference, None, "{}", kind.name());
            let looks = if kind == SceneKind::Player { 16 } else { 0 };
            assert_eq!(outcome.rays.cast, 20 * (10 + looks));
            assert!(outcome.rays.hits > 0, "{}", kind.name());
            let seeds = outcome.independent.iter().map(|runs| runs.candidate.seed);
            assert_eq!(seeds.collect::<Vec<_>>(), [3, 4]);
            for runs in &outcome.independent {
                assert!(runs.default.casting > Duration::ZERO);
                assert!(runs.default.casting < runs.default.elapsed);
            }
        }
    }

    #[test]
    fn a_ray_that_misses_is_reported() {
        let blind = QueryAccess::new(
            |broad_phase: &OwnBroadPhase, dispatcher, bodies, colliders, _| {
                let filter = QueryFilter::only_fixed();
                broad_phase.as_query_pipeline(dispatcher, bodies, colliders, filter)
            },
            |broad_phase, dispatcher, bodies, colliders, filter| {
                broad_phase.as_query_pipeline_mut(dispatcher, bodies, colliders, filter)
            },
        );
        let candidate = Candidate::new(OwnBroadPhase::new).with_queries(blind);
        let outcome = comparison(SceneKind::FallingBalls).run(&candidate, |_| {});
        let difference = outcome.first_difference.expect("a difference");
        assert!(difference.starts_with("step "), "{difference}");
        assert!(difference.contains("by the candidate"), "{difference}");
    }
}
