//! One simulation: what it is of, and what came of it.

use crate::finder::Finder;
use unisize_scenes::SceneKind;

/// One simulation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Case {
    pub(crate) kind: SceneKind,
    pub(crate) finder: Finder,
    /// Steps per simulated second; a multiple of [`FRAMES`].
    pub(crate) frequency: u32,
    /// What decides the starting positions, up to a little.
    pub(crate) seed: u64,
    /// About how many bodies.
    pub(crate) bodies: usize,
    /// How long, in simulated seconds.
    pub(crate) seconds: f64,
}

/// So often in a simulated second are errors measured, whatever the time step.
pub(crate) const FRAMES: u32 = 30;

/// The names of the errors.
pub(crate) const STRAYED: &str = "largest distance from its place, sizes";
pub(crate) const STRETCH: &str = "largest stretch, links";
pub(crate) const DEEPEST: &str = "largest penetration, sizes";
pub(crate) const MEAN_DEPTH: &str = "mean penetration, sizes";
pub(crate) const LOST: &str = "bodies lost, of all";
pub(crate) const ENERGY: &str = "energy gained, of what was put in";

/// What came of a simulation.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    /// Milliseconds of the processor for one simulated second, without those of measuring.
    pub(crate) milliseconds: f64,
    /// By name, the most telling one first. None is NaN; what is not a number is infinitely wrong.
    pub(crate) errors: Vec<(&'static str, f64)>,
    /// A hash of the poses and velocities of all bodies at the end. Where it differs, the runs do.
    pub(crate) state: u64,
}
