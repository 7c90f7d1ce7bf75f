//! A herd in a stampede: boxes are enlarged to find neighbours, and animals avoid those with which the broad phase holds a pair.

use crate::Run;
use anyhow::{Result, ensure};
use rapier2d::prelude::*;
use unisize::rapier2d_027::UnisizeBroadPhase;
use unisize_scenes::Stampede;
use unisize_scenes::dim2::{Observed, Tee, Timing};

const HERDS: [usize; 2] = [10_000, 100_000];
const FRAMES: usize = 200;

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    let (herds, frames) = run.choose((&[500][..], 20), (&HERDS[..], FRAMES));
    for &count in herds {
        let [mut seeing, mut blind] = [0; 2].map(|_| Herd::new(count));
        for _ in 0..frames {
            let pairs = seeing.find_neighbours()?;
            seeing.herd.advance(pairs);
            blind.herd.advance([]);
        }
        let (near, far) = (seeing.find_neighbours()?, blind.find_neighbours()?);
        let mean = |timing: Timing| timing.total.as_secs_f64() * 1e3 / timing.updates as f64;
        let Tee { heard, unheard, .. } = &seeing.broad_phases;
        let [default, ours] = [heard.timing(), unheard.timing()].map(mean);
        for (column, value) in [
            ("pairs of neighbours", near.len() as f64),
            (
                "run into each other if blind",
                blind.herd.collisions(far) as f64,
            ),
            (
                "if they avoid",
                seeing.herd.collisions(near.iter().copied()) as f64,
            ),
            ("Rapier's broad phase, ms", default),
            ("unisize, ms", ours),
            ("ratio", default / ours),
        ] {
            let row = format!("{count} animals");
            run.table.add("stampede", row, column, value);
        }
    }
    Ok(())
}

/// The herd, with a sensor for each neighbourhood, and the two broad phases that follow them.
struct Herd {
    herd: Stampede,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    listed: Vec<ColliderHandle>,
    broad_phases: Tee<Observed<DefaultBroadPhase>, Observed<UnisizeBroadPhase>>,
}

impl Herd {
    fn new(count: usize) -> Self {
        let herd = Stampede::new(count, 7);
        let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
        let half = Stampede::NEIGHBOURHOOD;
        let listed = herd.places().iter().map(|_| {
            let body = bodies.insert(RigidBodyBuilder::kinematic_position_based());
            let collider = ColliderBuilder::cuboid(half, half).sensor(true);
            colliders.insert_with_parent(collider, body, &mut bodies)
        });
        Self {
            listed: listed.collect(),
            herd,
            bodies,
            colliders,
            broad_phases: Tee::new(
                Observed::new(DefaultBroadPhase::new())
                    .clocked()
                    .with_held(),
                Observed::new(UnisizeBroadPhase::new()).clocked(),
            ),
        }
    }

    /// The pairs of neighbours, by both broad phases.
    fn find_neighbours(&mut self) -> Result<Vec<[u32; 2]>> {
        for (&place, &collider) in self.herd.places().iter().zip(&self.listed) {
            self.colliders[collider].set_translation(place.into());
        }
        let (params, mut events) = (IntegrationParameters::default(), Vec::new());
        let Self {
            bodies,
            colliders,
            listed,
            broad_phases,
            ..
        } = self;
        broad_phases.update(&params, colliders, bodies, listed, &[], &mut events);
        // Every body has one collider, inserted in the order of the animals, so their indices are the same.
        let index = |collider: ColliderHandle| collider.into_raw_parts().0;
        let held = broad_phases.unheard.inner.pairs();
        let pairs: Vec<_> = held
            .map(|pair| [index(pair.collider1), index(pair.collider2)])
            .collect();
        let (ours, theirs) = (pairs.len(), broad_phases.heard.held().len());
        ensure!(
            ours == theirs,
            "unisize holds {ours} pairs, Rapier's broad phase {theirs}"
        );
        Ok(pairs)
    }
}
