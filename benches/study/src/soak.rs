//! Does unisize run forever in the same memory?
//!
//! Very many updates are made in which colliders rest, drift, tremble, jump, come and go, and are disabled, resized and given NaN
//! poses. At intervals the broad phase checks itself, and its pairs are compared with its events.

#[path = "../../../tests/common/allocations.rs"]
mod allocations;

pub(crate) use allocations::Peaks;

use crate::options::Common;
use crate::output::Output;
use crate::{dim2, dim3};
use anyhow::Result;

/// Updates of a quick run and of a full one.
const UPDATES: [usize; 2] = [50_000, 1_000_000];

/// The greatest number of colliders.
pub(crate) const COLLIDERS: usize = 500;

/// Updates from one check to the next.
pub(crate) const CHECK_EVERY: u64 = 1_000;

/// Runs the study; whether unisize has passed.
pub(crate) fn run(common: &Common) -> Result<bool> {
    let mut output = Output::create(common)?;
    let updates = common.steps.unwrap_or(common.usual(UPDATES)) as u64;
    let seeds: Vec<_> = common.seeds([1, 1]).collect();
    let soaks = common.each(
        &seeds,
        |_| "soak",
        |dim, &seed| {
            let (peaks, pairs) = match dim {
                2 => dim2::soak::run(seed, updates),
                _ => dim3::soak::run(seed, updates),
            };
            (dim, seed, peaks, pairs)
        },
    );
    for (dim, seed, peaks, pairs) in &soaks {
        output.row(
            "soak",
            &[
                ("dimension", (*dim).into()),
                ("seed", (*seed).into()),
                ("updates", updates.into()),
                ("colliders", COLLIDERS.into()),
                ("pairs", (*pairs).into()),
                ("most_bytes_in_first_tenth", peaks.early.into()),
                ("most_bytes_later", peaks.late.into()),
            ],
        )?;
    }
    let is_flat = soaks.iter().all(|(_, _, peaks, _)| peaks.are_flat());
    println!(
        "\nMemory {}.",
        if is_flat { "did not grow" } else { "GREW" }
    );
    Ok(is_flat)
}
