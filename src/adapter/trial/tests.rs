//! A trial detects a faulty broad phase.

use super::super::rapier::dynamics::IntegrationParameters;
use super::super::rapier::math::Real;
use super::*;

fn handle(index: u32) -> ColliderHandle {
    ColliderHandle::from_raw_parts(index, 0)
}

/// A ball on the first axis.
fn ball(x: Real) -> Collider {
    let ball = ColliderBuilder::ball(0.5).active_collision_types(ActiveCollisionTypes::all());
    let mut place = version::Vector::default();
    place[0] = x;
    ball.translation(place).build()
}

/// Three balls, of which the first two touch. Injects a fault into unisize, moves the last ball to the second one, and returns the difference:
/// the indices of the colliders, and whether the pair is missing.
fn difference(fault: impl Fn(&mut UnisizeBroadPhase, &Input<'_>)) -> Option<([u32; 2], bool)> {
    let mut colliders = ColliderSet::new();
    let all = [0.0, 0.9, 5.0].map(|x| colliders.insert(ball(x)));
    let mut trial = Trial::new();
    let (params, bodies) = (IntegrationParameters::default(), RigidBodySet::new());
    let input = Input::new(&params, &colliders, &bodies, &all, &[]);
    trial.run(&input, &mut Vec::new());
    assert!(trial.report().pairs_match());

    colliders[all[2]].set_position(*ball(1.7).position());
    let input = Input::new(&params, &colliders, &bodies, &all[2..], &[]);
    fault(&mut trial.tried[version::FILTER_OF_OWN as usize], &input);
    trial.run(&input, &mut Vec::new());

    let report = trial.report();
    assert_eq!((report.updates, report.own.pairs), (2, 1.5));
    let difference = report.first_difference?;
    assert_eq!(difference.update, 2);
    let indices = difference.colliders.map(|handle| handle.into_raw_parts().0);
    Some((indices, difference.is_missing))
}

#[test]
fn faults_are_named() {
    assert_eq!(difference(|_, _| {}), None);
    let forgets_a_collider = |faulty: &mut UnisizeBroadPhase, input: &Input<'_>| {
        let removed = [handle(1)];
        let lists = Lists::new(&[], &removed);
        faulty.run_in_pipeline(&Input { lists, ..*input }, &mut Vec::new());
    };
    assert_eq!(difference(forgets_a_collider), Some(([1, 2], true)));
    let loses_events = |faulty: &mut UnisizeBroadPhase, input: &Input<'_>| {
        faulty.run_in_pipeline(input, &mut Vec::new());
    };
    assert_eq!(difference(loses_events), Some(([1, 2], true)));
    let has_a_wrong_box = |faulty: &mut UnisizeBroadPhase, input: &Input<'_>| {
        let aabb = ball(1.7).compute_aabb();
        faulty.set_boxes(input.params, &[(handle(0), aabb)]);
    };
    assert_eq!(difference(has_a_wrong_box), Some(([0, 2], false)));
}
