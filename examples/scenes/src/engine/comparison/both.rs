//! The two broad phases that are compared, and values that exist for each.

use std::ops::{Index, IndexMut};

/// One of the two broad phases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    /// Rapier's own.
    Default,
    /// The one that is compared with it.
    Candidate,
}

impl Side {
    /// Its name in a sentence.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Default => "the default",
            Self::Candidate => "the candidate",
        }
    }

    pub(super) fn other(self) -> Self {
        match self {
            Self::Default => Self::Candidate,
            Self::Candidate => Self::Default,
        }
    }
}

/// A value for each of the two broad phases.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Both<T> {
    /// That of Rapier's own broad phase.
    pub default: T,
    /// That of the broad phase that is compared with it.
    pub candidate: T,
}

impl<T> Both<T> {
    /// Computes something for each side, the default first.
    pub(super) fn of(mut value: impl FnMut(Side) -> T) -> Self {
        Self {
            default: value(Side::Default),
            candidate: value(Side::Candidate),
        }
    }
}

impl<T> Index<Side> for Both<T> {
    type Output = T;

    fn index(&self, side: Side) -> &T {
        match side {
            Side::Default => &self.default,
            Side::Candidate => &self.candidate,
        }
    }
}

impl<T> IndexMut<Side> for Both<T> {
    fn index_mut(&mut self, side: Side) -> &mut T {
        match side {
            Side::Default => &mut self.default,
            Side::Candidate => &mut self.candidate,
        }
    }
}
