//! An endless world: colliders that rest, drift, jump, come and go, in a mode that changes every few updates.
//!
//! Rapier's collision pipeline makes the lists of each update. The events amount to a set of pairs, which is checked;
//! they are kept from the narrow phase.

use super::ours::UnisizeBroadPhase;
use super::scenes::Observed;
use super::scenes::rapier::prelude::*;
use crate::soak::{CHECK_EVERY, COLLIDERS, Peaks};
use oorandom::Rand32;

/// How many updates a mode lasts.
const MODE_LENGTH: u64 = 8;

/// One collider in this many is one of a few.
const FEW: usize = 50;

/// What happens during a few consecutive updates.
#[derive(Clone, Copy, Debug)]
enum Mode {
    /// All sleep: nothing is listed.
    Rest,
    /// A few drift.
    FewMove,
    /// All drift.
    ManyMove,
    /// All tremble within their margins.
    Tremble,
    /// A few are suddenly elsewhere.
    Teleport,
    /// A few are removed, and others inserted under their indices.
    Replace,
    /// Their number falls, then rises.
    Fluctuate,
    /// A few are disabled, others enabled.
    Blink,
    /// A few get a position of NaN, others recover from it.
    Spoil,
    /// A few get another size.
    Resize,
}

const MODES: [Mode; 10] = [
    Mode::Rest,
    Mode::FewMove,
    Mode::ManyMove,
    Mode::Tremble,
    Mode::Teleport,
    Mode::Replace,
    Mode::Fluctuate,
    Mode::Blink,
    Mode::Spoil,
    Mode::Resize,
];

/// Makes so many updates: the peaks of memory, and the pairs at the end.
pub(crate) fn run(seed: u64, updates: u64) -> (Peaks, usize) {
    let mut soak = Soak::new(seed);
    let mut peaks = Peaks::default();
    for done in 1..=updates {
        soak.update();
        peaks.note(done, updates);
        if done % CHECK_EVERY == 0 || done == updates {
            soak.check();
        }
    }
    (peaks, soak.broad_phase.inner.stats().pairs)
}

/// The world and its state.
struct Soak {
    random: Rand32,
    colliders: ColliderSet,
    bodies: RigidBodySet,
    islands: IslandManager,
    broad_phase: Observed<UnisizeBroadPhase>,
    narrow_phase: NarrowPhase,
    pipeline: CollisionPipeline,
    live: Vec<ColliderHandle>,
    side: Real,
    mode: Mode,
    updates: u64,
}

impl Soak {
    /// A world of all colliders, with about one pair for each.
    fn new(seed: u64) -> Self {
        let mut soak = Self {
            random: Rand32::new(seed),
            colliders: ColliderSet::new(),
            bodies: RigidBodySet::new(),
            islands: IslandManager::new(),
            // The narrow phase would take nearly all the time, so it hears of nothing.
            broad_phase: Observed::new(UnisizeBroadPhase::new()).with_held().silent(),
            narrow_phase: NarrowPhase::new(),
            pipeline: CollisionPipeline::new(),
            live: Vec::new(),
            side: (2.0 * COLLIDERS as Real).powf(1.0 / DIM as Real),
            mode: Mode::Rest,
            updates: 0,
        };
        for _ in 0..COLLIDERS {
            soak.insert();
        }
        soak
    }

    /// Makes one update.
    fn update(&mut self) {
        if self.updates % MODE_LENGTH == 0 {
            self.mode = MODES[self.random.rand_range(0..MODES.len() as u32) as usize];
        }
        self.updates += 1;
        self.change();
        self.pipeline.step(
            IntegrationParameters::default().prediction_distance(),
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &(),
            &(),
        );
        assert_eq!(self.broad_phase.held_fault(), None, "a contradiction");
    }

    /// Panics unless the broad phase is valid, and holds the pairs that its events amount to.
    fn check(&self) {
        let (inner, held) = (&self.broad_phase.inner, self.broad_phase.held());
        inner.validate();
        let mut count = 0;
        for pair in inner.pairs() {
            count += 1;
            assert!(held.contains(&pair), "{pair:?}");
        }
        assert_eq!(count, held.len(), "pairs held, and pairs by events");
        let stats = inner.stats();
        let known = stats.proxies + stats.refused;
        assert_eq!(known, self.colliders.iter_enabled().count());
    }

    fn change(&mut self) {
        let few = self.live.len().div_ceil(FEW);
        let changed = match self.mode {
            Mode::Rest => Vec::new(),
            Mode::FewMove => self.live[..few].to_vec(),
            Mode::ManyMove | Mode::Tremble => self.live.clone(),
            Mode::Teleport | Mode::Blink | Mode::Spoil | Mode::Resize => {
                (0..few).map(|_| self.any()).collect()
            }
            Mode::Replace => {
                for _ in 0..few {
                    self.remove();
                    self.insert();
                }
                Vec::new()
            }
            Mode::Fluctuate => {
                let is_falling = self.updates / 500 % 2 == 0;
                for _ in 0..few {
                    if is_falling && self.live.len() > COLLIDERS / 2 {
                        self.remove();
                    } else if !is_falling && self.live.len() < COLLIDERS {
                        self.insert();
                    }
                }
                Vec::new()
            }
        };
        for handle in changed {
            self.change_one(handle);
        }
    }

    /// What its mode does to one collider.
    fn change_one(&mut self, handle: ColliderHandle) {
        let (chance, elsewhere) = (self.random.rand_float(), self.anywhere());
        let side = self.side;
        let collider = &mut self.colliders[handle];
        let place = *collider.translation();
        match self.mode {
            Mode::Blink => collider.set_enabled(chance < 0.8),
            Mode::Resize => collider.set_shape(SharedShape::ball(0.3 + 0.4 * chance)),
            Mode::Spoil if chance < 0.2 => collider.set_translation(Vector::repeat(Real::NAN)),
            Mode::Tremble => {
                collider.set_translation(place + Vector::repeat(0.002 * (chance - 0.5)));
            }
            Mode::FewMove | Mode::ManyMove => {
                // At a velocity of its own, and around at the ends of the world.
                let index = handle.into_raw_parts().0 as usize + 1;
                let velocity = |k: usize, _| 0.02 * (index * (3 + k) % 7) as Real - 0.06;
                let place = place + Vector::from_fn(velocity);
                collider.set_translation(place.map(|x| x.rem_euclid(side)));
            }
            _ => collider.set_translation(elsewhere),
        }
    }

    fn any(&mut self) -> ColliderHandle {
        let index = self.random.rand_range(0..self.live.len() as u32);
        self.live[index as usize]
    }

    fn anywhere(&mut self) -> Vector<Real> {
        Vector::from_fn(|_, _| self.random.rand_float() * self.side)
    }

    fn insert(&mut self) {
        let place = self.anywhere();
        let collider = if self.random.rand_float() < 0.5 {
            ColliderBuilder::ball(0.5)
        } else {
            ColliderBuilder::new(SharedShape::new(Cuboid::new(Vector::repeat(0.5))))
        };
        self.live
            .push(self.colliders.insert(collider.translation(place)));
    }

    fn remove(&mut self) {
        let index = self.random.rand_range(0..self.live.len() as u32);
        let handle = self.live.swap_remove(index as usize);
        self.colliders
            .remove(handle, &mut self.islands, &mut self.bodies, false);
    }
}
