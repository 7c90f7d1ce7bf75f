//! Where the time goes: the phases of the kernel and of an update, beside a lower bound.
//!
//! ```text
//! cargo bench --features rapier2d-027,rapier3d-027,parallel --bench phases
//! ```
//!
//! Prints Markdown tables. For the kernel, each phase is the median over some frames, between which the boxes drift. The
//! *floor* is measured on the same frames: reading every box once, moving every box to its strip by one counting sort
//! (one pass over the boxes to count, one to place them), and writing every pair once. The *slope* is that of log time
//! over the log of the number of boxes, between two lines of the table: 1 where time is proportional to the number. Then come other
//! ways to sort boxes into strips, to see whether the floor could be lower.
//!
//! For an update, it is the mean over 60 frames, since only some frames search, and the worst frame.

mod common;
#[path = "phases/floor.rs"]
mod floor;
#[path = "phases/kernel.rs"]
mod kernel;
#[path = "update/motion.rs"]
mod motion;

use motion::Motion;
use std::time::Duration;

#[path = "phases"]
mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d_027 as ours;

    mod dimension;
    #[path = "../common/rapier_027.rs"]
    mod version;
    pub(crate) use dimension::print;
}

#[path = "phases"]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027 as ours;

    mod dimension;
    #[path = "../common/rapier_027.rs"]
    mod version;
    pub(crate) use dimension::print;
}

fn main() {
    common::set_threads();
    kernel::print::<2>([0.2, 0.8]);
    kernel::print::<3>([0.1, 0.4]);
    kernel::print_floors();
    dim2::print();
    dim3::print();
}

fn median(times: impl IntoIterator<Item = Duration>) -> Duration {
    let mut times: Vec<_> = times.into_iter().collect();
    times.sort_unstable();
    times[times.len() / 2]
}

/// Microseconds, with significant digits only.
fn microseconds(time: Duration) -> String {
    let time = time.as_secs_f64() * 1e6;
    let decimals = if time < 100.0 { 1 } else { 0 };
    format!("{time:.decimals$}")
}
