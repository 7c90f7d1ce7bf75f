//! Broad phases that find all pairs anew at each update, and report how they differ from those of the update before.
//!
//! Floors and walls are many times larger than anything that moves, and would spoil a method that relies on a common size. So
//! boxes larger than any that can move are set apart and compared with all others, one by one.
//!
//! Memory is kept from update to update. The pairs found are sorted by comparison, in **O(p log p)**, to be compared with those
//! held.

use super::scenes::rapier::{math::DIM, prelude::*};
use unisize::Aabb;

/// A collider that a broad phase knows.
#[derive(Clone, Copy)]
pub(super) struct Proxy {
    pub(super) handle: ColliderHandle,
    pub(super) can_move: bool,
    pub(super) aabb: Aabb<Real, DIM>,
}

/// What finds all pairs, given all colliders by the index of their handles.
pub(super) trait FindAll: Send + Sync + 'static {
    /// Appends all pairs of indices, the smaller one first.
    fn find(&mut self, proxies: &[Option<Proxy>], pairs: &mut Vec<[u32; 2]>);
}

/// A broad phase that finds all pairs anew at each update.
#[derive(Default)]
pub(super) struct Anew<F> {
    finder: F,
    /// By the index of the collider's handle.
    proxies: Vec<Option<Proxy>>,
    /// The pairs held, as sorted keys.
    held: Vec<u64>,
    /// Scratch memory.
    pairs: Vec<[u32; 2]>,
    found: Vec<u64>,
}

impl<F: FindAll + Default> Anew<F> {
    /// An empty broad phase with this way to find pairs.
    pub(super) fn new(finder: F) -> Self {
        Self {
            finder,
            ..Self::default()
        }
    }
}

impl<F> Anew<F> {
    fn place(&mut self, handle: ColliderHandle, proxy: Option<Proxy>) {
        let slot = handle.into_raw_parts().0 as usize;
        if self.proxies.len() <= slot {
            self.proxies.resize(slot + 1, None);
        }
        self.proxies[slot] = proxy;
    }

    /// Reports how the sorted pairs found differ from those held, and holds them.
    fn replace(&mut self, events: &mut Vec<BroadPhasePairEvent>) {
        let handle = |slot: u32| {
            let proxy = self.proxies[slot as usize];
            proxy
                .expect("the colliders of a held pair are known")
                .handle
        };
        let pair = |key: u64| ColliderPair::new(handle((key >> 32) as u32), handle(key as u32));
        let mut before = self.held.iter().copied().peekable();
        for &key in &self.found {
            while let Some(gone) = before.next_if(|&other| other < key) {
                events.push(BroadPhasePairEvent::DeletePair(pair(gone)));
            }
            if before.next_if_eq(&key).is_none() {
                events.push(BroadPhasePairEvent::AddPair(pair(key)));
            }
        }
        events.extend(before.map(|gone| BroadPhasePairEvent::DeletePair(pair(gone))));
        std::mem::swap(&mut self.held, &mut self.found);
    }
}

impl<F: FindAll> BroadPhase for Anew<F> {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        if modified.is_empty() && removed.is_empty() {
            return;
        }
        for &handle in removed {
            self.place(handle, None);
            let slot = handle.into_raw_parts().0;
            let has = |key: u64| (key >> 32) as u32 == slot || key as u32 == slot;
            self.held.retain(|&key| !has(key));
        }
        for &handle in modified {
            let Some(collider) = colliders.get(handle) else {
                continue;
            };
            let aabb = collider.compute_collision_aabb(params.prediction_distance() / 2.0);
            let body = collider.parent().map(|parent| &bodies[parent]);
            let proxy = Proxy {
                handle,
                can_move: body.is_some_and(|body| !body.is_fixed()),
                aabb: Aabb::new(aabb.mins.coords.into(), aabb.maxs.coords.into()),
            };
            self.place(handle, Some(proxy));
        }
        self.pairs.clear();
        self.finder.find(&self.proxies, &mut self.pairs);
        self.found.clear();
        let keys = self.pairs.iter();
        self.found
            .extend(keys.map(|&[a, b]| u64::from(a) << 32 | u64::from(b)));
        self.found.sort_unstable();
        self.replace(events);
    }
}

/// All boxes: those that are larger on some axis than any that can move, and the others.
#[derive(Default)]
pub(super) struct BySize {
    /// The largest extent of a box that can move, on each axis.
    pub(super) largest: [Real; DIM],
    pub(super) usual: Vec<(u32, Aabb<Real, DIM>)>,
    large: Vec<(u32, Aabb<Real, DIM>)>,
}

impl BySize {
    /// Parts these boxes, in the order of their slots.
    pub(super) fn part(&mut self, proxies: &[Option<Proxy>]) {
        let movable = proxies.iter().flatten().filter(|p| p.can_move);
        self.largest = movable.fold([0.0; DIM], |size: [Real; DIM], proxy| {
            std::array::from_fn(|k| size[k].max(extent(&proxy.aabb, k)))
        });
        let slots = (0..).zip(proxies);
        let boxes = slots.filter_map(|(slot, proxy)| Some((slot, proxy.as_ref()?.aabb)));
        self.usual.clear();
        self.large.clear();
        for (slot, aabb) in boxes {
            let is_usual = (0..DIM).all(|k| extent(&aabb, k) <= self.largest[k]);
            let part = if is_usual {
                &mut self.usual
            } else {
                &mut self.large
            };
            part.push((slot, aabb));
        }
    }

    /// Compares each large box with all others.
    pub(super) fn find_large(&self, pairs: &mut Vec<[u32; 2]>) {
        for (index, &(slot, aabb)) in self.large.iter().enumerate() {
            let others = self.usual.iter().chain(&self.large[..index]);
            for &(other, _) in others.filter(|(_, other)| aabb.overlaps(other)) {
                pairs.push([slot.min(other), slot.max(other)]);
            }
        }
    }
}

/// The extents of all boxes that can move, on one axis.
pub(super) fn movable_extents(
    proxies: &[Option<Proxy>],
    axis: usize,
) -> impl Iterator<Item = Real> + '_ {
    let movable = proxies.iter().flatten().filter(|proxy| proxy.can_move);
    movable.map(move |proxy| extent(&proxy.aabb, axis))
}

pub(super) fn extent(aabb: &Aabb<Real, DIM>, axis: usize) -> Real {
    aabb.maxs[axis] - aabb.mins[axis]
}
