//! A broad phase that forwards every update to ours and checks the answer.

use std::collections::{BTreeMap, BTreeSet};

use super::model::{Changes, Model, Pair, overlap};
use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use super::{HandedOver, Settings, UnisizeBroadPhase, version};
use crate::ops::Sequence;
use unisize::PairFilter;

pub(crate) struct CheckedBroadPhase {
    inner: UnisizeBroadPhase,
    model: Model,
    updates: u64,
    /// The least prediction distance so far.
    prediction: Real,
    /// Boxes handed over since the last update.
    handed_over: usize,
    /// Whether one of them was not that of its collider.
    is_deceived: bool,
}

impl CheckedBroadPhase {
    pub(crate) fn new(sequence: &Sequence) -> Self {
        let settings = Settings::default()
            .with_margin(Real::from(sequence.margin))
            .with_filter(sequence.filter);
        let inner = UnisizeBroadPhase::with_settings(settings);
        Self {
            inner,
            model: Model::new(sequence.filter),
            updates: 0,
            prediction: Real::MAX,
            handed_over: 0,
            is_deceived: false,
        }
    }

    pub(super) fn model(&self) -> &Model {
        &self.model
    }

    /// What must hold after every update, whatever it was.
    fn check_state(&self) {
        let pairs: Vec<_> = self.inner.pairs().map(|p| raw(&p)).collect();
        let stats = self.inner.stats();
        assert_eq!(stats.pairs, pairs.len());
        assert_eq!(&as_set(&pairs), self.model.held(), "held pairs");
        assert_eq!(stats.proxies, self.model.proxies(), "proxies");
        assert_eq!(stats.refused, self.model.refused(), "refused");
        assert_eq!(stats.updates, self.updates, "updates");
        self.inner.validate();
    }

    /// Hands boxes over, where the engine does so. What the last update did and the pairs that are held stay as they are.
    pub(super) fn check_hand_over(
        &mut self,
        params: &IntegrationParameters,
        handed_over: &[HandedOver],
    ) {
        let boxes: Vec<_> = handed_over
            .iter()
            .map(|handed_over| (handed_over.handle, handed_over.aabb))
            .collect();
        let before = self.inner.stats();
        if !version::hand_over(&mut self.inner, params, &boxes) {
            return;
        }
        let (margin, prediction) = (self.margin(params), params.prediction_distance());
        for &HandedOver { handle, aabb, .. } in handed_over {
            self.model.hand_over(handle, aabb, margin, prediction);
        }
        for handed_over in handed_over {
            match handed_over.prediction {
                Some(prediction) => self.prediction = self.prediction.min(prediction),
                None => self.is_deceived = true,
            }
        }
        self.handed_over += boxes.len();
        let mut after = self.inner.stats();
        after.proxies = before.proxies;
        after.refused = before.refused;
        assert_eq!(after, before);
        self.check_state();
    }

    /// Checks that queries see the boxes as they are, each alone and what overlaps each.
    pub(super) fn check_leaves(&self) {
        let (bodies, colliders) = (RigidBodySet::new(), ColliderSet::new());
        let (dispatcher, filter) = (DefaultQueryDispatcher, QueryFilter::default());
        let asked = &self.inner;
        let queries = asked.as_query_pipeline(&dispatcher, &bodies, &colliders, filter);
        let boxes: BTreeMap<_, _> = self.model.boxes().collect();
        let announced = self.model.announced();
        let count = queries.bvh.leaf_count() as usize;
        assert!((boxes.len()..=boxes.len() + announced).contains(&count));
        for (index, aabb) in &boxes {
            let leaf = queries.bvh.leaf_node(*index);
            let leaf = leaf.expect("there is a leaf for it").aabb();
            assert_eq!(leaf, *aabb, "the leaf {index} and its box");
            // Parry does not look at the box of a leaf right below the root.
            let found: BTreeSet<_> = queries.bvh.intersect_aabb(aabb).collect();
            let mut overlapping = boxes.iter().filter(|(_, other)| overlap(aabb, other));
            let missed = overlapping.find(|(other, _)| !found.contains(other));
            assert_eq!(missed, None, "it overlaps the box {index}");
        }
    }

    /// Puts a clone in its place, and then, or not, one that was written and read.
    pub(super) fn renew(&mut self, is_written: bool) {
        self.inner = self.inner.clone();
        #[cfg(feature = "serde-serialize")]
        if is_written {
            let bytes = postcard::to_stdvec(&self.inner).expect("it can be written");
            self.inner = postcard::from_bytes(&bytes).expect("it can be read");
        }
        self.check_state();
    }

    /// How far a renewed box extends beyond its collider.
    fn margin(&self, params: &IntegrationParameters) -> Real {
        let margin = self.inner.settings().margin;
        let margin = margin.expect("each sequence has one");
        (margin * params.length_unit).max(0.0)
    }

    pub(crate) fn check_update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        lists: [&[ColliderHandle]; 2],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let [modified, removed] = lists;
        let mut sent = Vec::new();
        self.inner
            .update(params, colliders, bodies, modified, removed, &mut sent);
        let margin = self.margin(params);
        let are_outgrown = self.model.are_outgrown(margin, params);
        let expected = self.model.update(margin, params, colliders, bodies, lists);

        assert_eq!(changes(&sent), expected, "events");
        assert_in_order(&sent);
        // A box is renewed only when its collider is listed, so it may date from an earlier prediction distance.
        self.prediction = self.prediction.min(params.prediction_distance());
        for pair in &expected.deleted {
            if !self.model.may_meet(pair) || self.is_deceived {
                continue;
            }
            assert_far_apart(pair, self.prediction, colliders);
        }
        if !self.is_deceived {
            for pair in self.model.overlapping() {
                if !self.model.held().contains(&pair) {
                    assert_far_apart(&pair, self.prediction, colliders);
                }
            }
        }
        let listed = modified.len() + removed.len() + std::mem::take(&mut self.handed_over);
        // With volumes, longer extents may let colliders meet that are not listed.
        let has_volumes = self.inner.settings().filter == Some(PairFilter::Shapes);
        let are_read_again = has_volumes && are_outgrown && self.model.known().next().is_some();
        if listed > 0 || are_read_again {
            self.updates += 1;
            let stats = self.inner.stats();
            assert_eq!(stats.added, expected.added.len());
            assert_eq!(stats.deleted, expected.deleted.len());
        }
        self.check_state();
        if self.updates % 4 == 3 {
            self.renew(self.updates % 8 == 7);
        }
        events.append(&mut sent);
    }
}

fn raw(pair: &ColliderPair) -> Pair {
    let pair = [pair.collider1, pair.collider2].map(|handle| handle.into_raw_parts());
    assert!(pair[0].0 < pair[1].0, "{pair:?} is not in order");
    pair
}

/// The pairs as a set, without duplicates.
fn as_set(pairs: &[Pair]) -> BTreeSet<Pair> {
    let set: BTreeSet<_> = pairs.iter().copied().collect();
    assert_eq!(set.len(), pairs.len(), "a pair occurs twice in {pairs:?}");
    set
}

fn changes(events: &[BroadPhasePairEvent]) -> Changes {
    let (mut added, mut deleted) = (Vec::new(), Vec::new());
    for event in events {
        match event {
            BroadPhasePairEvent::AddPair(pair) => added.push(raw(pair)),
            BroadPhasePairEvent::DeletePair(pair) => deleted.push(raw(pair)),
        }
    }
    Changes {
        added: as_set(&added),
        deleted: as_set(&deleted),
    }
}

/// Pairs must end before others begin, each by the smaller index and then the larger one. What begins may be cut in runs after that, which take turns.
fn assert_in_order(events: &[BroadPhasePairEvent]) {
    let keys = events.iter().map(|event| {
        let (is_added, pair) = match event {
            BroadPhasePairEvent::AddPair(pair) => (true, raw(pair)),
            BroadPhasePairEvent::DeletePair(pair) => (false, raw(pair)),
        };
        (is_added, pair.map(|(index, _)| index))
    });
    let keys: Vec<_> = keys.collect();
    let mut sorted = keys.clone();
    sorted.sort_unstable();
    assert!(sorted.is_sorted_by(|a, b| a < b), "twice: {keys:?}");
    let begin = sorted.partition_point(|key| !key.0);
    let added = sorted.split_off(begin);
    let run = added.len().div_ceil(version::RUNS);
    for place in 0..run {
        sorted.extend(added.iter().skip(place).step_by(run));
    }
    assert_eq!(keys, sorted, "not in order");
}

/// A pair that is not held must be farther apart than the prediction distance, by the shapes and not their boxes.
fn assert_far_apart(pair: &Pair, prediction: Real, colliders: &ColliderSet) {
    let [a, b] = pair.map(|(index, generation)| {
        let handle = ColliderHandle::from_raw_parts(index, generation);
        colliders.get(handle).expect("no deletion is due for it")
    });
    let coordinates = [a, b].map(version::coordinates).concat();
    let magnitude = coordinates
        .iter()
        .fold(0.0, |most: Real, x| most.max(x.abs()));
    // A NaN pose has no distance, and very far out the distance itself is inexact.
    if coordinates.iter().any(|x| x.is_nan()) || magnitude > 1.0e3 {
        return;
    }
    if let Some(distance) = version::distance(a, b) {
        let reach = prediction + a.contact_skin() + b.contact_skin();
        let rounding = 1.0e-5 * (1.0 + magnitude);
        assert!(
            distance >= reach - rounding,
            "{pair:?} is not held at a distance of {distance}, within {reach}"
        );
    }
}
