//! A world at rest: boxes that are created asleep, among which one ball to a hundred boxes moves.

use super::*;

/// Half the size of a box.
const HALF: Real = 0.5;
/// The distance between boxes.
const SPACING: Real = 1.8;
/// The height of a storey. In the plane, boxes would else lie in a single row of great length.
const STOREY: Real = 4.0;
/// The radius of a mover, which is a little less than what fits between two boxes.
const MOVER: Real = 0.38;
/// The speed of a mover along its way.
const SPEED: Real = 6.0;
/// How far a mover sways across its way, far enough to brush the boxes now and then.
const SWAY: Real = 0.06;

/// A ball on its way.
#[derive(Clone)]
struct Mover {
    body: RigidBodyHandle,
    place: Vector,
    phase: Real,
    forward: bool,
}

impl Mover {
    /// The velocity that drives it back and forth along the first axis, from here.
    fn velocity(&mut self, here: Vector, time: Real, half_width: Real) -> Vector {
        if here[0].abs() > half_width {
            self.forward = here[0] < 0.0;
        }
        let sway = SWAY * sine(3.0 * time + self.phase);
        vector(|axis| match axis {
            0 if self.forward => SPEED,
            0 => -SPEED,
            flavour::ACROSS => (self.place[axis] + sway - here[axis]) * 10.0,
            _ => (self.place[axis] - here[axis]) * 10.0,
        })
    }
}

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let movers = bodies.div_ceil(100);
    let boxes = bodies - movers;
    let storeys = match DIM {
        2 => ((boxes as Real).sqrt() / 4.0).ceil().max(1.0) as usize,
        _ => 1,
    };
    let per_storey = boxes.div_ceil(storeys).max(1);
    let columns = power(per_storey as Real, 1.0 / (DIM - 1) as Real).ceil();
    let lattice = Lattice::with_columns(per_storey, SPACING, columns as usize);
    let half_width = lattice.half_width() + 1.0;

    let walls = Container::standing(half_width, storeys as Real * STOREY);
    let mut stage = Stage::walled(walls);
    let world = &mut stage.world;
    for storey in 1..storeys {
        let center = along(UP, storey as Real * STOREY - 0.25);
        world
            .colliders
            .insert(cuboid(wide_high(half_width, 0.25)).translation(center));
    }
    for index in 0..boxes {
        let mut center = lattice.center(index % per_storey);
        center[UP] = (index / per_storey) as Real * STOREY + HALF;
        center[0] += random.range(-0.1, 0.1);
        world.insert(
            RigidBodyBuilder::dynamic()
                .translation(center)
                .sleeping(true),
            cube(HALF),
        );
    }

    let mut movers: Vec<_> = (0..movers)
        .map(|index| {
            let place = lane(index, storeys, &lattice, random);
            let ball = RigidBodyBuilder::dynamic()
                .translation(place)
                .gravity_scale(0.0)
                .can_sleep(false);
            Mover {
                body: world.insert(ball, ColliderBuilder::ball(MOVER)),
                place,
                phase: random.range(0.0, core::f64::consts::TAU as Real),
                forward: random.index(2) == 0,
            }
        })
        .collect();
    stage.with_script(move |world: &mut World, cue: &mut Cue| {
        let time = cue.step as Real * world.params.dt;
        for mover in &mut movers {
            let here = own(world.bodies[mover.body].translation());
            let velocity = mover.velocity(here, time, lattice.half_width());
            cue.push(world, mover.body, velocity);
        }
    })
}

/// Where a mover starts: between two rows of boxes, or in the plane, above a row of them.
fn lane(index: usize, storeys: usize, lattice: &Lattice, random: &mut Random) -> Vector {
    let storey = index % storeys;
    let ground = storey as Real * STOREY;
    let round = index / storeys;
    let mut place = vector(|_| 0.0);
    if flavour::ACROSS == UP {
        // Movers of a storey fly one above the other as far as there is room.
        place[UP] = ground + 2.0 * HALF + MOVER + 0.02 + (round % 2) as Real * 2.2 * MOVER;
        place[0] = spread(round / 2, lattice);
    } else {
        let gaps = lattice.columns + 1;
        let gap = (round % gaps) as Real;
        place[UP] = ground + HALF;
        place[flavour::ACROSS] = gap * SPACING - lattice.half_width();
        place[0] = spread(round / gaps, lattice);
    }
    place[0] += random.range(-0.1, 0.1);
    place
}

/// Places along a lane, far enough apart for two movers.
fn spread(round: usize, lattice: &Lattice) -> Real {
    let slots = (lattice.columns / 2).max(1);
    let slot = (round * 7 + 3) % slots;
    (slot as Real * 2.0 + 1.0) * SPACING - lattice.half_width()
}
