//! The methods that find pairs: unisize by its margin, Rapier's own broad phase, and methods that miss pairs in exchange for speed.

/// A method that finds pairs. A margin is in typical sizes; `None` is the default margin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Finder {
    /// Rapier's own broad phase.
    Rapier,
    Unisize(Option<f32>),
    /// unisize, updated only in every n-th step.
    Seldom(usize, Option<f32>),
    /// A hash grid of the centres of boxes.
    #[cfg(not(feature = "rapier-036"))]
    Grid(Cell),
    /// Rapier's own broad phase without some of its pairs, which a study of accuracy has to notice.
    Lossy,
}

/// The methods of `accuracy`.
pub(crate) const FINDERS: &[Finder] = &[
    Finder::Rapier,
    Finder::DEFAULT,
    Finder::Seldom(2, None),
    #[cfg(not(feature = "rapier-036"))]
    Finder::Grid(Cell::Largest),
    #[cfg(not(feature = "rapier-036"))]
    Finder::Grid(Cell::Median),
    Finder::Lossy,
];

/// `Lossy` loses one pair in this many.
pub(crate) const LOST_ONE_IN: u32 = 1000;

/// The size of the cells of a grid.
#[cfg(not(feature = "rapier-036"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cell {
    /// The size of the largest collider that can move: the grid misses nothing.
    Largest,
    /// The median size: the grid misses pairs of larger colliders.
    Median,
}

impl Finder {
    pub(crate) const DEFAULT: Self = Self::Unisize(None);

    /// Whether it holds every pair that touches, for all motions and sizes.
    pub(crate) fn is_exact(self) -> bool {
        match self {
            Self::Rapier | Self::Unisize(_) => true,
            #[cfg(not(feature = "rapier-036"))]
            Self::Grid(cell) => cell == Cell::Largest,
            Self::Seldom(..) | Self::Lossy => false,
        }
    }

    /// Its name in tables and charts.
    pub(crate) fn name(self) -> String {
        match self {
            Self::Rapier => "Rapier's".to_owned(),
            Self::Unisize(None) => "unisize".to_owned(),
            Self::Unisize(Some(_)) => "unisize, no margin".to_owned(),
            Self::Seldom(2, None) => "every 2nd step".to_owned(),
            Self::Seldom(2, Some(_)) => "every 2nd step, wide margin".to_owned(),
            Self::Seldom(interval, _) => format!("every {interval}th step"),
            #[cfg(not(feature = "rapier-036"))]
            Self::Grid(Cell::Largest) => "hash grid, cells of the largest".to_owned(),
            #[cfg(not(feature = "rapier-036"))]
            Self::Grid(Cell::Median) => "hash grid, one size too small".to_owned(),
            Self::Lossy => format!("one pair in {LOST_ONE_IN} lost"),
        }
    }
}
