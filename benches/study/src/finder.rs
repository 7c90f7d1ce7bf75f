//! What finds the pairs: unisize by its settings, Rapier's own broad phase, and methods that miss pairs in exchange for speed.

/// What finds the pairs. Margins are in typical sizes; none is the default.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Finder {
    /// Rapier's own broad phase.
    Rapier,
    Unisize(Option<f32>),
    /// unisize, updated once in so many steps.
    Seldom(usize, Option<f32>),
    /// A hash grid of the centres of boxes.
    Grid(Cell),
    /// Rapier's own, some of whose pairs are lost: what a study of accuracy has to notice.
    Lossy,
}

/// One of so many pairs is lost.
pub(crate) const LOST_ONE_IN: u32 = 1000;

/// The size of the cells of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cell {
    /// That of the largest that can move: nothing is missed.
    Largest,
    /// The median, which fits the usual ones: pairs of larger ones are missed.
    Median,
}

impl Finder {
    pub(crate) const DEFAULT: Self = Self::Unisize(None);

    /// Whether it cannot miss a pair that touches, whatever bodies do and whatever sizes they have.
    pub(crate) fn is_exact(self) -> bool {
        match self {
            Self::Rapier | Self::Unisize(..) => true,
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
            Self::Grid(Cell::Largest) => "hash grid, cells of the largest".to_owned(),
            Self::Grid(Cell::Median) => "hash grid, one size too small".to_owned(),
            Self::Lossy => format!("one pair in {LOST_ONE_IN} lost"),
        }
    }
}
