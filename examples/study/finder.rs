//! What finds the pairs: unisize by its settings, Rapier's own broad phase, and methods that miss pairs in exchange for speed.

use unisize::Kernel;
use unisize_charts::{RGBColor, color};

/// What finds the pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Finder {
    /// Rapier's own broad phase.
    Rapier,
    /// unisize with this kernel, and a margin in typical sizes; `None` is the default.
    Unisize(Kernel, Option<f32>),
    /// unisize by default, updated once in so many steps.
    Seldom(usize),
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
    pub(crate) const DEFAULT: Self = Self::Unisize(Kernel::GridSweep, None);

    /// Whether it cannot miss a pair that touches, whatever bodies do and whatever sizes they have.
    pub(crate) fn is_exact(self) -> bool {
        match self {
            Self::Rapier | Self::Unisize(..) => true,
            Self::Grid(cell) => cell == Cell::Largest,
            Self::Seldom(_) | Self::Lossy => false,
        }
    }

    /// Its name in tables and charts.
    pub(crate) fn name(self) -> String {
        match self {
            Self::Rapier => "Rapier's".to_owned(),
            Self::Unisize(Kernel::GridSweep, None) => "unisize".to_owned(),
            Self::Unisize(Kernel::GridSweep, Some(0.0)) => "unisize, no margin".to_owned(),
            Self::Unisize(Kernel::GridSweep, Some(margin)) => {
                format!("unisize, margin of {margin} sizes")
            }
            Self::Unisize(kernel, _) => format!("unisize, {kernel:?}"),
            Self::Seldom(2) => "every 2nd step".to_owned(),
            Self::Seldom(interval) => format!("every {interval}th step"),
            Self::Grid(Cell::Largest) => "hash grid, cells of the largest".to_owned(),
            Self::Grid(Cell::Median) => "hash grid, cells of the median".to_owned(),
            Self::Lossy => format!("one pair in {LOST_ONE_IN} lost"),
        }
    }

    /// Its colour in charts.
    pub(crate) fn color(self) -> RGBColor {
        match self {
            Self::DEFAULT => color::RED,
            Self::Unisize(..) => color::SALMON,
            Self::Rapier => color::BLUE,
            Self::Seldom(..=2) => color::PINK,
            Self::Seldom(..=4) => color::ROSE,
            Self::Seldom(_) => color::PURPLE,
            Self::Grid(Cell::Largest) => color::GREEN,
            Self::Grid(Cell::Median) => color::OCHRE,
            Self::Lossy => color::GREY,
        }
    }
}
