//! Custom broad phases, which replace the tree of [`BroadPhaseBvh`].

use super::BroadPhaseBvh;
use crate::alloc_prelude::*;
use crate::dynamics::{IntegrationParameters, IslandManager, RigidBody, RigidBodyHandle, RigidBodySet};
use crate::geometry::{
    Aabb, BroadPhasePairEvent, ColliderChanges, ColliderHandle, ColliderPair, ColliderSet, NarrowPhase,
};
use crate::math::Real;
use core::any::Any;
use core::sync::atomic::{AtomicUsize, Ordering};
use parry::bounding_volume::BoundingVolume;
use parry::partitioning::Bvh;

/// The input of an update in a pipeline.
#[derive(Clone, Copy)]
#[non_exhaustive]
pub struct PipelineInput<'a> {
    /// As in [`CustomBroadPhase::update`], like the following two.
    pub params: &'a IntegrationParameters,
    #[allow(missing_docs)]
    pub colliders: &'a ColliderSet,
    #[allow(missing_docs)]
    pub bodies: &'a RigidBodySet,
    /// The narrow phase as the last step left it; `None` if the broad phase is updated by hand.
    pub narrow_phase: Option<&'a NarrowPhase>,
    /// The colliders that Rapier's own broad phase would read.
    pub modified: &'a [ColliderHandle],
    /// The modified colliders whose groups or body have changed, or the type or dominance of the body. They get new boxes, without a margin.
    pub reinserted: &'a [ColliderHandle],
    /// Listed colliders that Rapier's own broad phase would not read. Their boxes stay, even if their contact skin has changed.
    pub unmoved: &'a [ColliderHandle],
    /// The colliders of changed bodies that have soft CCD or whose next rotation is not of unit length, those of all multibodies that are
    /// awake, and colliders that were assigned as a whole, of which nothing tells what has changed. Their boxes stay.
    pub swept: &'a [ColliderHandle],
    /// The modified and unmoved colliders to whose change the narrow phase reacts: it wakes them and the colliders that they form pairs with.
    pub felt: &'a [ColliderHandle],
    /// Removed and disabled colliders.
    pub removed: &'a [ColliderHandle],
}

/// A broad phase that replaces Rapier's own: see [`BroadPhaseBvh::custom`].
pub trait CustomBroadPhase: Any + Send + Sync {
    /// Appends the changes of the pair set to `events`: the contract of [`BroadPhaseBvh::update`].
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
        removed_colliders: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    );

    /// The same in a pipeline, or through [`BroadPhaseBvh::update`].
    fn update_in_pipeline(
        &mut self,
        input: &PipelineInput<'_>,
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.update(
            input.params,
            input.colliders,
            input.bodies,
            input.modified,
            input.removed,
            events,
        );
    }

    /// Whether it has no colliders. A pipeline then passes it the boxes of all colliders, and ends the pairs of its narrow phase that the
    /// update does not report.
    fn is_empty(&self) -> bool {
        false
    }

    /// Removes all colliders; their pairs end without an event. A pipeline calls this before an update if a set of bodies or colliders is not
    /// the one that the last update left: the program has put a clone back, say.
    fn clear(&mut self) {}

    /// Sets the box of a collider, which counts as modified in the next update: the contract of [`BroadPhaseBvh::set_aabb`].
    fn set_aabb(&mut self, params: &IntegrationParameters, handle: ColliderHandle, aabb: Aabb);

    /// Sets the boxes of all colliders that a step has moved.
    fn set_aabbs(&mut self, params: &IntegrationParameters, aabbs: &[(ColliderHandle, Aabb)]) {
        for (handle, aabb) in aabbs {
            self.set_aabb(params, *handle, *aabb);
        }
    }

    /// Visits the colliders that the narrow phase would have woken in the last update if all pairs of overlapping boxes had been reported:
    /// each collider of [`PipelineInput::felt`] that has ever had a pair, and both colliders of each unreported pair of a felt or removed one.
    fn visit_unreported(&self, _visit: &mut dyn FnMut(ColliderHandle)) {}

    /// A tree over the current boxes, for queries and CCD. Its leaves are the indices of handles.
    fn bvh(&self) -> &Bvh;

    /// A copy of the broad phase, for `BroadPhaseBvh::clone`.
    fn clone_box(&self) -> Box<dyn CustomBroadPhase>;
}

impl BroadPhaseBvh {
    /// Replaces Rapier's own broad phase by `broad_phase`, on which the settings of Rapier's own have no effect.
    pub fn custom(broad_phase: impl CustomBroadPhase) -> Self {
        Self {
            custom: Custom::with(Some(Box::new(broad_phase))),
            ..Self::default()
        }
    }

    /// The custom broad phase, if there is one and it is a `T`.
    pub fn custom_ref<T: CustomBroadPhase>(&self) -> Option<&T> {
        let custom: &dyn Any = self.custom.broad_phase.as_deref()?;
        custom.downcast_ref()
    }

    /// The custom broad phase, if there is one and it is a `T`.
    pub fn custom_mut<T: CustomBroadPhase>(&mut self) -> Option<&mut T> {
        let custom: &mut dyn Any = self.custom.broad_phase.as_deref_mut()?;
        custom.downcast_mut()
    }

    /// [`Self::set_aabb`] for many colliders.
    pub(crate) fn set_aabbs(
        &mut self,
        params: &IntegrationParameters,
        aabbs: &[(ColliderHandle, Aabb)],
    ) {
        if let Some(custom) = &mut self.custom.broad_phase {
            return custom.set_aabbs(params, aabbs);
        }
        for (handle, aabb) in aabbs {
            self.set_aabb(params, *handle, *aabb);
        }
    }

    /// [`Self::update`] in a pipeline. A broad phase may be new in a running world, because it was assigned or read from a save. It then
    /// receives also the colliders that an update does not read, and pairs that only its predecessor has reported end.
    pub(crate) fn update_in_pipeline(
        &mut self,
        narrow_phase: &NarrowPhase,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
        removed_colliders: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.custom.note_update(colliders, bodies);
        let is_new = match &self.custom.broad_phase {
            Some(custom) => custom.is_empty(),
            None => self.frame_index == 0 && self.tree.is_empty(),
        };
        if is_new {
            self.set_unread(params, colliders, bodies, modified_colliders);
        }
        let is_custom = self.custom.update(
            Some(narrow_phase),
            params,
            colliders,
            bodies,
            modified_colliders,
            removed_colliders,
            events,
        );
        if !is_custom {
            self.update(
                params,
                colliders,
                bodies,
                modified_colliders,
                removed_colliders,
                events,
            );
        }
        if is_new {
            end_unreported(narrow_phase, colliders, events);
        }
    }

    /// Sets the boxes of the enabled colliders that an update with this list would not read. Boxes of bodies that can move are looser by the
    /// recycle distance: the narrow phase keeps a contact until its bodies have moved that far, so boxes of sleepers that touch may have parted.
    fn set_unread(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
    ) {
        let is_read = |handle: &&ColliderHandle| {
            let collider = colliders.get(**handle);
            collider.is_some_and(|collider| is_read(collider.changes))
        };
        let read = modified_colliders.iter().filter(is_read);
        let mut read: Vec<_> = read.map(|handle| handle.into_raw_parts()).collect();
        read.sort_unstable();
        let slack = params.contact_recycle_distance();
        let has_slack = params.contact_recycling && slack > 0.0;
        let is_finite = |aabb: &Aabb| aabb.mins.is_finite() && aabb.maxs.is_finite();
        for (handle, collider) in colliders.iter_enabled() {
            if read.binary_search(&handle.into_raw_parts()).is_err() {
                let aabb = collider.compute_broad_phase_aabb(params, bodies);
                let body = collider.parent().and_then(|parent| bodies.get(parent));
                let is_looser = has_slack && body.is_some_and(|body| !body.is_fixed());
                let looser = is_looser.then(|| aabb.loosened(slack));
                if let Some(aabb) = looser.filter(is_finite).or(Some(aabb)).filter(is_finite) {
                    self.set_aabb(params, handle, aabb);
                }
            }
        }
    }

    /// The list that takes the colliders of [swept](note_swept) bodies, if there is a custom broad phase.
    pub(crate) fn swept(&mut self) -> Option<&mut Vec<ColliderHandle>> {
        let is_custom = self.custom.broad_phase.is_some();
        is_custom.then_some(&mut self.custom.swept)
    }

    /// Keeps the colliders of links that are awake for the next update: the rotations of multibodies are never renormalized.
    pub(crate) fn note_links(
        &mut self,
        bodies: &RigidBodySet,
        links: impl Iterator<Item = RigidBodyHandle>,
    ) {
        if let Some(swept) = self.swept() {
            let links = links.filter_map(|handle| bodies.get(handle));
            let links = links.filter(|body| !body.is_sleeping());
            swept.extend(links.flat_map(|body| body.colliders().iter().copied()));
        }
    }

    /// Wakes the bodies of unreported pairs, as the narrow phase does for its pairs.
    pub(crate) fn wake_unreported(
        &self,
        islands: &mut IslandManager,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
    ) {
        let Some(custom) = &self.custom.broad_phase else {
            return;
        };
        custom.visit_unreported(&mut |handle| {
            if let Some(parent) = colliders.get(handle).and_then(|collider| collider.parent) {
                islands.wake_up(bodies, parent.handle, true);
            }
        });
    }

    /// The tree for queries and CCD.
    pub fn bvh(&self) -> &Bvh {
        match &self.custom.broad_phase {
            Some(custom) => custom.bvh(),
            None => &self.tree,
        }
    }
}

/// The custom broad phase of a [`BroadPhaseBvh`], if it has one.
#[derive(Default)]
pub(super) struct Custom {
    pub(super) broad_phase: Option<Box<dyn CustomBroadPhase>>,
    /// The number of its last update in a pipeline; `None` before the first one.
    last_update: Option<usize>,
    /// The list of the next update: see [`PipelineInput`].
    swept: Vec<ColliderHandle>,
    /// Scratch: the other lists of an update.
    modified: Vec<ColliderHandle>,
    reinserted: Vec<ColliderHandle>,
    unmoved: Vec<ColliderHandle>,
    felt: Vec<ColliderHandle>,
}

impl Clone for Custom {
    fn clone(&self) -> Self {
        let broad_phase = self.broad_phase.as_ref();
        Self {
            last_update: self.last_update,
            ..Self::with(broad_phase.map(|custom| custom.clone_box()))
        }
    }
}

impl Custom {
    pub(super) fn with(broad_phase: Option<Box<dyn CustomBroadPhase>>) -> Self {
        Self {
            broad_phase,
            last_update: None,
            swept: Vec::new(),
            modified: Vec::new(),
            reinserted: Vec::new(),
            unmoved: Vec::new(),
            felt: Vec::new(),
        }
    }

    /// Notes that an update in a pipeline begins, and clears the broad phase if it has not seen the last update of both sets.
    fn note_update(&mut self, colliders: &ColliderSet, bodies: &RigidBodySet) {
        let update = UPDATES.fetch_add(1, Ordering::Relaxed).wrapping_add(1);
        let sets = [&colliders.last_update, &bodies.last_update];
        let seen = sets.map(|last| Some(last.0.swap(update, Ordering::Relaxed)));
        let last = self.last_update.replace(update);
        if let Some(custom) = &mut self.broad_phase {
            // One that was read from a save is taken to belong to its sets.
            if last.is_some() && seen != [last; 2] {
                custom.clear();
            }
        }
    }

    /// Updates the custom broad phase with the colliders that Rapier's own would read. Returns whether there is one.
    pub(super) fn update(
        &mut self,
        narrow_phase: Option<&NarrowPhase>,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) -> bool {
        let Some(custom) = &mut self.broad_phase else {
            return false;
        };
        let lists = [
            &mut self.modified,
            &mut self.reinserted,
            &mut self.unmoved,
            &mut self.felt,
        ];
        lists.into_iter().for_each(Vec::clear);
        let unfelt = ColliderChanges::IN_MODIFIED_SET | ColliderChanges::DEFORMED;
        for &handle in modified {
            let Some(collider) = colliders.get(handle) else {
                self.modified.push(handle);
                continue;
            };
            let changes = collider.changes;
            if changes.needs_narrow_phase_update()
                && !unfelt.contains(changes)
                && collider.is_enabled()
            {
                self.felt.push(handle);
            }
            // Assigned as a whole, with the flags of another step.
            if !changes.contains(ColliderChanges::IN_MODIFIED_SET) {
                self.swept.push(handle);
            }
            if changes.intersects(REINSERTING) {
                self.reinserted.push(handle);
            }
            match is_read(changes) {
                true => self.modified.push(handle),
                false => self.unmoved.push(handle),
            }
        }
        let input = PipelineInput {
            params,
            colliders,
            bodies,
            narrow_phase,
            modified: &self.modified,
            reinserted: &self.reinserted,
            unmoved: &self.unmoved,
            swept: &self.swept,
            felt: &self.felt,
            removed,
        };
        custom.update_in_pipeline(&input, events);
        self.swept.clear();
        true
    }
}

/// The number of updates in all pipelines.
static UPDATES: AtomicUsize = AtomicUsize::new(0);

/// The number of the last update that has seen a set; 0 before the first one. A clone of the set keeps it. So once the set has been put
/// back, its number is not that of its broad phase.
#[derive(Debug, Default)]
pub(crate) struct LastUpdate(AtomicUsize);

impl Clone for LastUpdate {
    fn clone(&self) -> Self {
        Self(AtomicUsize::new(self.0.load(Ordering::Relaxed)))
    }
}

/// Keeps the colliders of a changed body for the next update if it has soft CCD or is kinematic and its next rotation is not of unit length.
pub(crate) fn note_swept(swept: &mut Vec<ColliderHandle>, body: &RigidBody) {
    let norm = body.next_position().rotation.length_squared();
    let is_off_unit = body.is_kinematic() && !((norm - 1.0).abs() <= 8.0 * Real::EPSILON);
    if body.soft_ccd_prediction() > 0.0 || is_off_unit {
        swept.extend(body.colliders());
    }
}

/// The changes after which Rapier's own broad phase reinserts a collider.
const REINSERTING: ColliderChanges = ColliderChanges::PARENT
    .union(ColliderChanges::PARENT_EFFECTIVE_DOMINANCE)
    .union(ColliderChanges::GROUPS);

/// Whether Rapier's own broad phase reads a listed collider with these changes.
fn is_read(changes: ColliderChanges) -> bool {
    changes.needs_broad_phase_update() || changes.intersects(REINSERTING)
}

/// Ends the pairs of a narrow phase that `events` do not add.
fn end_unreported(
    narrow_phase: &NarrowPhase,
    colliders: &ColliderSet,
    events: &mut Vec<BroadPhasePairEvent>,
) {
    let key = |a: ColliderHandle, b: ColliderHandle| {
        let mut key = [a.into_raw_parts(), b.into_raw_parts()];
        key.sort_unstable();
        key
    };
    let added = events.iter().filter_map(|event| match event {
        BroadPhasePairEvent::AddPair(pair) => Some(key(pair.collider1, pair.collider2)),
        BroadPhasePairEvent::DeletePair(_) => None,
    });
    let mut reported: Vec<_> = added.collect();
    reported.sort_unstable();
    let contacts = narrow_phase.contact_pairs();
    let contacts = contacts.map(|pair| (pair.collider1, pair.collider2));
    let intersections = narrow_phase.intersection_pairs();
    let pairs = contacts.chain(intersections.map(|(a, b, _)| (a, b)));
    for (a, b) in pairs {
        let are_there = colliders.contains(a) && colliders.contains(b);
        if are_there && reported.binary_search(&key(a, b)).is_err() {
            events.push(BroadPhasePairEvent::DeletePair(ColliderPair::new(a, b)));
        }
    }
}
