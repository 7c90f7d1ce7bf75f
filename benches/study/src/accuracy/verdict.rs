//! The comparison of every error in every scene, and the verdict from all of them together.

use super::ensembles::Ensembles;
use crate::finder::{FINDERS, Finder};
use crate::statistics::{holm, paired_test};

/// Two methods differ significantly if the corrected p-value is less than this.
pub(crate) const LEVEL: f64 = 0.05;

/// One error in one scene on a method, compared with Rapier's own broad phase on the same starts.
#[derive(Clone, Debug)]
pub(crate) struct Comparison {
    /// The scene, by its index.
    pub(crate) scene: usize,
    /// The error, by its index.
    pub(crate) error: usize,
    pub(crate) finder: Finder,
    /// The number of runs, over all seeds and time steps, that were worse with the method, and better.
    pub(crate) worse: usize,
    pub(crate) better: usize,
    /// The p-value of the difference.
    pub(crate) p: f64,
    /// The p-value corrected for the number of tests.
    pub(crate) corrected: f64,
}

impl Comparison {
    fn new(scene: usize, study: &Ensembles, error: usize, finder: Finder) -> Self {
        let own = study.samples(Finder::Rapier, error);
        let other = study.samples(finder, error);
        let count = |is_so: fn(f64, f64) -> bool| {
            let pairs = own.iter().flatten().zip(other.iter().flatten());
            pairs.filter(|(own, other)| is_so(**own, **other)).count()
        };
        let p = paired_test(&own, &other);
        Self {
            scene,
            error,
            finder,
            worse: count(|own, other| other > own),
            better: count(|own, other| other < own),
            p,
            corrected: p,
        }
    }

    /// Whether any run differs. If none does, the p-value is one, and the comparison does not count as a test.
    fn is_test(&self) -> bool {
        self.worse + self.better > 0
    }
}

/// All comparisons of every method but Rapier's own broad phase with that one.
#[derive(Clone, Debug)]
pub(crate) struct Verdict(pub(crate) Vec<Comparison>);

impl Verdict {
    /// Compares everything.
    ///
    /// The tests of each method are corrected by Holm's method. They count as at least as many as unisize has, so that unisize would be
    /// held to the same level.
    pub(crate) fn of(studies: &[Ensembles]) -> Self {
        let mut verdict = Self(Vec::new());
        for (scene, study) in studies.iter().enumerate() {
            for error in 0..study.errors().len() {
                let others = FINDERS.iter().filter(|&&finder| finder != Finder::Rapier);
                let compared = others.map(|&finder| Comparison::new(scene, study, error, finder));
                verdict.0.extend(compared);
            }
        }
        let least = verdict.tests(Finder::DEFAULT);
        for &finder in FINDERS {
            let is_tested = |of: &&mut Comparison| of.finder == finder && of.is_test();
            let tests: Vec<_> = verdict.0.iter_mut().filter(is_tested).collect();
            let p_values: Vec<_> = tests.iter().map(|test| test.p).collect();
            for (test, corrected) in tests.into_iter().zip(holm(&p_values, least)) {
                test.corrected = corrected;
            }
        }
        verdict
    }

    /// How many comparisons of a method are tests.
    pub(crate) fn tests(&self, finder: Finder) -> usize {
        let of_finder = self.0.iter().filter(|of| of.finder == finder);
        of_finder.filter(|of| of.is_test()).count()
    }

    /// Whether at least one error of a scene differs significantly between a method and Rapier's own broad phase.
    pub(crate) fn tells_apart(&self, scene: usize, finder: Finder) -> bool {
        let mut all = self.0.iter();
        all.any(|of| (of.scene, of.finder) == (scene, finder) && of.corrected < LEVEL)
    }

    /// The number of scenes in which at least one error does.
    pub(crate) fn told_apart(&self, scenes: usize, finder: Finder) -> usize {
        let told_apart = (0..scenes).filter(|&scene| self.tells_apart(scene, finder));
        told_apart.count()
    }
}

#[cfg(test)]
mod tests {
    use super::super::FREQUENCIES;
    use super::super::ensembles::Run;
    use super::*;
    use unisize_scenes::SceneKind;

    /// The verdict on 20 seeds in which the errors of unisize and of the control are larger by these factors: how many scenes tell
    /// either apart, and the first comparison of each.
    fn verdict(ours: f64, control: f64) -> ([usize; 2], [Comparison; 2], usize) {
        let mut study = Ensembles::new(2, SceneKind::FallingBalls, 10, 1.0);
        for seed in 1..=20 {
            let of_step = |frequency| FINDERS.iter().map(move |&finder| (frequency, finder));
            for (frequency, finder) in FREQUENCIES.into_iter().flat_map(of_step) {
                let factor = match finder {
                    Finder::Unisize(_) => ours,
                    Finder::Lossy => control,
                    _ => 1.0,
                };
                let error = factor * f64::from(seed) / f64::from(frequency);
                let run = Run {
                    milliseconds: 1.0,
                    errors: ["an error", "another"].map(|name| (name, error)).into(),
                    state: 0,
                };
                study.push(finder, frequency, run);
            }
        }
        let verdict = Verdict::of(&[study]);
        let finders = [Finder::DEFAULT, Finder::Lossy];
        let first = |finder| verdict.0.iter().find(|of| of.finder == finder).cloned();
        (
            finders.map(|finder| verdict.told_apart(1, finder)),
            finders.map(|finder| first(finder).expect("all are compared")),
            verdict.tests(Finder::DEFAULT),
        )
    }

    #[test]
    fn what_is_larger_is_told_apart_and_what_is_equal_is_not() {
        let (told_apart, [ours, control], tests) = verdict(1.0, 1.1);
        assert_eq!((told_apart, tests), ([0, 1], 0));
        assert_eq!([ours.worse + ours.better, control.worse], [0, 80]);
        // unisize has no test, and the control has two.
        assert!((control.corrected - 2.0 * control.p).abs() < 1e-12);

        let (told_apart, [ours, _], tests) = verdict(0.9, 1.0);
        assert_eq!((told_apart, tests), ([1, 0], 2));
        // Two tests, both at the smallest value.
        assert!((ours.corrected - 2.0 * ours.p).abs() < 1e-12);
        assert_eq!(ours.better, 80);
    }
}
