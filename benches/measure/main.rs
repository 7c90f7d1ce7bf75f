//! What updates of a broad phase take, in time and memory, and why: each question has a table.
//!
//! ```text
//! cargo bench --all-features -- kernels
//! ```
//!
//! prints a Markdown table, and with `--json FILE` appends its rows to a file as well, as `.ci/tables` reads them. Without a question, it
//! answers all of them. Whole steps are timed by `examples/compare`, and other libraries measured by `benches/peers`.
//!
//! One thread works, unless `RAYON_NUM_THREADS` says otherwise.

#[path = "../common/case.rs"]
mod case;
#[path = "../common/clock.rs"]
mod clock;
mod fit;
mod floor;
mod growth;
mod hard_boxes;
#[path = "../common/json_lines.rs"]
mod json_lines;
mod kernels;
mod options;
mod prices;
#[path = "../common/report.rs"]
mod report;
mod updates;

use clap::Parser;
use clock::Clock;
use options::{Options, Question};
use report::Report;
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;
use std::time::Duration;
use unisize_scenes::HardMotion;

#[path = "."]
mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d_027 as ours;
    use unisize_scenes::dim2 as scenes;

    #[path = "../common/engine_027.rs"]
    mod engine;
    pub(crate) mod fan;
    pub(crate) mod follow;
    #[path = "../common/frames.rs"]
    mod frames;
    pub(crate) mod hard_motions;
    pub(crate) mod hierarchy;
    pub(crate) mod queries;
}

#[path = "."]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027 as ours;
    use unisize_scenes::dim3 as scenes;

    #[path = "../common/engine_027.rs"]
    mod engine;
    pub(crate) mod fan;
    pub(crate) mod follow;
    #[path = "../common/frames.rs"]
    mod frames;
    pub(crate) mod hard_motions;
    pub(crate) mod hierarchy;
    pub(crate) mod queries;
}

#[path = "."]
mod dim2_036 {
    use rapier2d_036 as rapier;
    use unisize::rapier2d_036 as ours;

    #[path = "../common/engine_036.rs"]
    mod engine;
    pub(crate) mod follow;
    #[path = "../common/frames.rs"]
    mod frames;
    pub(crate) mod hard_motions;
}

#[path = "."]
mod dim3_036 {
    use rapier3d_036 as rapier;
    use unisize::rapier3d_036 as ours;

    #[path = "../common/engine_036.rs"]
    mod engine;
    pub(crate) mod follow;
    #[path = "../common/frames.rs"]
    mod frames;
    pub(crate) mod hard_motions;
}

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

fn main() -> anyhow::Result<()> {
    let options = Options::parse();
    if std::env::var_os("RAYON_NUM_THREADS").is_none() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
        pool.build_global()?;
    }
    let report = &mut Report::new(options.json.as_deref())?;
    for question in options.questions() {
        match question {
            Question::Kernels => kernels::measure(&options, report)?,
            Question::Updates => updates::measure(&options, report)?,
            Question::Scale => updates::scale(&options, report)?,
            Question::HardBoxes => {
                hard_boxes::measure::<2, dim2::hierarchy::Hierarchy>(&options, report)?;
                hard_boxes::measure::<3, dim3::hierarchy::Hierarchy>(&options, report)?;
            }
            Question::HardMotions => {
                let small = options.is_small();
                for measure in [dim2::hard_motions::measure, dim2_036::hard_motions::measure] {
                    measure(&HardMotion::ALL, small, report)?;
                }
                for measure in [dim3::hard_motions::measure, dim3_036::hard_motions::measure] {
                    measure(&HardMotion::ALL, small, report)?;
                }
            }
            Question::Queries => {
                for (count, one_in) in options.queries() {
                    let steps = options.least(10_000, 20);
                    dim2::queries::measure(count, one_in, steps, report)?;
                    dim3::queries::measure(count, one_in, steps, report)?;
                }
            }
            Question::Prices => prices::measure(&options, report)?,
        }
    }
    Ok(())
}

/// What updates of so many colliders are timed by. The processor's clock knows nothing of other threads.
fn clock_for(count: usize) -> Clock {
    if rayon::current_num_threads() > 1 {
        return Clock::Wall;
    }
    Clock::for_count(count)
}

/// The bytes that dropping a value frees.
fn bytes_held<T>(thing: T) -> usize {
    let before = ALLOCATOR.stats();
    drop(thing);
    let freed = ALLOCATOR.stats() - before;
    freed.bytes_deallocated - freed.bytes_allocated
}

/// Nanoseconds for each of so many.
fn ns_each(time: Duration, count: usize) -> f64 {
    time.as_secs_f64() * 1e9 / count as f64
}

fn median(times: impl IntoIterator<Item = Duration>) -> Duration {
    let mut times: Vec<_> = times.into_iter().collect();
    times.sort_unstable();
    times[times.len() / 2]
}
