//! A method: a way to find pairs, with a margin.

/// The margins, in typical sizes of a collider, besides the default one.
const MARGINS: [f32; 5] = [0.0, 0.05, 0.1, 0.25, 0.5];

/// Brute force takes too long with more bodies.
const BRUTE_FORCE_BODIES: usize = 2_000;

/// How pairs are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Search {
    /// Rapier's own broad phase, a hierarchy of boxes.
    Rapier,
    /// Ours, on the fast kernel.
    GridSweep,
    /// Ours, on the kernel of the paper.
    RankSweep,
    /// Ours, with brute force.
    BruteForce,
    /// The kernel of the paper on boxes enlarged to one common size, without a filter.
    CommonBox,
}

impl Search {
    /// In the order of tables and legends.
    pub(crate) const ALL: [Self; 5] = [
        Self::GridSweep,
        Self::RankSweep,
        Self::Rapier,
        Self::BruteForce,
        Self::CommonBox,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Rapier => "Rapier 0.27",
            Self::GridSweep => "GridSweep",
            Self::RankSweep => "RankSweep",
            Self::BruteForce => "BruteForce",
            Self::CommonBox => "RankSweep, common box, no filter",
        }
    }
}

/// By how much boxes are larger than their shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Margin {
    /// The default, which is also Rapier's, in length units.
    Default,
    /// In typical sizes of a collider.
    Sizes(f32),
}

impl Margin {
    /// For points of a chart.
    pub(crate) fn label(self) -> String {
        match self {
            Self::Default => "default".to_owned(),
            Self::Sizes(sizes) => sizes.to_string(),
        }
    }
}

/// A way to find pairs, with a margin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Method {
    pub(crate) search: Search,
    pub(crate) margin: Margin,
}

impl Method {
    /// The default settings.
    pub(crate) const AUTOMATIC: Self = Self {
        search: Search::GridSweep,
        margin: Margin::Default,
    };

    /// All methods for a scene with this many bodies, by search and then by margin.
    pub(crate) fn all(bodies: usize) -> Vec<Self> {
        let of_search = |search| {
            let margins = match search {
                Search::GridSweep | Search::RankSweep => {
                    let mut margins = MARGINS.map(Margin::Sizes).to_vec();
                    margins.insert(1, Margin::Default);
                    margins
                }
                Search::BruteForce if bodies > BRUTE_FORCE_BODIES => Vec::new(),
                Search::Rapier | Search::BruteForce => vec![Margin::Default],
                Search::CommonBox => vec![Margin::Sizes(0.0)],
            };
            let method = move |margin| Self { search, margin };
            margins.into_iter().map(method)
        };
        Search::ALL.into_iter().flat_map(of_search).collect()
    }

    /// The number of simulations of a scene with this many bodies, for the progress bar: one on each method, two with sorted
    /// events, and the reference.
    pub(crate) fn courses(bodies: usize) -> usize {
        Self::all(bodies).len() + 3
    }

    /// Whether users of unisize can choose this.
    pub(crate) fn is_setting(self) -> bool {
        matches!(
            self.search,
            Search::GridSweep | Search::RankSweep | Search::BruteForce
        )
    }

    pub(crate) fn name(self) -> String {
        match (self.search, self.margin) {
            (Search::Rapier | Search::CommonBox, _) => self.search.name().to_owned(),
            (search, Margin::Default) => format!("{}, default margin", search.name()),
            (search, Margin::Sizes(0.0)) => format!("{}, no margin", search.name()),
            (search, Margin::Sizes(sizes)) => format!("{}, {sizes} sizes", search.name()),
        }
    }
}
