//! The measurements in one scene, one type for both dimensions.

use super::front::front;
use super::method::Method;
use crate::study::Recall;

/// The measurements in one scene.
#[derive(Clone, Debug)]
pub(crate) struct Study {
    pub(crate) scene: &'static str,
    pub(crate) dim: u8,
    pub(crate) bodies: usize,
    pub(crate) steps: usize,
    /// The median of the largest extents of all colliders that can move, in length units.
    pub(crate) typical_size: f32,
    /// Whether things meet between two steps.
    pub(crate) is_fast: bool,
    pub(crate) figures: Vec<Figures>,
}

/// What one method missed in one scene, and its cost.
#[derive(Clone, Debug)]
pub(crate) struct Figures {
    pub(crate) method: Method,
    pub(crate) touching: Recall,
    /// Pairs held, summed over all steps that were examined.
    pub(crate) held: usize,
    /// Milliseconds per step.
    pub(crate) broad: f64,
    /// Milliseconds per step of broad and narrow phase together.
    pub(crate) both: f64,
}

impl Figures {
    /// The share of the touching pairs that were not held; none of none is zero.
    pub(crate) fn share_missed(&self) -> f64 {
        self.touching.missed() as f64 / self.touching.all.max(1) as f64
    }

    pub(crate) fn misses_nothing(&self) -> bool {
        self.touching.missed() == 0
    }
}

impl Study {
    pub(crate) fn title(&self) -> String {
        format!("{} {}D", self.scene, self.dim)
    }

    /// unisize with its default settings; where things are fast, on swept boxes.
    pub(crate) fn default(&self) -> &Figures {
        // It is the first in every list of methods.
        &self.figures[0]
    }

    /// How many pairs touch, summed over all steps that were examined: the same for all methods.
    pub(crate) fn touching(&self) -> usize {
        self.default().touching.all
    }

    /// The time of a method in broad and narrow phase, as a multiple of that of the default settings.
    pub(crate) fn relative(&self, figures: &Figures) -> f64 {
        figures.both / self.default().both
    }

    /// The methods that no other one beats in both the share missed and the time; the most accurate first.
    pub(crate) fn front(&self) -> Vec<&Figures> {
        let points: Vec<_> = (self.figures.iter())
            .map(|figures| (figures.share_missed(), figures.both))
            .collect();
        let front = front(&points).into_iter();
        front.map(|index| &self.figures[index]).collect()
    }

    /// The methods that miss nothing and are faster than the default settings; the fastest first.
    pub(crate) fn faster(&self) -> Vec<&Figures> {
        let is_faster = |f: &&Figures| f.misses_nothing() && f.both < self.default().both;
        let mut faster: Vec<_> = self.figures.iter().filter(is_faster).collect();
        faster.sort_by(|a, b| a.both.total_cmp(&b.both));
        faster
    }

    /// The methods that have missed what they must not miss.
    pub(crate) fn faults(&self) -> impl Iterator<Item = &Figures> {
        let must_not = |f: &&Figures| f.method.must_miss_nothing(self.is_fast);
        let figures = self.figures.iter().filter(must_not);
        figures.filter(|f| !f.misses_nothing())
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::method::{Feed, Method, Search};
    use super::{Figures, Study};
    use crate::study::Recall;

    /// A study with the default settings at 2 ms, no contact missed, and these other methods: what they find of 200 contacts,
    /// and how long they take.
    pub(in super::super) fn study(others: &[(Search, usize, f64)]) -> Study {
        let figures = |&(search, found, both): &(Search, usize, f64)| Figures {
            method: Method {
                search,
                feed: Feed::PLAIN,
            },
            touching: Recall { found, all: 200 },
            held: 400,
            broad: both / 2.0,
            both,
        };
        let default = (Search::DEFAULT, 200, 2.0);
        Study {
            scene: "ropes",
            dim: 2,
            bodies: 100,
            steps: 10,
            typical_size: 1.0,
            is_fast: false,
            figures: [default].iter().chain(others).map(figures).collect(),
        }
    }

    #[test]
    fn shares_are_of_all_that_touch() {
        let study = study(&[(Search::HashGrid, 150, 1.0)]);
        assert_eq!(study.default().share_missed(), 0.0);
        assert_eq!(study.figures[1].share_missed(), 0.25);
        assert_eq!(study.touching(), 200);
        let nothing = Figures {
            touching: Recall::default(),
            ..study.figures[1].clone()
        };
        assert_eq!(nothing.share_missed(), 0.0);
    }

    #[test]
    fn the_front_begins_with_what_misses_nothing() {
        let study = study(&[
            (Search::HashGrid, 150, 1.0),
            (Search::Rapier027, 200, 3.0),
            (Search::CommonBox(0.5), 100, 1.5),
        ]);
        let front: Vec<_> = study.front().iter().map(|f| f.method.search).collect();
        assert_eq!(front, [Search::DEFAULT, Search::HashGrid]);
        assert!(study.faster().is_empty());
        assert_eq!(study.faults().count(), 0);
    }

    #[test]
    fn what_is_faster_and_misses_nothing_is_told() {
        let study = study(&[
            (Search::HashGrid, 200, 1.5),
            (Search::Rapier027, 199, 0.5),
            (Search::Rapier036, 200, 1.0),
        ]);
        let faster: Vec<_> = study.faster().iter().map(|f| f.method.search).collect();
        assert_eq!(faster, [Search::Rapier036, Search::HashGrid]);
    }
}
