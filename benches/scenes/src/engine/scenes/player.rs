//! A player: falling balls, among which a character walks that looks around, and in space a vehicle drives.
//!
//! Both are controllers of Rapier, which ask the broad phase's tree at every step: the character where it can go and
//! whom it pushes, the vehicle what is under its wheels. Sixteen rays a step are what the character sees.

use super::grains::{SPACING, grain};
use super::rapier::control::KinematicCharacterController;
use super::rapier::parry::partitioning::Bvh;
use super::vehicle::Vehicle;
use super::*;

/// Half the height of the character, without its round ends.
const HALF: Real = 0.5;
/// The radius of the character.
const GIRTH: Real = 0.3;
/// The mass with which the character pushes.
const MASS: Real = 1.0;
/// The speed of the character.
const SPEED: Real = 4.0;
/// The share of its speed below which the character takes itself to be stuck, and turns.
const STUCK: Real = 0.1;
/// How many rays the character casts in a step.
const RAYS: usize = 16;

/// The character, and what else is driven.
#[derive(Clone)]
struct Play {
    body: RigidBodyHandle,
    shape: SharedShape,
    controller: KinematicCharacterController,
    heading: Vector,
    /// How fast the character falls, downward.
    fall: Real,
    vehicle: Option<Vehicle>,
}

impl Script for Play {
    fn copy(&self) -> Box<dyn Script> {
        Box::new(self.clone())
    }

    fn asks(&self) -> bool {
        true
    }

    fn ask(&mut self, world: &mut World, cue: &mut Cue, tree: &Bvh) {
        self.walk(world, cue, tree);
        if let Some(vehicle) = &mut self.vehicle {
            let work = vehicle.drive(cue.step, world, tree);
            cue.supply(1.0, work);
        }
    }

    fn rays(&self, world: &World) -> Vec<Ray> {
        let eye = own(world.bodies[self.body].translation());
        let directions = (0..RAYS).map(|index| {
            let angle = core::f64::consts::TAU as Real * index as Real / RAYS as Real;
            let mut direction = vector(|_| 0.0);
            direction[flavour::PLANE[0]] = cosine(angle);
            direction[flavour::PLANE[1]] = sine(angle);
            direction
        });
        // From just outside of the character, whom it would see otherwise.
        let outside = |direction: Vector| direction * (HALF + 2.0 * GIRTH);
        directions
            .map(|direction| Ray::new(Point::from(eye + outside(direction)), direction))
            .collect()
    }
}

impl Play {
    /// Walks on, falls and pushes balls, and turns where it cannot go on.
    fn walk(&mut self, world: &mut World, cue: &mut Cue, tree: &Bvh) {
        let dt = world.params.dt;
        let place = *world.bodies[self.body].position();
        self.fall += GRAVITY * dt;
        let wanted = (self.heading * SPEED - along(UP, self.fall)) * dt;

        let filter = QueryFilter::default().exclude_rigid_body(self.body);
        let mut hits = Vec::new();
        let movement = self.controller.move_shape(
            dt,
            &world.queries(tree, filter),
            &*self.shape,
            &place,
            wanted,
            |hit| hits.push(hit),
        );
        self.controller.solve_character_collision_impulses(
            dt,
            &mut world.queries_mut(tree, filter),
            &*self.shape,
            MASS,
            &hits,
        );
        // What is hit gets no more than the character's speed.
        let pushed = hits.len() as Real * MASS;
        cue.supply(pushed, length_squared(wanted / dt));

        let next = own(world.bodies[self.body].translation()) + movement.translation;
        world.bodies[self.body].set_next_kinematic_translation(next);
        if movement.grounded {
            self.fall = 0.0;
        }
        if dot(movement.translation, self.heading) < STUCK * SPEED * dt {
            self.heading = any_heading(&mut cue.random);
        }
    }
}

/// A horizontal direction.
fn any_heading(random: &mut Random) -> Vector {
    let angle = random.range(0.0, core::f64::consts::TAU as Real);
    direction(vector(|axis| match axis {
        0 => cosine(angle),
        UP => 0.0,
        _ => sine(angle),
    }))
}

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let lattice = Lattice::heap(bodies, SPACING, 1.0);
    // Wide enough that the balls do not bury the floor deeply.
    let half_width = 2.0 * lattice.half_width() + 4.0;
    let walls = Container::standing(half_width, lattice.height() + 1.0);
    let mut stage = Stage::walled(walls);
    if bodies == 0 {
        return stage;
    }
    let world = &mut stage.world;

    let mut place = along(0, 1.5 - half_width);
    place[UP] = HALF + GIRTH + 0.1;
    let shape = SharedShape::capsule_y(HALF, GIRTH);
    let body = world.insert(
        RigidBodyBuilder::kinematic_position_based().translation(place),
        ColliderBuilder::new(shape.clone()),
    );
    place[0] = half_width - 2.5;
    let vehicle = if bodies > 1 {
        Vehicle::insert(world, place)
    } else {
        None
    };
    let driven = world.bodies.len();
    for index in 0..bodies - driven {
        let (center, ball) = grain(lattice.center(index), random);
        stage.insert(center, ball);
    }
    stage.with_script(Play {
        body,
        shape,
        controller: KinematicCharacterController::default(),
        heading: any_heading(random),
        fall: 0.0,
        vehicle,
    })
}
