//! Rapier's vehicles, whose wheels are rays: the same journeys. There are none in two dimensions.

use super::rapier::control::{DynamicRayCastVehicleController, Wheel, WheelTuning};
use super::rapier::prelude::*;
use super::suite::twins::{Twins, cuboid, dynamic, fixed, triple};

/// Which of the wheels touch something.
fn grounded(wheels: &[Wheel]) -> usize {
    let touch = |wheel: &&Wheel| wheel.raycast_info().is_in_contact;
    wheels.iter().filter(touch).count()
}

#[test]
fn a_car_drives_over_obstacles_and_round_a_bend() {
    let mut twins = Twins::heavy();
    twins.insert_floor();
    let body = cuboid([1.0, 0.25, 0.5]).density(100.0);
    let (chassis, _) = twins.insert(dynamic(0.0, 1.0), body);
    for i in 0..6 {
        let bump = cuboid([0.2, 0.05, 0.4]);
        let side = if i % 2 == 0 { 0.5 } else { -0.5 };
        let place = triple([4.0 + 1.3 * i as Real, 0.05, side]);
        twins.insert(fixed(0.0, 0.0), bump.translation(place));
    }
    let tuning = WheelTuning {
        suspension_stiffness: 100.0,
        suspension_damping: 10.0,
        ..WheelTuning::default()
    };
    // One for our world and one for Rapier's.
    let mut vehicles = [(); 2].map(|()| {
        let mut vehicle = DynamicRayCastVehicleController::new(chassis);
        for (x, z) in [(0.75, 0.5), (0.75, -0.5), (-0.75, 0.5), (-0.75, -0.5)] {
            let hub = triple([x, -0.2, z]);
            vehicle.add_wheel(hub, -Vector::Y, Vector::Z, 0.4, 0.25, &tuning);
        }
        vehicle
    });
    twins.step();
    let filter = QueryFilter::new().exclude_rigid_body(chassis);
    let mut most = 0;
    for step in 0..600 {
        let mut vehicles = vehicles.iter_mut();
        let wheels = twins.both_scenes(filter, |scene| {
            let vehicle = vehicles.next().expect("there is one for each world");
            for (i, wheel) in vehicle.wheels_mut().iter_mut().enumerate() {
                wheel.engine_force = if step < 40 { 0.0 } else { 60.0 };
                wheel.steering = if step > 450 && i < 2 { 0.4 } else { 0.0 };
            }
            vehicle.update_vehicle(IntegrationParameters::default().dt, scene);
            vehicle.wheels().to_vec()
        });
        most = most.max(grounded(&wheels));
        twins.step();
    }
    assert_eq!(most, 4);
    let place = twins.ours.bodies[chassis].translation();
    assert!(place.x > 10.0 && place.z.abs() > 0.1, "it ends at {place}");
}
