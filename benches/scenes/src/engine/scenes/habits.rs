//! Habits of games: at every step a game touches all colliders, and changes little or nothing about them.

use super::*;

/// The largest radius of a ball.
const RADIUS: Real = 0.5;
/// How far a body may be off its place along each axis.
const OFFSET: Real = 0.04;

/// Sleeping balls, of which a loop over all colliders asks for the right to change them.
pub(super) fn build_touched(bodies: usize, random: &mut Random) -> Stage {
    let (stage, _) = balls(bodies, |ball| ball.sleeping(true), random);
    stage.with_script(|world: &mut World, _: &mut Cue| {
        for (_, collider) in world.colliders.iter_mut() {
            core::hint::black_box(collider);
        }
    })
}

/// Balls whose radius changes at every step, so that they push each other away.
pub(super) fn build_breathing(bodies: usize, random: &mut Random) -> Stage {
    let (stage, balls) = balls(bodies, |ball| ball.linear_damping(10.0), random);
    stage.with_script(move |world: &mut World, cue: &mut Cue| {
        for (index, &ball) in balls.iter().enumerate() {
            let breath = sine((cue.step + index) as Real / 5.0);
            let shape = SharedShape::ball(RADIUS * (0.9 + 0.1 * breath));
            let collider = world.bodies[ball].colliders()[0];
            world.colliders[collider].set_shape(shape);
        }
    })
}

/// Fixed boxes in a plate, and a sleeping ball among a hundred, each with a position that is set to what it is at every step.
pub(super) fn build_restated(bodies: usize, random: &mut Random) -> Stage {
    let columns = match DIM {
        2 => (bodies as Real).sqrt(),
        _ => (bodies as Real / 4.0).sqrt(),
    };
    // Boxes overlap those beside them.
    let lattice = Lattice::with_columns(bodies, 0.9 * 2.0 * RADIUS, columns.ceil() as usize);
    let mut world = floating();
    let boxes: Vec<_> = (0..bodies)
        .map(|index| {
            let place = place(&lattice, index, random);
            if index % 100 == 50 {
                let ball = RigidBodyBuilder::dynamic()
                    .translation(place)
                    .sleeping(true);
                return world.insert(ball, ColliderBuilder::ball(RADIUS));
            }
            world.insert(RigidBodyBuilder::fixed().translation(place), cube(RADIUS))
        })
        .collect();
    Stage::new(world, container_of(&lattice)).with_script(move |world: &mut World, _: &mut Cue| {
        for &handle in &boxes {
            let body = &mut world.bodies[handle];
            body.set_position(*body.position(), false);
        }
    })
}

/// Floating balls, of which many touch.
fn balls(
    bodies: usize,
    with: impl Fn(RigidBodyBuilder) -> RigidBodyBuilder,
    random: &mut Random,
) -> (Stage, Vec<RigidBodyHandle>) {
    let lattice = Lattice::heap(bodies, 2.0 * RADIUS, 1.0);
    let mut world = floating();
    let balls = (0..bodies)
        .map(|index| {
            let place = place(&lattice, index, random);
            let ball = with(RigidBodyBuilder::dynamic().translation(place));
            world.insert(ball, ColliderBuilder::ball(RADIUS))
        })
        .collect();
    (Stage::new(world, container_of(&lattice)), balls)
}

fn place(lattice: &Lattice, index: usize, random: &mut Random) -> Vector {
    lattice.center(index) + jitter(random, OFFSET)
}

/// Where the bodies of a lattice stay.
fn container_of(lattice: &Lattice) -> Container {
    Container::standing(lattice.half_width(), lattice.height())
}
