//! A vehicle of Rapier's own: a chassis on four wheels, each of which is a ray.

use super::engine::World;
use super::engine::space::{Point, Vector, along, length, own};
use super::rapier::control::{DynamicRayCastVehicleController, WheelTuning};
use super::rapier::parry::partitioning::Bvh;
use super::rapier::prelude::*;

/// Half the length, height and width of the chassis.
const HALF: [Real; 3] = [0.8, 0.2, 0.4];
/// The density of the chassis, enough to push balls aside.
const DENSITY: Real = 5.0;
/// The force of each of the two driven wheels.
const FORCE: Real = 6.0;
/// The angle at which the front wheels stand.
const STEERING: Real = 0.1;
/// The number of steps after which the vehicle changes its direction.
const LEG: usize = 100;

/// A vehicle that drives to and fro on a curve.
pub(super) struct Vehicle {
    controller: DynamicRayCastVehicleController,
}

/// Rapier's controller cannot be cloned, but its wheels can.
impl Clone for Vehicle {
    fn clone(&self) -> Self {
        let mut controller = controller(self.controller.chassis);
        let wheels = self.controller.wheels();
        controller.wheels_mut().clone_from_slice(wheels);
        Self { controller }
    }
}

impl Vehicle {
    /// Inserts a vehicle here.
    pub(super) fn insert(world: &mut World, place: Vector) -> Option<Self> {
        let [half_length, height, width] = HALF;
        let chassis = world.insert(
            RigidBodyBuilder::dynamic()
                .translation(place)
                .can_sleep(false),
            ColliderBuilder::cuboid(half_length, height, width).density(DENSITY),
        );
        Some(Self {
            controller: controller(chassis),
        })
    }

    /// Drives on, and returns the work of the engine.
    pub(super) fn drive(&mut self, step: usize, world: &mut World, tree: &Bvh) -> Real {
        let force = if (step / LEG) % 2 == 0 { -FORCE } else { FORCE };
        for wheel in &mut self.controller.wheels_mut()[..2] {
            wheel.engine_force = force;
            wheel.steering = STEERING;
        }
        let dt = world.params.dt;
        let chassis = self.controller.chassis;
        let filter = QueryFilter::default().exclude_rigid_body(chassis);
        self.controller
            .update_vehicle(dt, world.queries_mut(tree, filter));
        2.0 * FORCE * dt * length(own(world.bodies[chassis].linvel()))
    }
}

/// The controller of this chassis, with four wheels.
fn controller(chassis: RigidBodyHandle) -> DynamicRayCastVehicleController {
    let [half_length, height, width] = HALF;
    let mut controller = DynamicRayCastVehicleController::new(chassis);
    let tuning = WheelTuning {
        suspension_stiffness: 100.0,
        suspension_damping: 10.0,
        ..WheelTuning::default()
    };
    for (forward, aside) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let mut connection = along(1, -height);
        connection[0] = forward * 0.8 * half_length;
        connection[2] = aside * width;
        controller.add_wheel(
            Point::from(connection),
            -along(1, 1.0),
            along(2, 1.0),
            height,
            0.5 * height,
            &tuning,
        );
    }
    controller
}
