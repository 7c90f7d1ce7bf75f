//! Checks without a page: the contacts of all scenes, as the laboratory's `compare` checks them, and hashes of events, as in `tests/golden`.

use crate::UnisizeBroadPhase;
use crate::engine::{Candidate, Comparison, Observed, Scene, Steppable, install};
use crate::hash::Hash;
use crate::kind;
use crate::version::ALL_PAIRS;
use unisize::{PairFilter, Settings};
use unisize_scenes::SceneKind;
use wasm_bindgen::prelude::*;

/// The names of all scenes.
#[wasm_bindgen]
pub fn scenes() -> Vec<String> {
    SceneKind::ALL.map(|kind| kind.name().to_owned()).into()
}

/// The first difference from Rapier's own broad phase, in pairs, contacts or intersections, after any step of a scene.
///
/// # Errors
///
/// If there is no such scene.
#[wasm_bindgen]
pub fn first_difference(
    scene: &str,
    bodies: usize,
    steps: usize,
) -> Result<Option<String>, JsError> {
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
        ..Comparison::new(kind(scene)?, bodies, 1)
    };
    // With the first filter all pairs must be the same, and with the second the pairs of all shapes that touch.
    let candidates = [
        candidate(ALL_PAIRS),
        candidate(PairFilter::Shapes).leaving_out_more(),
    ];
    Ok(comparison.run(&candidates).first_difference)
}

/// The hash of all events of a scene in hexadecimal digits, as `scenes_are_golden` computes it. It is the same on every platform.
///
/// # Errors
///
/// If there is no such scene.
#[wasm_bindgen]
pub fn golden(scene: &str) -> Result<String, JsError> {
    let mut scene = Scene::build(kind(scene)?, 60, 1);
    let settings = Settings::default().with_filter(ALL_PAIRS);
    let observed = Observed::new(UnisizeBroadPhase::with_settings(settings)).with_events();
    let mut broad_phase = install(observed);
    let mut hash = Hash::default();
    for _ in 0..100 {
        scene.step(broad_phase.for_step(), &(), &());
        let events = broad_phase.take_events();
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
    Ok(format!("{:016x}", hash.0))
}
