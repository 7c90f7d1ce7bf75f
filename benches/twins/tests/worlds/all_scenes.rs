//! Every scene, small, with Rapier's broad phase and ours: the pairs held, the contacts and the
//! intersections are equal after every step, and what is simulated on ours alone stays sound. `compare` does the same at full size.

use super::UnisizeBroadPhase;
use super::scenes::{Candidate, Comparison};
use unisize_scenes::SceneKind;

fn compare(comparison: Comparison) {
    let candidate = Candidate::new(
        UnisizeBroadPhase::new,
        |ours| ours.pairs().collect(),
        UnisizeBroadPhase::as_query_pipeline,
    )
    .with_validation(UnisizeBroadPhase::validate);
    let outcome = comparison.run(&[candidate]);
    let name = comparison.kind.name();
    assert!(outcome.is_equal(), "{name}: {:?}", outcome.first_difference);
    // A single body has none that count.
    let may_have_none = comparison.bodies < 2 || comparison.kind == SceneKind::OneBody;
    let has_pairs = outcome.pairs.default > 0;
    assert!(may_have_none || has_pairs, "{name} has no pairs");
}

fn compare_all(bodies: usize, steps: usize, repeats: usize) {
    for kind in SceneKind::ALL {
        let comparison = Comparison::new(kind, bodies, 7);
        let comparison = Comparison {
            steps,
            repeats,
            rays: 4,
            ..comparison
        };
        compare(comparison);
    }
}

#[test]
fn a_hundred_bodies() {
    compare_all(150, 60, 1);
}

#[test]
fn one_body_or_none() {
    compare_all(1, 10, 0);
    compare_all(0, 10, 0);
}

/// So many that ours uses its threads, if it has any.
#[test]
fn a_large_swarm() {
    let comparison = Comparison {
        steps: 4,
        repeats: 0,
        ..Comparison::new(SceneKind::Swarm, 20_000, 7)
    };
    compare(comparison);
}
