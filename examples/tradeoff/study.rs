//! What was measured in one scene, the same type for both dimensions.

use crate::course::{Course, Run};
use crate::method::{Method, Search};

/// What was measured in one scene.
#[derive(Clone, Debug)]
pub(crate) struct Study {
    pub(crate) scene: &'static str,
    pub(crate) dim: u8,
    pub(crate) bodies: usize,
    pub(crate) steps: usize,
    /// The median of the largest extents of all colliders that can move, in length units.
    pub(crate) typical_size: f32,
    pub(crate) default_margin: f32,
    /// How many bodies the simulations on one method each had.
    pub(crate) course_bodies: usize,
    pub(crate) figures: Vec<Figures>,
    pub(crate) courses: Vec<Course>,
}

/// What one method held in one scene, and what it cost.
#[derive(Clone, Debug)]
pub(crate) struct Figures {
    pub(crate) method: Method,
    /// Pairs of shapes that touch or overlap.
    pub(crate) touching: Recall,
    /// Pairs of shapes that are nearer than the prediction distance, those included.
    pub(crate) near: Recall,
    /// Pairs held, over all steps at which it was looked.
    pub(crate) held: usize,
    /// Milliseconds a step.
    pub(crate) broad: f64,
    /// Milliseconds a step of broad and narrow phase together.
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
    /// Touching pairs for each pair held.
    pub(crate) fn precision(&self) -> f64 {
        self.touching.found as f64 / self.held.max(1) as f64
    }

    /// Pairs held for each pair that touches.
    pub(crate) fn held_a_contact(&self) -> f64 {
        self.held as f64 / self.touching.all.max(1) as f64
    }
}

impl Study {
    /// Pairs that touch, or nearly, and were not held, by all methods together.
    pub(crate) fn missed(&self) -> usize {
        let missed = |figures: &Figures| figures.touching.missed() + figures.near.missed();
        self.figures.iter().map(missed).sum()
    }

    /// Whether a simulation on the default settings was the very same as one on Rapier's broad phase at every step, once
    /// both report their events in order.
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

    /// The settings whose broad and narrow phase took the least time.
    pub(crate) fn best(&self) -> &Figures {
        let settings = self.figures.iter().filter(|f| f.method.is_setting());
        let best = settings.min_by(|a, b| a.both.total_cmp(&b.both));
        best.expect("the default settings are always measured")
    }
}
