//! For how many moves ahead boxes are inflated.
//!
//! The farther ahead, the fewer searches and the more candidates to compare. What pays depends on how far a box gets: boxes are inflated
//! for as many moves as take boxes half their size ahead on average, and for no more than [`LONGEST`], for sooner or later things turn. Finding the
//! best number scene by scene, by what each has cost, was tried and gains nothing on that.

use super::horizon::Horizon;
use crate::tuning::foresight::{AHEAD, CUT, CUT_RUNS, FIRST, LONGEST};

/// The moves of the horizon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Foresight {
    moves: u16,
    is_fixed: bool,
    /// No more than this, since there were too many candidates.
    limit: u16,
    /// Full runs until the limit is doubled.
    rest: u32,
}

impl Foresight {
    /// A foresight that goes by how fast things move, or is fixed at this number of moves.
    pub(super) fn new(fixed: Option<u16>) -> Self {
        Self {
            moves: fixed.unwrap_or(FIRST),
            is_fixed: fixed.is_some(),
            limit: LONGEST,
            rest: 0,
        }
    }

    /// The moves of its horizon.
    pub(super) fn moves(self) -> u16 {
        self.moves
    }

    /// Whether the user has fixed it.
    pub(super) fn is_fixed(self) -> bool {
        self.is_fixed
    }

    /// The horizon to inflate boxes by.
    pub(super) fn horizon(self) -> Horizon {
        Horizon::new(self.moves)
    }

    /// Whether it looks ahead at all.
    pub(super) fn is_any(self) -> bool {
        self.moves > 0
    }

    /// The foresight of a full run, where things move by `speed()` box sizes on average, if anything moves.
    pub(super) fn renewed(mut self, speed: impl FnOnce() -> Option<f64>) -> Self {
        if self.is_fixed {
            return self;
        }
        if self.limit < LONGEST {
            match self.rest.checked_sub(1) {
                Some(rest) => self.rest = rest,
                None => self.limit_to((2 * self.limit).max(1)),
            }
        }
        let moves = speed().map_or(f64::from(FIRST), |speed| AHEAD / speed);
        // Rounded down, so there are none where things are too fast.
        self.moves = moves.min(f64::from(self.limit)) as u16;
        self
    }

    /// Looks less far ahead, because there are too many candidates.
    pub(super) fn shorten(&mut self) {
        self.moves /= CUT;
        self.limit_to(self.moves);
    }

    fn limit_to(&mut self, limit: u16) {
        self.limit = limit.min(LONGEST);
        self.rest = CUT_RUNS;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_goes_half_a_size_ahead_and_no_farther_than_the_longest() {
        let moves = |speed| Foresight::new(None).renewed(|| speed).moves();
        let speeds = [None, Some(1e-9), Some(0.1), Some(0.5), Some(0.51)];
        assert_eq!(speeds.map(moves), [FIRST, LONGEST, 5, 1, 0]);
    }

    #[test]
    fn what_was_shortened_grows_again_by_and_by() {
        let slow = |foresight: Foresight| foresight.renewed(|| Some(1e-9));
        let mut foresight = slow(Foresight::new(None));
        // From none as well.
        while foresight.is_any() {
            foresight.shorten();
        }
        let mut expected = 0;
        while expected < LONGEST {
            for _ in 0..CUT_RUNS {
                foresight = slow(foresight);
                assert_eq!(foresight.moves(), expected);
            }
            foresight = slow(foresight);
            expected = (2 * expected).max(1);
            assert_eq!(foresight.moves(), expected);
        }
    }
}
