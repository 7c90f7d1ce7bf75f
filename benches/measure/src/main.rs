//! The time and the memory of updates of a broad phase, and the reasons: each question has a table.
//!
//! ```text
//! cargo run --release --manifest-path benches/Cargo.toml --package measure -- hard-boxes
//! ```
//!
//! prints a Markdown table, and with `--json FILE` appends its rows to a file as well, as `.ci/tables` reads them. Without a question, it
//! answers all of them. `benches/compare` times whole steps, and `benches/peers` measures other libraries.
//!
//! Everything runs on one thread.

mod adversary;
mod growth;
mod hard_boxes;
mod worlds;

use clap::{Parser, ValueEnum};
use cpu_time::ThreadTime;
use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use unisize_report::Report;

/// What is measured in each engine and dimension.
macro_rules! engine {
    ($name:ident, $rapier:ident, $unisize:ident, $file:literal $(, $only:ident)*) => {
        #[path = "."]
        mod $name {
            use $rapier as rapier;
            use unisize::$unisize as ours;

            #[path = $file]
            mod engine;
            pub(crate) mod hard_motions;
            $(pub(crate) mod $only;)*
            mod world;
        }
    };
}

engine! { dim2, rapier2d, rapier2d_027, "engine_027.rs", hierarchy, queries }
engine! { dim3, rapier3d, rapier3d_027, "engine_027.rs", hierarchy, queries }
engine! { dim2_036, rapier2d_036, rapier2d_036, "engine_036.rs" }
engine! { dim3_036, rapier3d_036, rapier3d_036, "engine_036.rs" }

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Measures the time and the memory of updates of a broad phase, and the reasons.
#[derive(Debug, Parser)]
struct Options {
    /// What to measure [default: everything]
    questions: Vec<Question>,
    /// How long to search for hard boxes, in each dimension
    #[arg(long, default_value_t = 2)]
    minutes: u32,
    /// Append the results to this file, a JSON object a line
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Few and small cases, to see that everything runs
    #[arg(long)]
    quick: bool,
}

/// What can be measured.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Question {
    /// Bytes per collider, of unisize and of Rapier's own broad phase
    Memory,
    /// Time and memory per body, from a hundred thousand bodies to four million
    Scale,
    /// Boxes on which methods break down
    HardBoxes,
    /// A search for boxes on which the kernel breaks down, which fails if it finds some
    Adversary,
    /// Motions on which broad phases break down
    HardMotions,
    /// A ray in each step, and the age of the tree
    Queries,
}

impl Options {
    fn questions(&self) -> Vec<Question> {
        if self.questions.is_empty() {
            return Question::value_variants().to_vec();
        }
        self.questions.clone()
    }

    /// The usual number, or the small one.
    fn least<T>(&self, usual: T, small: T) -> T {
        if self.quick { small } else { usual }
    }
}

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
                hard_boxes::measure::<2, dim2::hierarchy::Binned, dim2::hierarchy::Ploc>(
                    &options, report,
                )?;
                hard_boxes::measure::<3, dim3::hierarchy::Binned, dim3::hierarchy::Ploc>(
                    &options, report,
                )?;
            }
            Question::Adversary => {
                adversary::search::<f32, 2>(&options, report)?;
                adversary::search::<f32, 3>(&options, report)?;
                adversary::search::<f64, 2>(&options, report)?;
                adversary::search::<f64, 3>(&options, report)?;
            }
            Question::HardMotions => {
                let small = options.quick;
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

/// From so many colliders on, the processor's clock, which costs a third of a microsecond to read, disturbs nothing. It stands still while
/// something else has the processor; the machine's goes on.
const PROCESSOR_FROM: usize = 10_000;

/// How long some work on so many colliders takes.
fn time(count: usize, work: impl FnOnce()) -> Duration {
    if count < PROCESSOR_FROM {
        let start = Instant::now();
        work();
        start.elapsed()
    } else {
        let start = ThreadTime::now();
        work();
        start.elapsed()
    }
}
