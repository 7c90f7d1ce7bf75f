//! The phases of an update: one source, compiled once in each dimension.

#[path = "../update/frames.rs"]
mod frames;

use super::ours::{Settings, UnisizeBroadPhase};
use super::rapier;
use super::rapier::math::DIM;
use super::version;
use crate::{Motion, common, microseconds};
use frames::{Frames, Parents};
use std::time::Duration;
use unisize::PhaseTimes;

/// Numbers of colliders.
const COUNTS: [usize; 4] = [1_000, 10_000, 1 << 17, MOST];

/// Measured only where all are listed and none has a body, for the gain from a second thread.
const MOST: usize = 1 << 20;

/// The largest number of colliders in a smoke test.
const SMOKE_TEST_MAX: usize = 1_000;

const FRAMES_TO_SETTLE: usize = 20;

const FRAMES: usize = 60;

/// A table of every motion with every number of colliders.
pub(crate) fn print() {
    let [head, line] = PhaseTimes::default()
        .by_name()
        .iter()
        .fold([String::new(), String::new()], |[head, line], (name, _)| {
            [head + &format!(" {name} |"), line + "---|"]
        });
    println!("### Update, rapier{DIM}d, microseconds, mean of {FRAMES} frames\n");
    println!("| motion | bodies | n |{head} all | worst frame |");
    println!("|---|---|---|{line}---|---|");
    for motion in Motion::ALL {
        for (parents, are_there) in [(Parents::None, "no"), (Parents::Dynamic, "yes")] {
            for count in COUNTS {
                let is_too_large = common::is_smoke_test() && count > SMOKE_TEST_MAX;
                let is_for_threads = motion.stride() == 1 && matches!(parents, Parents::None);
                if !is_too_large && (count < MOST || is_for_threads) {
                    let cells = measure(motion, parents, count);
                    println!("| {} | {are_there} | {count} |{cells}", motion.name());
                }
            }
        }
    }
    println!();
}

/// The times of each phase, of all together and of the worst frame, as cells of the table.
fn measure(motion: Motion, parents: Parents, count: usize) -> String {
    let mut broad_phase = UnisizeBroadPhase::with_settings(Settings::default().with_timed(true));
    let mut frames = Frames::new(count, motion, parents, &mut broad_phase);
    let [mut all, mut worst] = [Duration::ZERO; 2];
    let mut phases = PhaseTimes::default();
    for frame in 0..FRAMES_TO_SETTLE + FRAMES {
        frames.advance();
        let time = frames.update(&mut broad_phase);
        if frame >= FRAMES_TO_SETTLE {
            all += time;
            worst = worst.max(time);
            phases += broad_phase.stats().times;
        }
    }
    let mean = |time: Duration| microseconds(time / FRAMES as u32);
    let cells = phases.by_name().map(|(_, time)| mean(time));
    format!(
        " {} | {} | {} |",
        cells.join(" | "),
        mean(all),
        microseconds(worst)
    )
}
