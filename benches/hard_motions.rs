//! Motions on which broad phases break down: how update time and memory grow, for Rapier's own broad phase, for
//! unisize, and for unisize with the kernel of the paper; for Rapier 0.27, and for 0.36, which hands over the boxes of what has
//! moved.
//!
//! ```text
//! cargo bench --all-features --bench hard_motions
//! ```
//!
//! Prints a Markdown table for each dimension. Times are for one update, by the clock of the processor: the mean and the worst
//! of 60, or of as many as fit in four seconds; the number of cubes then says after how many updates it was stopped.
//! *Work* is the mean number of cubes, held pairs and events together, the least that a broad phase has to process. *Times
//! drifting* is the time per unit of work, relative to drifting cubes. The *slopes* are those of log mean time and log
//! memory over log work, between the two largest numbers of cubes: 1 where they grow in proportion.

mod common;

use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;
use std::time::Duration;

#[path = "hard_motions"]
mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d_027 as ours;

    mod dimension;
    #[path = "../common/rapier_027.rs"]
    mod version;
    pub(crate) use dimension::print;
}

#[path = "hard_motions"]
mod dim2_036 {
    use rapier2d_036 as rapier;
    use unisize::rapier2d_036 as ours;

    mod dimension;
    #[path = "../common/rapier_036.rs"]
    mod version;
    pub(crate) use dimension::print;
}

#[path = "hard_motions"]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027 as ours;

    mod dimension;
    #[path = "../common/rapier_027.rs"]
    mod version;
    pub(crate) use dimension::print;
}

#[path = "hard_motions"]
mod dim3_036 {
    use rapier3d_036 as rapier;
    use unisize::rapier3d_036 as ours;

    mod dimension;
    #[path = "../common/rapier_036.rs"]
    mod version;
    pub(crate) use dimension::print;
}

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Numbers of cubes.
const COUNTS: [usize; 3] = [1 << 12, 1 << 14, 1 << 16];

/// The number of cubes in a smoke test.
const SMALL_COUNT: usize = 1 << 8;

const FRAMES: u32 = 60;

/// A case stops after this time, whatever its number of frames, and is not tried with more cubes.
const LONG: Duration = Duration::from_secs(4);

fn main() {
    common::set_threads();
    print_head(2);
    dim2::print(true);
    dim2_036::print(false);
    println!();
    print_head(3);
    dim3::print(true);
    dim3_036::print(false);
    println!();
}

/// One broad phase in one case.
struct Figures {
    count: usize,
    frames: u32,
    pairs: usize,
    events: usize,
    all: Duration,
    worst: Duration,
    bytes: usize,
}

impl Figures {
    /// Cubes, pairs and events.
    fn work(&self) -> f64 {
        (self.count + self.pairs) as f64 + self.events as f64 / f64::from(self.frames)
    }

    fn is_long(&self) -> bool {
        self.all >= LONG
    }

    fn seconds(&self) -> f64 {
        self.all.as_secs_f64() / f64::from(self.frames)
    }
}

/// Prints the line of one broad phase and motion. `drifting` is its time per unit of work on drifting cubes, once known.
fn print_row(motion: &str, name: &str, figures: &[Figures], drifting: &mut Option<f64>) {
    let Some(last) = figures.last() else { return };
    let each = last.seconds() / last.work() * 1e9;
    let drifting = *drifting.get_or_insert(each);
    let slope = |of: fn(&Figures) -> f64| match figures {
        [.., before, last] => {
            let slope = (of(last) / of(before)).ln() / (last.work() / before.work()).ln();
            format!("{slope:.2}")
        }
        _ => "–".to_owned(),
    };
    let stopped = if last.frames < FRAMES {
        format!(", stopped after {}", last.frames)
    } else {
        String::new()
    };
    println!(
        "| {motion} | {name} | {}{stopped} | {} | {} | {:.3} | {:.3} | {each:.1} | {:.1} | {} | {:.0} | {} |",
        last.count,
        last.pairs,
        last.events / last.frames as usize,
        last.seconds() * 1e3,
        last.worst.as_secs_f64() * 1e3,
        each / drifting,
        slope(Figures::seconds),
        last.bytes as f64 / last.count as f64,
        slope(|figures| figures.bytes as f64),
    );
}

fn print_head(dimension: usize) {
    println!("### {dimension}D\n");
    println!(
        "| motion | broad phase | n | pairs | events | mean ms | worst ms | ns a piece of work | times drifting | slope of time | bytes a cube | slope of memory |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|---|");
}
