//! Does unisize run forever in the same memory?
//!
//! Very many updates are made in which colliders rest, drift, tremble, jump, come and go, and are disabled, resized and given NaN
//! poses. At intervals the broad phase checks itself, and its pairs are compared with its events.

#[path = "../../../../tests/common/allocations.rs"]
mod allocations;

use crate::options::Common;
use crate::output::Output;
use crate::{dim2, dim3};
use allocations::Peaks;
use anyhow::Result;
use clap::Args;
use indicatif::ProgressBar;
use unisize_report::progress_bar;

/// Updates of a quick run and of a full one.
const UPDATES: [usize; 2] = [50_000, 1_000_000];

/// The greatest number of colliders.
const COLLIDERS: usize = 500;

/// Updates from one check to the next.
const CHECK_EVERY: u64 = 1_000;

/// Does unisize run forever in the same memory?
///
/// Exits with 1 if memory later peaks at more than one and a half times its peak in the first tenth of the updates.
#[derive(Args, Clone, Debug)]
pub(crate) struct Arguments {
    #[command(flatten)]
    common: Common,
}

/// Makes so many updates in one dimension: the peaks of memory, and the pairs at the end.
macro_rules! soaked {
    ($soak:ty, $seed:expr, $updates:expr, $bar:expr) => {{
        let (updates, bar): (u64, &ProgressBar) = ($updates, $bar);
        let mut soak = <$soak>::new(COLLIDERS, $seed);
        let mut peaks = Peaks::default();
        for done in 1..=updates {
            soak.update();
            peaks.note(done, updates);
            if done % CHECK_EVERY == 0 || done == updates {
                soak.check();
                bar.set_position(done);
            }
        }
        (peaks, soak.pairs())
    }};
}

impl Arguments {
    /// Runs the study; whether unisize has passed.
    pub(crate) fn run(&self) -> Result<bool> {
        let mut output = Output::create(&self.common)?;
        let usual = self.common.usual(UPDATES);
        let updates = self.common.steps.unwrap_or(usual) as u64;
        let mut is_flat = true;
        for &dim in self.common.dims() {
            for seed in self.common.seeds([1, 1]) {
                let bar = progress_bar(updates);
                bar.set_message(format!("soak {dim}D"));
                let (peaks, pairs) = match dim {
                    2 => soaked!(dim2::soak::Soak, seed, updates, &bar),
                    _ => soaked!(dim3::soak::Soak, seed, updates, &bar),
                };
                bar.finish_and_clear();
                is_flat &= peaks.are_flat();
                output.row(
                    "soak",
                    &[
                        ("dimension", dim.into()),
                        ("seed", seed.into()),
                        ("updates", updates.into()),
                        ("colliders", COLLIDERS.into()),
                        ("pairs", pairs.into()),
                        ("most_bytes_in_first_tenth", peaks.early.into()),
                        ("most_bytes_later", peaks.late.into()),
                    ],
                )?;
            }
        }
        println!(
            "\nMemory {}.",
            if is_flat { "did not grow" } else { "GREW" }
        );
        Ok(is_flat)
    }
}
