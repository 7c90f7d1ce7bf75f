//! What was measured of one scene in one dimension: an ensemble of runs for every method and time step.

use super::case::Run;
use crate::finder::Finder;
use crate::statistics::Median;
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
        let names = errors.into_iter().flatten().map(|error| error.name);
        names.collect()
    }

    /// An error by seed.
    fn sample(&self, finder: Finder, frequency: u32, error: usize) -> Vec<f64> {
        let runs = self.runs(finder, frequency);
        runs.map(|run| run.errors[error].value).collect()
    }

    /// An error by time step, then by seed.
    pub(crate) fn samples(&self, finder: Finder, error: usize) -> Vec<Vec<f64>> {
        let frequencies = super::FREQUENCIES.iter();
        frequencies
            .map(|&frequency| self.sample(finder, frequency, error))
            .collect()
    }

    /// The median of an error over the seeds.
    pub(crate) fn error(&self, finder: Finder, frequency: u32, error: usize) -> Median {
        Median::of(self.sample(finder, frequency, error))
    }

    /// The median of the milliseconds for one simulated second.
    pub(crate) fn milliseconds(&self, finder: Finder, frequency: u32) -> Median {
        let runs = self.runs(finder, frequency);
        Median::of(runs.map(|run| run.milliseconds))
    }

    /// How many pairs a method found in all its runs, and how many of them it lost.
    pub(crate) fn pairs(&self, finder: Finder) -> [usize; 2] {
        let runs = self.runs.iter().filter(|of| of.0 == finder);
        let pairs = runs.filter_map(|of| of.2.pairs);
        pairs.fold([0; 2], |sum, pairs| [sum[0] + pairs[0], sum[1] + pairs[1]])
    }

    /// Whether all errors of what misses nothing are numbers, as they are unless a simulation has exploded.
    pub(crate) fn is_finite(&self) -> bool {
        let exact = self.runs.iter().filter(|of| of.0.is_exact());
        let mut errors = exact.flat_map(|of| &of.2.errors);
        errors.all(|error| error.value.is_finite())
    }
}
