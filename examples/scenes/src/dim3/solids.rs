//! How the colliders of a world in three dimensions are drawn.

use super::rapier::prelude::*;
use unisize_pictures::{Color, Drawing};

/// Draws a collider, if it is a ball, a capsule or a cuboid.
pub(super) fn draw(drawing: &mut Drawing, collider: &Collider, color: Color) {
    let position = collider.position();
    let place = |point: Point<Real>| (position * point).coords.into();
    let shape = collider.shape();
    if let Some(ball) = shape.as_ball() {
        drawing.sphere(place(Point::origin()), ball.radius, color);
    } else if let Some(capsule) = shape.as_capsule() {
        let ends = [capsule.segment.a, capsule.segment.b].map(place);
        drawing.capsule(ends, capsule.radius, color);
    } else if let Some(cuboid) = shape.as_cuboid() {
        let rotation = position.rotation.coords.into();
        drawing.cuboid(
            place(Point::origin()),
            cuboid.half_extents.into(),
            rotation,
            color,
        );
    }
}
