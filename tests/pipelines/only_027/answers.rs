//! Asks both broad phases the same, in both of the ways that Rapier offers, and compares the answers.

use std::collections::BTreeSet;
use std::fmt::Debug;

use super::World;
use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use super::watched::Watched;

/// What is nearest, or is hit first.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Nearest {
    collider: (u32, u32),
    /// The bits of the distance or the time.
    distance: u64,
    /// Everything else about it. Numbers are printed so that they read back the same, to the last bit.
    details: String,
}

impl Nearest {
    pub(super) fn new(collider: ColliderHandle, distance: Real, details: impl Debug) -> Self {
        Self {
            collider: collider.into_raw_parts(),
            // The two zeros are equally far.
            distance: f64::from(distance + 0.0).to_bits(),
            details: format!("{details:?}"),
        }
    }
}

impl Watched {
    /// The answers of ours and of Rapier's broad phase.
    fn ask<T: PartialEq + Debug>(
        &mut self,
        filter: QueryFilter<'_>,
        question: impl Fn(&QueryPipeline<'_>) -> T,
    ) -> (T, T) {
        let dispatcher = &DefaultQueryDispatcher;
        let World {
            bodies, colliders, ..
        } = &mut self.world;
        let (unisize, default) = (&self.watchers.unheard, &self.watchers.heard);

        let ours = question(&unisize.as_query_pipeline(dispatcher, bodies, colliders, filter));
        let mutably = unisize.as_query_pipeline_mut(dispatcher, bodies, colliders, filter);
        assert_eq!(ours, question(&mutably.as_ref()), "ours, borrowed mutably");

        let theirs = question(&default.as_query_pipeline(dispatcher, bodies, colliders, filter));
        let mutably = default.as_query_pipeline_mut(dispatcher, bodies, colliders, filter);
        assert_eq!(
            theirs,
            question(&mutably.as_ref()),
            "theirs, borrowed mutably"
        );
        (ours, theirs)
    }

    /// Compares what both find nearest, and returns whether there is anything.
    pub(super) fn compare_nearest(
        &mut self,
        filter: QueryFilter<'_>,
        question: impl Fn(&QueryPipeline<'_>) -> Option<Nearest>,
    ) -> bool {
        let (ours, theirs) = self.ask(filter, &question);
        if ours != theirs {
            // Which of several equally near colliders is found depends on the shape of the tree.
            let nearest = ours.as_ref().zip(theirs.as_ref());
            let are_tied = nearest.is_some_and(|(ours, theirs)| {
                ours.distance == theirs.distance && ours.collider != theirs.collider
            });
            assert!(are_tied, "{ours:#?} is not {theirs:#?}");
            for tied in [&ours, &theirs] {
                let is_it = |handle: ColliderHandle, collider: &Collider| {
                    let tied = tied.as_ref().map(|tied| tied.collider);
                    tied == Some(handle.into_raw_parts())
                        && filter.predicate.is_none_or(|holds| holds(handle, collider))
                };
                let only_it = QueryFilter {
                    predicate: Some(&is_it),
                    ..filter
                };
                let (_, alone) = self.ask(only_it, &question);
                assert_eq!(tied, &alone, "they are not equally near");
            }
        }
        ours.is_some()
    }

    /// Compares all that both find, and returns how many there are.
    pub(super) fn compare_all(
        &mut self,
        filter: QueryFilter<'_>,
        question: impl Fn(&QueryPipeline<'_>) -> Vec<(ColliderHandle, String)>,
    ) -> usize {
        let (ours, theirs) = self.ask(filter, question);
        let count = ours.len();
        let sorted = |found: Vec<(ColliderHandle, String)>| -> BTreeSet<_> {
            let found = found.into_iter();
            found
                .map(|(handle, details)| (handle.into_raw_parts(), details))
                .collect()
        };
        let ours = sorted(ours);
        assert_eq!(ours.len(), count, "ours finds one twice");
        assert_eq!(ours, sorted(theirs), "ours (left) and Rapier's (right)");
        count
    }
}
