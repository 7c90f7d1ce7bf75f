//! The pairs that methods miss which trade accuracy for speed, and the time that they save, all on the same frames.
//!
//! - **recall**: how many of the pairs whose shapes touch, by Parry's exact queries, are held;
//! - **cost**: the time of the broad and the narrow phase together, because a wide margin moves work from one to the other.
//!
//! The study distinguishes methods that cannot miss from those that happened not to. For the latter, n frames without a miss mean that
//! fewer than about 3 / n of all frames have one (the rule of three).

use crate::finder::{Cell, Finder};
use crate::options::Common;
use crate::output::Output;
use crate::statistics::{geometric_mean, median, rarer_than};
use crate::{dim2, dim3};
use anyhow::Result;
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

/// The methods, unisize with its default first: one of each idea.
pub(crate) const FINDERS: [Finder; 10] = [
    Finder::DEFAULT,
    Finder::Unisize(Some(0.0)),
    Finder::Rapier,
    Finder::Grid(Cell::Largest),
    Finder::Grid(Cell::Median),
    Finder::Seldom(2, None),
    Finder::Seldom(2, Some(0.5)),
    Finder::Seldom(4, None),
    Finder::Seldom(8, None),
    Finder::Lossy,
];

/// Steps before the measured ones, of a quick run and of a full one: by then, bodies touch in every scene.
const LEAD_IN: [usize; 2] = [80, 140];
const STEPS: [usize; 2] = [20, 80];

/// The approximate number of bodies: of most scenes, of ropes, and of all in a quick run.
const BODIES: usize = 2_000;
const ROPES: usize = 1_000;
const QUICK_BODIES: usize = 120;

/// The ground truth is computed every n-th step. The number is odd, so that it meets all phases of an interval of two, four or eight.
const TRUTH_EVERY: [usize; 2] = [3, 5];

/// The frames on which all methods are measured.
pub(crate) struct Course {
    pub(crate) kind: SceneKind,
    pub(crate) bodies: usize,
    pub(crate) seed: u64,
    /// Steps before the measured ones.
    pub(crate) lead_in: usize,
    pub(crate) steps: usize,
    pub(crate) truth_every: usize,
}

/// The pairs that one method held and missed on a course, and its cost.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Figures {
    /// Pairs of shapes that touch or overlap, and how many of them it missed.
    pub(crate) touching: usize,
    pub(crate) missed: usize,
    /// The number of missed pairs nearer than the prediction distance, with the touching ones.
    pub(crate) near_missed: usize,
    /// Frames that were compared with the truth, and those in which a touching pair was missed.
    pub(crate) frames: usize,
    pub(crate) frames_with_misses: usize,
    /// Pairs held, summed over these frames.
    pub(crate) held: usize,
    /// Milliseconds per step of broad and narrow phase together.
    pub(crate) both: f64,
}

impl Figures {
    /// The sums of the counts over several seeds, and the medians of the times.
    fn of(seeds: &[Self]) -> Self {
        let sum = |count: fn(&Self) -> usize| seeds.iter().map(count).sum();
        Self {
            touching: sum(|of| of.touching),
            missed: sum(|of| of.missed),
            near_missed: sum(|of| of.near_missed),
            frames: sum(|of| of.frames),
            frames_with_misses: sum(|of| of.frames_with_misses),
            held: sum(|of| of.held),
            both: median(seeds.iter().map(|of| of.both)),
        }
    }

    fn share_missed(&self) -> f64 {
        self.missed as f64 / self.touching.max(1) as f64
    }
}

/// All methods in one scene, in their order.
struct Study {
    scene: SceneKind,
    dim: u8,
    figures: Vec<Figures>,
}

/// Runs the study; whether unisize has passed.
pub(crate) fn run(common: &Common) -> Result<bool> {
    let mut output = Output::create(common)?;
    let studies = common.each(
        &SCENES,
        |kind| kind.name(),
        |dim, &kind| study(common, dim, kind),
    );
    for method in Method::all(&studies) {
        method.report(&mut output)?;
    }
    for study in &studies {
        study.report(&mut output)?;
    }
    Ok(is_sound(&studies))
}

/// Measures all methods in one scene.
fn study(common: &Common, dim: u8, scene: SceneKind) -> Study {
    let bodies = match scene {
        SceneKind::Ropes => ROPES,
        _ => BODIES,
    };
    let race = |seed| {
        let course = Course {
            kind: scene,
            bodies: common.usual([QUICK_BODIES, bodies]),
            seed,
            lead_in: common.usual(LEAD_IN),
            steps: common.steps.unwrap_or(common.usual(STEPS)),
            truth_every: common.usual(TRUTH_EVERY),
        };
        match dim {
            2 => dim2::missed::race(&course),
            _ => dim3::missed::race(&course),
        }
    };
    let races: Vec<_> = common.seeds([1, 3]).map(race).collect();
    let of_finder = |index| {
        let seeds: Vec<_> = races.iter().map(|race| race[index]).collect();
        Figures::of(&seeds)
    };
    Study {
        scene,
        dim,
        figures: (0..FINDERS.len()).map(of_finder).collect(),
    }
}

impl Study {
    fn report(&self, output: &mut Output) -> Result<()> {
        for (finder, figures) in FINDERS.into_iter().zip(&self.figures) {
            output.row(
                "scene",
                &[
                    ("dimension", self.dim.into()),
                    ("scene", self.scene.name().into()),
                    ("method", finder.name().into()),
                    ("touching", figures.touching.into()),
                    ("missed", figures.missed.into()),
                    ("near_missed", figures.near_missed.into()),
                    ("frames", figures.frames.into()),
                    ("frames_with_misses", figures.frames_with_misses.into()),
                    ("held", figures.held.into()),
                    ("both_ms", figures.both.into()),
                ],
            )?;
        }
        Ok(())
    }
}

/// One method in all scenes.
struct Method {
    finder: Finder,
    /// The time of broad and narrow phase over that of unisize by default, the mean of all scenes.
    both: f64,
    /// The share that is missed in the worst scene.
    missed: f64,
    frames: usize,
    frames_with_misses: usize,
}

impl Method {
    fn all(studies: &[Study]) -> Vec<Self> {
        let of = |(index, finder): (usize, Finder)| {
            let figures = || studies.iter().map(|study| &study.figures[index]);
            let ratio = |study: &Study| study.figures[index].both / study.figures[0].both;
            Self {
                finder,
                both: geometric_mean(&studies.iter().map(ratio).collect::<Vec<_>>()),
                missed: figures().map(Figures::share_missed).fold(0.0, f64::max),
                frames: figures().map(|of| of.frames).sum(),
                frames_with_misses: figures().map(|of| of.frames_with_misses).sum(),
            }
        };
        FINDERS.into_iter().enumerate().map(of).collect()
    }

    /// The number of frames with misses, or its bound if there are none.
    fn misses(&self) -> String {
        let frames = self.frames;
        match self.frames_with_misses {
            0 if self.finder.is_exact() => "cannot".to_owned(),
            0 => format!("0 of {frames}, below {:.2} %", 100.0 * rarer_than(frames)),
            count => format!("{count} of {frames}"),
        }
    }

    fn report(&self, output: &mut Output) -> Result<()> {
        output.row(
            "method",
            &[
                ("method", self.finder.name().into()),
                ("cannot_miss", self.finder.is_exact().into()),
                ("both", self.both.into()),
                ("missed_percent", (100.0 * self.missed).into()),
                ("misses", self.misses().into()),
            ],
        )
    }
}

/// Whether some pairs touch, and no exact method has missed any of them; prints what is wrong.
fn is_sound(studies: &[Study]) -> bool {
    let mut is_sound = true;
    let mut touching = 0;
    for study in studies {
        let title = format!("{} {}D", study.scene.name(), study.dim);
        touching += study.figures[0].touching;
        if study.figures[0].touching == 0 {
            println!("NOTHING TOUCHES in {title}: nothing could be missed.");
        }
        let finders = FINDERS.into_iter().zip(&study.figures);
        for (finder, figures) in finders.filter(|of| of.0.is_exact()) {
            let missed = figures.missed + figures.near_missed;
            if missed > 0 {
                is_sound = false;
                println!("MISSED: {missed} pairs in {title} by {}", finder.name());
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
    use super::*;

    fn study(missed: impl Fn(usize) -> usize) -> Study {
        let figures = (0..FINDERS.len()).map(|index| Figures {
            touching: 200,
            missed: missed(index),
            frames: 16,
            frames_with_misses: missed(index),
            ..Figures::default()
        });
        Study {
            scene: SceneKind::Ropes,
            dim: 2,
            figures: figures.collect(),
        }
    }

    #[test]
    fn only_a_miss_of_what_cannot_miss_is_wrong() {
        for (index, finder) in FINDERS.into_iter().enumerate() {
            let study = study(|of| usize::from(of == index));
            assert_eq!(is_sound(&[study]), !finder.is_exact(), "{}", finder.name());
        }
        assert!(!is_sound(&[]));
    }

    #[test]
    fn what_could_have_missed_has_a_bound() {
        for method in Method::all(&[study(|_| 0), study(|_| 0)]) {
            let expected = match method.finder.is_exact() {
                true => "cannot",
                false => "0 of 32, below 8.94 %",
            };
            assert_eq!(method.misses(), expected);
        }
        let missing = Method::all(&[study(|_| 3)]);
        assert!(missing.iter().all(|of| of.misses() == "3 of 16"));
    }
}
