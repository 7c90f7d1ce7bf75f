//! A crowd: walkers of one size, each steering to a goal and bumping into others. In 2D it is seen from above; in 3D gravity keeps
//! the walkers on the ground.

use super::*;

/// Half the width of a walker.
const HALF_WIDTH: Real = 0.3;
/// Half the height of a walker.
const HALF_HEIGHT: Real = 0.6;
/// The distance between walkers at the start.
const SPACING: Real = 2.5;
/// The speed at which walkers like to walk.
const SPEED: Real = 2.0;
/// The share of the difference to the wanted velocity that a walker makes up for in a step.
const EAGERNESS: Real = 0.2;
/// The speed below which a walker counts as stuck, and steps to its right.
const STUCK: Real = 0.5 * SPEED;
/// The distance at which a goal counts as reached.
const REACHED: Real = 1.5;

/// A place on the plane.
fn somewhere(half_width: Real, random: &mut Random) -> Vector {
    planar(vector(|_| random.range(-half_width, half_width)))
}

/// A vector in the plane, turned to the right by most of a right angle.
///
/// Without it, walkers that meet head-on push each other forever, and the crowd becomes one jam.
fn aside(way: Vector) -> Vector {
    let [first, second] = flavour::PLANE;
    let (sine, cosine) = (sine(1.2), cosine(1.2));
    let mut turned = Vector::default();
    turned[first] = cosine * way[first] + sine * way[second];
    turned[second] = cosine * way[second] - sine * way[first];
    turned
}

/// The part of a vector that is in the plane.
fn planar(full: Vector) -> Vector {
    let mut planar = Vector::default();
    for axis in flavour::PLANE {
        planar[axis] = full[axis];
    }
    planar
}

/// The half extents of a box with this half width in the plane, and as high as a walker.
fn flat(half_width: Real) -> Vector {
    let mut half = vector(|_| HALF_HEIGHT);
    for axis in flavour::PLANE {
        half[axis] = half_width;
    }
    half
}

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let side = ((bodies as Real).sqrt().ceil() as usize).max(1);
    let half_width = side as Real * SPACING / 2.0;
    let container = Container {
        lo: -flat(half_width),
        hi: flat(half_width),
    };
    let slippery = |builder: ColliderBuilder| builder.friction(0.0).build();
    let mut world = if DIM == 2 { floating() } else { falling() };
    container.wall_in(&mut world, flavour::PLANE.contains(&UP), slippery);

    let mut walkers: Vec<_> = (0..bodies)
        .map(|index| {
            let mut place = Vector::default();
            for (axis, cell) in flavour::PLANE.into_iter().zip([index % side, index / side]) {
                let jitter = random.range(-0.3, 0.3);
                place[axis] = (cell as Real + 0.5) * SPACING - half_width + jitter;
            }
            let walker = world.insert(
                RigidBodyBuilder::dynamic()
                    .translation(place)
                    .locked_axes(flavour::UPRIGHT)
                    .can_sleep(false),
                slippery(figure(index)),
            );
            (walker, somewhere(half_width, random))
        })
        .collect();
    // Steers each walker to its goal, and then to another one.
    Stage::new(world, container).with_script(move |world: &mut World, cue: &mut Cue| {
        for (walker, goal) in &mut walkers {
            let body = &world.bodies[*walker];
            let velocity = own(body.linvel());
            let mut way = planar(*goal - own(body.translation()));
            let distance = length(way);
            if distance < REACHED {
                *goal = somewhere(half_width, &mut cue.random);
            }
            if length(velocity) < STUCK {
                way = aside(way);
            }
            let wanted = way * (SPEED / distance.max(REACHED));
            // Nobody steers a fall.
            let velocity = velocity + (wanted - planar(velocity)) * EAGERNESS;
            cue.push(world, *walker, velocity);
        }
    })
}

/// A box or a round figure with the same bounds.
fn figure(index: usize) -> ColliderBuilder {
    match index % 2 {
        0 => cuboid(flat(HALF_WIDTH)),
        _ if DIM == 2 => ColliderBuilder::ball(HALF_WIDTH),
        _ => ColliderBuilder::capsule_y(HALF_HEIGHT - HALF_WIDTH, HALF_WIDTH),
    }
}
