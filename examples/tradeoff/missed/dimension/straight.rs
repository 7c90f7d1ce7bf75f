//! Straight motion during a step, and the truth about it: what meets at any time between the beginning and the end.

use super::scenes::World;
use super::scenes::rapier::{
    math::{DIM, Isometry},
    parry::{
        bounding_volume::BoundingVolume,
        query::{self, ShapeCastOptions},
    },
    prelude::*,
};
use super::{SLACK, Stage};
use std::collections::HashMap;
use unisize::{Aabb, BruteForce, PairFinder};

/// Shapes that come as near as this, in length units, meet: what rounding makes of zero, and less than the prediction distance.
const CONTACT: Real = 1e-5;

/// How much further than its way soft CCD may look, in ways: it must not be cut short by rounding.
const AMPLE: Real = 2.0;

/// A pose at the start of the step, and the way from there to its end.
type Flight = (Isometry<Real>, Vector<Real>);

/// A body that goes straight, without turning.
struct Motion {
    body: RigidBodyHandle,
    start: Isometry<Real>,
    way: Vector<Real>,
}

/// All bodies that are not fixed, in one step.
pub(super) struct Motions {
    motions: Vec<Motion>,
    /// The colliders of these bodies.
    colliders: HashMap<ColliderHandle, Flight>,
}

impl Motions {
    /// The poses of all bodies that are not fixed.
    pub(super) fn starts(world: &World) -> Vec<(RigidBodyHandle, Isometry<Real>)> {
        let bodies = world.bodies.iter();
        let movable = bodies.filter(|(_, body)| !body.is_fixed());
        movable
            .map(|(handle, body)| (handle, *body.position()))
            .collect()
    }

    /// The motions from these poses to those that the bodies have now.
    pub(super) fn new(world: &World, starts: Vec<(RigidBodyHandle, Isometry<Real>)>) -> Self {
        let motion = |(body, start): (RigidBodyHandle, Isometry<Real>)| Motion {
            body,
            start,
            way: world.bodies[body].translation() - start.translation.vector,
        };
        let motions: Vec<_> = starts.into_iter().map(motion).collect();
        let mut colliders = HashMap::new();
        for motion in &motions {
            for &handle in world.bodies[motion.body].colliders() {
                let local = world.colliders[handle].position_wrt_parent();
                let local = local.copied().unwrap_or_else(Isometry::identity);
                colliders.insert(handle, (motion.start * local, motion.way));
            }
        }
        Self { motions, colliders }
    }

    /// The colliders, all of which count as moved.
    pub(super) fn handles(&self) -> Vec<ColliderHandle> {
        let mut handles: Vec<_> = self.colliders.keys().copied().collect();
        handles.sort_unstable_by_key(|handle| handle.into_raw_parts());
        handles
    }

    /// The pose of a collider at the start, and its way; that of a fixed one is zero.
    fn of(&self, handle: ColliderHandle, collider: &Collider) -> Flight {
        let still = (*collider.position(), Vector::zeros());
        self.colliders.get(&handle).copied().unwrap_or(still)
    }

    /// The world at the end of the step.
    pub(super) fn at_end(&self, world: &World) -> Stage {
        let mut stage = Stage::of(world);
        for (&handle, &(start, way)) in &self.colliders {
            stage.colliders[handle].set_position(moved(start, way));
        }
        stage.settle();
        stage
    }

    /// The world at the start of the step, where soft CCD foresees the motions.
    pub(super) fn at_start(&self, world: &World) -> Stage {
        let mut stage = Stage::of(world);
        let dt = world.params.dt;
        for motion in &self.motions {
            let body = &mut stage.bodies[motion.body];
            let is_asleep = body.is_sleeping();
            // A new body: the old one may remember forces, which soft CCD would foresee.
            let fresh = RigidBodyBuilder::new(body.body_type())
                .position(motion.start)
                .linvel(motion.way / dt)
                .soft_ccd_prediction(AMPLE * motion.way.norm());
            body.copy_from(&fresh.build());
            if is_asleep {
                body.sleep();
            }
        }
        for (&handle, &(start, _)) in &self.colliders {
            stage.colliders[handle].set_position(start);
        }
        stage.settle();
        stage
    }

    /// The pairs that meet at any time of the step, by Parry's shape casts and distances. **O(n²)**.
    pub(super) fn touching(&self, world: &World, typical_size: Real) -> Vec<ColliderPair> {
        let (handles, colliders): (Vec<_>, Vec<_>) = world.colliders.iter_enabled().unzip();
        let slack = SLACK * typical_size + world.params.prediction_distance();
        let motions: Vec<_> = (handles.iter().zip(&colliders))
            .map(|(&handle, collider)| self.of(handle, collider))
            .collect();
        let swept = |(collider, &(start, way)): (&&Collider, &(Isometry<Real>, _))| {
            let [first, last] =
                [start, moved(start, way)].map(|pose| collider.shape().compute_aabb(&pose));
            let aabb = first.merged(&last).loosened(slack);
            Aabb::<Real, DIM>::new(aabb.mins.coords.into(), aabb.maxs.coords.into())
        };
        let boxes: Vec<_> = colliders.iter().zip(&motions).map(swept).collect();
        let mut pairs = Vec::new();
        let found = BruteForce.find_pairs(&boxes, &mut pairs);
        found.expect("the boxes of a sane scene are valid");
        let pairs = pairs.into_iter().map(|pair| pair.map(|i| i as usize));
        let meeting = pairs.filter(|&[i, j]| {
            let (a, b) = (colliders[i], colliders[j]);
            world.may_touch(a, b) && meet([(a.shape(), motions[i]), (b.shape(), motions[j])])
        });
        meeting
            .map(|[i, j]| ColliderPair::new(handles[i], handles[j]))
            .collect()
    }
}

fn moved(start: Isometry<Real>, way: Vector<Real>) -> Isometry<Real> {
    Translation::from(way) * start
}

/// Whether two shapes that go straight from these poses along these ways meet at any time of the step.
///
/// Parry's shape casts tell, but some report pairs that pass each other at up to a hundredth of a length unit. So the distance is
/// looked at when they are said to meet. If there is some, it is looked at as often as need be from then on: they cannot meet
/// before one of them has gone that far.
fn meet(shapes: [(&dyn Shape, Flight); 2]) -> bool {
    let [(a, (start, way)), (b, (other_start, other_way))] = shapes;
    let distance = |time: Real| {
        let pose = moved(start, way * time);
        let other_pose = moved(other_start, other_way * time);
        let distance = query::distance(&pose, a, &other_pose, b);
        distance.expect("the shapes of the scenes are supported")
    };
    if distance(0.0) <= CONTACT || distance(1.0) <= CONTACT {
        return true;
    }
    let speed = (way - other_way).norm();
    if speed == 0.0 {
        return false;
    }
    let options = ShapeCastOptions {
        max_time_of_impact: 1.0,
        compute_impact_geometry_on_penetration: false,
        ..Default::default()
    };
    let hit = query::cast_shapes(&start, &way, a, &other_start, &other_way, b, options);
    let hit = hit.expect("the shapes of the scenes are supported");
    let Some(mut time) = hit.map(|hit| hit.time_of_impact) else {
        return false;
    };
    while time < 1.0 {
        let distance = distance(time);
        if distance <= CONTACT {
            return true;
        }
        // More than the spacing of numbers below 1, lest time stand still.
        time += (distance / speed).max(Real::EPSILON);
    }
    false
}

#[cfg(test)]
mod tests {
    use super::super::scenes::rapier::math::Isometry;
    use super::super::scenes::rapier::{parry::query, prelude::*};
    use super::{CONTACT, meet, moved};

    fn along(axis: usize, length: Real) -> Vector<Real> {
        let mut vector = Vector::zeros();
        vector[axis] = length;
        vector
    }

    fn cube(half: Real) -> SharedShape {
        SharedShape::new(Cuboid::new(Vector::repeat(half)))
    }

    #[test]
    fn what_flies_through_meets() {
        let (ball, wall) = (SharedShape::ball(0.15), cube(0.05));
        let meets = |from: Vector<Real>, way: Vector<Real>| {
            let bullet = (&*ball, (Isometry::from(from), way));
            let still = (&*wall, (Isometry::identity(), Vector::zeros()));
            let both = [meet([bullet, still]), meet([still, bullet])];
            assert_eq!(both[0], both[1]);
            both[0]
        };
        // Through it, short of it, past it, and away from it.
        assert!(meets(along(0, -1.5), along(0, 3.0)));
        assert!(!meets(along(0, -1.5), along(0, 1.2)));
        assert!(meets(along(0, -1.5), along(0, 1.4)));
        // It passes at a thousandth.
        assert!(!meets(along(0, -1.5) + along(1, 0.201), along(0, 3.0)));
        assert!(meets(along(0, -1.5) + along(1, 0.199), along(0, 3.0)));
        assert!(!meets(along(0, -1.5) + along(1, 0.25), along(0, 3.0)));
        assert!(!meets(along(0, -1.5), along(0, -3.0)));
        assert!(!meets(along(0, -1.5), Vector::zeros()));
        assert!(meets(along(0, -0.1), Vector::zeros()));
    }

    #[test]
    fn casts_agree_with_many_looks() {
        const LOOKS: usize = 2000;
        let mut random = oorandom::Rand32::new(9);
        let (ball, cube) = (SharedShape::ball(0.3), cube(0.4));
        let mut vector = |size: Real| Vector::from_fn(|_, _| (random.rand_float() - 0.5) * size);
        let mut met = 0;
        for _ in 0..60 {
            let (start, way) = (Isometry::from(vector(3.0)), vector(6.0));
            let (other, other_way) = (Isometry::from(vector(3.0)), vector(6.0));
            for shape in [&ball, &cube] {
                let looks = (0..=LOOKS).map(|look| {
                    let time = look as Real / LOOKS as Real;
                    let poses = [moved(start, way * time), moved(other, other_way * time)];
                    let distance = query::distance(&poses[0], &**shape, &poses[1], &*cube);
                    distance.expect("both are convex")
                });
                let nearest = looks.fold(Real::MAX, Real::min);
                let meets = meet([(&**shape, (start, way)), (&*cube, (other, other_way))]);
                met += usize::from(meets);
                // Between two looks they come nearer by less than this.
                assert!(if meets {
                    nearest < 0.01
                } else {
                    nearest > CONTACT
                });
            }
        }
        assert!((10..110).contains(&met));
    }
}
