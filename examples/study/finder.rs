//! What finds the pairs: unisize by its settings, Rapier's own broad phase, and methods that miss pairs in exchange for speed.

use unisize::{Kernel, PairFilter};
use unisize_charts::{RGBColor, color};

/// What finds the pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Finder {
    /// Rapier's own broad phase.
    Rapier,
    Unisize(Setting),
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

/// Settings of unisize.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Setting {
    pub(crate) kernel: Kernel,
    /// In typical sizes; `None` is the default.
    pub(crate) margin: Option<f32>,
    /// `None` is the default.
    pub(crate) filter: Option<PairFilter>,
}

impl Setting {
    pub(crate) const DEFAULT: Self = Self {
        kernel: Kernel::GridSweep,
        margin: None,
        filter: None,
    };
}

impl Finder {
    pub(crate) const DEFAULT: Self = Self::Unisize(Setting::DEFAULT);

    /// Whether it cannot miss a pair that touches, whatever bodies do and whatever sizes they have.
    pub(crate) fn is_exact(self) -> bool {
        match self {
            Self::Rapier | Self::Unisize(_) => true,
            Self::Grid(cell) => cell == Cell::Largest,
            Self::Seldom(_) | Self::Lossy => false,
        }
    }

    /// Its name in tables and charts.
    pub(crate) fn name(self) -> String {
        match self {
            Self::Rapier => "Rapier's".to_owned(),
            Self::Unisize(setting) => setting.name(),
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
            Self::Unisize(setting) if setting == Setting::DEFAULT => color::RED,
            Self::Unisize(_) => color::SALMON,
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

impl Setting {
    fn name(self) -> String {
        let kernel = match self.kernel {
            Kernel::GridSweep => None,
            kernel => Some(format!("{kernel:?}")),
        };
        let margin = self.margin.map(|margin| match margin {
            0.0 => "no margin".to_owned(),
            _ => format!("margin of {margin} sizes"),
        });
        let filter = self.filter.map(|filter| format!("filter {filter:?}"));
        let parts = ["unisize".to_owned()].into_iter();
        let parts = parts.chain([kernel, margin, filter].into_iter().flatten());
        parts.collect::<Vec<_>>().join(", ")
    }
}
