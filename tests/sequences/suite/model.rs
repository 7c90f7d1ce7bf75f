//! What a broad phase has to report, by brute force.

use std::collections::{BTreeMap, BTreeSet};

use super::rapier::parry::bounding_volume::BoundingVolume;
use super::rapier::prelude::*;
use super::version;
use super::volume::{Kind, Volume};
use unisize::PairFilter;

/// The skin of volumes, in margins of boxes.
const SKIN: Real = 0.0625;

/// Two colliders, by index and generation, the smaller index first.
pub(super) type Pair = [(u32, u32); 2];

/// Every known collider, and the pairs that are held: those that overlap and that the filter lets pass.
pub(super) struct Model {
    filter: PairFilter,
    proxies: BTreeMap<u32, Proxy>,
    /// The boxes at the end of the last update.
    settled: BTreeMap<u32, Aabb>,
    held: BTreeSet<Pair>,
    /// The pairs whose boxes overlap, that are not held, and that the keys have allowed since they overlap.
    near: BTreeSet<Pair>,
    /// The indices of colliders that were in such a pair at the end of the last update.
    near_indices: BTreeSet<u32>,
    /// The skin of volumes: a sixteenth of the margin of boxes, with which it grows and does not shrink.
    skin: Real,
    /// The prediction distance for which volumes are large enough. It grows in the same way.
    prediction: Real,
    /// Whether anything was handed over since the last update.
    is_begun: bool,
    /// Colliders that the next update reads, by index and generation, and the boxes that they were handed over with.
    awaited: BTreeMap<(u32, u32), Option<Aabb>>,
}

#[derive(Clone)]
struct Proxy {
    generation: u32,
    /// `None` while the collider's box is not sound.
    aabb: Option<Aabb>,
    key: Key,
    /// That of the collider when a pair last asked for it, or one that differs by no more than the skin.
    volume: Volume,
    /// Whether the collider may have another volume now.
    is_stale: bool,
    /// Whether the next update reads the volume, whether a pair asks for it or not.
    is_noted: bool,
}

/// What filters look at, as of when the collider was last listed.
#[derive(Clone, Copy, PartialEq)]
struct Key {
    body: Option<RigidBodyHandle>,
    body_type: RigidBodyType,
    collision_types: ActiveCollisionTypes,
    groups: InteractionGroups,
}

/// How an update changes the held pairs.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Changes {
    pub(super) added: BTreeSet<Pair>,
    pub(super) deleted: BTreeSet<Pair>,
}

impl Model {
    pub(super) fn new(filter: PairFilter) -> Self {
        Self {
            filter,
            proxies: BTreeMap::new(),
            settled: BTreeMap::new(),
            held: BTreeSet::new(),
            near: BTreeSet::new(),
            near_indices: BTreeSet::new(),
            skin: 0.0,
            prediction: 0.0,
            is_begun: false,
            awaited: BTreeMap::new(),
        }
    }

    /// The sound boxes, by index.
    pub(super) fn boxes(&self) -> impl Iterator<Item = (u32, Aabb)> + '_ {
        let proxies = self.proxies.iter();
        proxies.filter_map(|(&index, proxy)| Some((index, proxy.aabb?)))
    }

    /// For how many indices boxes were handed over, though no collider is known there. Each may have a box for queries.
    pub(super) fn announced(&self) -> usize {
        let indices = self.awaited.keys().map(|&(index, _)| index);
        let unknown = indices.filter(|index| !self.proxies.contains_key(index));
        unknown.collect::<BTreeSet<_>>().len()
    }

    /// A box is handed over between two updates. It counts at once if its collider is known, and keeps what filters look
    /// at; otherwise the next update reads the collider, but for its box, unless a newer one is known.
    pub(super) fn hand_over(
        &mut self,
        handle: ColliderHandle,
        aabb: Aabb,
        margin: Real,
        prediction: Real,
    ) {
        self.is_begun = true;
        let (index, generation) = handle.into_raw_parts();
        if let Some(known) = self.proxies.get(&index).cloned() {
            if known.generation == generation {
                self.follow(index, &aabb, prediction, false);
                return self.renew(handle, aabb, margin, known.key);
            }
            if known.generation > generation {
                return;
            }
            if is_sound(&aabb) {
                self.awaited.insert((index, known.generation), None);
                let proxy = Proxy {
                    aabb: Some(aabb),
                    ..known
                };
                self.proxies.insert(index, proxy);
            }
        }
        let aabb = is_sound(&aabb).then_some(aabb);
        self.awaited.insert((index, generation), aabb);
    }

    pub(super) fn held(&self) -> &BTreeSet<Pair> {
        &self.held
    }

    /// The number of colliders with a sound box.
    pub(super) fn proxies(&self) -> usize {
        let sound = self.proxies.values().filter(|proxy| proxy.aabb.is_some());
        sound.count()
    }

    /// The number of colliders without a sound box.
    pub(super) fn refused(&self) -> usize {
        self.proxies.len() - self.proxies()
    }

    /// Whether this is a collider that the model knows.
    pub(super) fn knows(&self, handle: ColliderHandle) -> bool {
        let (index, generation) = handle.into_raw_parts();
        let known = self.proxies.get(&index);
        known.is_some_and(|proxy| proxy.generation == generation)
    }

    /// The colliders that the model knows.
    pub(super) fn known(&self) -> impl Iterator<Item = ColliderHandle> + '_ {
        let known = self.proxies.iter();
        known.map(|(&index, proxy)| ColliderHandle::from_raw_parts(index, proxy.generation))
    }

    pub(super) fn update(
        &mut self,
        margin: Real,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        [modified, removed]: [&[ColliderHandle]; 2],
    ) -> Changes {
        let is_listed = !(modified.is_empty() && removed.is_empty());
        let is_begun = std::mem::take(&mut self.is_begun) || is_listed;
        for &handle in removed {
            self.forget(handle);
        }
        // Also without a listed collider, if any is known.
        let is_due = is_begun || self.known().next().is_some();
        if is_due && self.are_outgrown(margin, params) {
            self.skin = at_least(self.skin, margin * SKIN);
            self.prediction = at_least(self.prediction, params.prediction_distance());
            for proxy in self.proxies.values_mut() {
                (proxy.is_stale, proxy.is_noted) = (true, true);
                proxy.volume.forget_center();
            }
        }
        let awaited = std::mem::take(&mut self.awaited);
        for &(index, generation) in awaited.keys() {
            if self.knows(ColliderHandle::from_raw_parts(index, generation)) {
                // Its box was passed for another collider.
                self.proxies.get_mut(&index).unwrap().aabb = None;
            }
        }
        let awaited = awaited.into_iter().map(|((index, generation), aabb)| {
            (ColliderHandle::from_raw_parts(index, generation), aabb)
        });
        let awaited = awaited.filter(|(handle, _)| !removed.contains(handle));
        let modified = modified.iter().map(|&handle| (handle, None));
        for (handle, handed_over) in awaited.chain(modified) {
            match colliders.get(handle) {
                Some(collider) if collider.is_enabled() => {
                    let skin = params.prediction_distance() / 2.0;
                    let aabb = collider.compute_collision_aabb(skin);
                    let aabb = handed_over.unwrap_or(aabb);
                    let body = collider.parent().and_then(|body| bodies.get(body));
                    let key = Key {
                        body: collider.parent(),
                        body_type: body.map_or(RigidBodyType::Fixed, |body| body.body_type()),
                        collision_types: collider.active_collision_types(),
                        groups: collider.collision_groups(),
                    };
                    if self.knows(handle) {
                        let index = handle.into_raw_parts().0;
                        self.follow(index, &aabb, params.prediction_distance(), true);
                    }
                    self.renew(handle, aabb, margin, key);
                }
                _ => self.forget(handle),
            }
        }
        self.read_volumes(params, colliders, bodies);

        let mut held = self.overlapping_pairs();
        // What is forbidden after it was held stays.
        held.retain(|pair| {
            let is_allowed = self.held.contains(pair) || self.may_meet(pair);
            is_allowed && self.volumes_meet(pair, 2.0 * margin)
        });
        let sound = self.proxies.iter();
        self.settled = sound
            .filter_map(|(&index, proxy)| Some((index, proxy.aabb?)))
            .collect();
        let before = std::mem::replace(&mut self.held, held);
        let known = self.near.union(&before);
        let known: BTreeSet<_> = known.copied().collect();
        let mut near = self.overlapping_pairs();
        near.retain(|pair| known.contains(pair) || self.may_meet(pair));
        self.near = near.difference(&self.held).copied().collect();
        let indices = self.near.iter().flatten().map(|&(index, _)| index);
        self.near_indices = indices.collect();
        Changes {
            added: self.held.difference(&before).copied().collect(),
            deleted: before.difference(&self.held).copied().collect(),
        }
    }

    /// Whether an update with this margin and these parameters reads all volumes again.
    pub(super) fn are_outgrown(&self, margin: Real, params: &IntegrationParameters) -> bool {
        let extents = [margin * SKIN, params.prediction_distance()];
        extents[0] > self.skin || extents[1] > self.prediction
    }

    /// Whether the filter lets a pair of known colliders pass.
    pub(super) fn may_meet(&self, pair: &Pair) -> bool {
        let [a, b] = pair.map(|(index, _)| self.proxies[&index].key);
        let is_of_one_body = a.body.is_some() && a.body == b.body;
        let types_meet = |key: Key| key.collision_types.test(a.body_type, b.body_type);
        let bodies_meet = !is_of_one_body && (types_meet(a) || types_meet(b));
        match self.filter {
            PairFilter::Off => true,
            PairFilter::Bodies => bodies_meet,
            PairFilter::Groups | PairFilter::Shapes => bodies_meet && a.groups.test(b.groups),
            _ => panic!("there is another filter"),
        }
    }

    /// The distance by which volumes are extended.
    fn extension(&self) -> Real {
        self.prediction / 2.0 + self.skin
    }

    /// The distance by which volumes are extended more than boxes for this prediction distance.
    fn shortfall(&self, prediction: Real) -> Real {
        (self.extension() - prediction / 2.0).max(0.0)
    }

    /// A known collider is in this box now. If it was not listed, a ball follows it; other volumes are stale.
    fn follow(&mut self, index: u32, aabb: &Aabb, prediction: Real, is_listed: bool) {
        let (shortfall, skin) = (self.shortfall(prediction), self.skin);
        let proxy = self.proxies.get_mut(&index).expect("it is known");
        if proxy.volume.kind == Kind::Ball && !is_listed && !proxy.is_stale {
            let ball = proxy.volume.in_box(&aabb.loosened(shortfall));
            let stays = proxy.volume.difference(&ball) <= skin;
            if !stays {
                proxy.volume = ball;
            }
            return;
        }
        proxy.is_stale = true;
        proxy.is_noted |= matches!(proxy.volume.kind, Kind::Ball | Kind::Box)
            || self.near_indices.contains(&index);
    }

    /// Reads the stale volumes that are noted, and those that a pair asks for.
    fn read_volumes(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
    ) {
        if self.filter != PairFilter::Shapes {
            return;
        }
        let noted = self.proxies.iter().filter(|(_, proxy)| proxy.is_noted);
        let noted: Vec<_> = noted.map(|(&index, _)| index).collect();
        self.read_volumes_of(&noted, params, colliders, bodies);
        let overlapping = self.overlapping_pairs();
        let asks = |&pair: &&Pair| match self.held.contains(pair) {
            true => self.is_renewed(pair),
            false => self.may_meet(pair),
        };
        let asking = overlapping.iter().filter(asks);
        let asked: Vec<_> = asking.flatten().map(|&(index, _)| index).collect();
        self.read_volumes_of(&asked, params, colliders, bodies);
    }

    fn read_volumes_of(
        &mut self,
        slots: &[u32],
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
    ) {
        let (extension, skin) = (self.extension(), self.skin);
        let prediction = params.prediction_distance();
        let shortfall = self.shortfall(prediction);
        for index in slots {
            let proxy = self.proxies.get_mut(index).expect("it is known");
            proxy.is_noted = false;
            if !std::mem::take(&mut proxy.is_stale) {
                continue;
            }
            let handle = ColliderHandle::from_raw_parts(*index, proxy.generation);
            let collider = colliders.get(handle);
            let volume = collider.map_or_else(Volume::meeting_all, |collider| {
                let body = collider.parent().and_then(|body| bodies.get(body));
                // Of very many colliders of a body each keeps its box, and so does what has soft CCD.
                let has_volume = |body: &RigidBody| {
                    body.colliders().len() <= 32 && body.soft_ccd_prediction() <= 0.0
                };
                let volume = match body.is_none_or(has_volume) {
                    true => Volume::of(collider, extension),
                    false => Volume::meeting_all(),
                };
                match volume.kind {
                    Kind::Ball => {
                        let aabb = collider.compute_collision_aabb(prediction / 2.0);
                        volume.in_box(&aabb.loosened(shortfall))
                    }
                    _ => volume,
                }
            });
            let stays = proxy.volume.difference(&volume) <= skin;
            if !stays || proxy.volume.is_of_another_kind(&volume) {
                proxy.volume = volume;
            }
        }
    }

    /// Whether a box of a pair differs from that at the end of the last update.
    fn is_renewed(&self, pair: &Pair) -> bool {
        let mut pair = pair.iter();
        pair.any(|(index, _)| self.settled.get(index).copied() != self.proxies[index].aabb)
    }

    /// Whether a pair whose boxes overlap is held, by its volumes: as soon as they meet, until one of its boxes is renewed and
    /// they are farther apart than `slack`.
    fn volumes_meet(&self, pair: &Pair, slack: Real) -> bool {
        if self.filter != PairFilter::Shapes {
            return true;
        }
        let [a, b] = pair.map(|(index, _)| &self.proxies[&index]);
        match self.held.contains(pair) {
            false => a.volume.meets(&b.volume, 0.0),
            true => !self.is_renewed(pair) || a.volume.meets(&b.volume, slack),
        }
    }

    /// The pairs whose boxes overlap and that the filter lets pass but for their volumes.
    pub(super) fn overlapping(&self) -> impl Iterator<Item = Pair> + '_ {
        let pairs = self.overlapping_pairs().into_iter();
        pairs.filter(|pair| self.may_meet(pair))
    }

    /// Drops a collider and its pairs, which end without events.
    fn forget(&mut self, handle: ColliderHandle) {
        if self.knows(handle) {
            let gone = handle.into_raw_parts();
            self.proxies.remove(&gone.0);
            self.settled.remove(&gone.0);
            self.held.retain(|pair| !pair.contains(&gone));
            self.near.retain(|pair| !pair.contains(&gone));
        }
    }

    /// Updates a collider's box: as it is if there was none, or if it is [another leaf](Self::is_another_leaf); else with a
    /// margin and only once the collider has left the last one.
    fn renew(&mut self, handle: ColliderHandle, aabb: Aabb, margin: Real, key: Key) {
        let (index, generation) = handle.into_raw_parts();
        let known = self.proxies.get(&index).map(|proxy| proxy.generation);
        if let Some(stale) = known.filter(|&known| known != generation) {
            self.forget(ColliderHandle::from_raw_parts(index, stale));
        }
        let known = self.proxies.get(&index).cloned();
        let is_another_leaf = known
            .as_ref()
            .is_some_and(|proxy| Self::is_another_leaf(proxy.key, key));
        let held = known.as_ref().and_then(|proxy| proxy.aabb);
        let aabb = match held {
            _ if !is_sound(&aabb) => None,
            None => Some(aabb),
            Some(_) if is_another_leaf => Some(aabb),
            Some(last) => Some(renewed(&last, &aabb, margin)),
        };
        let proxy = match known {
            Some(known) => Proxy { aabb, key, ..known },
            None => Proxy {
                generation,
                aabb,
                key,
                volume: Volume::meeting_all(),
                is_stale: true,
                is_noted: true,
            },
        };
        self.proxies.insert(index, proxy);
    }

    /// Whether a collider that has changed like this is taken out of Rapier's own tree and put in anew.
    fn is_another_leaf(before: Key, now: Key) -> bool {
        let body = |key: Key| (key.body.map(|body| body.into_raw_parts().0), key.body_type);
        version::REINSERTS && (body(before) != body(now) || before.groups != now.groups)
    }

    fn overlapping_pairs(&self) -> BTreeSet<Pair> {
        let sound: Vec<_> = self
            .proxies
            .iter()
            .filter_map(|(&index, proxy)| Some(((index, proxy.generation), proxy.aabb?)))
            .collect();
        let mut pairs = BTreeSet::new();
        for (i, (first, a)) in sound.iter().enumerate() {
            for (second, b) in &sound[i + 1..] {
                if overlap(a, b) {
                    pairs.insert([*first, *second]);
                }
            }
        }
        pairs
    }
}

pub(super) fn overlap(a: &Aabb, b: &Aabb) -> bool {
    (0..DIM).all(|k| a.mins[k] <= b.maxs[k] && b.mins[k] <= a.maxs[k])
}

/// The former number, unless more is wanted: then that, and no less than twice the former one.
fn at_least(former: Real, wanted: Real) -> Real {
    match wanted > former {
        true => wanted.max(2.0 * former),
        false => former,
    }
}

fn is_sound(aabb: &Aabb) -> bool {
    (0..DIM).all(|k| aabb.mins[k] <= aabb.maxs[k])
}

/// The box that is held after a collider that had one has this box.
fn renewed(held: &Aabb, aabb: &Aabb, margin: Real) -> Aabb {
    match contains(held, aabb) {
        true => *held,
        false => aabb.loosened(margin),
    }
}

fn contains(outer: &Aabb, inner: &Aabb) -> bool {
    (0..DIM).all(|k| outer.mins[k] <= inner.mins[k] && inner.maxs[k] <= outer.maxs[k])
}
