//! What was measured of one scene in one dimension: an ensemble of runs for every method and time step.

use super::FREQUENCIES;
use super::case::{Case, Run};
use crate::finder::Finder;
use crate::statistics::median;
use unisize_scenes::SceneKind;

/// The runs of one scene in one dimension.
#[derive(Clone, Debug)]
pub(crate) struct Ensembles {
    pub(crate) dim: u8,
    pub(crate) kind: SceneKind,
    pub(crate) bodies: usize,
    pub(crate) seconds: f64,
    runs: Vec<(Finder, u32, Run)>,
}

impl Ensembles {
    /// A scene for which nothing has run yet.
    pub(crate) fn new(dim: u8, kind: SceneKind, bodies: usize, seconds: f64) -> Self {
        Self {
            dim,
            kind,
            bodies,
            seconds,
            runs: Vec::new(),
        }
    }

    /// The name of the scene, with its dimension.
    pub(crate) fn title(&self) -> String {
        format!("{} {}D", self.kind.name(), self.dim)
    }

    /// One simulation of it.
    pub(crate) fn case(&self, finder: Finder, frequency: u32, seed: u64) -> Case {
        Case {
            kind: self.kind,
            finder,
            frequency,
            seed,
            bodies: self.bodies,
            seconds: self.seconds,
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

    /// The names of the errors, the most telling one first.
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

    /// Whether all errors of what misses nothing are numbers, as they are unless a simulation has exploded.
    pub(crate) fn is_finite(&self) -> bool {
        let exact = self.runs.iter().filter(|of| of.0.is_exact());
        let mut errors = exact.flat_map(|of| &of.2.errors);
        errors.all(|(_, error)| error.is_finite())
    }
}
