//! What is checked without a page: contacts, as the example `compare` does it, and hashes of events, as `tests/golden` does.

use super::UnisizeBroadPhase;
use super::scenes::{Candidate, Comparison, Observed, PairEvent, Scene, Steppable, install};
use super::version::ALL_PAIRS;
use crate::hash::Hash;
use unisize::{PairFilter, Settings};
use unisize_scenes::SceneKind;

/// The first difference to Rapier's own broad phase in a scene, in pairs, contacts or intersections, after any step.
pub(crate) fn first_difference(kind: SceneKind, bodies: usize, steps: usize) -> Option<String> {
    let candidate = |filter| {
        let settings = Settings::default().with_filter(filter);
        Candidate::new(
            move || UnisizeBroadPhase::with_settings(settings),
            |ours| ours.pairs().collect(),
            UnisizeBroadPhase::as_query_pipeline,
        )
        .with_validation(UnisizeBroadPhase::validate)
    };
    let comparison = Comparison {
        steps,
        repeats: 0,
        ..Comparison::new(kind, bodies, 1)
    };
    // The default's pairs are all of those whose boxes overlap: so first, it is these that must be the same.
    let boxes = comparison.run(&candidate(ALL_PAIRS));
    let shapes = candidate(PairFilter::Shapes).leaving_out_more();
    boxes
        .first_difference
        .or_else(|| comparison.run(&shapes).first_difference)
}

/// The hash of all events of a scene, as of `scenes_are_golden` in `tests/golden`.
pub(crate) fn golden(kind: SceneKind) -> u64 {
    let mut scene = Scene::build(kind, 60, 1);
    let settings = Settings::default().with_filter(ALL_PAIRS);
    let observed = Observed::new(UnisizeBroadPhase::with_settings(settings)).with_events();
    let mut broad_phase = install(observed);
    let mut hash = Hash::default();
    for _ in 0..100 {
        scene.step(broad_phase.for_step(), &(), &());
        write(&mut hash, &broad_phase.take_events());
    }
    hash.0
}

fn write(hash: &mut Hash, events: &[PairEvent]) {
    hash.write(events.len() as u32);
    for event in events {
        hash.write(u32::from(event.is_add()));
        let pair = event.pair();
        for handle in [pair.collider1, pair.collider2] {
            let (index, generation) = handle.into_raw_parts();
            hash.write(index);
            hash.write(generation);
        }
    }
}
