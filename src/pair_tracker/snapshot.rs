//! A tracker as it is written and read by serde.
//!
//! Pairs depend on boxes alone, but the order in which changes are reported depends on more: on reaches, on the order of
//! the candidates, on when there were full runs. All of that is written, so that a tracker that was read goes on as
//! the one that was written does. What can be told from it is not written but made anew: which candidates are held,
//! links, sorted layers. What is written is checked when it is read, so whatever it was, the tracker is in order.

use serde::{Deserialize, Serialize};

use super::candidates::CandidatesSnapshot;
use super::layers::LayersSnapshot;
use super::{Horizon, Layers, PairTracker};
use crate::stopwatch::Stopwatch;
use crate::{Aabb, Real};

/// What decides the changes to come.
#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "R: Serialize", deserialize = "R: Real + Deserialize<'de>"))]
pub(crate) struct TrackerSnapshot<R, const D: usize> {
    /// By slot.
    proxies: Vec<Option<Proxy<R, D>>>,
    horizon: Horizon,
    candidates: CandidatesSnapshot,
    layers: LayersSnapshot<R, D>,
}

/// A box and its reach.
#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "R: Serialize", deserialize = "R: Real + Deserialize<'de>"))]
struct Proxy<R, const D: usize> {
    aabb: Aabb<R, D>,
    reach: Aabb<R, D>,
}

impl<R: Real, const D: usize> TrackerSnapshot<R, D> {
    /// A tracker between two updates, with its layers.
    pub(crate) fn new(tracker: &PairTracker<R, D>, layers: &Layers<R, D>) -> Self {
        debug_assert!(!tracker.is_touched(), "an update was not finished");
        let proxies = tracker.boxes.iter().zip(&tracker.reaches);
        Self {
            proxies: proxies
                .map(|(&aabb, &reach)| aabb.is_valid().then_some(Proxy { aabb, reach }))
                .collect(),
            horizon: tracker.horizon,
            candidates: tracker.candidates.snapshot(),
            layers: layers.snapshot(tracker.boxes.len()),
        }
    }

    /// The tracker, and its layers in the place of these, which must be empty.
    ///
    /// # Errors
    /// What is wrong, if it can be no tracker.
    pub(crate) fn restore(
        self,
        layers: &mut Layers<R, D>,
    ) -> Result<PairTracker<R, D>, &'static str> {
        let Self {
            proxies,
            horizon,
            candidates,
            layers: kept_layers,
        } = self;
        if u32::try_from(proxies.len()).is_err() {
            return Err("there are too many slots");
        }
        let mut tracker = PairTracker::default();
        for proxy in proxies {
            let [aabb, reach] = match proxy {
                None => [PairTracker::absent(); 2],
                Some(Proxy { aabb, .. }) if !aabb.is_valid() => {
                    return Err("a box is not valid");
                }
                Some(Proxy { aabb, reach }) if !reach.contains(&aabb) => {
                    return Err("a box is not in its reach");
                }
                Some(Proxy { aabb, reach }) => [aabb, reach],
            };
            tracker.boxes.push(aabb);
            tracker.reaches.push(reach);
        }
        tracker.previous = tracker.boxes.clone();
        if !horizon.is_sound() {
            return Err("no horizon is like that");
        }
        tracker.horizon = horizon;
        let mut found = Vec::new();
        Layers::Grid(Box::default()).find_all(
            &tracker.reaches,
            &mut found,
            &mut Stopwatch::default(),
        );
        tracker.candidates = candidates.restore(&tracker.boxes, found)?;
        layers.restore(kept_layers, &tracker.reaches)?;
        Ok(tracker)
    }
}
