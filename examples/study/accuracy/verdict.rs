//! The comparison of every error in every scene, and what follows from all of them together.

use super::ensembles::Ensembles;
use crate::FINDERS;
use crate::finder::Finder;
use crate::statistics::{Median, holm, paired_test};
use serde::Serialize;
use unisize_scenes::SceneKind;

/// Two methods are told apart if the chance of it is less than that, were they alike: of all tests together.
pub(crate) const LEVEL: f64 = 0.05;

/// The time step at which medians are shown, in steps per second.
pub(crate) const SHOWN: u32 = 60;

/// One error in one scene, with another broad phase than Rapier's own, compared with it on the same starts.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Comparison {
    #[serde(skip)]
    pub(crate) kind: SceneKind,
    #[serde(skip)]
    pub(crate) finder: Finder,
    pub(crate) dimension: u8,
    scene: &'static str,
    pub(crate) error: &'static str,
    method: String,
    /// With Rapier's own broad phase, at 60 steps a second.
    rapier: Median,
    /// With the other one.
    other: Median,
    /// How many runs, of all seeds and time steps, were worse with the other one, better, and the same.
    worse: usize,
    better: usize,
    same: usize,
    /// The chance of a difference as large as this, were both alike.
    p: f64,
    /// The same for all tests together.
    corrected: f64,
}

impl Comparison {
    fn new(study: &Ensembles, error: usize, finder: Finder) -> Self {
        let own = study.samples(Finder::Rapier, error);
        let other = study.samples(finder, error);
        let pairs = || own.iter().flatten().zip(other.iter().flatten());
        let p = paired_test(&own, &other);
        Self {
            kind: study.kind,
            finder,
            dimension: study.dim,
            scene: study.kind.name(),
            error: study.errors()[error],
            method: finder.name(),
            rapier: study.error(Finder::Rapier, SHOWN, error),
            other: study.error(finder, SHOWN, error),
            worse: pairs().filter(|(own, other)| other > own).count(),
            better: pairs().filter(|(own, other)| other < own).count(),
            same: pairs().filter(|(own, other)| other == own).count(),
            p,
            corrected: p,
        }
    }

    /// Whether any run came out differently. If none did, the chance is one, and does not count among the tests.
    pub(crate) fn is_test(&self) -> bool {
        self.worse + self.better > 0
    }

    /// Whether the two are told apart.
    pub(crate) fn is_told_apart(&self) -> bool {
        self.corrected < LEVEL
    }
}

/// All comparisons of a run.
#[derive(Clone, Debug)]
pub(crate) struct Verdict {
    /// Every method but Rapier's own broad phase, with that one.
    pub(crate) comparisons: Vec<Comparison>,
    /// How many comparisons of unisize are tests.
    pub(crate) tests: usize,
}

impl Verdict {
    /// Compares everything.
    ///
    /// The tests of unisize are corrected by Holm's method. Where all runs came out the same, there is nothing to test. The tests
    /// of another finder are each multiplied by the number of the tests of unisize, or by that of its own if that is larger, which
    /// is at least as strict as Holm's method: what tells the other apart would have told unisize apart.
    pub(crate) fn of(studies: &[Ensembles]) -> Self {
        let mut comparisons = Vec::new();
        for study in studies {
            for error in 0..study.errors().len() {
                let others = FINDERS.iter().filter(|&&finder| finder != Finder::Rapier);
                comparisons.extend(others.map(|&finder| Comparison::new(study, error, finder)));
            }
        }
        let tests = |finder: Finder| {
            let comparisons = comparisons.iter();
            let tests = comparisons.filter(|of| of.finder == finder && of.is_test());
            tests.map(|of| of.p).collect::<Vec<_>>()
        };
        let ours = tests(Finder::DEFAULT);
        let mut adjusted = holm(&ours).into_iter();
        let factors = FINDERS.iter();
        let factors: Vec<_> = factors
            .map(|&finder| (finder, ours.len().max(tests(finder).len()) as f64))
            .collect();
        for (finder, factor) in factors {
            let of_finder = comparisons.iter_mut();
            let of_finder = of_finder.filter(|of| of.finder == finder && of.is_test());
            for comparison in of_finder {
                comparison.corrected = match finder == Finder::DEFAULT {
                    true => adjusted.next().unwrap_or(1.0),
                    false => (comparison.p * factor).min(1.0),
                };
            }
        }
        let ours = ours.len();
        Self {
            comparisons,
            tests: ours,
        }
    }

    /// The comparisons of what finds pairs like this, in a scene.
    pub(crate) fn of_scene<'a>(
        &'a self,
        study: &'a Ensembles,
        finder: Finder,
    ) -> impl Iterator<Item = &'a Comparison> {
        let comparisons = self.comparisons.iter();
        comparisons
            .filter(move |of| (of.dimension, of.kind, of.finder) == (study.dim, study.kind, finder))
    }

    /// The least corrected p-value of a scene.
    pub(crate) fn least(&self, study: &Ensembles, finder: Finder) -> f64 {
        let of_scene = self.of_scene(study, finder);
        of_scene
            .map(|comparison| comparison.corrected)
            .fold(1.0, f64::min)
    }

    /// In how many of these scenes one error at least tells it apart from Rapier's own.
    pub(crate) fn told_apart(&self, studies: &[Ensembles], finder: Finder) -> usize {
        let is_told_apart = |study: &&Ensembles| self.least(study, finder) < LEVEL;
        studies.iter().filter(is_told_apart).count()
    }
}

#[cfg(test)]
mod tests {
    use super::super::FREQUENCIES;
    use super::super::case::{Reading, Run};
    use super::{Comparison, Ensembles, FINDERS, Finder, SceneKind, Verdict};

    /// A study of 20 seeds in which the errors of unisize and of the control are larger by these factors.
    fn study(ours: f64, control: f64) -> Ensembles {
        let mut study = Ensembles::new(2, SceneKind::FallingBalls, 10, 1.0);
        for seed in 1..=20 {
            for frequency in FREQUENCIES {
                for &finder in FINDERS {
                    let factor = match finder {
                        Finder::Unisize(..) => ours,
                        Finder::Lossy => control,
                        _ => 1.0,
                    };
                    let errors = ["an error", "another"].map(|name| Reading {
                        name,
                        value: factor * f64::from(seed) / f64::from(frequency),
                    });
                    let run = Run {
                        milliseconds: 1.0,
                        errors: errors.into(),
                        pairs: None,
                        state: 0,
                    };
                    study.push(finder, frequency, run);
                }
            }
        }
        study
    }

    #[test]
    fn what_is_larger_is_told_apart_and_what_is_equal_is_not() {
        let told_apart = |study: Ensembles| {
            let studies = [study];
            let verdict = Verdict::of(&studies);
            let finders = [Finder::DEFAULT, Finder::Lossy];
            let counts = finders.map(|finder| verdict.told_apart(&studies, finder));
            (counts, verdict)
        };
        let of = |verdict: &Verdict, finder| -> Comparison {
            let mut comparisons = verdict.comparisons.iter();
            comparisons.find(|of| of.finder == finder).cloned().unwrap()
        };
        let (counts, verdict) = told_apart(study(1.0, 1.1));
        assert_eq!((counts, verdict.tests), ([0, 1], 0));
        let control = of(&verdict, Finder::Lossy);
        assert_eq!((control.worse, control.same), (80, 0));
        assert_eq!(of(&verdict, Finder::DEFAULT).same, 80);
        // unisize has no test, and the control has two.
        assert!((control.corrected - 2.0 * control.p).abs() < 1e-12);

        let (counts, verdict) = told_apart(study(0.9, 1.0));
        assert_eq!((counts, verdict.tests), ([1, 0], 2));
        // Two tests, both at the smallest value.
        let ours = of(&verdict, Finder::DEFAULT);
        assert!((ours.corrected - 2.0 * ours.p).abs() < 1e-12);
        assert_eq!(ours.better, 80);
    }
}
