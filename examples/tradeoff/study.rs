//! The measurements in one scene, one type for both dimensions.

use crate::course::{Course, Run};
use crate::method::{Method, Search};

/// The measurements in one scene.
#[derive(Clone, Debug)]
pub(crate) struct Study {
    pub(crate) scene: &'static str,
    pub(crate) dim: u8,
    pub(crate) bodies: usize,
    pub(crate) steps: usize,
    /// The median of the largest extents of all colliders that can move, in length units.
    pub(crate) typical_size: f32,
    pub(crate) default_margin: f32,
    /// The number of bodies of the simulations on one method each.
    pub(crate) course_bodies: usize,
    pub(crate) figures: Vec<Figures>,
    pub(crate) courses: Vec<Course>,
}

/// The pairs that one method held in one scene, and its cost.
#[derive(Clone, Debug)]
pub(crate) struct Figures {
    pub(crate) method: Method,
    /// Pairs of shapes that touch or overlap.
    pub(crate) touching: Recall,
    /// Pairs of shapes nearer than the prediction distance, touching ones included.
    pub(crate) near: Recall,
    /// Pairs held, summed over all steps that were examined.
    pub(crate) held: usize,
    /// Milliseconds per step.
    pub(crate) broad: f64,
    /// Milliseconds per step of broad and narrow phase together.
    pub(crate) both: f64,
}

/// How many of the pairs that should be held are.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Recall {
    pub(crate) found: usize,
    pub(crate) all: usize,
}

impl Recall {
    pub(crate) fn missed(self) -> usize {
        self.all - self.found
    }
}

impl Figures {
    /// Touching pairs per pair held.
    pub(crate) fn precision(&self) -> f64 {
        self.touching.found as f64 / self.held.max(1) as f64
    }

    /// Pairs held per touching pair.
    pub(crate) fn held_a_contact(&self) -> f64 {
        self.held as f64 / self.touching.all.max(1) as f64
    }
}

impl Study {
    /// Pairs that touch, or nearly so, and were not held, summed over all methods.
    pub(crate) fn missed(&self) -> usize {
        let missed = |figures: &Figures| figures.touching.missed() + figures.near.missed();
        self.figures.iter().map(missed).sum()
    }

    /// Whether a simulation on the default settings equals one on Rapier's broad phase at every step, once both sort their
    /// events.
    pub(crate) fn is_same_in_order(&self) -> bool {
        let mut runs = self.courses.iter();
        runs.any(|course| course.run == Run::AutomaticInOrder && course.most_from_rapier == 0.0)
    }

    pub(crate) fn of(&self, search: Search) -> impl Iterator<Item = &Figures> {
        let is_of = move |figures: &&Figures| figures.method.search == search;
        self.figures.iter().filter(is_of)
    }

    /// The default settings.
    pub(crate) fn automatic(&self) -> &Figures {
        let mut figures = self.figures.iter();
        let found = figures.find(|figures| figures.method == Method::AUTOMATIC);
        found.expect("the default settings are always measured")
    }

    /// The settings with the least time in the broad and the narrow phase.
    pub(crate) fn best(&self) -> &Figures {
        let settings = self.figures.iter().filter(|f| f.method.is_setting());
        let best = settings.min_by(|a, b| a.both.total_cmp(&b.both));
        best.expect("the default settings are always measured")
    }
}
