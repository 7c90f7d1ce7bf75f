//! A method that may trade accuracy for speed: what finds pairs, and what it is fed.

use unisize::Kernel;

/// The common sizes of the paper's kernel, as quantiles of the sizes of movable boxes.
const QUANTILES: [f64; 5] = [0.5, 0.75, 0.9, 0.99, 1.0];

/// The foresights of unisize that are fixed.
const FORESIGHTS: [u16; 3] = [0, 4, 16];

/// The steps between two updates of a tree that is updated seldom.
pub(crate) const INTERVALS: [usize; 3] = [2, 4, 8];

/// The margins of boxes that are given to a tree that is updated seldom, in typical sizes.
const MARGINS: [f32; 4] = [0.01, 0.05, 0.2, 0.5];

/// The margins with which fast things are looked for without sweeping their boxes, in typical sizes.
const WIDE_MARGINS: [f32; 4] = [0.25, 0.5, 1.0, 2.0];

/// Brute force takes too long with more bodies.
const BRUTE_FORCE_BODIES: usize = 2_000;

/// What finds pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Search {
    /// unisize, on one of its kernels.
    Unisize {
        kernel: Kernel,
        /// `None` is the default: by itself.
        foresight: Option<u16>,
        /// Whether it has its default margin, or none.
        has_margin: bool,
    },
    /// The broad phase of Rapier 0.27, a tree.
    Rapier027,
    /// The broad phase of Rapier 0.36, another tree.
    Rapier036,
    /// The kernel of the paper on boxes of one size, this quantile of the sizes.
    CommonBox(f64),
    /// A hash grid of the centres of boxes.
    HashGrid,
}

impl Search {
    /// The default settings of unisize.
    pub(crate) const DEFAULT: Self = Self::Unisize {
        kernel: Kernel::GridSweep,
        foresight: None,
        has_margin: true,
    };
}

/// What a broad phase is fed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Feed {
    /// It is updated once in this many steps.
    pub(crate) interval: usize,
    /// Boxes are loosened by this on every side, in typical sizes.
    pub(crate) margin: f32,
    /// Whether boxes are swept from the beginning of the step to its end, or those at the end.
    pub(crate) swept: bool,
}

impl Feed {
    /// The boxes at the end of each step, as they are.
    pub(crate) const PLAIN: Self = Self {
        interval: 1,
        margin: 0.0,
        swept: false,
    };

    pub(crate) const SWEPT: Self = Self {
        swept: true,
        ..Self::PLAIN
    };
}

/// What finds pairs, and what it is fed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Method {
    pub(crate) search: Search,
    pub(crate) feed: Feed,
}

impl Method {
    const fn plain(search: Search) -> Self {
        Self {
            search,
            feed: Feed::PLAIN,
        }
    }

    const fn swept(search: Search) -> Self {
        Self {
            search,
            feed: Feed::SWEPT,
        }
    }

    /// The methods for a scene of this many bodies, in the order of tables.
    pub(crate) fn all(bodies: usize) -> Vec<Self> {
        let mut searches = unisize_settings(bodies);
        searches.extend([Search::Rapier027, Search::Rapier036]);
        searches.extend(QUANTILES.map(Search::CommonBox));
        searches.push(Search::HashGrid);
        let mut methods: Vec<_> = searches.into_iter().map(Self::plain).collect();
        for search in [Search::DEFAULT, Search::Rapier027] {
            for interval in INTERVALS {
                methods.extend(MARGINS.map(|margin| Self {
                    search,
                    feed: Feed {
                        interval,
                        margin,
                        swept: false,
                    },
                }));
            }
        }
        methods
    }

    /// The methods for things that are fast for their size.
    pub(crate) fn for_fast_things(bodies: usize) -> Vec<Self> {
        let settings = unisize_settings(bodies).into_iter();
        let mut methods: Vec<_> = settings.map(Self::swept).collect();
        methods.push(Self::swept(Search::Rapier027));
        let searches = [
            Search::DEFAULT,
            Search::Rapier027,
            Search::Rapier036,
            Search::CommonBox(1.0),
            Search::HashGrid,
        ];
        methods.extend(searches.map(Self::plain));
        methods.extend(WIDE_MARGINS.map(|margin| Self {
            search: Search::DEFAULT,
            feed: Feed {
                margin,
                ..Feed::PLAIN
            },
        }));
        methods
    }

    /// Whether it has to hold every pair that touches. If `is_fast`, things touch between two steps.
    pub(crate) fn must_miss_nothing(self, is_fast: bool) -> bool {
        let is_exact = matches!(self.search, Search::Unisize { .. });
        is_exact && self.feed.interval == 1 && self.feed.swept == is_fast
    }

    /// Whether it finds what touches at the end of a step, whatever things do and whatever sizes they have.
    pub(crate) fn is_exact(self) -> bool {
        let may_miss = match self.search {
            Search::CommonBox(share) => share < 1.0,
            Search::HashGrid => true,
            Search::Unisize { .. } | Search::Rapier027 | Search::Rapier036 => false,
        };
        !may_miss && self.feed.interval == 1
    }

    /// Whether this is unisize in some way, updated in every step.
    pub(crate) fn is_setting(self) -> bool {
        matches!(self.search, Search::Unisize { .. }) && self.feed.interval == 1
    }

    /// The name of the search with its variant.
    pub(crate) fn name(self) -> String {
        match self.search {
            Search::Unisize {
                kernel,
                foresight,
                has_margin,
            } => {
                let foresight = foresight.map(|moves| format!("foresight {moves}"));
                let margin = (!has_margin).then(|| "no margin".to_owned());
                let mut parts = vec![format!("unisize, {kernel:?}")];
                parts.extend([foresight, margin].into_iter().flatten());
                if parts.len() == 1 && kernel == Kernel::GridSweep {
                    parts.push("default settings".to_owned());
                }
                parts.join(", ")
            }
            Search::Rapier027 => "Rapier 0.27".to_owned(),
            Search::Rapier036 => "Rapier 0.36".to_owned(),
            Search::CommonBox(share) if share < 1.0 => {
                format!("RankSweep, common box, {share} quantile")
            }
            Search::CommonBox(_) => "RankSweep, common box, largest".to_owned(),
            Search::HashGrid => "hash grid of centres".to_owned(),
        }
    }

    /// The name with what it is fed.
    pub(crate) fn full_name(self) -> String {
        let Feed {
            interval,
            margin,
            swept,
        } = self.feed;
        let mut name = self.name();
        if swept {
            name += ", swept boxes";
        }
        if interval > 1 {
            name += &format!(", every {}", ordinal(interval));
        }
        if margin > 0.0 {
            name += &format!(", margin {margin}");
        }
        name
    }
}

/// "2nd step" and so on.
pub(crate) fn ordinal(interval: usize) -> String {
    match interval {
        1 => "step".to_owned(),
        2 => "2nd step".to_owned(),
        3 => "3rd step".to_owned(),
        _ => format!("{interval}th step"),
    }
}

/// unisize, all of whose settings find everything: the default settings first.
fn unisize_settings(bodies: usize) -> Vec<Search> {
    let with = |kernel, foresight, has_margin| Search::Unisize {
        kernel,
        foresight,
        has_margin,
    };
    let mut settings = vec![
        Search::DEFAULT,
        with(Kernel::GridSweep, None, false),
        with(Kernel::RankSweep, None, true),
    ];
    if bodies <= BRUTE_FORCE_BODIES {
        settings.push(with(Kernel::BruteForce, None, true));
    }
    let fixed = |moves| with(Kernel::GridSweep, Some(moves), true);
    settings.extend(FORESIGHTS.map(fixed));
    settings
}

#[cfg(test)]
mod tests {
    use super::{Method, Search};

    #[test]
    fn the_methods_are_different_and_the_default_is_the_first() {
        for methods in [Method::all(100), Method::for_fast_things(100)] {
            for (index, method) in methods.iter().enumerate() {
                let before = &methods[..index];
                assert!(!before.contains(method));
                let name = method.full_name();
                assert!(before.iter().all(|other| other.full_name() != name));
            }
        }
        assert_eq!(Method::all(100)[0], Method::plain(Search::DEFAULT));
        assert_eq!(Method::all(1_000_000).len() + 1, Method::all(100).len());
    }

    #[test]
    fn only_exact_methods_must_miss_nothing() {
        let exact = |is_fast| {
            let methods = match is_fast {
                false => Method::all(100),
                true => Method::for_fast_things(100),
            };
            let exact = methods.iter().filter(|m| m.must_miss_nothing(is_fast));
            exact.count()
        };
        // Seven settings of unisize.
        assert_eq!([exact(false), exact(true)], [7, 7]);
        // With two versions of Rapier, and the paper's kernel with the largest size.
        let all = Method::all(100);
        assert_eq!(all.iter().filter(|method| method.is_exact()).count(), 10);
    }
}
