//! What each setting costs, and what it is worth.
//!
//! ```text
//! cargo run --release --all-features --example tradeoff
//! ```
//!
//! runs Rapier's own broad phase, and unisize with each kernel and a range of margins, on six scenes in two and three
//! dimensions. All get the same scene at the same step, in turns, and three things are measured:
//!
//! - **recall**: how many of the pairs whose shapes touch, by Parry's exact queries, are held;
//! - **cost**: the time of the broad phase, and of the broad and the narrow phase together, because a wide margin moves
//!   work from one to the other;
//! - **fidelity**: how far a whole simulation on each of them is from one with a quarter of the time step.
//!
//! That study has methods that find every contact. With `--study missed`, methods that trade accuracy for speed are measured
//! beside them: trees that are updated seldom, a hash grid, a common box size that is too small. See [`missed`].
//!
//! It prints tables in Markdown and draws `docs/figures/tradeoff-*.svg`, or `missed-*.svg`. It exits with 1 if a touching pair
//! was missed, in the second study by unisize, or if nothing touched there, or if the default settings do not simulate what
//! Rapier's broad phase does, and with 2 if it was called wrongly or cannot write.
//!
//! All is on one thread, whatever features are on.

mod chart;
mod course;
mod method;
mod missed;
mod options;
#[path = "../progress/bar.rs"]
mod progress;
mod quantile;
mod study;
mod table;

#[path = "."]
mod dim2 {
    //! The measurements in rapier2d.
    use rapier2d_036 as newest;
    use unisize::rapier2d_027 as ours;
    use unisize_scenes::dim2 as scenes;

    mod dimension;
    pub(super) use dimension::{missed, study};
}

#[path = "."]
mod dim3 {
    //! The measurements in rapier3d.
    use rapier3d_036 as newest;
    use unisize::rapier3d_027 as ours;
    use unisize_scenes::dim3 as scenes;

    mod dimension;
    pub(super) use dimension::{missed, study};
}

use options::{Options, Study};
use progress::progress_bar;
use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let options = Options::of_command_line();
    // The clock is that of this thread, which stands still while others work for it.
    let threads = rayon::ThreadPoolBuilder::new().num_threads(1);
    if let Err(error) = threads.build_global() {
        eprintln!("error: cannot have a single thread: {error}");
        return ExitCode::from(2);
    }
    let figures = options.out();
    // Before the long run, which a failure would waste.
    if let Err(error) = std::fs::create_dir_all(&figures) {
        eprintln!("error: cannot create {}: {error}", figures.display());
        return ExitCode::from(2);
    }
    match options.study {
        Study::Margins => margins(&options, &figures),
        Study::Missed => missed::run(&options, &figures),
    }
}

/// The study of kernels and margins.
fn margins(options: &Options, figures: &Path) -> ExitCode {
    let bar = progress_bar(options.total_steps() as u64);
    let mut studies = Vec::new();
    for kind in options.scenes() {
        for dim in [2, 3] {
            bar.set_message(format!("{} {dim}D", kind.name()));
            let study = match dim {
                2 => dim2::study(kind, options, || bar.inc(1)),
                _ => dim3::study(kind, options, || bar.inc(1)),
            };
            bar.suspend(|| table::print_study(&study));
            studies.push(study);
        }
    }
    bar.finish_and_clear();
    table::print_summary(&studies);
    for dim in [2, 3] {
        let of_dim: Vec<_> = studies.iter().filter(|study| study.dim == dim).collect();
        let file = figures.join(format!("tradeoff-{dim}d.svg"));
        if let Err(error) = chart::draw(&file, dim, &of_dim) {
            eprintln!("error: {error}");
            return ExitCode::from(2);
        }
        println!("Drawn: {}", file.display());
    }
    let missed: usize = studies.iter().map(study::Study::missed).sum();
    if missed == 0 {
        println!("No method missed a pair that touches.");
    } else {
        println!("MISSED: {missed} pairs that touch.");
    }
    let differing = studies.iter().filter(|study| !study.is_same_in_order());
    let differing = differing.count();
    if differing == 0 {
        println!(
            "With events in order, all simulations on the default settings equal those on Rapier's."
        );
    } else {
        println!("DIFFERENT from Rapier's although events were in order: {differing} simulations.");
    }
    match missed + differing {
        0 => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    }
}
