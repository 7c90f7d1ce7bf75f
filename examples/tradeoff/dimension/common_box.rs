//! The paper's kernel as published: every box is enlarged to the common size, and every pair that is found is reported.
//!
//! It then needs no test of candidates, but reports pairs whose boxes do not overlap, more of them the more sizes differ. Every
//! update searches all boxes anew. Floors and walls would make the common size that of the world, so boxes larger than any
//! that can move are compared with all others one by one.

use super::scenes::rapier::{math::DIM, prelude::*};
use unisize::{Aabb, PairFinder, RankSweep};

/// The paper's kernel on boxes of one size.
#[derive(Default)]
pub(super) struct CommonBox {
    /// By the index of the collider's handle.
    proxies: Vec<Option<Proxy>>,
    sweep: RankSweep<Real, DIM>,
    /// The pairs held, sorted.
    held: Vec<[u32; 2]>,
}

#[derive(Clone, Copy)]
struct Proxy {
    handle: ColliderHandle,
    can_move: bool,
    aabb: Aabb<Real, DIM>,
}

impl CommonBox {
    fn place(&mut self, handle: ColliderHandle, proxy: Option<Proxy>) {
        let slot = handle.into_raw_parts().0 as usize;
        if self.proxies.len() <= slot {
            self.proxies.resize(slot + 1, None);
        }
        self.proxies[slot] = proxy;
    }

    /// The largest extent of a movable box on each axis.
    fn common_size(&self) -> [Real; DIM] {
        let movable = self.proxies.iter().flatten().filter(|p| p.can_move);
        movable.fold([0.0; DIM], |size, proxy| {
            std::array::from_fn(|k| size[k].max(extent(&proxy.aabb, k)))
        })
    }

    /// All pairs, sorted.
    fn pairs(&mut self) -> Vec<[u32; 2]> {
        let size = self.common_size();
        let (mut slots, mut boxes) = (Vec::new(), Vec::new());
        let (mut large, mut pairs) = (Vec::new(), Vec::new());
        let proxies = self.proxies.iter().enumerate();
        for (slot, proxy) in
            proxies.filter_map(|(slot, proxy)| Some((slot as u32, proxy.as_ref()?)))
        {
            let aabb = proxy.aabb;
            if (0..DIM).all(|k| extent(&aabb, k) <= size[k]) {
                slots.push(slot);
                let mins = aabb.mins;
                let maxs = std::array::from_fn(|k| aabb.maxs[k].max(mins[k] + size[k]));
                boxes.push(Aabb::new(mins, maxs));
            } else {
                large.push((slot, aabb));
            }
        }
        let swept = self.sweep.find_pairs(&boxes, &mut pairs);
        swept.expect("the boxes of a sane scene are valid");
        for pair in &mut pairs {
            *pair = pair.map(|index| slots[index as usize]);
        }
        for (index, &(slot, aabb)) in large.iter().enumerate() {
            let others = slots.iter().map(|&other| {
                let proxy = self.proxies[other as usize].expect("it was just listed");
                (other, proxy.aabb)
            });
            let others = others.chain(large[..index].iter().copied());
            for (other, _) in others.filter(|(_, other)| aabb.overlaps(other)) {
                pairs.push([slot.min(other), slot.max(other)]);
            }
        }
        pairs.sort_unstable();
        pairs
    }

    fn event_pair(&self, pair: [u32; 2]) -> ColliderPair {
        let [first, second] = pair.map(|slot| {
            let proxy = self.proxies[slot as usize];
            proxy
                .expect("the colliders of a held pair are known")
                .handle
        });
        ColliderPair::new(first, second)
    }
}

fn extent(aabb: &Aabb<Real, DIM>, axis: usize) -> Real {
    aabb.maxs[axis] - aabb.mins[axis]
}

impl BroadPhase for CommonBox {
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
            self.held.retain(|pair| !pair.contains(&slot));
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
        let pairs = self.pairs();
        let before = std::mem::replace(&mut self.held, pairs);
        for &pair in &self.held {
            if before.binary_search(&pair).is_err() {
                events.push(BroadPhasePairEvent::AddPair(self.event_pair(pair)));
            }
        }
        for &pair in &before {
            if self.held.binary_search(&pair).is_err() {
                events.push(BroadPhasePairEvent::DeletePair(self.event_pair(pair)));
            }
        }
    }
}
