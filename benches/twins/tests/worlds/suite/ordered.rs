//! Two equal worlds whose broad phases report their pairs in one order, so that solvers do the same in both: for bodies that meet many.

use std::collections::BTreeSet;

use super::rapier::parry::query::contact;
use super::rapier::prelude::*;
use super::snapshot::{EventLog, Pair, Snapshot, pair};
use super::twins::{Twins, assert_alike};
use super::version;
use super::{
    Installed, Observed, OwnBroadPhase, PairFilter, Settings, Steppable, UnisizeBroadPhase, World,
    install,
};

pub(crate) struct Ordered {
    pub(crate) twins: Twins,
    pub(crate) ours: Installed<Observed<UnisizeBroadPhase>>,
    pub(crate) theirs: Installed<Observed<OwnBroadPhase>>,
    filter: Option<PairFilter>,
}

/// Plays at the default level, and at that of Rapier's own broad phase.
pub(crate) fn at_both_levels(play: impl Fn(Ordered)) {
    for filter in [None, Some(version::LEVEL_OF_OWN)] {
        play(Ordered::new(filter));
    }
}

impl Ordered {
    /// With the default level if there is no `filter`.
    pub(crate) fn new(filter: Option<PairFilter>) -> Self {
        let settings = Settings::default().with_filter(filter);
        let ours = UnisizeBroadPhase::with_settings(settings);
        let mut twins = Twins::heavy();
        twins.both(|world| version::look_at_contacts_anew(&mut world.params));
        Self {
            twins,
            ours: install(Observed::new(ours).sorted()),
            theirs: install(Observed::new(OwnBroadPhase::new()).sorted()),
            filter,
        }
    }

    /// Whether both worlds look the same after each step.
    pub(crate) fn are_alike(&self) -> bool {
        self.filter == Some(version::LEVEL_OF_OWN)
    }

    /// Makes one step, and returns what is seen of ours: colliders that overlap have a contact or intersect. At the level of Rapier's own
    /// broad phase, both worlds must look the same. At others, the solver gets contacts in another order, and rounds otherwise.
    pub(crate) fn step(&mut self) -> Snapshot {
        let logs = [EventLog::default(), EventLog::default()];
        let before = [&self.twins.ours, &self.twins.theirs].map(overlaps);
        let Twins { ours, theirs, .. } = &mut self.twins;
        ours.step(self.ours.for_step(), &(), &logs[0]);
        theirs.step(self.theirs.for_step(), &(), &logs[1]);
        self.ours.inner.validate();
        let after = || [&self.twins.ours, &self.twins.theirs].map(overlaps);
        let overlaps = match version::LOOKS_AFTER_MOVES {
            true => after(),
            false => before,
        };
        let seen = self.twins.snapshots(logs);
        for (seen, overlaps) in seen.iter().zip(overlaps) {
            for pair in overlaps {
                let is_seen = seen.contacts.contains(&pair) || seen.intersections.contains(&pair);
                assert!(is_seen, "{pair:?} overlap");
            }
        }
        let [ours, theirs] = seen;
        if self.are_alike() {
            assert_alike(&ours, &theirs);
        }
        ours
    }
}

/// The pairs that overlap and may touch.
fn overlaps(world: &World) -> BTreeSet<Pair> {
    let place = |collider: &Collider| match (collider.parent(), collider.position_wrt_parent()) {
        (Some(body), Some(place)) => *world.bodies[body].position() * *place,
        _ => *collider.position(),
    };
    let all = world.colliders.iter_enabled();
    let all = all.map(|(handle, it)| (handle, it, place(it), it.shape().compute_aabb(&place(it))));
    let all: Vec<_> = all.collect();
    let mut pairs = BTreeSet::new();
    for (i, (a, first, one, aabb)) in all.iter().enumerate() {
        for (b, second, other, other_aabb) in &all[..i] {
            let may_touch = aabb.intersects(other_aabb)
                && world.may_touch(first, second)
                && !are_joined(world, first, second);
            if may_touch
                && contact(one, first.shape(), other, second.shape(), 0.0)
                    .is_ok_and(|found| found.is_some_and(|found| found.dist < -1.0e-3))
            {
                pairs.insert(pair(*a, *b));
            }
        }
    }
    pairs
}

/// Whether a joint keeps the bodies of two colliders from touching.
fn are_joined(world: &World, first: &Collider, second: &Collider) -> bool {
    let (Some(first), Some(second)) = (first.parent(), second.parent()) else {
        return false;
    };
    let mut joints = world.impulse_joints.joints_between(first, second);
    joints.any(|(_, joint)| !joint.data.contacts_enabled)
}
