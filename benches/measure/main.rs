//! What updates of a broad phase take, in time and memory, and why: each question has a table.
//!
//! ```text
//! cargo bench --all-features -- hard-boxes
//! ```
//!
//! prints a Markdown table, and with `--json FILE` appends its rows to a file as well, as `.ci/tables` reads them. Without a question, it
//! answers all of them. Whole steps are timed by `examples/compare`, and other libraries measured by `benches/peers`.
//!
//! One thread works.

mod case;
mod clock;
mod growth;
mod hard_boxes;
#[path = "../common/json_lines.rs"]
mod json_lines;
mod options;
#[path = "../common/report.rs"]
mod report;
mod worlds;

use clap::Parser;
use options::{Options, Question};
use report::Report;
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;

/// What is measured in each engine and dimension.
macro_rules! engine {
    ($name:ident, $rapier:ident, $unisize:ident, $file:literal $(, $only:ident)*) => {
        #[path = "."]
        mod $name {
            use $rapier as rapier;
            use unisize::$unisize as ours;

            #[path = $file]
            mod engine;
            pub(crate) mod follow;
            mod frames;
            pub(crate) mod hard_motions;
            $(pub(crate) mod $only;)*
        }
    };
}

engine!(
    dim2,
    rapier2d,
    rapier2d_027,
    "engine_027.rs",
    hierarchy,
    queries
);
engine!(
    dim3,
    rapier3d,
    rapier3d_027,
    "engine_027.rs",
    hierarchy,
    queries
);
engine!(dim2_036, rapier2d_036, rapier2d_036, "engine_036.rs");
engine!(dim3_036, rapier3d_036, rapier3d_036, "engine_036.rs");

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Numbers of balls, and one in how many moves, for the queries.
const QUERIES: [(usize, usize); 5] = [
    (10_000, 1),
    (10_000, 10),
    (10_000, 100),
    (1_000, 1),
    (10, 1),
];

fn main() -> anyhow::Result<()> {
    let options = Options::parse();
    rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build_global()?;
    let report = &mut Report::new(options.json.as_deref())?;
    for question in options.questions() {
        match question {
            Question::Memory => worlds::memory(&options, report)?,
            Question::Scale => worlds::scale(&options, report)?,
            Question::HardBoxes => {
                hard_boxes::measure::<2, dim2::hierarchy::Hierarchy>(&options, report)?;
                hard_boxes::measure::<3, dim3::hierarchy::Hierarchy>(&options, report)?;
            }
            Question::HardMotions => {
                let small = options.is_small();
                dim2::hard_motions::measure(small, report)?;
                dim2_036::hard_motions::measure(small, report)?;
                dim3::hard_motions::measure(small, report)?;
                dim3_036::hard_motions::measure(small, report)?;
            }
            Question::Queries => {
                let steps = options.least(10_000, 20);
                for &(count, one_in) in options.least(&QUERIES[..], &QUERIES[4..]) {
                    dim2::queries::measure(count, one_in, steps, report)?;
                    dim3::queries::measure(count, one_in, steps, report)?;
                }
            }
        }
    }
    Ok(())
}

/// The bytes that dropping a value frees.
fn bytes_held<T>(thing: T) -> usize {
    let before = ALLOCATOR.stats();
    drop(thing);
    let freed = ALLOCATOR.stats() - before;
    freed.bytes_deallocated - freed.bytes_allocated
}
