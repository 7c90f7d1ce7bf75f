//! What was measured of one scene in one dimension: every method with every time step and seed.

use crate::case::{Method, Run};
use crate::scene::Scene;
use crate::statistics::Median;

/// The runs of one scene in one dimension.
#[derive(Clone, Debug)]
pub(crate) struct Study {
    pub(crate) dim: u8,
    pub(crate) scene: Scene,
    pub(crate) bodies: usize,
    pub(crate) seconds: f64,
    pub(crate) methods: Vec<Method>,
    /// Steps per simulated second.
    pub(crate) frequencies: &'static [u32],
    ensembles: Vec<Ensemble>,
}

/// The runs of one method with one time step, by seed.
#[derive(Clone, Debug)]
struct Ensemble {
    method: Method,
    frequency: u32,
    runs: Vec<Run>,
}

impl Study {
    pub(crate) fn new(
        dim: u8,
        scene: Scene,
        bodies: usize,
        seconds: f64,
        methods: &[Method],
        frequencies: &'static [u32],
    ) -> Self {
        let ensembles = frequencies.iter().flat_map(|&frequency| {
            let of_method = move |&method: &Method| Ensemble {
                method,
                frequency,
                runs: Vec::new(),
            };
            methods.iter().map(of_method)
        });
        Self {
            dim,
            scene,
            bodies,
            seconds,
            methods: methods.to_vec(),
            frequencies,
            ensembles: ensembles.collect(),
        }
    }

    /// Adds the run of the next seed.
    pub(crate) fn push(&mut self, method: Method, frequency: u32, run: Run) {
        let mut ensembles = self.ensembles.iter_mut();
        let is_of =
            |ensemble: &&mut Ensemble| ensemble.method == method && ensemble.frequency == frequency;
        let ensemble = ensembles.find(is_of);
        ensemble
            .expect("a method and a time step of this study")
            .runs
            .push(run);
    }

    fn runs(&self, method: Method, frequency: u32) -> &[Run] {
        let mut ensembles = self.ensembles.iter();
        let found =
            ensembles.find(|ensemble| ensemble.method == method && ensemble.frequency == frequency);
        found.map_or(&[], |ensemble| &ensemble.runs)
    }

    /// The names of the errors, the most telling one first.
    pub(crate) fn errors(&self) -> Vec<&'static str> {
        let first = self
            .ensembles
            .iter()
            .find_map(|ensemble| ensemble.runs.first());
        first.map_or(Vec::new(), |run| {
            run.errors.iter().map(|error| error.name).collect()
        })
    }

    /// An error by seed.
    fn sample(&self, method: Method, frequency: u32, error: usize) -> Vec<f64> {
        let runs = self.runs(method, frequency).iter();
        runs.map(|run| run.errors[error].value).collect()
    }

    /// An error by time step, then by seed.
    pub(crate) fn samples(&self, method: Method, error: usize) -> Vec<Vec<f64>> {
        let frequencies = self.frequencies.iter();
        frequencies
            .map(|&frequency| self.sample(method, frequency, error))
            .collect()
    }

    /// The median of an error over the seeds.
    pub(crate) fn error(&self, method: Method, frequency: u32, error: usize) -> Median {
        Median::of(self.sample(method, frequency, error))
    }

    /// The median of the milliseconds for one simulated second.
    pub(crate) fn milliseconds(&self, method: Method, frequency: u32) -> Median {
        Median::of(
            self.runs(method, frequency)
                .iter()
                .map(|run| run.milliseconds),
        )
    }

    /// How many pairs a method found in all its runs, and how many of them it lost.
    pub(crate) fn pairs(&self, method: Method) -> [usize; 2] {
        let ensembles = self
            .ensembles
            .iter()
            .filter(|ensemble| ensemble.method == method);
        let pairs = ensembles
            .flat_map(|ensemble| &ensemble.runs)
            .filter_map(|run| run.pairs);
        pairs.fold([0; 2], |sum, pairs| [sum[0] + pairs[0], sum[1] + pairs[1]])
    }

    /// Whether all errors are numbers, as they are unless a simulation has exploded.
    pub(crate) fn is_finite(&self) -> bool {
        let runs = self.ensembles.iter().flat_map(|ensemble| &ensemble.runs);
        let mut errors = runs.flat_map(|run| &run.errors);
        errors.all(|error| error.value.is_finite())
    }
}
