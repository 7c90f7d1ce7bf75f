//! Every scene, small, with Rapier's broad phase and each kernel of ours: the pairs held, the contacts and the
//! intersections are equal after every step, and what is simulated on ours alone stays sound. `compare` does the same at full size.

use super::scenes::{Candidate, Comparison};
use super::{Kernel, Settings, UnisizeBroadPhase};
use unisize_scenes::SceneKind;

fn compare(kernel: Kernel, comparison: Comparison) {
    let settings = Settings::default().with_kernel(kernel);
    let candidate = Candidate::new(
        move || UnisizeBroadPhase::with_settings(settings),
        |ours| ours.pairs().collect(),
        UnisizeBroadPhase::as_query_pipeline,
    )
    .with_validation(UnisizeBroadPhase::validate);
    let outcome = comparison.run(&candidate);
    let name = comparison.kind.name();
    assert!(outcome.is_equal(), "{name}: {:?}", outcome.first_difference);
    let has_pairs = outcome.pairs.default > 0;
    assert!(comparison.bodies < 2 || has_pairs, "{name} has no pairs");
}

fn compare_all(kernel: Kernel, bodies: usize, steps: usize, repeats: usize) {
    for kind in SceneKind::ALL {
        let comparison = Comparison::new(kind, bodies, 7);
        let comparison = Comparison {
            steps,
            repeats,
            rays: 4,
            ..comparison
        };
        compare(kernel, comparison);
    }
}

#[test]
fn grid_sweep() {
    compare_all(Kernel::GridSweep, 150, 60, 1);
}

#[test]
fn rank_sweep() {
    compare_all(Kernel::RankSweep, 150, 60, 0);
}

#[test]
fn one_body_or_none() {
    compare_all(Kernel::GridSweep, 1, 10, 0);
    compare_all(Kernel::GridSweep, 0, 10, 0);
}

/// So many that ours uses its threads, if it has any.
#[test]
fn a_large_swarm() {
    let comparison = Comparison {
        steps: 4,
        repeats: 0,
        ..Comparison::new(SceneKind::Swarm, 20_000, 7)
    };
    compare(Kernel::GridSweep, comparison);
}
