//! Steps a scene in one flavour of Rapier until it is asleep.

use super::ours::UnisizeBroadPhase;
use super::scenes::rapier::prelude::*;
use super::scenes::{Scene, Steppable, install};
use crate::asleep::Case;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::ops::Range;

/// From each start, the steps until all bodies sleep, on Rapier's own broad phase and on unisize. It is `None` if a body is still awake
/// after the last step. The threads of the current pool share the starts.
pub(crate) fn steps_until_asleep(case: &Case, starts: Range<u64>) -> Vec<[Option<usize>; 2]> {
    let both = |seed| {
        let default = run(case, seed, DefaultBroadPhase::new());
        let ours = run(case, seed, install(UnisizeBroadPhase::new()));
        [default, ours]
    };
    starts.into_par_iter().map(both).collect()
}

fn run(case: &Case, seed: u64, mut broad_phase: impl Steppable) -> Option<usize> {
    let mut scene = Scene::build(case.kind, case.bodies, seed);
    (1..=case.steps).find(|_| {
        scene.step(broad_phase.for_step(), &(), &());
        let mut bodies = scene.world.bodies.iter();
        bodies.all(|(_, body)| body.is_sleeping() || !body.is_dynamic())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use unisize_scenes::SceneKind;

    #[test]
    fn columns_fall_asleep_and_a_gas_does_not() {
        let of = |kind| {
            let case = Case {
                kind,
                bodies: 28,
                steps: 300,
            };
            steps_until_asleep(&case, 1..3)
        };
        for steps in of(SceneKind::Columns).into_iter().flatten() {
            // A body has to rest for a while before it may sleep.
            assert!(steps.is_some_and(|steps| steps > 30), "{steps:?}");
        }
        assert_eq!(of(SceneKind::Gas), [[None; 2]; 2]);
    }
}
