//! A simulation and its errors, and the ensembles of one scene in one dimension: the runs of every method and time step.

use super::FREQUENCIES;
use crate::finder::Finder;
use crate::statistics::median;
use unisize_scenes::SceneKind;

/// One simulation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    pub(crate) kind: SceneKind,
    pub(crate) finder: Finder,
    /// Steps per simulated second; a multiple of [`FRAMES`].
    pub(crate) frequency: u32,
    /// The seed of the small differences between starting positions.
    pub(crate) seed: u64,
    /// About how many bodies.
    pub(crate) bodies: usize,
    /// How long, in simulated seconds.
    pub(crate) seconds: f64,
}

/// Errors are measured this many times per simulated second, with every time step.
pub(crate) const FRAMES: u32 = 30;

/// The names of the errors.
pub(crate) const STRAYED: &str = "largest distance from its place, sizes";
pub(crate) const STRETCH: &str = "largest stretch, links";
pub(crate) const DEEPEST: &str = "largest penetration, sizes";
pub(crate) const MEAN_DEPTH: &str = "mean penetration, sizes";
pub(crate) const LOST: &str = "bodies lost, of all";
pub(crate) const ENERGY: &str = "energy gained, of what was put in";

/// The result of a simulation.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    /// Milliseconds of processor time per simulated second, without the time of measuring errors.
    pub(crate) milliseconds: f64,
    /// The errors by name, the most significant one first. None is NaN: an error that is not a number counts as infinite.
    pub(crate) errors: Vec<(&'static str, f64)>,
    /// A hash of the poses and velocities of all bodies at the end.
    pub(crate) state: u64,
}

/// The runs of one scene in one dimension.
#[derive(Clone, Debug)]
pub(crate) struct Ensembles {
    pub(crate) dim: u8,
    /// The fields that all runs have in common; its method, time step and seed have no meaning.
    pub(crate) case: Case,
    runs: Vec<(Finder, u32, Run)>,
}

impl Ensembles {
    /// A scene for which nothing has run yet.
    pub(crate) fn new(dim: u8, kind: SceneKind, bodies: usize, seconds: f64) -> Self {
        let case = Case {
            kind,
            finder: Finder::DEFAULT,
            frequency: FRAMES,
            seed: 0,
            bodies,
            seconds,
        };
        Self {
            dim,
            case,
            runs: Vec::new(),
        }
    }

    /// The name of the scene, with its dimension.
    pub(crate) fn title(&self) -> String {
        format!("{} {}D", self.case.kind.name(), self.dim)
    }

    /// One simulation of it.
    pub(crate) fn case(&self, finder: Finder, frequency: u32, seed: u64) -> Case {
        Case {
            finder,
            frequency,
            seed,
            ..self.case
        }
    }

    /// Adds the run of the next seed.
    pub(crate) fn push(&mut self, finder: Finder, frequency: u32, run: Run) {
        self.runs.push((finder, frequency, run));
    }

    fn runs(&self, finder: Finder, frequency: u32) -> impl Iterator<Item = &Run> {
        let runs = self.runs.iter();
        let runs = runs.filter(move |of| (of.0, of.1) == (finder, frequency));
        runs.map(|of| &of.2)
    }

    /// The names of the errors, the most significant one first.
    pub(crate) fn errors(&self) -> Vec<&'static str> {
        let errors = self.runs.first().map(|of| &of.2.errors);
        errors.into_iter().flatten().map(|error| error.0).collect()
    }

    /// An error by time step, then by seed.
    pub(crate) fn samples(&self, finder: Finder, error: usize) -> Vec<Vec<f64>> {
        let sample = |frequency| self.runs(finder, frequency).map(|run| run.errors[error].1);
        FREQUENCIES
            .map(|frequency| sample(frequency).collect())
            .into()
    }

    /// The median of an error over the seeds.
    pub(crate) fn error(&self, finder: Finder, frequency: u32, error: usize) -> f64 {
        median(self.runs(finder, frequency).map(|run| run.errors[error].1))
    }

    /// The median of the milliseconds for one simulated second.
    pub(crate) fn milliseconds(&self, finder: Finder, frequency: u32) -> f64 {
        median(self.runs(finder, frequency).map(|run| run.milliseconds))
    }

    /// Whether all errors of exact methods are finite, as they are unless a simulation has exploded.
    pub(crate) fn is_finite(&self) -> bool {
        let exact = self.runs.iter().filter(|of| of.0.is_exact());
        let mut errors = exact.flat_map(|of| &of.2.errors);
        errors.all(|(_, error)| error.is_finite())
    }
}
