//! The scene simulated on each broad phase alone.
//!
//! The two runs drift apart, since the order of events decides the order in which the solver works, and with it the
//! last bits of its result. So their end states are not compared with each other, but each with what physics
//! demands; see [`Sanity::verdict`](super::Sanity::verdict).

use super::outcome::Independent;
use super::rapier::prelude::*;
use super::{Both, Candidate, Comparison};
use std::time::{Duration, Instant};

impl Comparison {
    /// Simulates the scene on the default alone, then on the candidate alone.
    pub(super) fn run_alone<C: BroadPhase>(
        &self,
        candidate: &Candidate<C>,
        mut on_step: impl FnMut(usize),
    ) -> Both<Independent> {
        Both {
            default: self.run_one(&mut DefaultBroadPhase::new(), &mut on_step),
            candidate: self.run_one(&mut (candidate.create)(), |step| {
                on_step(self.steps + step);
            }),
        }
    }

    fn run_one(
        &self,
        broad_phase: &mut dyn BroadPhase,
        mut on_step: impl FnMut(usize),
    ) -> Independent {
        let mut scene = self.build();
        let initial = scene.sanity();
        let mut elapsed = Duration::ZERO;
        for step in 1..=self.steps {
            let start = Instant::now();
            scene.step(broad_phase, &(), &());
            elapsed += start.elapsed();
            on_step(step);
        }
        let sanity = scene.sanity();
        let verdict = sanity.verdict(&initial);
        Independent {
            sanity,
            verdict,
            elapsed,
        }
    }
}

/// Says so if the candidate's run went wrong where the default's did not.
pub(super) fn difference(runs: &Both<Independent>) -> Option<String> {
    match (&runs.default.verdict, &runs.candidate.verdict) {
        (Ok(()), Err(verdict)) => Some(format!(
            "simulated on the candidate alone: {verdict}, which does not happen on the default"
        )),
        _ => None,
    }
}
