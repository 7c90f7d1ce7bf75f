//! All methods on the same frames, each with a narrow phase of its own.
//!
//! As in the study of margins, several instances of every method take turns in a new random order at each step. The figure of a
//! method is the median over its instances and the mean over steps.

use super::broad_phases;
use super::fed::is_due;
use super::reel::{Frame, Reel};
use super::scenes::rapier::prelude::*;
use super::{Contestant, Lap, WARM_UP, median, recall, shuffle};
use crate::missed::method::Method;
use crate::missed::study::Figures;
use crate::options::Options;
use crate::study::Recall;
use std::time::Duration;
use unisize_scenes::SceneKind;

/// Measures all methods.
pub(super) fn run(
    kind: SceneKind,
    options: &Options,
    methods: &[Method],
    typical_size: Real,
    on_step: &mut impl FnMut(),
) -> Vec<Figures> {
    let mut reel = Reel::new(kind, options, typical_size);
    let dt = reel.dt();
    let repeats = options.repeats();
    let mut runners: Vec<_> = methods
        .iter()
        .map(|&method| Runner::new(method, repeats, typical_size, dt))
        .collect();
    let mut turns: Vec<_> = (0..methods.len())
        .flat_map(|runner| (0..repeats).map(move |member| (runner, member)))
        .collect();
    let mut random = oorandom::Rand32::new(options.seed);
    for step in 1..=options.steps() {
        let mut frame = match kind {
            // Bullets hit at certain steps after a volley, so all steps count.
            SceneKind::Bullets => reel.next_straight(true),
            _ => reel.next(step % options.odd_truth_every() == 0),
        };
        for runner in &mut runners {
            runner.list(&frame.moved, step - 1);
        }
        shuffle(&mut turns, &mut random);
        for &(runner, member) in &turns {
            runners[runner].step(member, &mut frame);
        }
        let is_timed = step > options.steps() / WARM_UP;
        for runner in &mut runners {
            if is_timed {
                runner.take_time();
            }
            if let Some(touching) = &frame.touching {
                runner.compare(touching);
            }
        }
        on_step();
    }
    runners.iter().map(Runner::figures).collect()
}

/// All instances of one method.
struct Runner {
    method: Method,
    /// The first one records its pairs.
    members: Vec<Contestant>,
    /// What has moved since the last update.
    pending: Vec<ColliderHandle>,
    /// What is marked as moved in this step: all that is pending if there is an update, what has just moved otherwise.
    listed: Vec<ColliderHandle>,
    /// The times of this step.
    laps: Vec<Lap>,
    /// The times of all steps, one lap each.
    total: Lap,
    timed_steps: u32,
    touching: Recall,
    held: usize,
}

impl Runner {
    fn new(method: Method, size: usize, typical_size: Real, dt: Real) -> Self {
        let none = Lap {
            broad: Duration::ZERO,
            both: Duration::ZERO,
        };
        let member = |index| {
            let broad_phase = broad_phases::create(method, typical_size, dt);
            Contestant::new(broad_phase, index == 0)
        };
        Self {
            method,
            members: (0..size).map(member).collect(),
            pending: Vec::new(),
            listed: Vec::new(),
            laps: vec![none; size],
            total: none,
            timed_steps: 0,
            touching: Recall::default(),
            held: 0,
        }
    }

    /// Lists what is to be marked in a step, after so many others.
    fn list(&mut self, moved: &[ColliderHandle], steps: usize) {
        self.pending.extend(moved);
        self.listed.clear();
        if is_due(steps, self.method.feed.interval) {
            self.listed.append(&mut self.pending);
        } else {
            self.listed.extend(moved);
        }
    }

    fn step(&mut self, member: usize, frame: &mut Frame) {
        let stage = match &mut frame.swept {
            Some(swept) if self.method.feed.swept => swept,
            _ => &mut frame.stage,
        };
        self.laps[member] = self.members[member].step(stage, &self.listed);
    }

    fn take_time(&mut self) {
        self.total.broad += median(self.laps.iter().map(|lap| lap.broad));
        self.total.both += median(self.laps.iter().map(|lap| lap.both));
        self.timed_steps += 1;
    }

    fn compare(&mut self, touching: &[ColliderPair]) {
        let broad_phase = self.members[0].broad_phase();
        let recall = recall(touching, broad_phase);
        self.touching.found += recall.found;
        self.touching.all += recall.all;
        self.held += broad_phase.held().len();
    }

    fn figures(&self) -> Figures {
        let ms = |time: Duration| time.as_secs_f64() * 1e3 / f64::from(self.timed_steps);
        Figures {
            method: self.method,
            touching: self.touching,
            held: self.held,
            broad: ms(self.total.broad),
            both: ms(self.total.both),
        }
    }
}
