//! A broad phase that is updated seldom, or with loosened or swept boxes.
//!
//! Boxes are changed through what Rapier's interface has for it. A broad phase loosens every box by half the prediction distance,
//! so a larger distance loosens it by more. With soft CCD it sweeps boxes along the velocity for one time step, which
//! `CollisionPipeline` says is zero. The narrow phase sees neither. The margin comes on top of the one that a broad phase has by
//! itself, and unlike that one it is full again after each update.

use super::scenes::rapier::prelude::*;
use crate::missed::method::Feed;

/// A broad phase that is updated seldom, or with other boxes.
pub(super) struct Fed {
    inner: Box<dyn BroadPhase>,
    interval: usize,
    /// In length units.
    margin: Real,
    /// The time for which boxes are swept if they are.
    dt: Real,
    /// How often it has been called.
    calls: usize,
}

impl Fed {
    pub(super) fn new(
        inner: Box<dyn BroadPhase>,
        feed: Feed,
        typical_size: Real,
        dt: Real,
    ) -> Self {
        Self {
            inner,
            interval: feed.interval,
            margin: feed.margin * typical_size,
            dt: if feed.swept { dt } else { 0.0 },
            calls: 0,
        }
    }
}

/// Whether a broad phase that is updated once in this many steps is updated now, after so many calls.
pub(super) fn is_due(calls: usize, interval: usize) -> bool {
    calls % interval == 0
}

impl BroadPhase for Fed {
    /// If it is due, the lists must have all that was modified since it last was.
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let is_due = is_due(self.calls, self.interval);
        self.calls += 1;
        if !is_due {
            return;
        }
        let loosened = params.prediction_distance() + 2.0 * self.margin;
        let params = IntegrationParameters {
            normalized_prediction_distance: loosened / params.length_unit,
            dt: self.dt,
            ..*params
        };
        let inner = &mut self.inner;
        inner.update(&params, colliders, bodies, modified, removed, events);
    }
}

#[cfg(test)]
mod tests {
    use super::super::scenes::rapier::prelude::*;
    use super::Fed;
    use crate::missed::method::Feed;

    /// The events of updates of two balls of radius 0.5 with this gap, in steps that all list both.
    fn events(gap: Real, feed: Feed, steps: usize) -> Vec<usize> {
        let mut fed = Fed::new(Box::new(DefaultBroadPhase::new()), feed, 1.0, 1.0);
        let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
        let handles: Vec<_> = [0.0, 1.0 + gap]
            .into_iter()
            .map(|x| {
                let mut place: Vector<Real> = Vector::zeros();
                place[0] = x;
                let body = RigidBodyBuilder::dynamic()
                    .translation(place)
                    .linvel(if x > 0.0 { -place } else { place })
                    .soft_ccd_prediction(if feed.swept { 100.0 } else { 0.0 });
                let body = bodies.insert(body);
                colliders.insert_with_parent(ColliderBuilder::ball(0.5), body, &mut bodies)
            })
            .collect();
        let params = IntegrationParameters {
            dt: 0.0,
            ..Default::default()
        };
        let step = |_| {
            let mut events = Vec::new();
            fed.update(&params, &colliders, &bodies, &handles, &[], &mut events);
            events.len()
        };
        (0..steps).map(step).collect()
    }

    #[test]
    fn margins_are_on_both_sides() {
        let margin = |margin| Feed {
            margin,
            ..Feed::PLAIN
        };
        assert_eq!(events(0.5, margin(0.2), 1), [0]);
        assert_eq!(events(0.5, margin(0.3), 1), [1]);
    }

    #[test]
    fn swept_boxes_reach_where_things_go() {
        assert_eq!(events(5.0, Feed::PLAIN, 1), [0]);
        assert_eq!(events(5.0, Feed::SWEPT, 1), [1]);
    }

    #[test]
    fn updates_are_left_out() {
        let seldom = Feed {
            interval: 3,
            ..Feed::PLAIN
        };
        assert_eq!(events(-0.1, seldom, 2), [1, 0]);
        let late: Vec<bool> = (0..7).map(|calls| super::is_due(calls, 3)).collect();
        assert_eq!(late, [true, false, false, true, false, false, true]);
    }
}
