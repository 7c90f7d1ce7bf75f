//! Does unisize run forever in the same memory?
//!
//! Very many updates are made in which colliders rest, drift, tremble, jump, come and go, and are disabled, resized and given NaN
//! poses. At intervals the broad phase checks itself, and its pairs are compared with its events.

mod memory;

use crate::options::{Common, at_least_one};
use crate::output::{Output, table};
use crate::progress::progress_bar;
use crate::{dim2, dim3};
use anyhow::Result;
use clap::Args;
use indicatif::ProgressBar;
use memory::{Peaks, live_bytes};
use serde::Serialize;

const UPDATES: usize = 1_000_000;
const QUICK_UPDATES: usize = 50_000;

/// Updates from one check to the next.
const CHECK_EVERY: u64 = 1_000;

/// Does unisize run forever in the same memory?
///
/// Exits with 1 if memory later peaks at more than one and a half times its peak in the first tenth of the updates.
#[derive(Args, Clone, Debug)]
pub(crate) struct Arguments {
    #[command(flatten)]
    common: Common,
    /// The greatest number of colliders
    #[arg(long, value_name = "N", default_value_t = 500, value_parser = at_least_one())]
    colliders: usize,
}

/// What came of all updates in one dimension.
#[derive(Serialize)]
struct Row {
    dimension: u8,
    updates: u64,
    colliders: usize,
    seed: u64,
    pairs_at_end: usize,
    bytes_in_first_tenth: usize,
    bytes_later: usize,
    bytes_at_end: usize,
    is_flat: bool,
}

/// Makes the updates in one dimension, and returns the peaks and the number of pairs held at the end.
macro_rules! soaked {
    ($soak:ty, $colliders:expr, $seed:expr, $updates:expr, $bar:expr) => {{
        let (updates, bar): (u64, &ProgressBar) = ($updates, $bar);
        let mut soak = <$soak>::new($colliders, $seed);
        let mut peaks = Peaks::default();
        for done in 1..=updates {
            soak.update();
            peaks.note(done, updates);
            if done % CHECK_EVERY == 0 || done == updates {
                soak.check();
                bar.set_position(done);
            }
        }
        (peaks, soak.pairs(), live_bytes())
    }};
}

impl Arguments {
    /// Runs the study; whether unisize has passed.
    pub(crate) fn run(&self) -> Result<bool> {
        let mut output = Output::create("soak", &self.common)?;
        let usual = self.common.usual(QUICK_UPDATES, UPDATES);
        let updates = self.common.steps.unwrap_or(usual) as u64;
        let mut table = table([
            "world",
            "updates",
            "colliders",
            "pairs at the end",
            "bytes at most in the first tenth",
            "at most later",
            "at the end",
        ]);
        let mut is_flat = true;
        for &dim in self.common.dims() {
            for seed in self.common.seeds(1, 1) {
                let bar = progress_bar(updates);
                bar.set_message(format!("soak {dim}D"));
                let (peaks, pairs_at_end, bytes_at_end) = match dim {
                    2 => soaked!(dim2::soak::Soak, self.colliders, seed, updates, &bar),
                    _ => soaked!(dim3::soak::Soak, self.colliders, seed, updates, &bar),
                };
                bar.finish_and_clear();
                let row = Row {
                    dimension: dim,
                    updates,
                    colliders: self.colliders,
                    seed,
                    pairs_at_end,
                    bytes_in_first_tenth: peaks.early,
                    bytes_later: peaks.late,
                    bytes_at_end,
                    is_flat: peaks.are_flat(),
                };
                output.row("soak", &row)?;
                is_flat &= row.is_flat;
                let figures = [
                    self.colliders,
                    pairs_at_end,
                    peaks.early,
                    peaks.late,
                    bytes_at_end,
                ];
                let mut cells = vec![format!("{dim}D, seed {seed}"), updates.to_string()];
                cells.extend(figures.map(|figure| figure.to_string()));
                table.add_row(cells);
            }
        }
        println!("{table}\n");
        println!("Memory {}.", if is_flat { "did not grow" } else { "GREW" });
        Ok(is_flat)
    }
}
