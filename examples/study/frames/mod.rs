//! What finders miss and cost on the same frames.
//!
//! [`settings`] studies what cannot miss: the kernels, margins and filters of unisize. [`missed`] studies what misses contacts in
//! exchange for speed. Both measure
//!
//! - **recall**: how many of the pairs whose shapes touch, by Parry's exact queries, are held;
//! - **precision**: how many pairs are held for each that touches;
//! - **cost**: the time of the broad phase, and of the broad and the narrow phase together, because a wide margin moves work from one
//!   to the other.

pub(crate) mod missed;
pub(crate) mod settings;

use crate::finder::Finder;
use crate::options::{Common, at_least_one};
use crate::output::{Output, table};
use crate::progress::progress_bar;
use crate::{dim2, dim3};
use anyhow::Result;
use clap::Args;
use serde::Serialize;
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

/// Steps before those that are measured: by then, things touch in every scene.
const LEAD_IN: usize = 140;
const QUICK_LEAD_IN: usize = 80;

const STEPS: usize = 80;
const QUICK_STEPS: usize = 20;

const QUICK_BODIES: usize = 120;

/// What is compared with the truth: once in so many steps. It is odd, so that each of every two, four or eight is met equally often.
const TRUTH_EVERY: usize = 5;
const QUICK_TRUTH_EVERY: usize = 3;

/// What both studies can be told.
#[derive(Args, Clone, Debug)]
pub(crate) struct Frames {
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

/// What one finder held and missed in one scene, and its cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(crate) struct Figures {
    /// Pairs of shapes that touch or overlap.
    pub(crate) touching: Recall,
    /// Pairs of shapes nearer than the prediction distance, touching ones included.
    pub(crate) near: Recall,
    /// Frames that were compared with the truth, and those in which a touching pair was missed.
    pub(crate) frames: usize,
    pub(crate) frames_with_misses: usize,
    /// Pairs held, summed over these frames.
    pub(crate) held: usize,
    /// Milliseconds per step.
    pub(crate) broad: f64,
    /// Milliseconds per step of broad and narrow phase together.
    pub(crate) both: f64,
}

/// How many of the pairs that should be held are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub(crate) struct Recall {
    pub(crate) found: usize,
    pub(crate) all: usize,
}

impl Recall {
    /// Counts more of them.
    pub(crate) fn add(&mut self, (found, all): (usize, usize)) {
        self.found += found;
        self.all += all;
    }

    pub(crate) fn missed(self) -> usize {
        self.all - self.found
    }

    /// The share that is missed; none of none is zero.
    pub(crate) fn share_missed(self) -> f64 {
        self.missed() as f64 / self.all.max(1) as f64
    }
}

impl Figures {
    /// Of several seeds: the sum of all counts, and the median of times.
    fn of(seeds: &[Self]) -> Self {
        let mut sum = Self::default();
        for figures in seeds {
            sum.touching
                .add((figures.touching.found, figures.touching.all));
            sum.near.add((figures.near.found, figures.near.all));
            sum.frames += figures.frames;
            sum.frames_with_misses += figures.frames_with_misses;
            sum.held += figures.held;
        }
        let median = |time: fn(&Self) -> f64| {
            let mut times: Vec<_> = seeds.iter().map(time).collect();
            times.sort_by(f64::total_cmp);
            times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
        };
        Self {
            broad: median(|figures| figures.broad),
            both: median(|figures| figures.both),
            ..sum
        }
    }

    /// Pairs held per touching pair, which is the reciprocal of the precision.
    fn held_a_contact(&self) -> f64 {
        self.held as f64 / self.touching.all.max(1) as f64
    }
}

/// All finders in one scene; the first one is unisize by default.
pub(crate) struct Study {
    scene: &'static str,
    dim: u8,
    bodies: usize,
    finders: Vec<(Finder, Figures)>,
}

impl Study {
    fn title(&self) -> String {
        format!("{} {}D", self.scene, self.dim)
    }

    fn default(&self) -> &Figures {
        &self.finders[0].1
    }

    fn of(&self, finder: Finder) -> Option<&Figures> {
        let mut finders = self.finders.iter();
        finders.find(|of| of.0 == finder).map(|of| &of.1)
    }

    /// The fastest finder of those that fulfil a condition.
    fn fastest(&self, is_meant: impl Fn(Finder, &Figures) -> bool) -> Option<(Finder, &Figures)> {
        let meant = self.finders.iter().filter(|of| is_meant(of.0, &of.1));
        let fastest = meant.min_by(|a, b| a.1.both.total_cmp(&b.1.both));
        fastest.map(|of| (of.0, &of.1))
    }
}

/// A finder in a scene.
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

impl Frames {
    /// Measures these finders in all scenes.
    fn studies(
        &self,
        output: &mut Output,
        finders: impl Fn(usize) -> Vec<Finder>,
    ) -> Result<Vec<Study>> {
        let kinds = SCENES.into_iter();
        let kinds: Vec<_> = kinds
            .filter(|kind| self.only.is_empty() || self.only.iter().any(|n| n == kind.name()))
            .collect();
        let steps = self
            .common
            .steps
            .unwrap_or(self.common.usual(QUICK_STEPS, STEPS));
        let seeds = self.common.seeds(1, 3);
        let all = kinds.len() * self.common.dims().len() * seeds.clone().count() * steps;
        let bar = progress_bar(all as u64);
        let mut studies = Vec::new();
        for &dim in self.common.dims() {
            for &kind in &kinds {
                bar.set_message(format!("{} {dim}D", kind.name()));
                let bodies = self.bodies(kind);
                let finders = finders(bodies);
                let races: Vec<_> = (seeds.clone())
                    .map(|seed| {
                        let course = Course {
                            kind,
                            bodies,
                            seed,
                            lead_in: self.common.usual(QUICK_LEAD_IN, LEAD_IN),
                            steps,
                            truth_every: self.common.usual(QUICK_TRUTH_EVERY, TRUTH_EVERY),
                            finders: &finders,
                        };
                        match dim {
                            2 => dim2::frames::race(&course, || bar.inc(1)),
                            _ => dim3::frames::race(&course, || bar.inc(1)),
                        }
                    })
                    .collect();
                let figures = (0..finders.len()).map(|index| {
                    let seeds: Vec<_> = races.iter().map(|race| race[index]).collect();
                    Figures::of(&seeds)
                });
                let study = Study {
                    scene: kind.name(),
                    dim,
                    bodies,
                    finders: finders.iter().copied().zip(figures).collect(),
                };
                for (finder, figures) in &study.finders {
                    let row = Row {
                        dimension: dim,
                        scene: study.scene,
                        bodies,
                        method: finder.name(),
                        cannot_miss: finder.is_exact(),
                        figures,
                    };
                    output.row("method", &row)?;
                }
                studies.push(study);
            }
        }
        bar.finish_and_clear();
        Ok(studies)
    }

    fn bodies(&self, kind: SceneKind) -> usize {
        let usual = match kind {
            SceneKind::Ropes => 1_000,
            _ => 2_000,
        };
        self.bodies
            .unwrap_or(self.common.usual(QUICK_BODIES, usual))
    }
}

/// Prints a figure of every scene and finder.
fn print_by_scene(studies: &[Study], what: &str, figure: impl Fn(&Study, &Figures) -> String) {
    println!("### {what}\n");
    let mut finders: Vec<Finder> = Vec::new();
    for (finder, _) in studies.iter().flat_map(|study| &study.finders) {
        if !finders.contains(finder) {
            finders.push(*finder);
        }
    }
    let mut head = vec!["scene".to_owned()];
    head.extend(finders.iter().map(|finder| finder.name()));
    let mut table = table(head);
    for study in studies {
        let mut row = vec![study.title()];
        row.extend(finders.iter().map(|&finder| {
            let figures = study.of(finder);
            figures.map_or_else(|| "-".to_owned(), |figures| figure(study, figures))
        }));
        table.add_row(row);
    }
    println!("{table}\n");
}

/// Whether something touches, and what cannot miss has missed nothing of it; prints what is wrong.
fn is_sound(studies: &[Study]) -> bool {
    let mut is_sound = true;
    for study in studies {
        if study.default().touching.all == 0 {
            println!(
                "NOTHING TOUCHES in {}: nothing could be missed.\n",
                study.title()
            );
        }
        for (finder, figures) in study.finders.iter().filter(|of| of.0.is_exact()) {
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
    let touching: usize = studies
        .iter()
        .map(|study| study.default().touching.all)
        .sum();
    if is_sound {
        println!("What cannot miss missed nothing of {touching} pairs that touch.");
    }
    is_sound && touching > 0
}

#[cfg(test)]
mod tests {
    use super::{Figures, Recall, Study};
    use crate::finder::{Cell, Finder};

    fn figures(found: usize, both: f64) -> Figures {
        Figures {
            touching: Recall { found, all: 200 },
            held: 400,
            broad: both / 2.0,
            both,
            ..Figures::default()
        }
    }

    #[test]
    fn seeds_are_summed_and_times_are_medians() {
        let of = Figures::of(&[figures(200, 3.0), figures(150, 1.0), figures(200, 2.0)]);
        assert_eq!((of.touching.all, of.touching.missed()), (600, 50));
        assert_eq!((of.both, of.broad, of.held_a_contact()), (2.0, 1.0, 2.0));
        assert_eq!(Recall::default().share_missed(), 0.0);
    }

    #[test]
    fn only_a_miss_of_what_cannot_miss_is_wrong() {
        let study = |finder, found| {
            [Study {
                scene: "ropes",
                dim: 2,
                bodies: 100,
                finders: vec![
                    (Finder::DEFAULT, figures(200, 2.0)),
                    (finder, figures(found, 1.0)),
                ],
            }]
        };
        assert!(super::is_sound(&study(Finder::Rapier, 200)));
        assert!(!super::is_sound(&study(Finder::Rapier, 199)));
        assert!(!super::is_sound(&study(Finder::Grid(Cell::Largest), 199)));
        let fast = study(Finder::Grid(Cell::Median), 199);
        assert!(super::is_sound(&fast));
        let fastest = fast[0].fastest(|finder, _| finder.is_exact()).unwrap();
        assert_eq!(fastest.0, Finder::DEFAULT);
        assert!(!super::is_sound(&[]));
    }
}
