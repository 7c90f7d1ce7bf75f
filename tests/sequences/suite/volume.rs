//! The bounding volumes that tell pairs apart, as the documentation of `PairFilter::Shapes` and of the library's `volume.rs`
//! has them: written again, with the same roundings.

use super::rapier::prelude::*;
use super::version;

type Array = [Real; DIM];

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Volume {
    pub(super) kind: Kind,
    /// A NaN if it meets all.
    center: Array,
    /// Except of a ball, loosened by what rounding may do.
    radius: Real,
    /// Half the axis of a capsule, the half axes of a cuboid, the normal of a half-space.
    halves: Vec<Array>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Box,
    Ball,
    Capsule,
    Cuboid,
    HalfSpace,
}

impl Volume {
    pub(super) fn meeting_all() -> Self {
        Self {
            kind: Kind::Box,
            center: [Real::NAN; DIM],
            radius: 0.0,
            halves: Vec::new(),
        }
    }

    /// The volume of a collider, extended by this distance.
    pub(super) fn of(collider: &Collider, extension: Real) -> Self {
        if !collider.active_hooks().is_empty() {
            return Self::meeting_all();
        }
        let distance = (collider.contact_skin() + extension).max(0.0);
        let (shape, pose) = (collider.shape(), collider.position());
        let turned = |vector| Array::from(pose.rotation * vector);
        let center = version::coordinates(collider);
        let cuboid = |center, half: Array| {
            let least = half.into_iter().fold(0.0, Real::max) * 1.0e-6;
            let halves = (0..DIM).map(|k| {
                let mut axis = [0.0; DIM];
                axis[k] = half[k].max(least);
                turned(axis.into())
            });
            Self {
                kind: Kind::Cuboid,
                center,
                radius: distance,
                halves: halves.collect(),
            }
        };
        let mut volume = if let Some(ball) = shape.as_ball() {
            Self {
                kind: Kind::Ball,
                center,
                radius: ball.radius + distance,
                halves: Vec::new(),
            }
        } else if let Some(capsule) = shape.as_capsule() {
            // All are centred.
            Self {
                kind: Kind::Capsule,
                center,
                radius: capsule.radius + distance,
                halves: vec![turned(version::arrow(capsule.segment.b))],
            }
        } else if let Some(shape) = shape.as_cuboid() {
            cuboid(center, shape.half_extents.into())
        } else if let Some(half_space) = shape.as_halfspace() {
            Self {
                kind: Kind::HalfSpace,
                center,
                radius: distance,
                halves: vec![turned(version::normal(half_space))],
            }
        } else {
            let local = shape.compute_local_aabb();
            let [mins, maxs] = [local.mins, local.maxs].map(version::arrow);
            let middle = version::origin(pose) + pose.rotation * ((mins + maxs) * 0.5);
            cuboid(middle.into(), ((maxs - mins) * 0.5).into())
        };
        if volume.kind != Kind::Ball {
            volume.radius = volume.loosened();
        }
        let off = (version::norm_squared(pose) - 1.0).abs();
        if off > 8.0 * Real::EPSILON {
            return Self::meeting_all();
        }
        let off = if volume.kind == Kind::Ball {
            8.0 * Real::EPSILON
        } else {
            off
        };
        if off > 0.0 {
            let size = volume.extent().iter().fold(0.0, |sum, x| sum + x) + volume.radius;
            volume.radius += size * (off + off);
        }
        volume
    }

    /// The sum of how much all numbers of two volumes of one kind differ. Half-spaces are equal or not.
    pub(super) fn difference(&self, other: &Self) -> Real {
        if self.kind == Kind::HalfSpace {
            return if self == other { 0.0 } else { Real::INFINITY };
        }
        let sum = |vector: Array| vector.iter().fold(0.0, |sum, x: &Real| sum + x.abs());
        let halves = self.halves.iter().zip(&other.halves);
        let halves = halves.fold([0.0; DIM], |change: Array, (&a, &b)| {
            std::array::from_fn(|k| change[k] + minus(b, a)[k].abs())
        });
        let radii = (other.radius - self.radius).abs();
        (sum(minus(other.center, self.center)) + radii) + sum(halves)
    }

    /// How far the segments reach along each axis of the world.
    fn extent(&self) -> Array {
        let halves = self.halves.iter();
        halves.fold([0.0; DIM], |extent: Array, half| {
            std::array::from_fn(|k| extent[k] + half[k].abs())
        })
    }

    /// Whether another volume is of another kind, or a ball of another size.
    pub(super) fn is_of_another_kind(&self, other: &Self) -> bool {
        self.kind != other.kind || self.kind == Kind::Ball && self.radius != other.radius
    }

    /// Meets all, until it is replaced.
    pub(super) fn forget_center(&mut self) {
        self.center = [Real::NAN; DIM];
    }

    /// A ball in the middle of this box, which meets all if the box is larger.
    pub(super) fn in_box(&self, aabb: &Aabb) -> Self {
        let [mins, maxs] = [Array::from(aabb.mins), Array::from(aabb.maxs)];
        let mut ball = self.clone();
        ball.center = std::array::from_fn(|k| (mins[k] + maxs[k]) * 0.5);
        let diameter = ball.loosened() * 2.0;
        if !(0..DIM).all(|k| maxs[k] - mins[k] <= diameter) {
            ball.center = [Real::NAN; DIM];
        }
        ball
    }

    /// The radius, and eight rounding errors of the sum of all numbers.
    fn loosened(&self) -> Real {
        let (center, extent) = (self.center, self.extent());
        let axes = 0..DIM;
        let sum = axes.fold(self.radius, |sum, k| sum + (center[k].abs() + extent[k]));
        self.radius + sum * (8.0 * Real::EPSILON)
    }

    /// The radius that tells it apart.
    fn reach(&self) -> Real {
        match self.kind {
            Kind::Ball => self.loosened(),
            _ => self.radius,
        }
    }

    /// How far the segments reach along an axis, times its length.
    fn segments(&self, axis: Array) -> Real {
        self.halves
            .iter()
            .fold(0.0, |sum, h| sum + dot(*h, axis).abs())
    }

    /// Whether there is no axis that tells two volumes apart, loosened by `slack` together.
    pub(super) fn meets(&self, other: &Self, slack: Real) -> bool {
        let between = minus(other.center, self.center);
        let reach = self.reach() + other.reach() + slack;
        let is_apart = |axis: Array| {
            let segments = self.segments(axis) + other.segments(axis);
            dot(between, axis).abs() > reach * dot(axis, axis).sqrt() + segments
        };
        let is_behind = |normal: Array, center: Array, volume: &Self| {
            dot(center, normal) > reach * dot(normal, normal).sqrt() + volume.segments(normal)
        };
        let is_apart_by_sides = |cuboid: &Self, other: &Self| {
            cuboid.kind == Kind::Cuboid
                && cuboid.halves.iter().any(|&axis| {
                    let squared = dot(axis, axis);
                    let reach = reach * squared.sqrt() + (squared + other.segments(axis));
                    dot(between, axis).abs() > reach
                })
        };
        let is_apart_in_world = || {
            (0..DIM).any(|k| {
                let halves = self.halves.iter().chain(&other.halves);
                between[k].abs() > halves.fold(reach, |sum, h| sum + h[k].abs())
            })
        };
        match (self.kind, other.kind) {
            (Kind::Box, _) | (_, Kind::Box) | (Kind::HalfSpace, Kind::HalfSpace) => true,
            (Kind::HalfSpace, _) => !is_behind(self.halves[0], between, other),
            (_, Kind::HalfSpace) => {
                !is_behind(other.halves[0], minus(self.center, other.center), self)
            }
            (Kind::Ball, Kind::Ball) => {
                let are_apart = dot(between, between) > reach * reach;
                !are_apart
            }
            (Kind::Cuboid, _) | (_, Kind::Cuboid) => {
                !(is_apart_in_world()
                    || is_apart_by_sides(self, other)
                    || is_apart_by_sides(other, self)
                    || is_apart(self.shortest_to_center(other))
                    || is_apart(other.shortest_to_center(self)))
            }
            _ => !(is_apart(between) || is_apart(self.shortest(other, between))),
        }
    }

    /// From the nearest point of its segments to the other's centre.
    fn shortest_to_center(&self, other: &Self) -> Array {
        let between = minus(other.center, self.center);
        self.halves.iter().fold(between, |shortest, &half| {
            let t = part(dot(between, half), dot(half, half));
            std::array::from_fn(|k| shortest[k] - t * half[k])
        })
    }

    /// From one core segment to the other, where they are nearest.
    fn shortest(&self, other: &Self, between: Array) -> Array {
        let core = |volume: &Self| volume.halves.first().copied().unwrap_or([0.0; DIM]);
        let (u, v) = (core(self), core(other));
        let [uu, uv, vv] = [dot(u, u), dot(u, v), dot(v, v)];
        let [ud, vd] = [dot(u, between), dot(v, between)];
        let s = part(ud * vv - vd * uv, uu * vv - uv * uv);
        let t = part(s * uv - vd, vv);
        let s = part(t * uv + ud, uu);
        std::array::from_fn(|k| between[k] + t * v[k] - s * u[k])
    }
}

fn part(numerator: Real, denominator: Real) -> Real {
    match denominator > 0.0 {
        true => (numerator / denominator).clamp(-1.0, 1.0),
        false => 0.0,
    }
}

fn minus(a: Array, b: Array) -> Array {
    std::array::from_fn(|k| a[k] - b[k])
}

fn dot(a: Array, b: Array) -> Real {
    (0..DIM).fold(0.0, |sum, k| sum + a[k] * b[k])
}
