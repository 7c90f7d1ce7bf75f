//! The second study: what each method misses, and how much faster it is for that.
//!
//! Methods that may miss contacts run on the same frames as those that may not: a tree that is updated seldom, a grid whose
//! cells are too small for some, the kernel of the paper with a common size that is too small for some. One table and one panel
//! for each scene; bullets, which pass through things between two steps, have a chart of their own.

mod chart;
mod family;
mod front;
pub(super) mod method;
pub(super) mod study;
mod table;
mod verdict;

use crate::options::Options;
use crate::progress::progress_bar;
use crate::{dim2, dim3};
use std::path::Path;
use std::process::ExitCode;
use study::Study;

/// Measures all scenes and prints what was found. The charts go to this folder.
pub(super) fn run(options: &Options, figures: &Path) -> ExitCode {
    let bar = progress_bar(options.total_steps() as u64);
    let mut studies = Vec::new();
    for kind in options.scenes() {
        for dim in [2, 3] {
            bar.set_message(format!("{} {dim}D", kind.name()));
            studies.push(match dim {
                2 => dim2::missed(kind, options, || bar.inc(1)),
                _ => dim3::missed(kind, options, || bar.inc(1)),
            });
        }
    }
    bar.finish_and_clear();
    if studies.iter().any(|study| !study.is_fast) {
        println!("{}\n", verdict::verdict(&studies));
    }
    table::print(&studies);
    let charts = match chart::draw(figures, &studies) {
        Ok(charts) => charts,
        Err(error) => {
            eprintln!("error: {error}");
            return ExitCode::from(2);
        }
    };
    for file in charts {
        println!("Drawn: {}", file.display());
    }
    for study in studies.iter().filter(|study| study.touching() == 0) {
        println!(
            "NOTHING TOUCHES in {}: nothing could be missed.",
            study.title()
        );
    }
    let touching: usize = studies.iter().map(Study::touching).sum();
    let faults: Vec<_> = studies.iter().flat_map(faults).collect();
    if faults.is_empty() && touching > 0 {
        println!("unisize, updated in every step, missed nothing of {touching} pairs that touch.");
        return ExitCode::SUCCESS;
    }
    for fault in faults {
        println!("MISSED: {fault}");
    }
    ExitCode::FAILURE
}

fn faults(study: &Study) -> impl Iterator<Item = String> {
    study.faults().map(|figures| {
        let (missed, all) = (figures.touching.missed(), figures.touching.all);
        let name = figures.method.full_name();
        format!("{missed} of {all} pairs in {} by {name}", study.title())
    })
}
