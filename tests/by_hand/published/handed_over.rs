//! Boxes passed by `set_aabbs`, for known and unknown colliders, and their part in snapshots.

use super::super::Desk;
use super::super::rapier::parry::bounding_volume::BoundingVolume;
use super::super::rapier::parry::query::DefaultQueryDispatcher;
use super::*;

impl Desk {
    /// Passes the current boxes of colliders.
    fn pass_boxes(&mut self, handles: &[ColliderHandle]) {
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
fn the_next_update_reads_an_unknown_collider() {
    let mut desk = Desk::default();
    let known = desk.ball(0.5, [0.0, 0.0]);
    desk.update(&[known], &[]);
    // The boxes overlap at a corner, where the balls are apart.
    let other = desk.ball(0.5, [0.9, 0.8]);
    desk.pass_boxes(&[other]);
    desk.place(other, [0.8, 0.8]);
    desk.pass_boxes(&[other]);
    assert_eq!(desk.update(&[], &[]), []);
    assert_eq!(desk.counts(), [2, 0, 0]);
    desk.place(other, [0.6, 0.6]);
    desk.pass_boxes(&[other]);
    assert_eq!(desk.update(&[], &[]), [(true, [known, other])]);
}

/// Rapier's own broad phase holds the pair in any case, so its narrow phase tests the two at the new distance.
#[test]
fn a_longer_reach_counts_without_a_listed_collider() {
    let mut desk = Desk::default();
    let balls = [desk.ball(0.5, [0.0, 0.0]), desk.ball(0.5, [0.8, 0.8])];
    assert_eq!(desk.update(&balls, &[]), []);
    assert_eq!(desk.update(&[], &[]), []);
    desk.params.normalized_prediction_distance = 0.2;
    assert_eq!(desk.update(&[], &[]), [(true, balls)]);
}

/// A box may reach to where a ball is going, and so does not show where the ball is, even if volumes have reached as far before.
#[test]
fn a_swept_box_is_no_ball_although_volumes_have_reached_as_far() {
    let mut desk = Desk::default();
    let usual = desk.params.normalized_prediction_distance;
    desk.params.normalized_prediction_distance = 0.4;
    let balls = [desk.ball(0.5, [0.0, 0.0]), desk.ball(0.5, [9.0, 0.0])];
    assert_eq!(desk.update(&balls, &[]), []);
    desk.params.normalized_prediction_distance = usual;
    // They touch, and are about to part.
    for (ball, place, step) in [(0, 20.0, -0.38), (1, 20.68, 0.38)] {
        desk.place(balls[ball], [place; 2]);
        let aabb = desk.colliders[balls[ball]].compute_broad_phase_aabb(&desk.params, &desk.bodies);
        let step = (Vector::X + Vector::Y) * step;
        let swept = aabb.merged(&Aabb::new(aabb.mins + step, aabb.maxs + step));
        desk.broad_phase.set_aabb(&desk.params, balls[ball], swept);
    }
    assert_eq!(desk.update(&[], &[]), [(true, balls)]);
}

/// Until the next update, queries see it: its collider may be new, and the removal of the other one not reported yet.
#[test]
fn a_box_for_a_generation_that_does_not_exist_changes_nothing() {
    let mut desk = Desk::with_settings(Settings::default().with_filter(PairFilter::Off));
    let balls = [0.0, 5.0].map(|x| desk.ball(0.5, [x, 0.0]));
    desk.update(&balls, &[]);
    let (slot, generation) = balls[0].into_raw_parts();
    let later = ColliderHandle::from_raw_parts(slot, generation + 9);
    for side in [20.0, Real::NAN] {
        let aabb = Aabb::new((-Vector::ONE * side).into(), (Vector::ONE * side).into());
        desk.broad_phase.set_aabb(&desk.params, later, aabb);
        assert_eq!(desk.update(&[], &[]), []);
        assert_eq!(desk.counts(), [2, 0, 0]);
    }
}

/// A collider has a volume if it had no hooks, and its body few colliders, when it was last listed.
#[cfg(feature = "serde-serialize")]
#[test]
fn a_snapshot_knows_which_colliders_have_volumes() {
    let mut desk = Desk::default();
    let ball = desk.ball(0.5, [0.0, 0.0]);
    let body = desk.bodies.insert(RigidBodyBuilder::dynamic());
    let mut capsules = Vec::new();
    let mut add = |desk: &mut Desk| {
        let Desk {
            colliders, bodies, ..
        } = desk;
        let capsule = ColliderBuilder::capsule_x(0.3, 0.5);
        let capsule = colliders.insert_with_parent(capsule, body, bodies);
        capsules.push(capsule);
        desk.place(capsule, [3.0 * capsules.len() as Real, 9.0]);
        capsule
    };
    let hooked = ColliderBuilder::capsule_x(0.3, 0.5).active_hooks(ActiveHooks::all());
    let hooked = hooked.active_collision_types(ActiveCollisionTypes::all());
    let hooked = desk.colliders.insert(hooked.translation(Vector::X * -9.0));
    let first = add(&mut desk);
    let mut listed: Vec<_> = (1..32).map(|_| add(&mut desk)).collect();
    listed.extend([ball, hooked, first]);
    assert_eq!(desk.update(&listed, &[]), []);
    let last = add(&mut desk);
    assert_eq!(desk.update(&[last], &[]), []);
    let saved = postcard::to_stdvec(&desk.broad_phase).unwrap();
    // The boxes overlap at corners, where the shapes are apart.
    desk.place(first, [1.1, 0.8]);
    desk.place(hooked, [-1.1, 0.8]);
    for _ in 0..2 {
        desk.pass_boxes(&[first, hooked]);
        assert_eq!(desk.update(&[], &[]), [(true, [ball, hooked])]);
        desk.broad_phase = postcard::from_bytes(&saved).unwrap();
    }
}

#[cfg(feature = "serde-serialize")]
#[test]
fn inconsistent_snapshots_are_refused() {
    use serde_json::{Value, json};

    fn error(desk: &Desk, change: impl Fn(&mut Value)) -> String {
        let mut damaged = serde_json::to_value(&desk.broad_phase).unwrap();
        let before = damaged.clone();
        change(&mut damaged["table"]);
        assert_ne!(damaged, before, "nothing was changed");
        let outcome = serde_json::from_value::<UnisizeBroadPhase>(damaged);
        outcome.expect_err("the snapshot is accepted").to_string()
    }
    type Change = fn(&mut Value);
    let damages: [(&str, Change); 6] = [
        ("passed box is not valid", |table| {
            table["pending"][0][1]["mins"][0] = json!(99.0);
        }),
        ("for no update", |table| table["is_begun"] = json!(false)),
        ("no collider", |table| table["pending"] = json!([])),
        ("out of range", |table| {
            table["tracker"]["touched"][0][0] = json!(77)
        }),
        ("not valid", |table| {
            table["tracker"]["touched"][0][1]["mins"][0] = json!(99.0);
        }),
        ("filter key", |table| {
            let key = table["tracker"]["keys"][0].clone();
            table["tracker"]["keys"].as_array_mut().unwrap().push(key);
        }),
    ];
    // Two balls that touch, one of which has then moved, and one that the broad phase does not know yet.
    let mut desk = Desk::default();
    let handles = [0.0, 0.9, 9.0].map(|x| desk.ball(0.5, [x, 0.0]));
    desk.update(&handles[..2], &[]);
    desk.place(handles[1], [8.5, 0.0]);
    desk.pass_boxes(&handles[1..]);
    for (part, change) in damages {
        let error = error(&desk, change);
        assert!(error.contains(part), "{error}");
    }
    // Two colliders that may not form a pair are no candidate.
    let mut desk = Desk::default();
    let handles = [0.0, 0.5].map(|x| desk.ball(0.5, [x, 0.0]));
    for handle in handles {
        desk.colliders[handle].set_active_collision_types(ActiveCollisionTypes::empty());
    }
    assert_eq!(desk.update(&handles, &[]), []);
    let error = error(&desk, |table| table["tracker"]["near"] = json!([[0, 1]]));
    assert!(error.contains("near"), "{error}");
}

/// The first collider that a ray along the x axis hits at this height.
fn hit(desk: &Desk, height: Real) -> Option<ColliderHandle> {
    let (bodies, colliders) = (&desk.bodies, &desk.colliders);
    let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
    let broad_phase = &desk.broad_phase;
    let scene = broad_phase.as_query_pipeline(dispatcher, bodies, colliders, filter);
    let ray = Ray::new(Vector::X * -99.0 + Vector::Y * height, Vector::X);
    let (handle, _) = scene.cast_ray(&ray, Real::MAX, true)?;
    Some(handle)
}

/// Passes boxes several times between two updates, each time outside of the margins.
#[test]
fn queries_use_the_boxes_passed_last() {
    let mut desk = Desk::default();
    let place = |i| 2.0 * i as Real;
    let handles: Vec<_> = (0..8).map(|i| desk.ball(0.5, [place(i), 0.0])).collect();
    desk.update(&handles, &[]);
    for round in 1..=12 {
        let height = 10.0 * round as Real;
        for (i, &handle) in handles.iter().enumerate() {
            desk.place(handle, [place(i), height]);
        }
        desk.pass_boxes(&handles);
        assert_eq!(hit(&desk, height), Some(handles[0]), "round {round}");
        desk.broad_phase.validate();
    }
}

/// Threads note them in another order, and CCD visits leaves in the order of the tree.
#[test]
fn the_tree_does_not_depend_on_the_order_of_passed_boxes() {
    let leaves = |is_reversed: bool| {
        let mut desk = Desk::default();
        let place = |i| 2.0 * i as Real;
        let balls = (0..100).map(|i| desk.ball(0.5, [place(i), 0.0]));
        let handles: Vec<_> = balls.collect();
        desk.update(&handles, &[]);
        assert_eq!(hit(&desk, 0.0), Some(handles[0]));
        let mut moved: Vec<_> = handles.into_iter().step_by(17).collect();
        for (i, &handle) in moved.iter().enumerate() {
            desk.place(handle, [50.0, place(i)]);
        }
        if is_reversed {
            moved.reverse();
        }
        desk.pass_boxes(&moved);
        let (bodies, colliders) = (&desk.bodies, &desk.colliders);
        let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
        let broad_phase = &desk.broad_phase;
        let scene = broad_phase.as_query_pipeline(dispatcher, bodies, colliders, filter);
        let everywhere = Aabb::new(Vector::splat(-1.0e9), Vector::splat(1.0e9));
        scene.bvh.intersect_aabb(&everywhere).collect::<Vec<_>>()
    };
    assert_eq!(leaves(false).len(), 100);
    assert_eq!(leaves(false), leaves(true));
}

/// The index of a removed collider may belong to another collider by now, whose box must not change.
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
