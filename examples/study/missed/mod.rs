//! What methods miss that trade accuracy for speed, and what unisize's own settings cost, all on the same frames.
//!
//! - **recall**: how many of the pairs whose shapes touch, by Parry's exact queries, are held;
//! - **precision**: how many pairs are held for each that touches;
//! - **cost**: the time of the broad phase, and of the broad and the narrow phase together, because a wide margin moves work from one
//!   to the other.
//!
//! What cannot miss is told from what happened not to. Of the latter, n frames without a miss say that fewer than about 3 / n of all
//! frames have one (the rule of three).

mod figures;

use crate::finder::{Cell, Finder};
use crate::options::{Common, at_least_one};
use crate::output::{Output, number, percent, table};
use crate::progress::progress_bar;
use crate::statistics::rarer_than;
use crate::{dim2, dim3};
use anyhow::Result;
use clap::Args;
pub(crate) use figures::{Figures, Recall};
use serde::Serialize;
use unisize::Kernel;
use unisize_charts::{Axis, Chart, Panel, Series};
use unisize_scenes::SceneKind;

/// The scenes. None of them removes a collider, which could not be passed on.
const SCENES: [SceneKind; 6] = [
    SceneKind::Ropes,
    SceneKind::Hopper,
    SceneKind::Crowd,
    SceneKind::MixedEight,
    SceneKind::Gas,
    SceneKind::Sleeping,
];

/// What is measured, unisize by default first: one of each idea.
pub(crate) const FINDERS: [Finder; 11] = [
    Finder::DEFAULT,
    Finder::Unisize(Kernel::GridSweep, Some(0.0)),
    Finder::Unisize(Kernel::GridSweep, Some(0.25)),
    Finder::Unisize(Kernel::RankSweep, None),
    Finder::Rapier,
    Finder::Grid(Cell::Largest),
    Finder::Grid(Cell::Median),
    Finder::Seldom(2),
    Finder::Seldom(4),
    Finder::Seldom(8),
    Finder::Lossy,
];

/// Steps before those that are measured, of a quick run and of a full one: by then, things touch in every scene.
const LEAD_IN: [usize; 2] = [80, 140];
const STEPS: [usize; 2] = [20, 80];
const QUICK_BODIES: usize = 120;

/// What is compared with the truth: once in so many steps. It is odd, so that each of every two, four or eight is met equally often.
const TRUTH_EVERY: [usize; 2] = [3, 5];

/// The band of the chart that stands for zero: no share that is counted is as small.
const ZERO: [f64; 2] = [1e-7, 1e-6];

/// What do methods miss that trade accuracy for speed, and how much faster are they?
///
/// Exits with 1 if unisize, or what cannot miss either, misses a pair whose shapes touch, or nearly do.
#[derive(Args, Clone, Debug)]
pub(crate) struct Arguments {
    #[command(flatten)]
    common: Common,
    /// A scene; may be given several times [default: six of them]
    #[arg(long, value_name = "SCENE", value_parser = SCENES.map(SceneKind::name))]
    only: Vec<String>,
    /// About how many bodies per scene [default: 2,000, of ropes 1,000; with --quick 120]
    #[arg(long, value_name = "N", value_parser = at_least_one())]
    bodies: Option<usize>,
}

/// Frames, and what is measured on them.
pub(crate) struct Course<'a> {
    pub(crate) kind: SceneKind,
    pub(crate) bodies: usize,
    pub(crate) seed: u64,
    /// Steps before those that are measured.
    pub(crate) lead_in: usize,
    pub(crate) steps: usize,
    pub(crate) truth_every: usize,
    pub(crate) finders: &'a [Finder],
}

/// All methods in one scene, in their order.
struct Study {
    scene: &'static str,
    dim: u8,
    bodies: usize,
    figures: Vec<Figures>,
}

/// A method in a scene.
#[derive(Serialize)]
struct Row<'a> {
    dimension: u8,
    scene: &'a str,
    bodies: usize,
    method: String,
    cannot_miss: bool,
    #[serde(flatten)]
    figures: &'a Figures,
}

impl Arguments {
    /// Runs the study; whether unisize has passed.
    pub(crate) fn run(&self) -> Result<bool> {
        let mut output = Output::create("missed", &self.common)?;
        let studies = self.studies();
        for study in &studies {
            for (finder, figures) in FINDERS.into_iter().zip(&study.figures) {
                let row = Row {
                    dimension: study.dim,
                    scene: study.scene,
                    bodies: study.bodies,
                    method: finder.name(),
                    cannot_miss: finder.is_exact(),
                    figures,
                };
                output.row("method", &row)?;
            }
        }
        print_methods(&studies);
        print_by_scene(&studies, "Missed, of the pairs that touch", |_, figures| {
            percent(figures.touching.share_missed())
        });
        print_by_scene(
            &studies,
            "Broad and narrow phase, over unisize",
            |default, figures| number(figures.both / default.both),
        );
        print_by_scene(
            &studies,
            "Pairs held per pair that touches",
            |_, figures| number(figures.held_a_contact()),
        );
        output.chart(None, || chart(&studies))?;
        Ok(is_sound(&studies))
    }

    /// Measures all methods in all scenes.
    fn studies(&self) -> Vec<Study> {
        let kinds = self.common.scenes(&SCENES, &self.only);
        let of = |[quick, full]: [usize; 2]| self.common.usual(quick, full);
        let steps = self.common.steps.unwrap_or(of(STEPS));
        let seeds = self.common.seeds(1, 3);
        let all = kinds.len() * self.common.dims().len() * seeds.clone().count() * steps;
        let bar = progress_bar(all as u64);
        let mut studies = Vec::new();
        for &dim in self.common.dims() {
            for &kind in &kinds {
                bar.set_message(format!("{} {dim}D", kind.name()));
                let race = |seed| {
                    let course = Course {
                        kind,
                        bodies: self.bodies(kind),
                        seed,
                        lead_in: of(LEAD_IN),
                        steps,
                        truth_every: of(TRUTH_EVERY),
                        finders: &FINDERS,
                    };
                    match dim {
                        2 => dim2::missed::race(&course, || bar.inc(1)),
                        _ => dim3::missed::race(&course, || bar.inc(1)),
                    }
                };
                let races: Vec<_> = seeds.clone().map(race).collect();
                let figures = (0..FINDERS.len()).map(|index| {
                    let seeds: Vec<_> = races.iter().map(|race| race[index]).collect();
                    Figures::of(&seeds)
                });
                studies.push(Study {
                    scene: kind.name(),
                    dim,
                    bodies: self.bodies(kind),
                    figures: figures.collect(),
                });
            }
        }
        bar.finish_and_clear();
        studies
    }

    fn bodies(&self, kind: SceneKind) -> usize {
        let usual = match kind {
            SceneKind::Ropes => 1_000,
            _ => 2_000,
        };
        let usual = self.common.usual(QUICK_BODIES, usual);
        self.bodies.unwrap_or(usual)
    }
}

impl Study {
    fn title(&self) -> String {
        format!("{} {}D", self.scene, self.dim)
    }
}

/// One method in all scenes.
struct Method {
    finder: Finder,
    /// Broad phase, and broad and narrow phase, over unisize by default: geometric means.
    broad: f64,
    both: f64,
    /// The least and the most of the latter.
    range: [f64; 2],
    missed_at_worst: f64,
    scenes_with_misses: usize,
    frames: usize,
    frames_with_misses: usize,
}

impl Method {
    fn all(studies: &[Study]) -> Vec<Self> {
        let of = |(index, finder): (usize, Finder)| {
            let figures = || studies.iter().map(|study| &study.figures[index]);
            let ratios = |time: fn(&Figures) -> f64| {
                let ratio = |study: &Study| time(&study.figures[index]) / time(&study.figures[0]);
                studies.iter().map(ratio).collect::<Vec<_>>()
            };
            let mean = |ratios: &[f64]| {
                let logarithms = ratios.iter().map(|ratio| ratio.ln());
                (logarithms.sum::<f64>() / ratios.len() as f64).exp()
            };
            let both = ratios(|figures| figures.both);
            Self {
                finder,
                broad: mean(&ratios(|figures| figures.broad)),
                both: mean(&both),
                range: [
                    both.iter().copied().fold(f64::INFINITY, f64::min),
                    both.iter().copied().fold(0.0, f64::max),
                ],
                missed_at_worst: figures()
                    .map(|figures| figures.touching.share_missed())
                    .fold(0.0, f64::max),
                scenes_with_misses: figures().filter(|of| of.touching.missed() > 0).count(),
                frames: figures().map(|figures| figures.frames).sum(),
                frames_with_misses: figures().map(|figures| figures.frames_with_misses).sum(),
            }
        };
        FINDERS.into_iter().enumerate().map(of).collect()
    }

    /// How many frames had misses, or may have where none had.
    fn frames(&self) -> String {
        match self.frames_with_misses {
            0 if self.finder.is_exact() => "none can".to_owned(),
            0 => format!(
                "none of {}: below {}",
                self.frames,
                percent(rarer_than(self.frames))
            ),
            count => format!("{count} of {}", self.frames),
        }
    }
}

/// Prints what each method costs in all scenes, and what it misses at worst.
fn print_methods(studies: &[Study]) {
    println!(
        "### What methods cost and miss\n\nTimes are over those of unisize by default, geometric means of all scenes.\n"
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
    for method in Method::all(studies) {
        let [least, most] = method.range.map(number);
        let is_exact = method.finder.is_exact();
        table.add_row([
            method.finder.name(),
            if is_exact { "yes" } else { "no" }.to_owned(),
            number(method.broad),
            number(method.both),
            least,
            most,
            percent(method.missed_at_worst),
            format!("{} of {}", method.scenes_with_misses, studies.len()),
            method.frames(),
        ]);
    }
    println!("{table}\n");
}

/// Prints a figure of every scene and method, from that of unisize by default and its own.
fn print_by_scene(studies: &[Study], what: &str, figure: impl Fn(&Figures, &Figures) -> String) {
    println!("### {what}\n");
    let mut head = vec!["scene".to_owned()];
    head.extend(FINDERS.map(Finder::name));
    let mut table = table(head);
    for study in studies {
        let mut row = vec![study.title()];
        let default = &study.figures[0];
        row.extend(study.figures.iter().map(|figures| figure(default, figures)));
        table.add_row(row);
    }
    println!("{table}\n");
}

/// Each method as a labelled point: the mean time against what is missed at worst. A ring is around what happened not to miss.
fn chart(studies: &[Study]) -> Chart {
    let series = Method::all(studies).into_iter().map(|method| {
        let name = method.finder.name();
        let point = (method.missed_at_worst, method.both);
        let series = Series::new(name.clone(), method.finder.color(), [point]).labelled([name]);
        match method.frames_with_misses == 0 && !method.finder.is_exact() {
            true => series.ringed(),
            false if method.finder == Finder::DEFAULT => series.bold(),
            false => series,
        }
    });
    let panel = Panel::new(
        "",
        Axis::log("share of touching pairs that is missed, at worst")
            .with_zero_between(ZERO[0], ZERO[1]),
        Axis::log("broad and narrow phase, over unisize, mean"),
        series,
    );
    let title = "Contacts missed against time: left is exact, low is fast";
    Chart::new(title, [panel]).note("A ring: nothing was missed, but could be.")
}

/// Whether something touches, and what cannot miss has missed nothing of it; prints what is wrong.
fn is_sound(studies: &[Study]) -> bool {
    let mut is_sound = true;
    let mut touching = 0;
    for study in studies {
        let all = study.figures[0].touching.all;
        touching += all;
        if all == 0 {
            println!(
                "NOTHING TOUCHES in {}: nothing could be missed.\n",
                study.title()
            );
        }
        let finders = FINDERS.into_iter().zip(&study.figures);
        for (finder, figures) in finders.filter(|of| of.0.is_exact()) {
            let missed = figures.touching.missed() + figures.near.missed();
            if missed > 0 {
                is_sound = false;
                println!(
                    "MISSED: {missed} pairs in {} by {}\n",
                    study.title(),
                    finder.name()
                );
            }
        }
    }
    if is_sound {
        println!("What cannot miss missed nothing of {touching} pairs that touch.");
    }
    is_sound && touching > 0
}

#[cfg(test)]
mod tests {
    use super::{FINDERS, Figures, Recall, Study, is_sound};

    #[test]
    fn only_a_miss_of_what_cannot_miss_is_wrong() {
        for (index, finder) in FINDERS.into_iter().enumerate() {
            let recall = |of| Recall {
                found: if of == index { 199 } else { 200 },
                all: 200,
            };
            let figures = (0..FINDERS.len()).map(|of| Figures {
                touching: recall(of),
                ..Figures::default()
            });
            let study = Study {
                scene: "ropes",
                dim: 2,
                bodies: 100,
                figures: figures.collect(),
            };
            assert_eq!(is_sound(&[study]), !finder.is_exact(), "{}", finder.name());
        }
        assert!(!is_sound(&[]));
    }
}
