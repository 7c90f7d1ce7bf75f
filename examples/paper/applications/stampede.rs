//! A herd in a stampede: boxes are enlarged to find neighbours, and animals avoid those with which the broad phase holds a pair.

use crate::page::Page;
use crate::progress::progress_bar;
use crate::race::Times;
use crate::table::{Table, digits};
use anyhow::{Result, ensure};
use rapier2d::prelude::*;
use std::time::Instant;
use unisize::rapier2d_027::UnisizeBroadPhase;
use unisize::{Aabb, GridSweep, PairFinder};
use unisize_scenes::Stampede;

const HERDS: [usize; 2] = [10_000, 100_000];
const FRAMES: usize = 200;

const QUICK_HERD: usize = 500;
const QUICK_FRAMES: usize = 20;

pub(super) fn run(page: &Page, quick: bool) -> Result<()> {
    let (herds, frames) = if quick {
        (&[QUICK_HERD][..], QUICK_FRAMES)
    } else {
        (&HERDS[..], FRAMES)
    };
    let bar = progress_bar((herds.len() * frames) as u64);
    bar.set_message("stampede");
    let mut table = Table::new([
        "animals",
        "pairs of neighbours",
        "run into each other if blind",
        "if they avoid",
        "Rapier's broad phase, ms",
        "unisize, ms",
        "ratio",
        "GridSweep without Rapier, ms",
        "avoidance from the pairs, ms",
    ]);
    for &count in herds {
        let mut herd = Herd::new(count);
        let mut blind = Stampede::new(count, 7);
        for _ in 0..frames {
            herd.advance()?;
            blind.advance([]);
            bar.inc(1);
        }
        let mut blind_pairs = Vec::new();
        GridSweep::default().find_pairs(&boxes(&blind), &mut blind_pairs)?;
        let pairs = &herd.pairs;
        let mut row = vec![count.to_string(), pairs.len().to_string()];
        row.push(blind.collisions(blind_pairs).to_string());
        row.push(herd.herd.collisions(pairs.iter().copied()).to_string());
        let [default, ours, kernel, avoidance] = &herd.times;
        let ratio = default.mean() / ours.mean();
        let means = [
            default.mean(),
            ours.mean(),
            ratio,
            kernel.mean(),
            avoidance.mean(),
        ];
        row.extend(means.map(digits));
        table.push(row);
    }
    bar.finish_and_clear();
    page.put("stampede", &table)
}

/// The herd, with a collider for each neighbourhood, and the two broad phases that follow them.
struct Herd {
    herd: Stampede,
    params: IntegrationParameters,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    handles: Vec<(RigidBodyHandle, ColliderHandle)>,
    listed: Vec<ColliderHandle>,
    default: DefaultBroadPhase,
    ours: UnisizeBroadPhase,
    kernel: GridSweep<f32, 2>,
    /// The number of pairs that the default broad phase holds.
    default_pairs: usize,
    /// The pairs that unisize holds.
    pairs: Vec<[u32; 2]>,
    /// The times of the default broad phase, of unisize, of the kernel alone, and of avoidance.
    times: [Times; 4],
}

impl Herd {
    fn new(count: usize) -> Self {
        let herd = Stampede::new(count, 7);
        let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
        let handles: Vec<_> = herd
            .places()
            .iter()
            .map(|&place| {
                let body = RigidBodyBuilder::kinematic_position_based().translation(place.into());
                let body = bodies.insert(body);
                let half = Stampede::NEIGHBOURHOOD;
                let collider = ColliderBuilder::cuboid(half, half).sensor(true);
                (
                    body,
                    colliders.insert_with_parent(collider, body, &mut bodies),
                )
            })
            .collect();
        Self {
            herd,
            params: IntegrationParameters::default(),
            listed: handles.iter().map(|&(_, collider)| collider).collect(),
            bodies,
            colliders,
            handles,
            default: DefaultBroadPhase::new(),
            ours: UnisizeBroadPhase::new(),
            kernel: GridSweep::default(),
            default_pairs: 0,
            pairs: Vec::new(),
            times: Default::default(),
        }
    }

    /// Finds all neighbours with each broad phase, and goes on to the next frame.
    fn advance(&mut self) -> Result<()> {
        for (&place, &(body, collider)) in self.herd.places().iter().zip(&self.handles) {
            self.colliders[collider].set_translation(place.into());
            self.bodies[body].set_translation(place.into(), false);
        }
        let Self {
            params,
            bodies,
            colliders,
            listed,
            ..
        } = self;
        let mut events = Vec::new();
        let mut update = |broad_phase: &mut dyn BroadPhase, times: &mut Times| {
            events.clear();
            let start = Instant::now();
            broad_phase.update(params, colliders, bodies, listed, &[], &mut events);
            times.push(start.elapsed());
            let is_new =
                |event: &&BroadPhasePairEvent| matches!(event, BroadPhasePairEvent::AddPair(_));
            let added = events.iter().filter(is_new).count();
            (added, events.len() - added)
        };
        let (added, deleted) = update(&mut self.default, &mut self.times[0]);
        self.default_pairs = self.default_pairs + added - deleted;
        update(&mut self.ours, &mut self.times[1]);
        let boxes = boxes(&self.herd);
        let mut pairs = Vec::new();
        let start = Instant::now();
        self.kernel.find_pairs(&boxes, &mut pairs)?;
        self.times[2].push(start.elapsed());

        // Every body has one collider, inserted in the order of the animals, so their indices are the same.
        let index = |collider: ColliderHandle| collider.into_raw_parts().0;
        let start = Instant::now();
        self.pairs.clear();
        let held = self.ours.pairs();
        self.pairs
            .extend(held.map(|pair| [index(pair.collider1), index(pair.collider2)]));
        self.herd.advance(self.pairs.iter().copied());
        self.times[3].push(start.elapsed());
        ensure!(
            self.pairs.len() == self.default_pairs,
            "unisize holds {} pairs, Rapier's broad phase {}",
            self.pairs.len(),
            self.default_pairs
        );
        Ok(())
    }
}

/// The neighbourhoods.
fn boxes(herd: &Stampede) -> Vec<Aabb<f32, 2>> {
    let half = Stampede::NEIGHBOURHOOD;
    let around = |place: &[f32; 2]| Aabb::new(place.map(|x| x - half), place.map(|x| x + half));
    herd.places().iter().map(around).collect()
}
