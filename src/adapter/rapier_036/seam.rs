//! The trait of a patched Rapier 0.36, whose pipelines accept any broad phase that implements it.

use std::sync::OnceLock;

use super::adapter::{Input, Trial, UnisizeBroadPhase};
use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use super::rapier::geometry::{
    Aabb, BroadPhasePairEvent, ColliderHandle, ColliderSet, CustomBroadPhase, NarrowPhase,
    PipelineInput,
};
use super::rapier::parry::partitioning::Bvh;
use crate::bit_set::BitSet;
use crate::parallel;
use crate::proxy_table::Lists;
use crate::stats::Stats;

/// Looking up a pair in the graphs of a narrow phase takes about as long as reading this many pairs one after the other.
const LOOKUP_COST: usize = 16;

/// The contacts and intersections of a narrow phase, as its last step left them.
struct Contacts<'a> {
    narrow_phase: &'a NarrowPhase,
    /// About so many pairs will be asked for.
    asked: usize,
    /// The indices of the colliders that have an active contact or an intersection; `None` if too few pairs will be asked for.
    touching: OnceLock<Option<BitSet>>,
}

impl<'a> Contacts<'a> {
    /// Finds [`touching`](Self::touching), on one of the threads that ask.
    fn find_touching(&self) -> Option<BitSet> {
        let pairs = || self.narrow_phase.contact_pairs();
        let is_worth_it = self.asked / parallel::threads() > pairs().size_hint().0 / LOOKUP_COST;
        is_worth_it.then(|| {
            let active = pairs().filter(|pair| pair.has_any_active_contact());
            let active = active.map(|pair| [pair.collider1, pair.collider2]);
            let intersections = self.narrow_phase.intersection_pairs();
            let intersecting = intersections.filter(|&(_, _, is_intersecting)| is_intersecting);
            let pairs = active.chain(intersecting.map(|(first, second, _)| [first, second]));
            let indices: Vec<u32> = pairs.flatten().map(index).collect();
            let mut touching = BitSet::default();
            touching.resize(indices.iter().max().map_or(0, |&last| last as usize + 1));
            for i in indices {
                touching.insert(i as usize);
            }
            touching
        })
    }

    /// Whether two colliders have an active contact or an intersection.
    fn is_active(&self, [first, second]: [ColliderHandle; 2]) -> bool {
        let touches_none = |handle| {
            let i = index(handle) as usize;
            let touching = self.touching.get_or_init(|| self.find_touching());
            touching
                .as_ref()
                .is_some_and(|touching| i >= 64 * touching.words().len() || !touching.contains(i))
        };
        if touches_none(first) || touches_none(second) {
            return false;
        }
        // Two colliders have either a contact pair or an intersection pair.
        match self.narrow_phase.contact_pair(first, second) {
            Some(pair) => pair.has_any_active_contact(),
            None => self.narrow_phase.intersection_pair(first, second) == Some(true),
        }
    }
}

/// The index of a handle.
fn index(handle: ColliderHandle) -> u32 {
    handle.into_raw_parts().0
}

/// Calls `run` with the input of a pipeline. The update is expected to end about as many pairs as the last one; a first one asks about many.
fn with_input(input: &PipelineInput<'_>, last: Stats, run: impl FnOnce(&Input<'_>)) {
    let all = usize::MAX * usize::from(last.proxies == 0);
    let contacts = input.narrow_phase.map(|narrow_phase| Contacts {
        narrow_phase,
        asked: last.deleted.max(all),
        touching: OnceLock::new(),
    });
    let is_active = contacts.as_ref().map(|all| |pair| all.is_active(pair));
    run(&Input {
        lists: Lists {
            modified: input.modified,
            reinserted: input.reinserted,
            unmoved: input.unmoved,
            swept: input.swept,
            removed: input.removed,
        },
        skips_unbounded: true,
        felt: input.felt,
        is_active: is_active.as_ref().map(|is_active| is_active as _),
        ..Input::new(input.params, input.colliders, input.bodies, &[], &[])
    });
}

/// Implements the trait; the first argument is the method for updates in a pipeline. What is left differs between the two types.
macro_rules! impl_custom_broad_phase {
    ($name:ident, $run_in_pipeline:ident, $($rest:tt)*) => {
        impl CustomBroadPhase for $name {
            fn update(
                &mut self,
                params: &IntegrationParameters,
                colliders: &ColliderSet,
                bodies: &RigidBodySet,
                modified_colliders: &[ColliderHandle],
                removed_colliders: &[ColliderHandle],
                events: &mut Vec<BroadPhasePairEvent>,
            ) {
                let (modified, removed) = (modified_colliders, removed_colliders);
                self.run(&Input::new(params, colliders, bodies, modified, removed), events);
            }

            fn update_in_pipeline(
                &mut self,
                input: &PipelineInput<'_>,
                events: &mut Vec<BroadPhasePairEvent>,
            ) {
                with_input(input, self.stats(), |input| self.$run_in_pipeline(input, events));
            }

            fn is_empty(&self) -> bool {
                self.stats().proxies == 0
            }

            fn clear(&mut self) {
                self.remove_all();
            }

            fn set_aabb(
                &mut self,
                params: &IntegrationParameters,
                handle: ColliderHandle,
                aabb: Aabb,
            ) {
                self.set_boxes(params, &[(handle, aabb)]);
            }

            fn set_aabbs(
                &mut self,
                params: &IntegrationParameters,
                aabbs: &[(ColliderHandle, Aabb)],
            ) {
                self.set_boxes(params, aabbs);
            }

            fn clone_box(&self) -> Box<dyn CustomBroadPhase> {
                Box::new(self.clone())
            }

            $($rest)*
        }
    };
}

impl_custom_broad_phase! { UnisizeBroadPhase, run_in_pipeline,
    fn visit_unreported(&self, visit: &mut dyn FnMut(ColliderHandle)) {
        self.unreported.iter().copied().for_each(visit);
    }

    fn bvh(&self) -> &Bvh {
        self.tree()
    }
}

impl_custom_broad_phase! { Trial, run,
    fn bvh(&self) -> &Bvh {
        self.own().bvh()
    }
}
