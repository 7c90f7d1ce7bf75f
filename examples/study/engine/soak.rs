//! An endless world: colliders that rest, drift, jump, come and go, in a mode that changes every few updates.
//!
//! Rapier's collision pipeline makes the lists of each update. The events amount to a set of pairs, which is checked;
//! they are kept from the narrow phase.

use super::ours::UnisizeBroadPhase;
use super::scenes::Observed;
use super::scenes::rapier::prelude::*;
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

/// The world and its state.
pub(crate) struct Soak {
    random: Rand32,
    colliders: ColliderSet,
    bodies: RigidBodySet,
    islands: IslandManager,
    broad_phase: Observed<UnisizeBroadPhase>,
    narrow_phase: NarrowPhase,
    pipeline: CollisionPipeline,
    live: Vec<ColliderHandle>,
    /// How many colliders there are at most.
    most: usize,
    side: Real,
    mode: Mode,
    updates: u64,
}

impl Soak {
    /// A world of this many colliders, with about one pair for each.
    pub(crate) fn new(colliders: usize, seed: u64) -> Self {
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
            most: colliders,
            side: (2.0 * colliders as Real).powf(1.0 / DIM as Real),
            mode: Mode::Rest,
            updates: 0,
        };
        for _ in 0..colliders {
            soak.insert();
        }
        soak
    }

    /// Makes one update.
    pub(crate) fn update(&mut self) {
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
    pub(crate) fn check(&self) {
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

    /// The number of pairs held.
    pub(crate) fn pairs(&self) -> usize {
        self.broad_phase.inner.stats().pairs
    }

    fn change(&mut self) {
        let count = self.live.len();
        let few = count.div_ceil(FEW);
        match self.mode {
            Mode::Rest => {}
            Mode::FewMove => {
                // The same ones as long as the mode lasts, most of the time.
                let first = self.updates / MODE_LENGTH * 37;
                for i in 0..few as u64 {
                    self.drift(self.live[((first + i) % count as u64) as usize]);
                }
            }
            Mode::ManyMove => (0..count).for_each(|i| self.drift(self.live[i])),
            Mode::Tremble => {
                for i in 0..count {
                    let by = 0.002 * (self.random.rand_float() - 0.5);
                    self.shift(self.live[i], Vector::repeat(by));
                }
            }
            Mode::Teleport => {
                for _ in 0..few {
                    let (handle, place) = (self.any(), self.anywhere());
                    self.colliders[handle].set_translation(place);
                }
            }
            Mode::Replace => {
                for _ in 0..few {
                    self.remove();
                    self.insert();
                }
            }
            Mode::Fluctuate => {
                let is_falling = self.updates / 500 % 2 == 0;
                for _ in 0..few {
                    if is_falling && self.live.len() > self.most / 2 {
                        self.remove();
                    } else if !is_falling && self.live.len() < self.most {
                        self.insert();
                    }
                }
            }
            Mode::Blink => {
                for _ in 0..few {
                    let handle = self.any();
                    let is_on = self.random.rand_float() < 0.8;
                    self.colliders[handle].set_enabled(is_on);
                }
            }
            Mode::Spoil => {
                for _ in 0..few {
                    let handle = self.any();
                    let place = if self.random.rand_float() < 0.2 {
                        Vector::repeat(Real::NAN)
                    } else {
                        self.anywhere()
                    };
                    self.colliders[handle].set_translation(place);
                }
            }
            Mode::Resize => {
                for _ in 0..few {
                    let handle = self.any();
                    let radius = 0.3 + 0.4 * self.random.rand_float();
                    self.colliders[handle].set_shape(SharedShape::ball(radius));
                }
            }
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

    fn shift(&mut self, handle: ColliderHandle, by: Vector<Real>) {
        let collider = &mut self.colliders[handle];
        let place = collider.translation() + by;
        collider.set_translation(place);
    }

    /// Moves a collider at its constant velocity, and wraps it around at the ends of the world.
    fn drift(&mut self, handle: ColliderHandle) {
        let index = handle.into_raw_parts().0 as usize;
        let velocity = Vector::from_fn(|k, _| 0.02 * (((index + 1) * (3 + k)) % 7) as Real - 0.06);
        let side = self.side;
        let collider = &mut self.colliders[handle];
        let place = collider.translation() + velocity;
        collider.set_translation(place.map(|x| {
            if x < 0.0 {
                x + side
            } else if x > side {
                x - side
            } else {
                x
            }
        }));
    }
}
