//! Bullets that are too fast for their size: half of the bodies with CCD at a thin wall, a quarter with
//! soft CCD at a stack of boxes, which are the last quarter.
//!
//! Soft CCD enlarges the boxes that a broad phase sees, along the way of the bullet.

use super::*;

/// The radius of a bullet.
const RADIUS: Real = 0.15;
/// The speed of a bullet with CCD, in length units per second: ten of its sizes in a step.
const HARD_SPEED: Real = 180.0;
/// The speed of a bullet with soft CCD.
const SOFT_SPEED: Real = 60.0;
/// The distance ahead at which soft CCD looks for obstacles: more than a step.
const SOFT_DISTANCE: Real = 2.0;
/// Half the thickness of the wall.
const HALF_WALL: Real = 0.05;
/// How far bullets fly before they hit.
const RANGE: Real = 12.0;
/// The room around the volleys.
const MARGIN: Real = 10.0;

/// One of this many bodies may pass the wall.
///
/// Rapier's CCD fails where a bullet that touches the floor or a side flies into the corner with the wall:
/// it takes the contact that exists for the first impact. That happens to about one in a hundred.
const LEAK: usize = 33;

/// The number of steps between two volleys.
const INTERVAL: usize = 15;
/// The number of volleys after which bullets are used again.
const VOLLEYS: usize = 8;

/// Shoots bullets of one kind along the first axis: new ones first, then those that have lain about for longest.
#[derive(Clone)]
struct Gun {
    bullets: Vec<RigidBodyHandle>,
    magazine: usize,
    next: usize,
    muzzle: Real,
    speed: Real,
    bullet: RigidBodyBuilder,
}

impl Gun {
    fn volley(&self) -> usize {
        self.magazine.div_ceil(VOLLEYS)
    }

    /// How many bullets of a volley fly side by side.
    fn columns(&self) -> usize {
        match DIM {
            2 => 1,
            _ => ((self.volley() as Real).sqrt().ceil() as usize).max(1),
        }
    }

    /// How many bullets of a volley fly one above the other.
    fn rows(&self) -> usize {
        self.volley().div_ceil(self.columns())
    }

    fn shoot(&mut self, world: &mut World, cue: &mut Cue) {
        let columns = self.columns();
        for index in 0..self.volley() {
            let across = (index % columns) as Real - (columns - 1) as Real / 2.0;
            let from = vector(|axis| match axis {
                0 => self.muzzle,
                UP => 1.0 + (index / columns) as Real,
                _ => across,
            }) + jitter(&mut cue.random, 0.2);
            let velocity = along(0, self.speed) + jitter(&mut cue.random, 1.0);
            if self.bullets.len() < self.magazine {
                let bullet = self.bullet.clone().translation(from).linvel(velocity);
                let collider = ColliderBuilder::ball(RADIUS).density(5.0);
                self.bullets.push(cue.insert(world, bullet, collider));
            } else {
                cue.throw(world, self.bullets[self.next], from, velocity);
                self.next = (self.next + 1) % self.magazine;
            }
        }
    }
}

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let boxes = bodies / 4;
    let stack = Lattice::heap(boxes, 1.05, 2.0);
    let center = RANGE + stack.half_width();
    let hard = Gun {
        bullets: Vec::new(),
        magazine: bodies.div_ceil(2),
        next: 0,
        muzzle: -RANGE,
        speed: HARD_SPEED,
        bullet: RigidBodyBuilder::dynamic().ccd_enabled(true),
    };
    let soft = Gun {
        bullets: Vec::new(),
        magazine: bodies - boxes - hard.magazine,
        next: 0,
        muzzle: center + stack.half_width() + RANGE,
        speed: -SOFT_SPEED,
        bullet: RigidBodyBuilder::dynamic()
            .soft_ccd_prediction(SOFT_DISTANCE)
            .user_data(1),
    };

    let height = stack.height().max(hard.rows().max(soft.rows()) as Real) + MARGIN;
    let half_width = stack.half_width().max(hard.columns() as Real / 2.0) + MARGIN;
    let room = Container {
        lo: vector(|axis| match axis {
            0 => hard.muzzle - 2.0,
            UP => 0.0,
            _ => -half_width,
        }),
        hi: vector(|axis| match axis {
            0 => soft.muzzle + 2.0,
            UP => height,
            _ => half_width,
        }),
    };
    let mut stage = Stage::new(falling(), room);
    room.wall_in(&mut stage.world, true, |side| side.build());
    // The wall parts the room in two, and what is on one side is meant to stay there.
    stage.containers = vec![room; 2];
    stage.containers[0].hi[0] = 0.0;
    stage.containers[1].lo[0] = 0.0;
    let wall = RigidBodyBuilder::fixed().translation(along(UP, height / 2.0));
    let half = vector(|axis| match axis {
        0 => HALF_WALL,
        UP => height / 2.0,
        _ => half_width,
    });
    stage.world.insert(wall, cuboid(half));

    for index in 0..boxes {
        let mut place = stack.center(index) + along(0, center);
        place[0] += random.range(-0.02, 0.02);
        stage.world.insert(
            RigidBodyBuilder::dynamic().translation(place).user_data(1),
            cube(0.5),
        );
    }
    stage.may_fall_through = bodies.div_ceil(LEAK) + 1;
    let mut guns = [hard, soft];
    stage.with_script(move |world: &mut World, cue: &mut Cue| {
        if cue.step % INTERVAL == 0 {
            guns.iter_mut().for_each(|gun| gun.shoot(world, cue));
        }
    })
}
