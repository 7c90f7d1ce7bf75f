//! Boxes that are handed over, for colliders that are known and for others, and what a snapshot has of them.

use super::super::Desk;
use super::super::rapier::parry::query::DefaultQueryDispatcher;
use super::*;

impl Desk {
    /// Hands over the boxes of colliders as they are.
    fn hand_over(&mut self, handles: &[ColliderHandle]) {
        let boxes = handles.iter().map(|&handle| {
            let collider = &self.colliders[handle];
            let aabb = collider.compute_broad_phase_aabb(&self.params, &self.bodies);
            (handle, aabb)
        });
        let boxes: Vec<_> = boxes.collect();
        self.broad_phase.set_aabbs(&self.params, &boxes);
    }
}

/// Its box has no margin, however many boxes were passed for it.
#[test]
fn the_next_update_reads_a_collider_that_is_not_known() {
    let mut desk = Desk::default();
    let known = desk.ball(0.5, [0.0, 0.0]);
    desk.update(&[known], &[]);
    // In the corner of its box, and away from it.
    let other = desk.ball(0.5, [0.9, 0.8]);
    desk.hand_over(&[other]);
    desk.place(other, [0.8, 0.8]);
    desk.hand_over(&[other]);
    assert_eq!(desk.update(&[], &[]), []);
    assert_eq!(desk.counts(), [2, 0, 0]);
    desk.place(other, [0.6, 0.6]);
    desk.hand_over(&[other]);
    assert_eq!(desk.update(&[], &[]), [(true, [known, other])]);
}

#[cfg(feature = "serde-serialize")]
#[test]
fn what_is_in_a_snapshot_must_make_sense() {
    use serde_json::{Value, json};

    fn complaint(desk: &Desk, change: impl Fn(&mut Value)) -> String {
        let mut damaged = serde_json::to_value(&desk.broad_phase).unwrap();
        let before = damaged.clone();
        change(&mut damaged["table"]);
        assert_ne!(damaged, before, "nothing was changed");
        let outcome = serde_json::from_value::<UnisizeBroadPhase>(damaged);
        outcome.expect_err("it is accepted").to_string()
    }
    type Change = fn(&mut Value);
    let damages: [(&str, Change); 6] = [
        ("for no update", |table| {
            table["gathered"]["is_begun"] = json!(false)
        }),
        ("can be counted", |table| {
            table["gathered"]["listed"] = json!(1_u64 << 40)
        }),
        ("no collider", |table| table["pending"] = json!([])),
        ("out of range", |table| {
            table["tracker"]["touched"][0][0] = json!(77)
        }),
        ("not valid", |table| {
            table["tracker"]["touched"][0][1]["mins"][0] = json!(99.0);
        }),
        ("filter key", |table| {
            let key = table["tracker"]["proxies"][0]["key"].clone();
            table["tracker"]["other_keys"] = json!([[0, key]]);
        }),
    ];
    // Two balls that touch, of which one has been moved on, and one that the broad phase does not know yet.
    let mut desk = Desk::default();
    let handles = [0.0, 0.9, 9.0].map(|x| desk.ball(0.5, [x, 0.0]));
    desk.update(&handles[..2], &[]);
    desk.place(handles[1], [8.5, 0.0]);
    desk.hand_over(&handles[1..]);
    for (part, change) in damages {
        let said = complaint(&desk, change);
        assert!(said.contains(part), "{said}");
    }
    // Two that may not meet are no candidate.
    let mut desk = Desk::default();
    let handles = [0.0, 0.5].map(|x| desk.ball(0.5, [x, 0.0]));
    for handle in handles {
        desk.colliders[handle].set_active_collision_types(ActiveCollisionTypes::empty());
    }
    assert_eq!(desk.update(&handles, &[]), []);
    let said = complaint(&desk, |table| table["tracker"]["near"] = json!([[0, 1]]));
    assert!(said.contains("near"), "{said}");
}

/// What a ray along the first axis hits first at this height, which comes from far outside.
fn hit(desk: &Desk, height: Real) -> Option<ColliderHandle> {
    let (bodies, colliders) = (&desk.bodies, &desk.colliders);
    let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
    let broad_phase = &desk.broad_phase;
    let scene = broad_phase.as_query_pipeline(dispatcher, bodies, colliders, filter);
    let ray = Ray::new(Vector::X * -99.0 + Vector::Y * height, Vector::X);
    let (handle, _) = scene.cast_ray(&ray, Real::MAX, true)?;
    Some(handle)
}

/// Many times between two updates, and each time beyond the margin.
#[test]
fn queries_see_the_boxes_of_every_hand_over() {
    let mut desk = Desk::default();
    let place = |i| 2.0 * i as Real;
    let handles: Vec<_> = (0..8).map(|i| desk.ball(0.5, [place(i), 0.0])).collect();
    desk.update(&handles, &[]);
    for round in 1..=12 {
        let height = 10.0 * round as Real;
        for (i, &handle) in handles.iter().enumerate() {
            desk.place(handle, [place(i), height]);
        }
        desk.hand_over(&handles);
        assert_eq!(hit(&desk, height), Some(handles[0]), "round {round}");
        desk.broad_phase.validate();
    }
}

/// The index of what is gone may have another collider by now, which stays where it is.
#[test]
fn a_box_for_an_earlier_generation_is_ignored() {
    let mut desk = Desk::default();
    let [other, gone] = [9.0, 0.0].map(|height| desk.ball(0.5, [0.0, height]));
    desk.update(&[other, gone], &[]);
    let aabb = desk.colliders[other].compute_aabb();
    let (islands, bodies) = (&mut IslandManager::new(), &mut desk.bodies);
    let colliders = &mut desk.colliders;
    colliders.remove(gone, islands, bodies, &mut SoftBodySet::new(), false);
    let present = desk.ball(0.5, [0.0, 0.0]);
    assert_eq!(gone.into_raw_parts().0, present.into_raw_parts().0);
    desk.update(&[present], &[gone]);
    for _ in 0..2 {
        desk.broad_phase.set_aabb(&desk.params, gone, aabb);
        assert_eq!(hit(&desk, 0.0), Some(present));
        assert_eq!(desk.update(&[], &[]), []);
    }
    assert_eq!(desk.counts(), [2, 0, 0]);
}
