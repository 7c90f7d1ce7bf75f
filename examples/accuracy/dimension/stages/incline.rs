//! An incline: balls roll down without slipping, with g sin α / (1 + k), where k is the moment of inertia over m r²:
//! 1/2 for a disc, 2/5 for a ball. The floor is level, and gravity is tilted instead.

use super::{
    Case, ColliderBuilder, Course, DIM, Followed, GRAVITY, Jitter, Penetration, Stage, UP, World,
    horizontal, insert, insert_floor, place, vector,
};

/// The radius of a ball.
const RADIUS: f64 = 0.5;

/// The distance of two balls.
const SPACING: f64 = 2.0;

/// How far a ball may be off its place along the incline.
const JITTER: f64 = 0.1;

/// The slope, in radians.
const SLOPE: f64 = 0.3;

/// Enough to roll: tan α k / (1 + k) is a tenth.
const FRICTION: f64 = 0.8;

/// The acceleration of a ball that rolls.
pub(crate) fn acceleration() -> f64 {
    let inertia = if DIM == 2 { 0.5 } else { 0.4 };
    GRAVITY * SLOPE.sin() / (1.0 + inertia)
}

pub(super) fn build(case: &Case, jitter: &mut Jitter) -> Stage {
    let gravity = place(|axis| match axis {
        0 => GRAVITY * SLOPE.sin(),
        UP => -GRAVITY * SLOPE.cos(),
        _ => 0.0,
    });
    let mut world = World::new(vector(gravity));
    let columns = match DIM {
        2 => case.bodies,
        _ => (case.bodies as f64).sqrt().ceil() as usize,
    };
    let way = acceleration() * case.seconds * case.seconds / 2.0;
    let half_width = columns as f64 * SPACING + way;
    let friction = |collider: ColliderBuilder| collider.friction(FRICTION as _);
    insert_floor(&mut world, half_width, friction);
    let mut followed = Vec::new();
    for index in 0..case.bodies {
        let mut center = place(|_| RADIUS);
        for (axis, cell) in horizontal().zip([index % columns, index / columns]) {
            center[axis] = (cell as f64 - (columns - 1) as f64 / 2.0) * SPACING;
        }
        center[0] += jitter.by(JITTER);
        let ball = friction(ColliderBuilder::ball(RADIUS as _));
        let body = insert(&mut world, center, ball);
        let course = move |time: f64| center[0] + acceleration() * time * time / 2.0;
        followed.push(Followed {
            body,
            course: Box::new(course),
        });
    }
    Stage::new(world)
        .with(Course::new(followed, way))
        .with(Penetration::new(2.0 * RADIUS, 0.0))
}
