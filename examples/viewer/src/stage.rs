//! A scene on stage, in either dimension.

use crate::history::Sample;
use crate::lines::{Extent, Line};
use crate::setup::Setup;
use crate::{dim2, dim3};
use clap::ValueEnum;
use unisize_pictures::{Camera, Drawing};

/// A simulated world with its broad phases.
pub(crate) trait Stage {
    /// Simulates a step and returns its times.
    fn step(&mut self) -> Sample;

    /// The number of steps simulated so far.
    fn steps(&self) -> usize;

    /// The number of steps after which nothing new is to be seen.
    fn length(&self) -> usize;

    /// Continues in the same world with new broad phases.
    fn change(&mut self, setup: &Setup);

    /// The best view of it.
    fn camera(&self) -> Camera;

    /// Draws the world.
    fn draw(&self, drawing: &mut Drawing);

    /// The boxes of all colliders, without margins.
    fn extents(&mut self) -> Vec<Extent>;

    /// A line for each pair that the broad phase holds, except pairs of walls.
    fn pair_lines(&mut self) -> Vec<Line>;

    /// The number of strips of the second and the third axis; 0 if unknown.
    fn strips(&self) -> [u32; 2];

    /// The numbers in the panel.
    fn facts(&self) -> Vec<Fact>;

    /// Whether both broad phases hold the same pairs, if both are timed.
    fn agree(&self) -> Option<bool>;
}

/// A number in the panel.
pub(crate) struct Fact {
    pub(crate) name: &'static str,
    pub(crate) value: String,
    pub(crate) hint: &'static str,
}

impl Fact {
    pub(crate) fn new(name: &'static str, value: String, hint: &'static str) -> Self {
        Self { name, value, hint }
    }
}

/// The scenes, by the names of the examples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Scene {
    /// Ropes of jointed capsules fall over bars and tangle
    #[value(name = "rope3d")]
    Rope3d,
    /// Grains are poured into a container
    #[value(name = "particles3d")]
    Particles3d,
    /// A stampede: the pairs of the broad phase are the neighbours that animals avoid
    #[value(name = "crowd2d")]
    Crowd2d,
    /// Boxes in a plane all fly through its centre
    #[value(name = "cluster")]
    Cluster,
}

impl Scene {
    pub(crate) const ALL: [Self; 4] = [
        Self::Rope3d,
        Self::Particles3d,
        Self::Crowd2d,
        Self::Cluster,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Rope3d => "rope3d",
            Self::Particles3d => "particles3d",
            Self::Crowd2d => "crowd2d",
            Self::Cluster => "cluster",
        }
    }

    /// The default number of bodies: what runs in about real time.
    pub(crate) fn bodies(self) -> usize {
        match self {
            Self::Rope3d => 1_200,
            Self::Particles3d => 3_000,
            Self::Crowd2d => 1_500,
            Self::Cluster => 10_000,
        }
    }

    /// Puts the scene on stage with about this many bodies.
    pub(crate) fn open(self, bodies: usize, setup: &Setup) -> Box<dyn Stage> {
        match self {
            Self::Rope3d => Box::new(dim3::Live::<dim3::Ropes>::new(bodies, setup)),
            Self::Particles3d => Box::new(dim3::Live::<dim3::Pour>::new(bodies, setup)),
            Self::Crowd2d => Box::new(dim2::Live::<dim2::Gorge>::new(bodies, setup)),
            Self::Cluster => Box::new(dim3::Live::<dim3::Implosion>::new(bodies, setup)),
        }
    }
}
