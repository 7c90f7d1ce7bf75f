//! The comparison of every error in every scene, and what follows from all of them together.

use crate::case::{Finder, Method, Scalar};
use crate::scene::Scene;
use crate::statistics::{Median, holm, paired_test};
use crate::study::Study;

/// Two methods are told apart if the chance of it is less than that, were they alike: of all tests together.
pub(crate) const LEVEL: f64 = 0.05;

/// The time step at which medians are shown, in steps per second.
const SHOWN: u32 = 60;

/// One error in one scene, with another broad phase than Rapier's own, compared with it on the same starts.
#[derive(Clone, Debug)]
pub(crate) struct Comparison {
    pub(crate) dim: u8,
    pub(crate) scene: Scene,
    pub(crate) error: &'static str,
    pub(crate) scalar: Scalar,
    /// With Rapier's own broad phase, at 60 steps a second.
    pub(crate) own: Median,
    /// With the other one.
    pub(crate) other: Median,
    /// How many runs, of all seeds and time steps, were worse with the other one, better, and the same.
    pub(crate) worse: usize,
    pub(crate) better: usize,
    pub(crate) same: usize,
    /// The chance of a difference as large as this, were both alike.
    pub(crate) p: f64,
    /// The same for all tests together.
    pub(crate) adjusted: f64,
}

impl Comparison {
    fn new(study: &Study, error: usize, method: Method) -> Self {
        let reference = Method {
            finder: Finder::Rapier,
            ..method
        };
        let own = study.samples(reference, error);
        let other = study.samples(method, error);
        let pairs = || own.iter().flatten().zip(other.iter().flatten());
        let p = paired_test(&own, &other);
        Self {
            dim: study.dim,
            scene: study.scene,
            error: study.errors()[error],
            scalar: method.scalar,
            own: study.error(reference, SHOWN, error),
            other: study.error(method, SHOWN, error),
            worse: pairs().filter(|(own, other)| other > own).count(),
            better: pairs().filter(|(own, other)| other < own).count(),
            same: pairs().filter(|(own, other)| other == own).count(),
            p,
            adjusted: p,
        }
    }

    /// Whether any run came out differently. If none did, the chance is one, and does not count among the tests.
    pub(crate) fn is_test(&self) -> bool {
        self.worse + self.better > 0
    }

    /// Whether the two are told apart.
    pub(crate) fn is_told_apart(&self) -> bool {
        self.adjusted < LEVEL
    }
}

/// All comparisons of a run.
#[derive(Clone, Debug)]
pub(crate) struct Verdict {
    /// unisize with Rapier's own broad phase.
    pub(crate) ours: Vec<Comparison>,
    /// The control with Rapier's own broad phase.
    pub(crate) control: Vec<Comparison>,
    /// How many comparisons of unisize are tests.
    pub(crate) tests: usize,
    /// What the p-values of the control are multiplied by: that, or the number of its own tests.
    pub(crate) control_factor: usize,
}

impl Verdict {
    /// Compares everything.
    ///
    /// The tests of unisize are corrected by Holm's method. Where all runs came out the same, there is nothing to test. The tests
    /// of the control are each multiplied by the number of the tests of unisize, or by that of its own if that is larger, which is
    /// at least as strict as Holm's method: what tells the control apart would have told unisize apart.
    pub(crate) fn of(studies: &[Study]) -> Self {
        let compare = |finder: Finder| {
            let of_study = move |study: &Study| {
                let methods = study
                    .methods
                    .iter()
                    .filter(|method| method.finder == finder);
                let errors = study.errors().len();
                let of_method = |&method: &Method| {
                    (0..errors)
                        .map(move |error| Comparison::new(study, error, method))
                        .collect::<Vec<_>>()
                };
                methods.flat_map(of_method).collect::<Vec<_>>()
            };
            studies.iter().flat_map(of_study).collect::<Vec<_>>()
        };
        let mut ours = compare(Finder::Unisize);
        let mut tests: Vec<_> = ours
            .iter_mut()
            .filter(|comparison| comparison.is_test())
            .collect();
        let p_values: Vec<_> = tests.iter().map(|comparison| comparison.p).collect();
        for (comparison, adjusted) in tests.iter_mut().zip(holm(&p_values)) {
            comparison.adjusted = adjusted;
        }
        let tests = tests.len();
        let mut control = compare(Finder::Control);
        let own_tests = control.iter().filter(|comparison| comparison.is_test());
        let control_factor = tests.max(own_tests.count());
        for comparison in &mut control {
            comparison.adjusted = (comparison.p * control_factor.max(1) as f64).min(1.0);
        }
        Self {
            ours,
            control,
            tests,
            control_factor,
        }
    }

    /// Whether unisize cannot be told apart from Rapier's own broad phase in anything.
    pub(crate) fn is_same(&self) -> bool {
        !self.ours.iter().any(Comparison::is_told_apart)
    }

    /// Whether unisize is told apart by any error of a scene.
    pub(crate) fn is_told_apart(&self, dim: u8, scene: Scene, scalar: Scalar) -> bool {
        let mut ours = self.ours.iter();
        ours.any(|comparison| {
            let place = (comparison.dim, comparison.scene, comparison.scalar);
            place == (dim, scene, scalar) && comparison.is_told_apart()
        })
    }

    /// Where the control is told apart by one error at least: the dimension and the scene.
    pub(crate) fn noticed(&self) -> Vec<(u8, Scene)> {
        let mut scenes: Vec<_> = self
            .control
            .iter()
            .filter(|comparison| comparison.is_told_apart())
            .map(|comparison| (comparison.dim, comparison.scene))
            .collect();
        scenes.dedup();
        scenes
    }
}

#[cfg(test)]
mod tests {
    use super::Verdict;
    use crate::case::{Finder, Method, Reading, Run, Scalar};
    use crate::scene::Scene;
    use crate::study::Study;

    /// A study of 20 seeds in which the errors of unisize and of the control are larger by these factors.
    fn study(ours: f64, control: f64) -> Study {
        let methods = Method::all(&[Scalar::F32]);
        let mut study = Study::new(2, Scene::Pile, 10, 1.0, &methods, &[60, 120]);
        for seed in 1..=20 {
            for &frequency in study.frequencies {
                for &method in &methods {
                    let factor = match method.finder {
                        Finder::Rapier => 1.0,
                        Finder::Unisize => ours,
                        Finder::Control => control,
                    };
                    let errors = ["an error", "another"].map(|name| Reading {
                        name,
                        value: factor * f64::from(seed) / f64::from(frequency),
                    });
                    let run = Run {
                        milliseconds: 1.0,
                        errors: errors.into(),
                        pairs: Some([1000, 1]).filter(|_| method.finder == Finder::Control),
                        state: 0,
                    };
                    study.push(method, frequency, run);
                }
            }
        }
        study
    }

    #[test]
    fn what_is_larger_is_told_apart_and_what_is_equal_is_not() {
        let verdict = Verdict::of(&[study(1.0, 1.1)]);
        assert!(verdict.is_same());
        assert_eq!(verdict.tests, 0);
        assert_eq!(verdict.noticed(), [(2, Scene::Pile)]);
        assert!(verdict.ours.iter().all(|comparison| comparison.same == 40));
        assert!(
            verdict
                .control
                .iter()
                .all(|comparison| comparison.worse == 40)
        );
        // unisize has no test, and the control has two.
        assert!((verdict.control[0].adjusted - 2.0 * verdict.control[0].p).abs() < 1e-12);

        let verdict = Verdict::of(&[study(0.9, 1.0)]);
        assert!(!verdict.is_same());
        assert!(verdict.is_told_apart(2, Scene::Pile, Scalar::F32));
        assert!(!verdict.is_told_apart(3, Scene::Pile, Scalar::F32));
        assert!(verdict.noticed().is_empty());
        assert_eq!(verdict.tests, 2);
        // Two tests, both at the smallest value.
        assert!((verdict.ours[0].adjusted - 2.0 * verdict.ours[0].p).abs() < 1e-12);
        assert!(
            verdict
                .ours
                .iter()
                .all(|comparison| comparison.better == 40)
        );
    }
}
