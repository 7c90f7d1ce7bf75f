//! A cache of a collider's shape, so that its box can be computed without reading the shape.
//!
//! A collider only points to its shape. Following that pointer, and finding out which kind of shape it points to, costs more than the rest of
//! reading a collider. So the table keeps the few numbers that determine the box of a simple shape, together with shared ownership of the
//! shape. A shared shape cannot be changed in place ([`SharedShape::make_mut`] copies it first), so the numbers are valid as long as the
//! collider points to the same shape.

use std::sync::Arc;

use super::rapier::geometry::{ActiveCollisionTypes, Collider, ShapeType, SharedShape};
use super::rapier::math::{DIM, Real};
use super::version::{self, Vector};
use crate::aabb::Aabb;
use crate::volume::{MOST_OFF_UNIT, Volume, VolumeKind};

/// The cache of one collider; empty until it is first read.
#[derive(Clone, Default)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct Outline {
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    known: Option<(SharedShape, Profile)>,
    /// The properties at the last reading.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    unrecorded: Option<UnrecordedProperties>,
    /// The kind of the volume, if it is a box whatever the shape is: as of the last reading, because bodies are scattered in memory.
    pub(super) without_volume: Option<VolumeKind>,
}

/// The properties of a collider that affect its pairs, and that a program can change without Rapier recording what has changed; and
/// whether it is a sensor. The shape and the [key](super::collider_key::ColliderKey) have the others.
type UnrecordedProperties = (Real, ActiveCollisionTypes, bool, bool);

#[inline(always)]
fn unrecorded(collider: &Collider) -> UnrecordedProperties {
    (
        collider.contact_skin(),
        collider.active_collision_types(),
        !collider.active_hooks().is_empty(),
        collider.is_sensor(),
    )
}

/// The numbers of a simple shape: a ball, a cuboid, or a capsule centered at its origin.
#[derive(Clone, Copy)]
struct Profile {
    /// One end of a capsule's axis, or the half extents of a cuboid; zero for a ball.
    extent: Vector,
    /// Negative for a cuboid.
    radius: Real,
}

impl Profile {
    fn of(shape: &SharedShape) -> Option<Self> {
        let round = |extent, radius: Real| (radius >= 0.0).then_some(Self { extent, radius });
        if let Some(ball) = shape.as_ball() {
            return round(Vector::default(), ball.radius);
        }
        if let Some(cuboid) = shape.as_cuboid() {
            return Some(Self {
                extent: cuboid.half_extents,
                radius: -1.0,
            });
        }
        let capsule = shape.as_capsule()?;
        let [start, end] = [capsule.segment.a, capsule.segment.b].map(coordinates);
        let is_centered = start == -end && end != Vector::default();
        is_centered.then(|| round(end, capsule.radius)).flatten()
    }

    fn is_cuboid(self) -> bool {
        self.radius < 0.0
    }

    fn is_ball(self) -> bool {
        !self.is_cuboid() && self.extent == Vector::default()
    }
}

impl Outline {
    /// The box of this collider if its shape is simple: bit for bit that of [`Collider::compute_aabb`].
    #[inline(always)]
    pub(super) fn aabb(&self, collider: &Collider) -> Option<Aabb<Real, DIM>> {
        let profile = self.profile(collider.shared_shape())?;
        // These are Parry's operations in Parry's order.
        let pose = collider.position();
        let center = version::origin(pose);
        let Profile { extent, radius } = profile;
        Some(if profile.is_cuboid() {
            around(center, version::rotated_extent(pose, &extent))
        } else if profile.is_ball() {
            Aabb::new(center.into(), center.into()).loosened(radius)
        } else {
            around(center, (pose.rotation * extent).abs()).loosened(radius)
        })
    }

    /// The bounding volume of this collider, loosened by this distance.
    #[inline(always)]
    pub(super) fn volume(&self, collider: &Collider, distance: Real) -> Volume<Real, DIM> {
        let (shape, pose) = (collider.shared_shape(), collider.position());
        let Some(off) = off_unit(version::norm_squared(pose)) else {
            return Volume::BOX;
        };
        let Some(profile) = self.profile(shape) else {
            return unusual_volume(shape, pose, distance).stretched(off);
        };
        let center = version::origin(pose).into();
        let Profile { extent, radius } = profile;
        if profile.is_ball() {
            // A ball follows its box, which does not show how the rotation changes.
            return Volume::new(VolumeKind::Ball, center, radius + distance, &[])
                .stretched(MOST_OFF_UNIT as Real * Real::EPSILON);
        }
        let volume = if profile.is_cuboid() {
            let halves = turned_halves(pose, extent);
            Volume::new(VolumeKind::Cuboid, center, distance, &halves)
        } else {
            let half = (pose.rotation * extent).into();
            Volume::new(VolumeKind::Capsule, center, radius + distance, &[half])
        };
        volume.stretched(off)
    }

    /// Whether anything but the pose and the key of a collider may have changed since it was noted.
    #[inline(always)]
    pub(super) fn has_changed(&self, collider: &Collider) -> bool {
        let shape = collider.shared_shape();
        let is_another = |(known, _): &(SharedShape, _)| !Arc::ptr_eq(&known.0, &shape.0);
        self.unrecorded != Some(unrecorded(collider)) || self.known.as_ref().is_some_and(is_another)
    }

    /// Notes the properties of a collider. Returns whether anything but its pose and its key may have changed.
    #[inline(always)]
    pub(super) fn note(&mut self, collider: &Collider) -> bool {
        let former = self.unrecorded.replace(unrecorded(collider));
        let shape = collider.shared_shape();
        let is_known = self.known(shape).is_some() || self.learn(shape);
        former != self.unrecorded || !is_known
    }

    /// The profile of a shape, if it is simple.
    #[inline(always)]
    fn profile(&self, shape: &SharedShape) -> Option<Profile> {
        self.known(shape).or_else(|| Profile::of(shape))
    }

    /// The same, if it is cached.
    #[inline(always)]
    fn known(&self, shape: &SharedShape) -> Option<Profile> {
        let (known, profile) = self.known.as_ref()?;
        Arc::ptr_eq(&known.0, &shape.0).then_some(*profile)
    }

    /// Caches a shape if it is simple. Returns false: it was not known.
    #[cold]
    fn learn(&mut self, shape: &SharedShape) -> bool {
        let profile = Profile::of(shape);
        self.known = profile.map(|profile| (shape.clone(), profile));
        false
    }
}

/// The vector from the origin to a point. In Rapier 0.36, points are vectors.
fn coordinates(point: impl Into<[Real; DIM]>) -> Vector {
    Vector::from(point.into())
}

/// How much the norm squared of a rotation or a normal is off from 1; `None` if it is not of unit length. Rapier keeps such a rotation as it is,
/// and Parry's shapes grow or shrink by it, each algorithm in its own way.
#[inline(always)]
pub(super) fn off_unit(norm_squared: Real) -> Option<Real> {
    let off = (norm_squared - 1.0).abs();
    (off <= MOST_OFF_UNIT as Real * Real::EPSILON).then_some(off)
}

/// The volume of any other shape, loosened by this distance.
#[inline(never)]
fn unusual_volume(shape: &SharedShape, pose: &version::Pose, distance: Real) -> Volume<Real, DIM> {
    let origin = version::origin(pose);
    let turned = |vector: Vector| pose.rotation * vector;
    if let Some(capsule) = shape.as_capsule() {
        let [start, end] = [capsule.segment.a, capsule.segment.b].map(coordinates);
        let center = origin + turned((start + end) * 0.5);
        let half = turned((end - start) * 0.5).into();
        let radius = capsule.radius + distance;
        return Volume::new(VolumeKind::Capsule, center.into(), radius, &[half]);
    }
    if let Some(half_space) = shape.as_halfspace() {
        let normal = version::normal(half_space);
        if off_unit(<[Real; DIM]>::from(normal).iter().map(|x| x * x).sum()).is_none() {
            return Volume::BOX;
        }
        let normal = turned(normal).into();
        return Volume::new(VolumeKind::HalfSpace, origin.into(), distance, &[normal]);
    }
    let parts = shape.as_compound().map_or(&[][..], |it| it.shapes());
    let mut offs = parts
        .iter()
        .map(|(pose, _)| off_unit(version::norm_squared(pose)));
    let Some(off) = offs.try_fold(0.0, |most: Real, off| Some(most.max(off?))) else {
        return Volume::BOX;
    };
    let (center, half_extents, radius) = match (shape.as_round_cuboid(), shape.shape_type()) {
        (Some(cuboid), _) => {
            let half_extents = cuboid.inner_shape.half_extents;
            (origin, half_extents, cuboid.border_radius + distance)
        }
        (_, ShapeType::TriMesh | ShapeType::Polyline | ShapeType::HeightField)
        | (_, ShapeType::Voxels | ShapeType::Custom) => return Volume::BOX,
        _ => {
            let aabb = shape.compute_local_aabb();
            let [mins, maxs] = [aabb.mins, aabb.maxs].map(coordinates);
            (
                origin + turned((mins + maxs) * 0.5),
                (maxs - mins) * 0.5,
                distance,
            )
        }
    };
    let halves = turned_halves(pose, half_extents);
    Volume::new(VolumeKind::Cuboid, center.into(), radius, &halves).stretched(off)
}

/// The half axes of a rotated box with these half extents. A flat box gets a small extent instead of zero, because every half axis is a
/// candidate for a separating axis.
#[inline(always)]
fn turned_halves(pose: &version::Pose, half_extents: Vector) -> [[Real; DIM]; DIM] {
    let halves: [Real; DIM] = half_extents.into();
    let least = halves.into_iter().fold(0.0, Real::max) * FLATTEST;
    // Not `from_fn`: the compiler leaves that closure a function, and what it stores number by number is then loaded as vectors, which stalls.
    let mut turned = [[0.0; DIM]; DIM];
    for (k, turned) in turned.iter_mut().enumerate() {
        let mut half = [0.0; DIM];
        half[k] = halves[k].max(least);
        *turned = (pose.rotation * Vector::from(half)).into();
    }
    turned
}

/// The minimum ratio of a half extent of a volume to the largest one.
const FLATTEST: Real = 1.0e-6;

/// The box with this center and these half extents.
#[inline(always)]
fn around(center: Vector, half_extents: Vector) -> Aabb<Real, DIM> {
    Aabb::new(
        (center - half_extents).into(),
        (center + half_extents).into(),
    )
}
