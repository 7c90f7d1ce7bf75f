//! A trial: the world goes on as on Rapier's own broad phase, and the report says what is so.

use super::rapier::prelude::*;
use super::snapshot::{EventLog, Snapshot};
use super::twins::{at, cube, cuboid, dynamic};
use super::{PairFilter, Settings, Steppable, Trial, World, install};

/// A world in which cubes fall on a floor and on each other.
struct Pile {
    world: World,
    cubes: Vec<RigidBodyHandle>,
}

impl Pile {
    const STEPS: usize = 150;

    fn new() -> Self {
        let mut world = World::new(at(0.0, -9.81));
        let floor = cuboid([50.0, 1.0, 50.0]).translation(at(0.0, -1.0));
        world.insert(RigidBodyBuilder::fixed(), floor);
        let place = |i: usize| {
            [
                1.3 * (i % 6) as Real + 0.05 * i as Real,
                1.1 * (i / 6) as Real + 0.6,
            ]
        };
        let cubes = (0..36)
            .map(place)
            .map(|[x, y]| world.insert(dynamic(x, y), cube()));
        let cubes = cubes.collect();
        Self { world, cubes }
    }

    /// One step, before which something changes now and then.
    fn step(&mut self, step: usize, broad_phase: &mut impl Steppable) -> Snapshot {
        let Self { world, cubes } = self;
        let changed = world.bodies[cubes[9]].colliders()[0];
        match step {
            20 => world.remove(cubes[3]),
            40 => world.colliders[changed].set_collision_groups(InteractionGroups::none()),
            60 => world.colliders[changed].set_collision_groups(InteractionGroups::all()),
            80 => world.colliders[changed].set_enabled(false),
            100 => {
                cubes.push(world.insert(dynamic(2.0, 9.0), cube()));
            }
            _ => {}
        }
        let log = EventLog::default();
        world.step(broad_phase.for_step(), &(), &log);
        Snapshot::of(world, log)
    }
}

#[test]
fn a_world_is_the_same_as_on_rapiers_own_broad_phase() {
    let [mut tried, mut own] = [(); 2].map(|()| Pile::new());
    let mut trial = install(Trial::new());
    let mut default = DefaultBroadPhase::new();
    for step in 0..Pile::STEPS {
        let seen = tried.step(step, &mut trial);
        assert!(seen == own.step(step, &mut default), "step {step}");
    }
    let report = trial.report();
    assert_eq!(report.first_difference, None, "{report}");
    assert!(report.updates >= Pile::STEPS as u64);
    let enabled = tried.world.colliders.iter_enabled().count();
    assert_eq!(report.colliders, enabled);
    assert!(report.own.pairs > 10.0);
    for levels in report.levels().windows(2) {
        assert!(levels[0].pairs >= levels[1].pairs);
    }
    for measured in report.levels() {
        let level = measured.level.expect("it is unisize");
        assert_eq!(report.level(level).total, measured.total);
    }
    let shapes = report.level(PairFilter::Shapes);
    assert!(shapes.pairs < report.level(PairFilter::Groups).pairs);
    assert!(
        report
            .to_string()
            .contains("Rapier's own after every update")
    );
}

#[test]
fn pairs_that_differ_are_named() {
    for (margin, is_missing) in [(0.0, true), (0.3, false)] {
        let mut pile = Pile::new();
        let settings = Settings::default().with_margin(margin);
        let mut trial = install(Trial::with_settings(settings));
        for step in 0..Pile::STEPS {
            pile.step(step, &mut trial);
        }
        let report = trial.report();
        let Some(difference) = report.first_difference else {
            panic!("with a margin of {margin} the pairs were the same");
        };
        assert_eq!(difference.is_missing, is_missing);
        assert!(difference.update > 1 && difference.update < Pile::STEPS as u64);
        for collider in difference.colliders {
            let name = format!("{collider:?}");
            assert!(report.to_string().contains(&name), "{report}");
        }
    }
}

#[test]
fn memory_is_told_by_who_counts_it() {
    let mut pile = Pile::new();
    // As if each look at it had taken one more MiB; the memory of events is taken off.
    const MIB: usize = 1 << 20;
    fn allocated() -> usize {
        use std::sync::atomic::{AtomicUsize, Ordering};
        static BYTES: AtomicUsize = AtomicUsize::new(0);
        BYTES.fetch_add(MIB, Ordering::Relaxed)
    }
    let mut trial = install(Trial::new().with_allocated(allocated));
    for step in 0..3 {
        pile.step(step, &mut trial);
    }
    let report = trial.report();
    let own = report.own.bytes.unwrap_or(0);
    assert!(own > 2 * MIB as i64, "{own}");
    assert!(report.levels().iter().all(|level| level.bytes.is_some()));
    assert_eq!(Trial::new().report().own.bytes, None);
}
