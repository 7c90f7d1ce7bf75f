//! Pendulums: single balls that swing so little that the cosine tells where they are, and chains of four that should keep
//! their energy. They never touch each other, so that a broad phase can do no wrong here.

use super::{
    Case, ColliderBuilder, GRAVITY, INERTIA_OF_BALL, Jitter, PIN, Place, Stage, UP, World, along,
    falling, gauge, place, plus, vector,
};
use super::{GenericJointBuilder, RigidBodyBuilder, RigidBodyHandle};

/// The length of a link and the radius of a ball.
const LINK: f64 = 1.0;
const RADIUS: f64 = 0.2;

/// The distance of two pendulums.
const SPACING: f64 = 6.0;

/// The links of a chain.
const LINKS: usize = 4;

/// The angle at which a single one starts, in radians. Its period is longer than that of the cosine by a sixteenth of its
/// square.
const SMALL: f64 = 0.02;

/// The angle at which a chain starts, in radians.
const LARGE: f64 = 0.5;

/// How far an angle may be off, as a part of it.
const JITTER: f64 = 0.05;

/// How fast a single one swings, in radians a second: a body that turns about a point beside it.
pub(crate) fn frequency() -> f64 {
    let inertia = INERTIA_OF_BALL * RADIUS * RADIUS;
    (GRAVITY * LINK / (inertia + LINK * LINK)).sqrt()
}

/// A pendulum of so many links at this angle, with its balls from the top down.
fn hang(world: &mut World, hook: Place, links: usize, angle: f64) -> Vec<RigidBodyHandle> {
    let link = plus(along(0, LINK * angle.sin()), along(UP, -LINK * angle.cos()));
    let fixed = RigidBodyBuilder::fixed().translation(vector(hook));
    let mut previous = world.bodies.insert(fixed);
    let mut balls = Vec::new();
    for index in 1..=links {
        let center = place(|axis| hook[axis] + index as f64 * link[axis]);
        // So slow a swing would be put to sleep.
        let body = RigidBodyBuilder::dynamic()
            .can_sleep(false)
            .translation(vector(center));
        let ball = world.insert(body, ColliderBuilder::ball(RADIUS as _));
        let up = vector(place(|axis| -link[axis]));
        let pin = GenericJointBuilder::new(PIN)
            .local_anchor1(vector(place(|_| 0.0)).into())
            .local_anchor2(up.into());
        world.impulse_joints.insert(previous, ball, pin, true);
        balls.push(ball);
        previous = ball;
    }
    balls
}

pub(super) fn build(case: &Case, jitter: &mut Jitter) -> Stage {
    let mut world = falling();
    // As many single ones as chains.
    let pairs = case.bodies.div_ceil(LINKS + 1);
    let mut followed = Vec::new();
    let mut put_in = 0.0;
    for index in 0..pairs {
        let hook = |row: f64| plus(along(0, index as f64 * SPACING), along(UP, row * SPACING));
        let angle = SMALL * (1.0 + jitter.by(JITTER));
        let single = hang(&mut world, hook(2.0), 1, angle);
        let (middle, swing) = (hook(2.0)[0], LINK * angle.sin());
        followed.push(gauge::Followed {
            body: single[0],
            course: Box::new(move |time| middle + swing * (frequency() * time).cos()),
        });

        let angle = LARGE * (1.0 + jitter.by(JITTER));
        for (link, ball) in (1..).zip(hang(&mut world, hook(1.0), LINKS, angle)) {
            let height = f64::from(link) * LINK * (1.0 - angle.cos());
            put_in += f64::from(world.bodies[ball].mass()) * GRAVITY * height;
        }
    }
    let energy = gauge::energy_changed(&world, put_in);
    Stage::new(world)
        .with(energy)
        .with(gauge::course(followed, LINK * SMALL))
        .with(gauge::stretch(LINK))
}
