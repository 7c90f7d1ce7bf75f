//! How far ahead fat boxes are drawn, chosen by what each distance has cost.
//!
//! A longer horizon means fewer searches and more candidates to compare. Which one is best depends on how fast things
//! move, how densely they lie and how straight they go, so it is tried: every update counts its work, in the
//! [prices](crate::tuning::prices) of its units. Half as many moves and twice as many are tried in turn, each for some updates,
//! and the cheapest horizon is kept. Where neither pays, trials become rare. No clock is asked: the events are the same
//! whatever is chosen, but so should be the work, on every machine.

#[cfg(test)]
mod tests;

use super::horizon::Horizon;
use crate::tuning::foresight::{
    FIRST, GAIN, LEAST_PAIRS, LONGEST, MOST_REST, SHORTENING, TOO_FAST, TRIAL_UPDATES,
};
use crate::tuning::prices::{COMPARED, SEARCHED};

/// Chooses the horizon. Adapts itself at full runs only, because that is when all fat boxes are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Foresight {
    /// The moves of the present horizon: 0, or a power of 2.
    moves: u16,
    phase: Phase,
    /// What the present horizon has cost since it was chosen.
    spent: Spent,
    /// The price of a move under the settled horizon, when it was last used; 0 if that is not known.
    settled_price: f64,
    /// Whether the next trial is of a longer horizon.
    is_longer_next: bool,
    /// Failed trials in a row.
    failures: u32,
    /// Measurements to wait before the next trial.
    rest: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    /// The user has fixed it.
    Fixed,
    /// Nothing has been measured yet: it goes by how fast things move.
    Guessed,
    /// The horizon is the best that is known.
    Settled,
    /// The horizon is on trial; the best that is known has this many moves.
    Tried { settled: u16 },
}

/// The work of some updates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Spent {
    pub(super) updates: u64,
    /// Boxes that were renewed.
    pub(super) moved: u64,
    /// The price of the searching.
    pub(super) searching: u64,
    /// The price of all work, searching included.
    pub(super) all: u64,
}

impl Spent {
    pub(super) fn add(&mut self, other: Self) {
        self.updates = self.updates.saturating_add(other.updates);
        self.moved = self.moved.saturating_add(other.moved);
        self.searching = self.searching.saturating_add(other.searching);
        self.all = self.all.saturating_add(other.all);
    }
}

/// How fast things move, and how densely they lie, when that is all that is known.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Motion {
    /// Box sizes a move, on average; `None` if nothing has moved that was there before.
    pub(super) speed: Option<f64>,
    /// Pairs of overlapping boxes per slot.
    pub(super) pairs: f64,
}

impl Foresight {
    /// A foresight that adapts itself, or is fixed at this number of moves.
    pub(super) fn new(fixed: Option<u16>) -> Self {
        Self {
            moves: fixed.unwrap_or(FIRST).min(LONGEST),
            phase: match fixed {
                Some(_) => Phase::Fixed,
                None => Phase::Guessed,
            },
            spent: Spent::default(),
            settled_price: 0.0,
            is_longer_next: false,
            failures: 0,
            rest: 0,
        }
    }

    /// The moves of its horizon.
    pub(super) fn moves(self) -> u16 {
        self.moves
    }

    /// Whether the user has fixed it.
    pub(super) fn is_fixed(self) -> bool {
        self.phase == Phase::Fixed
    }

    /// The horizon to draw fat boxes by.
    pub(super) fn horizon(self) -> Horizon {
        Horizon::new(self.moves)
    }

    /// Whether it looks ahead at all.
    pub(super) fn is_any(self) -> bool {
        self.moves > 0
    }

    /// The foresight after updates that have cost this, in `D` dimensions. `motion` is asked for only at the beginning.
    pub(super) fn adapted<const D: usize>(
        mut self,
        spent: Spent,
        motion: impl FnOnce() -> Motion,
    ) -> Self {
        if self.is_fixed() {
            return self;
        }
        let motion = match self.phase {
            Phase::Guessed => motion(),
            _ => Motion::default(),
        };
        if let Some(speed) = motion.speed {
            self.moves = guess::<D>(speed, motion.pairs);
        }
        self.spent.add(spent);
        if self.spent.updates < TRIAL_UPDATES {
            return self;
        }
        // By move, so that it means something if more or fewer move than before.
        let price = self.spent.all as f64 / self.spent.moved.max(1) as f64;
        self.spent = Spent::default();
        match self.phase {
            Phase::Tried { settled } if price >= self.most_for_trial() => {
                self.moves = settled;
                self.fail();
            }
            Phase::Tried { .. } => {
                // Go on in the same direction.
                self.settled_price = price;
                self.failures = 0;
                self.try_next();
            }
            _ => {
                self.settled_price = price;
                match self.rest.checked_sub(1) {
                    Some(rest) => self.rest = rest,
                    None => self.try_next(),
                }
            }
        }
        self
    }

    /// A trial has paid if its price is below this. At about equal prices the shorter horizon wins: it takes less memory, and
    /// an even shorter one may be cheaper still.
    fn most_for_trial(&self) -> f64 {
        let gain = if self.is_longer_next { -GAIN } else { GAIN };
        self.settled_price * (1.0 + gain)
    }

    /// Tries the next horizon, if there is one.
    fn try_next(&mut self) {
        let settled = self.moves;
        self.moves = match (self.is_longer_next, settled) {
            (true, 0) => 1,
            (true, moves) => LONGEST.min(2 * moves),
            (false, moves) => moves / 2,
        };
        if self.moves == settled {
            self.fail();
        } else {
            self.phase = Phase::Tried { settled };
        }
    }

    /// Settles, after a trial that has not paid, or could not be made.
    fn fail(&mut self) {
        self.phase = Phase::Settled;
        self.is_longer_next = !self.is_longer_next;
        self.failures = self.failures.saturating_add(1);
        // Both directions in turn, then a rest that becomes longer.
        self.rest = match self.failures % 2 {
            0 => self.next_rest(),
            _ => 0,
        };
    }

    fn next_rest(&self) -> u32 {
        MOST_REST.min(1 << (self.failures / 2).min(31))
    }

    /// Looks less far ahead, because there are too many candidates.
    pub(super) fn shorten(&mut self) {
        if !self.is_any() {
            return;
        }
        self.moves /= SHORTENING;
        self.phase = Phase::Settled;
        self.spent = Spent::default();
        self.is_longer_next = true;
        // It may have been a moment, so it is tried again, and more rarely if it was not.
        self.failures = self.failures.saturating_add(2);
        self.rest = self.next_rest();
    }
}

/// A first guess: with moves of `v` box sizes and `p` pairs per box there are about `p · D · v · h` candidates per box too
/// many with a horizon of `h` moves. If searching for a box costs `K` and comparing a candidate `c`, the best is
/// `√(K / (c · p · D · v))`.
fn guess<const D: usize>(speed: f64, pairs: f64) -> u16 {
    if speed > TOO_FAST {
        return 0;
    }
    let growth = D as f64 * pairs.max(LEAST_PAIRS) * speed;
    let squared = SEARCHED as f64 / COMPARED as f64 / growth;
    let mut moves = 1;
    // The nearest power of 2, by ratio; comparisons are the same on every machine.
    while moves < LONGEST && squared > f64::from(moves) * f64::from(2 * moves) {
        moves *= 2;
    }
    moves
}
