//! What misses contacts in exchange for speed, and how much faster it is for that.
//!
//! What cannot miss is told from what happened not to. Of the latter, n frames without a miss say that fewer than about 3 / n of all
//! frames have one (the rule of three).

use super::{Frames, Study, is_sound, print_by_scene};
use crate::finder::{Cell, Finder, Setting};
use crate::output::{Output, number, percent, table};
use crate::statistics::Share;
use anyhow::Result;
use clap::Args;
use unisize_charts::{Axis, Chart, Panel, Series};

/// What is measured, unisize by default first: one of each idea.
pub(crate) const FINDERS: [Finder; 9] = [
    Finder::DEFAULT,
    Finder::Unisize(Setting {
        margin: Some(0.0),
        ..Setting::DEFAULT
    }),
    Finder::Rapier,
    Finder::Grid(Cell::Largest),
    Finder::Grid(Cell::Median),
    Finder::Seldom(2),
    Finder::Seldom(4),
    Finder::Seldom(8),
    Finder::Lossy,
];

/// The band of a chart that stands for zero: no share that is counted is as small.
const ZERO: [f64; 2] = [1e-7, 1e-6];

/// What do methods miss that trade accuracy for speed, and how much faster are they?
///
/// Exits with 1 if unisize, or what cannot miss either, misses a pair whose shapes touch, or nearly do.
#[derive(Args, Clone, Debug)]
pub(crate) struct Arguments {
    #[command(flatten)]
    frames: Frames,
}

impl Arguments {
    /// Runs the study; whether unisize has passed.
    pub(crate) fn run(&self) -> Result<bool> {
        let mut output = Output::create("missed", &self.frames.common)?;
        let studies = self.frames.studies(&mut output, |_| FINDERS.to_vec())?;
        print_methods(&studies);
        print_faster(&studies);
        print_by_scene(&studies, "Missed, of the pairs that touch", |_, figures| {
            percent(figures.touching.share_missed())
        });
        print_by_scene(
            &studies,
            "Broad and narrow phase, over unisize",
            |study, figures| number(figures.both / study.default().both),
        );
        for &dim in self.frames.common.dims() {
            output.chart(dim, || chart(dim, &studies))?;
        }
        Ok(is_sound(&studies))
    }
}

/// Prints what each method costs in all scenes, and what it misses at worst.
fn print_methods(studies: &[Study]) {
    println!(
        "### What methods cost and miss\n\nTimes are those of unisize by default, geometric means of all scenes.\n"
    );
    let mut table = table([
        "method",
        "cannot miss",
        "broad phase",
        "broad and narrow phase",
        "least",
        "most",
        "missed at worst",
        "scenes with misses",
        "frames with misses",
    ]);
    for finder in FINDERS {
        let figures = || {
            studies
                .iter()
                .filter_map(|study| Some((study, study.of(finder)?)))
        };
        let mean = |ratio: &dyn Fn((&Study, &super::Figures)) -> f64| {
            let logarithms = figures().map(|of| ratio(of).ln());
            number((logarithms.sum::<f64>() / studies.len() as f64).exp())
        };
        let ratios = || figures().map(|(study, of)| of.both / study.default().both);
        let shares = figures().map(|(_, of)| of.touching.share_missed());
        let missing = figures().filter(|(_, of)| of.touching.missed() > 0);
        let [count, frames] = figures().fold([0, 0], |[count, frames], (_, of)| {
            [count + of.frames_with_misses, frames + of.frames]
        });
        table.add_row([
            finder.name(),
            if finder.is_exact() { "yes" } else { "no" }.to_owned(),
            mean(&|(study, of)| of.broad / study.default().broad),
            mean(&|(study, of)| of.both / study.default().both),
            number(ratios().fold(f64::INFINITY, f64::min)),
            number(ratios().fold(0.0, f64::max)),
            percent(shares.fold(0.0, f64::max)),
            format!("{} of {}", missing.count(), studies.len()),
            frames_with_misses(finder, count, frames),
        ]);
    }
    println!("{table}\n");
}

/// How many frames had misses, or may have where none had.
fn frames_with_misses(finder: Finder, count: usize, frames: usize) -> String {
    match count {
        0 if finder.is_exact() => "none can".to_owned(),
        0 => format!(
            "none of {frames}: below {}",
            percent(Share::of(0, frames).high)
        ),
        _ => format!("{count} of {frames}"),
    }
}

/// Prints for each scene what missed nothing and was faster than unisize by default.
fn print_faster(studies: &[Study]) {
    println!("### What missed nothing and was fastest, over unisize by default\n");
    let mut table = table([
        "scene",
        "of what cannot miss",
        "time",
        "of what happened not to miss",
        "time",
        "frames with misses",
    ]);
    for study in studies {
        let time = |both: f64| number(both / study.default().both);
        let mut row = vec![study.title()];
        if let Some((finder, of)) = study.fastest(|finder, _| finder.is_exact()) {
            row.extend([finder.name(), time(of.both)]);
        }
        let lucky = study.fastest(|finder, of| !finder.is_exact() && of.touching.missed() == 0);
        match lucky {
            None => row.extend(["-"; 3].map(str::to_owned)),
            Some((finder, of)) => row.extend([
                finder.name(),
                time(of.both),
                frames_with_misses(finder, 0, of.frames),
            ]),
        }
        table.add_row(row);
    }
    println!("{table}\n");
}

/// Time against the share that is missed, a panel for each scene.
fn chart(dim: u8, studies: &[Study]) -> Chart {
    let [from, to] = ZERO;
    let panels = studies
        .iter()
        .filter(|study| study.dim == dim)
        .map(|study| {
            let series = study.finders.iter().map(|(finder, of)| {
                let place = (of.touching.share_missed(), of.both / study.default().both);
                let series = Series::new(finder.name(), finder.color(), [place]);
                match *finder == Finder::DEFAULT {
                    true => series.bold(),
                    false => series,
                }
            });
            Panel::new(
                study.title(),
                Axis::log("share of touching pairs that is missed").with_zero_between(from, to),
                Axis::linear("broad and narrow phase, over unisize"),
                series,
            )
        });
    Chart::new(
        format!("Contacts missed against time, {dim}D: left is exact, low is fast"),
        panels,
    )
    .columns(3)
}
