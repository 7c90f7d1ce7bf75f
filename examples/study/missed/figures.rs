//! What one method held and missed in one scene, and its cost.

use serde::Serialize;

/// What one method held and missed in one scene, and its cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(crate) struct Figures {
    /// Pairs of shapes that touch or overlap.
    pub(crate) touching: Recall,
    /// Pairs of shapes nearer than the prediction distance, touching ones included.
    pub(crate) near: Recall,
    /// Frames that were compared with the truth, and those in which a touching pair was missed.
    pub(crate) frames: usize,
    pub(crate) frames_with_misses: usize,
    /// Pairs held, summed over these frames.
    pub(crate) held: usize,
    /// Milliseconds per step.
    pub(crate) broad: f64,
    /// Milliseconds per step of broad and narrow phase together.
    pub(crate) both: f64,
}

/// How many of the pairs that should be held are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub(crate) struct Recall {
    pub(crate) found: usize,
    pub(crate) all: usize,
}

impl Recall {
    /// Counts more of them.
    pub(crate) fn add(&mut self, more: Self) {
        self.found += more.found;
        self.all += more.all;
    }

    pub(crate) fn missed(self) -> usize {
        self.all - self.found
    }

    /// The share that is missed; none of none is zero.
    pub(crate) fn share_missed(self) -> f64 {
        self.missed() as f64 / self.all.max(1) as f64
    }
}

impl Figures {
    /// Of several seeds: the sum of all counts, and the median of times.
    pub(super) fn of(seeds: &[Self]) -> Self {
        let mut sum = Self::default();
        for figures in seeds {
            sum.touching.add(figures.touching);
            sum.near.add(figures.near);
            sum.frames += figures.frames;
            sum.frames_with_misses += figures.frames_with_misses;
            sum.held += figures.held;
        }
        let median = |time: fn(&Self) -> f64| {
            let mut times: Vec<_> = seeds.iter().map(time).collect();
            times.sort_by(f64::total_cmp);
            times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
        };
        Self {
            broad: median(|figures| figures.broad),
            both: median(|figures| figures.both),
            ..sum
        }
    }

    /// Pairs held per touching pair, which is the reciprocal of the precision.
    pub(super) fn held_a_contact(&self) -> f64 {
        self.held as f64 / self.touching.all.max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::{Figures, Recall};

    #[test]
    fn seeds_are_summed_and_times_are_medians() {
        let figures = |found, both| Figures {
            touching: Recall { found, all: 200 },
            held: 400,
            both,
            ..Figures::default()
        };
        let of = Figures::of(&[figures(200, 3.0), figures(150, 1.0), figures(200, 2.0)]);
        assert_eq!((of.touching.all, of.touching.missed()), (600, 50));
        assert_eq!((of.both, of.held_a_contact()), (2.0, 2.0));
        assert_eq!(Recall::default().share_missed(), 0.0);
    }
}
