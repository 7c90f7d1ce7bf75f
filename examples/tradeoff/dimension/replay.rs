//! All methods on one simulation that none of them drives.
//!
//! At each step, several instances of every method get the world as it is, in a new random order. The figure of a method is
//! the median over its instances and the mean over steps: an update of unisize that searches takes longer than others, and
//! must count.

use super::broad_phases;
use super::contestant::{Contestant, Lap, Stage};
use super::scenes::Scene;
use super::scenes::rapier::prelude::*;
use super::truth::Truth;
use crate::method::{Margin, Method, Search};
use crate::options::Options;
use crate::study::{Figures, Recall};
use std::time::Duration;
use unisize_scenes::SceneKind;

/// The broad phase that drives.
const DRIVER: Method = Method {
    search: Search::Rapier,
    margin: Margin::Default,
};

/// One in this many steps, the first ones, is not timed: memory is allocated and scenes begin to move.
pub(super) const WARM_UP: usize = 10;

/// Measures all methods.
pub(super) fn run(
    kind: SceneKind,
    options: &Options,
    methods: &[Method],
    typical_size: Real,
    on_step: &mut impl FnMut(),
) -> Vec<Figures> {
    let mut scene = Scene::build(kind, options.bodies(kind), options.seed);
    let mut driver = broad_phases::create(DRIVER, typical_size)
        .with_lists()
        .sorted();
    let mut teams: Vec<_> = methods
        .iter()
        .map(|&method| Team::new(method, options.repeats(), typical_size))
        .collect();
    let mut turns: Vec<_> = (0..methods.len())
        .flat_map(|team| (0..options.repeats()).map(move |member| (team, member)))
        .collect();
    let mut random = oorandom::Rand32::new(options.seed);
    for step in 1..=options.steps() {
        scene.step(&mut driver, &(), &());
        let moved: Vec<_> = (driver.take_updates().into_iter())
            .flat_map(|update| update.modified)
            .collect();
        let mut stage = Stage::of(&scene.world);
        shuffle(&mut turns, &mut random);
        for &(team, member) in &turns {
            let team = &mut teams[team];
            team.laps[member] = team.members[member].step(&mut stage, &moved);
        }
        if step > options.steps() / WARM_UP {
            teams.iter_mut().for_each(Team::take_time);
        }
        if step % options.truth_every() == 0 {
            let truth = Truth::of(&scene.world, typical_size);
            teams.iter_mut().for_each(|team| team.compare(&truth));
        }
        on_step();
    }
    teams.iter().map(Team::figures).collect()
}

pub(super) fn shuffle<T>(turns: &mut [T], random: &mut oorandom::Rand32) {
    for last in (1..turns.len()).rev() {
        turns.swap(last, random.rand_range(0..last as u32 + 1) as usize);
    }
}

/// All instances of one method.
struct Team {
    method: Method,
    /// The first one records its pairs.
    members: Vec<Contestant>,
    /// The times of this step.
    laps: Vec<Lap>,
    /// The times of all steps, one lap each.
    total: Lap,
    timed_steps: u32,
    touching: Recall,
    near: Recall,
    held: usize,
}

impl Team {
    fn new(method: Method, size: usize, typical_size: Real) -> Self {
        let none = Lap {
            broad: Duration::ZERO,
            both: Duration::ZERO,
        };
        let member = |index| {
            let broad_phase = broad_phases::create(method, typical_size);
            Contestant::new(broad_phase, index == 0)
        };
        Self {
            method,
            members: (0..size).map(member).collect(),
            laps: vec![none; size],
            total: none,
            timed_steps: 0,
            touching: Recall::default(),
            near: Recall::default(),
            held: 0,
        }
    }

    fn take_time(&mut self) {
        self.total.broad += median(self.laps.iter().map(|lap| lap.broad));
        self.total.both += median(self.laps.iter().map(|lap| lap.both));
        self.timed_steps += 1;
    }

    fn compare(&mut self, truth: &Truth) {
        let broad_phase = self.members[0].broad_phase();
        let [touching, near] = truth.recall(broad_phase);
        for (sum, recall) in [(&mut self.touching, touching), (&mut self.near, near)] {
            sum.found += recall.found;
            sum.all += recall.all;
        }
        self.held += broad_phase.held().len();
    }

    fn figures(&self) -> Figures {
        let ms = |time: Duration| time.as_secs_f64() * 1e3 / f64::from(self.timed_steps);
        Figures {
            method: self.method,
            touching: self.touching,
            near: self.near,
            held: self.held,
            broad: ms(self.total.broad),
            both: ms(self.total.both),
        }
    }
}

pub(super) fn median(times: impl Iterator<Item = Duration>) -> Duration {
    let mut times: Vec<_> = times.collect();
    times.sort_unstable();
    times[times.len() / 2]
}
