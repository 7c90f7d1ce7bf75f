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

/// A report in which Rapier's own updates took 100 ms for 1,000 pairs, and those of unisize this many milliseconds for this many pairs at each
/// level.
fn report(levels: [(u64, f64); LEVELS.len()]) -> TrialReport {
    let mut report = Trial::new().report();
    (report.own.total, report.own.pairs) = (Duration::from_millis(100), 1000.0);
    for (measured, (millis, pairs)) in report.levels.iter_mut().zip(levels) {
        (measured.total, measured.pairs) = (Duration::from_millis(millis), pairs);
    }
    report.overhead = Duration::from_millis(500);
    report
}

#[test]
fn speedups_follow_from_the_times_of_steps() {
    let [elapsed, narrow_phase] = [1500, 400].map(Duration::from_millis);
    let plain = report([(100, 1000.0), (100, 1000.0), (80, 1000.0), (150, 250.0)]);
    assert_eq!(plain.min_speedup(PairFilter::Groups), None);
    assert_eq!(plain.estimated_speedup(PairFilter::Groups), None);

    let bounded = plain.clone().with_steps(elapsed, None);
    assert_eq!(bounded.min_speedup(PairFilter::Groups), Some(1.0 / 0.98));
    assert_eq!(bounded.estimated_speedup(PairFilter::Groups), None);

    let timed = plain.with_steps(elapsed, narrow_phase);
    assert_eq!(timed.min_speedup(PairFilter::Shapes), Some(1.0 / 1.05));
    assert_eq!(
        timed.estimated_speedup(PairFilter::Shapes),
        Some(1.0 / 0.75)
    );
    let printed = timed.to_string();
    assert!(printed.contains("at least"), "{printed}");
}

#[test]
fn the_level_that_takes_least_time_is_recommended() {
    let [elapsed, narrow_phase] = [1500, 400].map(Duration::from_millis);
    // The narrow phase saves 300 ms with the last level, which costs 50 ms more.
    let saves_pairs = report([(100, 1000.0), (100, 1000.0), (80, 1000.0), (150, 250.0)]);
    let timed = saves_pairs.with_steps(elapsed, narrow_phase);
    assert_eq!(timed.recommended_filter(), Some(PairFilter::Shapes));
    // It saves 4 ms with it, which costs 120 ms more.
    let saves_none = report([(90, 1000.0), (90, 1000.0), (50, 1000.0), (220, 990.0)]);
    let timed = saves_none.with_steps(elapsed, narrow_phase);
    assert_eq!(timed.recommended_filter(), Some(PairFilter::Groups));
    // No level is faster.
    let slower = report([(200, 1000.0); LEVELS.len()]);
    assert_eq!(slower.recommended_filter(), None);
    let timed = slower.with_steps(elapsed, narrow_phase);
    assert_eq!(timed.recommended_filter(), None);
}
