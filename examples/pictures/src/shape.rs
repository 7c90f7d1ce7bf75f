//! Bodies in the coordinates of a view, and where rays meet them.
//!
//! A ray's direction has 1 as its third coordinate, so that the parameter of a point on it is its depth. Rays are
//! moved up to a body before they are cut with it: small bodies far away are as round as near ones.

use glam::{Mat3, Vec3};

/// A ray into the depth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray {
    /// In the plane of depth 0.
    pub(crate) origin: Vec3,
    /// With 1 as its third coordinate.
    pub(crate) direction: Vec3,
}

impl Ray {
    pub(crate) fn at(&self, depth: f32) -> Vec3 {
        self.origin + self.direction * depth
    }
}

/// Where a ray enters a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    pub(crate) depth: f32,
    /// The unit vector away from the body.
    pub(crate) normal: Vec3,
}

/// The lower and upper bounds of a body on each axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    pub(crate) lo: Vec3,
    pub(crate) hi: Vec3,
}

/// A body.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    Sphere {
        center: Vec3,
        radius: f32,
    },
    /// The points within `radius` of a line of this half length and direction.
    Capsule {
        center: Vec3,
        axis: Vec3,
        half: f32,
        radius: f32,
    },
    /// The columns of `axes` are unit vectors.
    Cuboid {
        center: Vec3,
        axes: Mat3,
        half: Vec3,
    },
    /// A disc across a normal.
    Disc {
        center: Vec3,
        normal: Vec3,
        radius: f32,
    },
}

impl Shape {
    /// The same shape, with its points mapped by a motion: `point` for places, `direction` for directions.
    pub(crate) fn moved(
        self,
        point: impl Fn(Vec3) -> Vec3,
        direction: impl Fn(Vec3) -> Vec3,
    ) -> Self {
        match self {
            Self::Sphere { center, radius } => Self::Sphere {
                center: point(center),
                radius,
            },
            Self::Capsule {
                center,
                axis,
                half,
                radius,
            } => Self::Capsule {
                center: point(center),
                axis: direction(axis),
                half,
                radius,
            },
            Self::Cuboid { center, axes, half } => Self::Cuboid {
                center: point(center),
                axes: Mat3::from_cols(
                    direction(axes.x_axis),
                    direction(axes.y_axis),
                    direction(axes.z_axis),
                ),
                half,
            },
            Self::Disc {
                center,
                normal,
                radius,
            } => Self::Disc {
                center: point(center),
                normal: direction(normal),
                radius,
            },
        }
    }

    /// Whether it has a place and a size.
    pub(crate) fn is_sound(&self) -> bool {
        match *self {
            Self::Sphere { center, radius } => center.is_finite() && is_size(radius),
            Self::Capsule {
                center,
                axis,
                half,
                radius,
            } => {
                center.is_finite()
                    && axis.is_finite()
                    && half >= 0.0
                    && half.is_finite()
                    && is_size(radius)
            }
            Self::Cuboid { center, axes, half } => {
                center.is_finite()
                    && axes.is_finite()
                    && half.is_finite()
                    && half.min_element() >= 0.0
                    && half.max_element() > 0.0
            }
            Self::Disc { center, radius, .. } => center.is_finite() && is_size(radius),
        }
    }

    pub(crate) fn extent(&self) -> Extent {
        let (center, reach) = match *self {
            Self::Sphere { center, radius } => (center, Vec3::splat(radius)),
            Self::Capsule {
                center,
                axis,
                half,
                radius,
            } => (center, axis.abs() * half + Vec3::splat(radius)),
            Self::Cuboid { center, axes, half } => (
                center,
                axes.x_axis.abs() * half.x
                    + axes.y_axis.abs() * half.y
                    + axes.z_axis.abs() * half.z,
            ),
            Self::Disc {
                center,
                normal,
                radius,
            } => {
                let across = (Vec3::ONE - normal * normal).max(Vec3::ZERO);
                (
                    center,
                    Vec3::from(across.to_array().map(f32::sqrt)) * radius,
                )
            }
        };
        Extent {
            lo: center - reach,
            hi: center + reach,
        }
    }

    /// Where a ray enters the body, if it does.
    #[inline]
    pub(crate) fn hit(&self, ray: &Ray) -> Option<Hit> {
        let center = match *self {
            Self::Sphere { center, .. }
            | Self::Capsule { center, .. }
            | Self::Cuboid { center, .. }
            | Self::Disc { center, .. } => center,
        };
        let from = ray.at(center.z) - center;
        let (way, normal) = match *self {
            Self::Sphere { radius, .. } => hit_sphere(from, ray.direction, radius)?,
            Self::Capsule {
                axis, half, radius, ..
            } => hit_capsule(from, ray.direction, axis, half, radius)?,
            Self::Cuboid { axes, half, .. } => hit_cuboid(from, ray.direction, &axes, half)?,
            Self::Disc { normal, radius, .. } => hit_disc(from, ray.direction, normal, radius)?,
        };
        Some(Hit {
            depth: center.z + way,
            normal,
        })
    }
}

fn is_size(size: f32) -> bool {
    size > 0.0 && size.is_finite()
}

/// Around the origin: how far along the direction the sphere is entered, and the normal there.
#[inline]
fn hit_sphere(from: Vec3, direction: Vec3, radius: f32) -> Option<(f32, Vec3)> {
    let square = direction.length_squared();
    let nearest = -from.dot(direction) / square;
    let rest = radius * radius - (from + direction * nearest).length_squared();
    // NaN is no hit either.
    if rest >= 0.0 {
        let way = nearest - (rest / square).sqrt();
        Some((way, (from + direction * way) / radius))
    } else {
        None
    }
}

/// Around the origin: how far along the direction the capsule is entered, and the normal there.
#[inline]
fn hit_capsule(
    from: Vec3,
    direction: Vec3,
    axis: Vec3,
    half: f32,
    radius: f32,
) -> Option<(f32, Vec3)> {
    // Across the axis, the capsule is a circle.
    let across = direction - axis * direction.dot(axis);
    let start = from - axis * from.dot(axis);
    let square = across.length_squared();
    let nearest = -start.dot(across) / square;
    let rest = radius * radius - (start + across * nearest).length_squared();
    if rest < 0.0 {
        return None;
    }
    let way = nearest - (rest / square).sqrt();
    let along = (from + direction * way).dot(axis);
    if along.abs() <= half {
        let normal = (start + across * way) / radius;
        return Some((way, normal));
    }
    // Past an end, or along the axis, where `along` is not a number.
    let end = if along.is_finite() {
        axis * half.copysign(along)
    } else {
        axis * -half.copysign(direction.dot(axis))
    };
    let (way, normal) = hit_sphere(from - end, direction, radius)?;
    Some((way, normal))
}

/// Around the origin: how far along the direction the cuboid is entered, and the normal there.
#[inline]
fn hit_cuboid(from: Vec3, direction: Vec3, axes: &Mat3, half: Vec3) -> Option<(f32, Vec3)> {
    let turn = |vector: Vec3| {
        Vec3::new(
            axes.x_axis.dot(vector),
            axes.y_axis.dot(vector),
            axes.z_axis.dot(vector),
        )
    };
    let (from, direction) = (turn(from), turn(direction));
    let (mut enter, mut leave, mut face) = (f32::NEG_INFINITY, f32::INFINITY, 0);
    for axis in 0..3 {
        if direction[axis] == 0.0 {
            if from[axis].abs() > half[axis] {
                return None;
            }
            continue;
        }
        let (near, far) = (
            (-half[axis].copysign(direction[axis]) - from[axis]) / direction[axis],
            (half[axis].copysign(direction[axis]) - from[axis]) / direction[axis],
        );
        if near > enter {
            (enter, face) = (near, axis);
        }
        leave = leave.min(far);
    }
    if enter <= leave {
        let normal = axes.col(face) * -direction[face].signum();
        Some((enter, normal))
    } else {
        None
    }
}

/// Around the origin: how far along the direction the disc is met, and the normal there.
#[inline]
fn hit_disc(from: Vec3, direction: Vec3, normal: Vec3, radius: f32) -> Option<(f32, Vec3)> {
    let facing = normal.dot(direction);
    let way = -normal.dot(from) / facing;
    let distance = (from + direction * way).length_squared();
    (distance <= radius * radius).then(|| (way, normal * -facing.signum()))
}

#[cfg(test)]
mod tests {
    use super::{Ray, Shape};
    use glam::{Mat3, Vec3};

    /// Cuts a body with rays from many sides, and checks depths by small steps along each ray.
    fn check(shape: Shape, is_inside: impl Fn(Vec3) -> bool) {
        let mut hits = 0;
        for x in -8..=8 {
            for y in -8..=8 {
                let direction = Vec3::new(x as f32 * 0.035, y as f32 * 0.035, 1.0);
                let ray = Ray {
                    origin: Vec3::ZERO,
                    direction,
                };
                let walked = (0..4000)
                    .map(|step| step as f32 * 0.005)
                    .find(|&depth| is_inside(ray.at(depth)));
                match (shape.hit(&ray), walked) {
                    (Some(hit), Some(depth)) => {
                        hits += 1;
                        assert!((hit.depth - depth).abs() < 0.01, "{hit:?} {depth}");
                        assert!((hit.normal.length() - 1.0).abs() < 1e-4);
                        assert!(hit.normal.dot(direction) <= 1e-4, "{hit:?}");
                    }
                    (None, None) => {}
                    // A ray may graze the body between two steps.
                    (Some(hit), None) => assert!(hit.normal.dot(direction).abs() < 0.35, "{hit:?}"),
                    (None, Some(depth)) => panic!("the body at depth {depth} is missed"),
                }
            }
        }
        assert!(hits > 20, "{hits} hits");
    }

    #[test]
    fn rays_meet_bodies_where_they_are() {
        let center = Vec3::new(0.5, -0.3, 8.0);
        check(
            Shape::Sphere {
                center,
                radius: 1.5,
            },
            |point| point.distance(center) <= 1.5,
        );
        for axis in [Vec3::X, Vec3::Z, Vec3::new(1.0, 2.0, -2.0) / 3.0] {
            check(
                Shape::Capsule {
                    center,
                    axis,
                    half: 1.2,
                    radius: 0.8,
                },
                |point| {
                    let along = (point - center).dot(axis).clamp(-1.2, 1.2);
                    point.distance(center + axis * along) <= 0.8
                },
            );
        }
        let half = Vec3::new(1.5, 0.7, 1.0);
        for axes in [
            Mat3::IDENTITY,
            Mat3::from_axis_angle(Vec3::ONE.normalize(), 0.7),
        ] {
            check(Shape::Cuboid { center, axes, half }, |point| {
                (axes.transpose() * (point - center))
                    .abs()
                    .cmple(half)
                    .all()
            });
        }
    }

    #[test]
    fn extents_hold_their_bodies() {
        let center = Vec3::new(1.0, 2.0, 3.0);
        let axes = Mat3::from_axis_angle(Vec3::Z, std::f32::consts::FRAC_PI_2);
        let half = Vec3::new(3.0, 1.0, 2.0);
        let extent = Shape::Cuboid { center, axes, half }.extent();
        assert!(extent.hi.distance(center + Vec3::new(1.0, 3.0, 2.0)) < 1e-5);
        assert!(extent.lo.distance(center - Vec3::new(1.0, 3.0, 2.0)) < 1e-5);
    }

    #[test]
    fn unsound_bodies_are_told() {
        let sphere = |x: f32, radius: f32| Shape::Sphere {
            center: Vec3::splat(x),
            radius,
        };
        assert!(sphere(1e30, 1.0).is_sound());
        assert!(!sphere(f32::NAN, 1.0).is_sound());
        assert!(!sphere(f32::INFINITY, 1.0).is_sound());
        for radius in [0.0, -1.0, f32::NAN, f32::INFINITY] {
            assert!(!sphere(0.0, radius).is_sound());
        }
    }
}
