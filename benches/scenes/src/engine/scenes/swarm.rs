//! A swarm: kinematic bodies that all move at every step, so that a step is little more than the broad phase.
//!
//! Rapier ignores pairs of kinematic bodies unless a collider asks for them. Every fourth is a sensor that
//! does, so that there are intersections.

use super::*;

/// Half the size of a body.
const HALF: Real = 0.5;
/// The distance between bodies at the start. They overlap later.
const SPACING: Real = 1.6;
/// The largest drift along each axis, in length units per second.
const DRIFT: Real = 3.0;
/// The radius of the circles that are flown on top of the drift.
const CIRCLE: Real = 0.5;

/// A body with its flight.
#[derive(Clone)]
struct Flyer {
    body: RigidBodyHandle,
    home: Vector,
    drift: Vector,
    phase: Real,
}

impl Flyer {
    /// The place at this time: a drift that is reflected by the box, and a circle on top of it.
    fn place(&self, time: Real, container: &Container) -> Vector {
        vector(|axis| {
            let drifted = self.home[axis] + self.drift[axis] * time;
            let (lo, hi) = (container.lo[axis], container.hi[axis]);
            let quarter = axis as Real * (core::f64::consts::FRAC_PI_2 as Real);
            reflect(drifted, lo, hi) + CIRCLE * sine(2.0 * time + self.phase + quarter)
        })
    }
}

/// Folds a coordinate into `lo..hi` as if it were reflected at both ends.
fn reflect(coordinate: Real, lo: Real, hi: Real) -> Real {
    let width = hi - lo;
    let period = (coordinate - lo).rem_euclid(2.0 * width);
    lo + if period < width {
        period
    } else {
        2.0 * width - period
    }
}

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let lattice = Lattice::heap(bodies, SPACING, 1.0);
    let container = Container::standing(lattice.half_width(), lattice.height());
    let mut world = floating();
    let flyers: Vec<_> = (0..bodies)
        .map(|index| {
            let home = lattice.center(index) + jitter(random, 0.25);
            let shape = match index % 2 {
                0 => ColliderBuilder::ball(HALF),
                _ => cube(HALF * 0.8),
            };
            let collider = match index % 4 {
                0 => shape
                    .sensor(true)
                    .active_events(ActiveEvents::COLLISION_EVENTS)
                    .active_collision_types(ActiveCollisionTypes::all()),
                _ => shape,
            };
            Flyer {
                body: world.insert(
                    RigidBodyBuilder::kinematic_position_based().translation(home),
                    collider,
                ),
                home,
                drift: jitter(random, DRIFT),
                phase: random.range(0.0, core::f64::consts::TAU as Real),
            }
        })
        .collect();
    Stage::new(world, container).with_script(move |world: &mut World, cue: &mut Cue| {
        let time = (cue.step + 1) as Real * world.params.dt;
        for flyer in &flyers {
            let place = flyer.place(time, &container);
            world.bodies[flyer.body].set_next_kinematic_translation(place);
        }
    })
}
