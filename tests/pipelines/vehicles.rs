//! Rapier's vehicles, whose wheels are rays: the same journeys. There are none in two dimensions.

use super::rapier::control::{DynamicRayCastVehicleController, Wheel, WheelTuning};
use super::rapier::prelude::*;
use super::suite::twins::{Twins, at, cube, cuboid, dynamic, fixed, triple};
use super::version::{Vector, linvel, origin};

/// A car on a wide floor.
struct Drive {
    twins: Twins,
    chassis: RigidBodyHandle,
    /// One for our world and one for Rapier's.
    vehicles: [DynamicRayCastVehicleController; 2],
}

impl Drive {
    fn new() -> Self {
        let mut twins = Twins::heavy();
        twins.insert_floor();
        let body = cuboid([1.0, 0.25, 0.5]).density(100.0);
        let (chassis, _) = twins.insert(dynamic(0.0, 1.0), body);
        let tuning = WheelTuning {
            suspension_stiffness: 100.0,
            suspension_damping: 10.0,
            ..WheelTuning::default()
        };
        let vehicles = [(); 2].map(|()| {
            let mut vehicle = DynamicRayCastVehicleController::new(chassis);
            let (down, side) = (at(0.0, -1.0), triple([0.0, 0.0, 1.0]));
            for (x, z) in [(0.75, 0.5), (0.75, -0.5), (-0.75, 0.5), (-0.75, -0.5)] {
                let hub = triple([x, -0.2, z]).into();
                vehicle.add_wheel(hub, down, side, 0.4, 0.25, &tuning);
            }
            vehicle
        });
        twins.step();
        Self {
            twins,
            chassis,
            vehicles,
        }
    }

    /// Drives for this many steps; both worlds, and the full state of the wheels, must stay equal.
    fn drive(&mut self, steps: usize, set: impl Fn(&mut [Wheel])) -> Vec<Wheel> {
        let filter = QueryFilter::new().exclude_rigid_body(self.chassis);
        let mut wheels = Vec::new();
        for _ in 0..steps {
            let mut vehicles = self.vehicles.iter_mut();
            wheels = self.twins.both_scenes(filter, |scene| {
                let vehicle = vehicles.next().expect("there is one for each world");
                set(vehicle.wheels_mut());
                vehicle.update_vehicle(IntegrationParameters::default().dt, scene);
                vehicle.wheels().to_vec()
            });
            self.twins.step();
        }
        wheels
    }

    fn ahead(&mut self, steps: usize) -> Vec<Wheel> {
        self.drive(steps, |wheels| {
            wheels
                .iter_mut()
                .for_each(|wheel| wheel.engine_force = 60.0);
        })
    }

    fn place(&self) -> Vector {
        origin(self.twins.ours.bodies[self.chassis].position())
    }
}

/// Which of the wheels touch something.
fn grounded(wheels: &[Wheel]) -> usize {
    let touch = |wheel: &&Wheel| wheel.raycast_info().is_in_contact;
    wheels.iter().filter(touch).count()
}

#[test]
fn round_a_bend_and_to_a_stop() {
    let mut drive = Drive::new();
    assert_eq!(grounded(&drive.drive(40, |_| {})), 4);
    drive.ahead(150);
    let straight = drive.place();
    assert!(straight.x > 3.0 && straight.z.abs() < 0.1, "{straight}");
    drive.drive(150, |wheels| {
        for wheel in &mut wheels[..2] {
            wheel.steering = 0.4;
        }
    });
    let bent = drive.place();
    assert!((bent - straight).z.abs() > 1.0, "{bent}");
    drive.drive(200, |wheels| {
        for wheel in wheels {
            wheel.engine_force = 0.0;
            wheel.brake = 50.0;
        }
    });
    let stopped = linvel(&drive.twins.ours.bodies[drive.chassis]).x.abs();
    assert!(stopped < 0.1, "it is at {stopped}");
}

#[test]
fn over_obstacles() {
    let mut drive = Drive::new();
    for i in 0..6 {
        let bump = cuboid([0.2, 0.05, 0.4]);
        let side = if i % 2 == 0 { 0.5 } else { -0.5 };
        let place = triple([4.0 + 1.3 * i as Real, 0.05, side]);
        drive.twins.insert(fixed(0.0, 0.0), bump.translation(place));
    }
    let mut tilted = false;
    for _ in 0..400 {
        drive.ahead(1);
        let turn = *drive.twins.ours.bodies[drive.chassis].rotation();
        let ahead = turn * at(1.0, 0.0);
        tilted |= ahead.x < 0.9998;
    }
    assert!(tilted && drive.place().x > 12.0, "{}", drive.place());
}

#[test]
fn off_a_ledge_and_into_a_cube() {
    let mut drive = Drive::new();
    let ledge = cuboid([6.0, 0.5, 3.0]).translation(at(3.0, 0.5));
    drive.twins.insert(fixed(0.0, 0.0), ledge);
    let above = at(0.0, 2.0);
    drive
        .twins
        .change_body(drive.chassis, |body| body.set_translation(above, true));
    let (hit, _) = drive.twins.insert(dynamic(16.0, 0.5), cube());
    drive.twins.step();
    let mut least = 4;
    for _ in 0..400 {
        least = least.min(grounded(&drive.ahead(1)));
    }
    assert_eq!(least, 0, "it flies off the ledge");
    let pushed = drive.twins.ours.bodies[hit].translation().x;
    assert!(pushed > 17.0, "the cube is at {pushed}");
}
