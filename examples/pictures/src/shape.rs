//! Bodies, and where rays meet them.
//!
//! A ray's direction has 1 as its third coordinate, so that the parameter of a point on it is its depth. Rays are
//! moved up to a body before they are cut with it: small bodies far away are as round as near ones.

use crate::Color;
use crate::raster::View;
use glam::{Mat3, Vec3};

/// A body of a [`Drawing`](crate::Drawing).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Its shape and place.
    pub solid: Solid,
    /// Its colour.
    pub color: Color,
    /// Whether it is a body in space; one in the plane has its colour as it is.
    pub is_lit: bool,
}

/// The shape and the place of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid {
    /// All within `radius` of a point.
    Sphere {
        /// The point.
        center: [f32; 3],
        /// The distance.
        radius: f32,
    },
    /// All within `radius` of the line between two points.
    Capsule {
        /// The points.
        ends: [[f32; 3]; 2],
        /// The distance.
        radius: f32,
    },
    /// A box, or a rectangle if the third of its edges has no length.
    Cuboid {
        /// Its middle.
        center: [f32; 3],
        /// Half of each of its edges.
        half_edges: [[f32; 3]; 3],
    },
    /// A disc in the plane of the first two axes.
    Disc {
        /// Its middle.
        center: [f32; 2],
        /// The distance from there to its rim.
        radius: f32,
    },
}

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

/// A body in the coordinates of a view.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shape {
    center: Vec3,
    /// Unit vectors; the second is that of a capsule's line.
    axes: Mat3,
    /// Half the edges of a box, or on the second axis half of a capsule's line.
    half: Vec3,
    /// Of what is round; 0 of a box.
    radius: f32,
    /// Whether it lies in the plane: it hides what came before it.
    pub(crate) is_flat: bool,
}

impl Shape {
    /// A figure as it is seen; `None` if it is not finite or has no size.
    pub(crate) fn seen(figure: &Figure, view: &View) -> Option<Self> {
        let round = |ends: [Vec3; 2], radius: f32| {
            let half = ends[0].distance(ends[1]) / 2.0;
            let axis = (ends[1] - ends[0]).try_normalize().unwrap_or(Vec3::Y);
            let axes = Mat3::from_cols(Vec3::ZERO, axis, Vec3::ZERO);
            (ends[0].midpoint(ends[1]), axes, Vec3::Y * half, radius)
        };
        let (center, axes, half, radius) = match figure.solid {
            Solid::Sphere { center, radius } => round([center.into(); 2], radius),
            Solid::Capsule { ends, radius } => round(ends.map(Vec3::from), radius),
            Solid::Disc {
                center: [x, y],
                radius,
            } => round([Vec3::new(x, y, 0.0); 2], radius),
            Solid::Cuboid { center, half_edges } => {
                let edges = half_edges.map(Vec3::from);
                let [x, y, z] = edges.map(Vec3::normalize_or_zero);
                let half = Vec3::from(edges.map(Vec3::length));
                // A rectangle has a normal all the same.
                let z = if z == Vec3::ZERO { x.cross(y) } else { z };
                (center.into(), Mat3::from_cols(x, y, z), half, 0.0)
            }
        };
        let is_sound = center.is_finite() && axes.is_finite() && half.is_finite();
        let has_size =
            radius > 0.0 && radius.is_finite() || radius == 0.0 && half.max_element() > 0.0;
        (is_sound && has_size).then(|| Self {
            center: view.point(center),
            axes: Mat3::from_cols(
                view.direction(axes.x_axis),
                view.direction(axes.y_axis),
                view.direction(axes.z_axis),
            ),
            half,
            radius,
            is_flat: !figure.is_lit,
        })
    }

    /// The lower and the upper bounds on each axis.
    pub(crate) fn extent(&self) -> (Vec3, Vec3) {
        let Self { axes, half, .. } = self;
        let reach =
            axes.x_axis.abs() * half.x + axes.y_axis.abs() * half.y + axes.z_axis.abs() * half.z;
        let reach = reach + self.radius;
        (self.center - reach, self.center + reach)
    }

    /// The depth at which a ray enters the body, if it does, and the unit vector away from the body there.
    #[inline]
    pub(crate) fn hit(&self, ray: &Ray) -> Option<(f32, Vec3)> {
        let from = ray.at(self.center.z) - self.center;
        let (way, normal) = if self.radius > 0.0 {
            self.hit_round(from, ray.direction)?
        } else {
            self.hit_box(from, ray.direction)?
        };
        Some((self.center.z + way, normal))
    }

    /// Around the origin: how far along the direction the capsule is entered, and the normal there.
    #[inline]
    fn hit_round(&self, from: Vec3, direction: Vec3) -> Option<(f32, Vec3)> {
        let (axis, half) = (self.axes.y_axis, self.half.y);
        if half == 0.0 {
            return hit_sphere(from, direction, self.radius);
        }
        // Across the axis, the capsule is a circle.
        let across = direction - axis * direction.dot(axis);
        let start = from - axis * from.dot(axis);
        let (way, normal) = hit_sphere(start, across, self.radius).unwrap_or((f32::NAN, axis));
        let along = (from + direction * way).dot(axis);
        if along.abs() <= half {
            return Some((way, normal));
        }
        // Past an end, or along the axis, where `along` is not a number.
        let end = if along.is_finite() {
            axis * half.copysign(along)
        } else {
            axis * -half.copysign(direction.dot(axis))
        };
        hit_sphere(from - end, direction, self.radius)
    }

    /// Around the origin: how far along the direction the box is entered, and the normal there.
    #[inline]
    fn hit_box(&self, from: Vec3, direction: Vec3) -> Option<(f32, Vec3)> {
        let turn = self.axes.transpose();
        let (from, direction) = (turn * from, turn * direction);
        let (mut enter, mut leave, mut face) = (f32::NEG_INFINITY, f32::INFINITY, 0);
        for axis in 0..3 {
            if direction[axis] == 0.0 {
                if from[axis].abs() > self.half[axis] {
                    return None;
                }
                continue;
            }
            let ahead = self.half[axis].copysign(direction[axis]);
            let near = (-ahead - from[axis]) / direction[axis];
            if near > enter {
                (enter, face) = (near, axis);
            }
            leave = leave.min((ahead - from[axis]) / direction[axis]);
        }
        let normal = self.axes.col(face) * -direction[face].signum();
        (enter <= leave).then_some((enter, normal))
    }
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
