//! Whole simulations report the same events in the same order, on every platform and in every version since a hash was stored.

use super::scenes::{Observed, Scene};
use super::{FLAVOUR, PairFilter, Settings, UnisizeBroadPhase};
use crate::hash::Hash;
use crate::hashes::golden;
use unisize_scenes::SceneKind;

#[test]
fn scenes_are_golden() {
    // The ships have pairs within bodies as well.
    for kind in SceneKind::ALL
        .into_iter()
        .filter(|kind| *kind != SceneKind::OneBody)
    {
        let mut scene = Scene::build(kind, 60, 1);
        // With all pairs, also those that can have no effect.
        let settings = Settings::default().with_filter(PairFilter::Off);
        let broad_phase = UnisizeBroadPhase::with_settings(settings);
        let mut broad_phase = Observed::new(broad_phase).with_events();
        let mut hash = Hash::default();
        for _ in 0..100 {
            scene.step(&mut broad_phase, &(), &());
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
        golden(FLAVOUR, kind.name(), &hash);
    }
}
