//! Casts of what turns on its way.

use super::rapier::parry::query::{DefaultQueryDispatcher, NonlinearRigidMotion, QueryDispatcher};
use super::rapier::prelude::*;
use super::spin;
use super::twins::{Twins, at, cube, dynamic};

/// Balls and cubes in a wide grid, some of them moving.
fn grid() -> Twins {
    let mut twins = Twins::weightless();
    for i in 0..8 {
        for j in 0..8 {
            let body = dynamic(3.0 * i as Real, 3.0 * j as Real);
            let body = body.linvel(at(0.3, 0.2) * ((i + j) % 2) as Real);
            let shapes = [cube(), ColliderBuilder::ball(0.6)];
            twins.insert(body, shapes[i % 2].clone());
        }
    }
    twins
}

/// Parry runs a nonlinear cast against a ball around each node of the tree as well, and for some motions misses what is
/// behind one: Rapier's broad phase does, and so does ours, by the shapes of their trees. So where the answers differ, one
/// of them must be what is hit first of all colliders, each by itself, and the other one a later hit, or none.
fn compare_nonlinear_casts(twins: &mut Twins, start: Isometry<Real>, probe: &Ball) -> Option<Real> {
    let motion = NonlinearRigidMotion::new(start, Point::origin(), at(-1.0, -0.3), spin(0.5));
    let [ours, theirs] = twins.answers(|_, scene| {
        let hit = scene.cast_shape_nonlinear(&motion, probe, 0.0, 10.0, false);
        hit.map(|(_, hit)| hit.time_of_impact)
    });
    if ours != theirs {
        let colliders = twins.ours.colliders.iter_enabled();
        let times: Vec<_> = colliders
            .filter_map(|(_, collider)| {
                let still = NonlinearRigidMotion::constant_position(*collider.position());
                let (dispatcher, shape) = (DefaultQueryDispatcher, collider.shape());
                let hit = dispatcher
                    .cast_shapes_nonlinear(&still, shape, &motion, probe, 0.0, 10.0, false)
                    .expect("these shapes can be cast");
                hit.map(|hit| hit.time_of_impact)
            })
            .collect();
        let first = times.iter().copied().min_by(Real::total_cmp);
        assert!(ours == first || theirs == first, "{ours:?}, {theirs:?}");
        for time in ours.iter().chain(&theirs) {
            assert!(times.contains(time), "{time} is no hit");
        }
    }
    ours
}

#[test]
fn casts_that_turn() {
    let mut twins = grid();
    for steps in [1, 30] {
        twins.steps(steps);
        let mut hits = 0;
        for i in 0..60 {
            let start = Isometry::from(at(-2.0 + 0.45 * i as Real, 25.0 - 0.37 * i as Real));
            let hit = compare_nonlinear_casts(&mut twins, start, &Ball::new(1.7));
            hits += usize::from(hit.is_some());
        }
        assert!(hits > 20, "only {hits} hits");
    }
}
