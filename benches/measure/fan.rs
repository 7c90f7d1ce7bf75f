//! Several broad phases that follow one world: one source, compiled once in each dimension.

use std::time::{Duration, Instant};

use super::ours::{Settings, Stats, UnisizeBroadPhase};
use super::scenes::Scene;
use super::scenes::rapier::prelude::*;
use unisize_scenes::SceneKind;

use crate::prices::{FORESIGHTS, Follower, Race, Work};

/// Several broad phases that are given the same updates. Rapier's own one drives the world.
struct Fan {
    default: DefaultBroadPhase,
    ours: Vec<UnisizeBroadPhase>,
    race: Race,
    /// Which one is the first.
    turn: usize,
}

impl BroadPhase for Fan {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let mut unheard = Vec::new();
        // The first one finds the colliders in no cache.
        self.turn = (self.turn + 1) % self.ours.len();
        let all = self.ours.iter_mut().zip(&mut self.race.ours);
        let mut all: Vec<_> = all.collect();
        all.rotate_left(self.turn);
        for (ours, follower) in all {
            unheard.clear();
            let updates = ours.stats().updates;
            let start = Instant::now();
            ours.update(params, colliders, bodies, modified, removed, &mut unheard);
            let time = start.elapsed();
            let stats = ours.stats();
            if stats.updates != updates {
                follower.take(time, work(&stats), stats.full_runs);
            }
        }
        let start = Instant::now();
        self.default
            .update(params, colliders, bodies, modified, removed, events);
        self.race.default += start.elapsed();
    }
}

fn work(stats: &Stats) -> Work {
    let work = stats.work;
    [
        1.0,
        stats.listed as f64,
        work.compared as f64,
        work.picked as f64,
        work.walked as f64,
        work.looked_up as f64,
        work.searched as f64,
        work.found as f64,
    ]
}

/// Follows a scene with each foresight.
pub(crate) fn follow(kind: SceneKind, bodies: usize, steps: usize) -> Race {
    let ours = FORESIGHTS
        .map(|moves| UnisizeBroadPhase::with_settings(Settings::default().with_foresight(moves)));
    let mut fan = Fan {
        default: DefaultBroadPhase::new(),
        ours: ours.into(),
        race: Race {
            scene: kind.name(),
            dim: DIM,
            default: Duration::ZERO,
            ours: FORESIGHTS.map(|_| Follower::default()).into(),
        },
        turn: 0,
    };
    let mut scene = Scene::build(kind, bodies, 1);
    for _ in 0..steps {
        scene.step(&mut fan, &(), &());
    }
    fan.race
}
