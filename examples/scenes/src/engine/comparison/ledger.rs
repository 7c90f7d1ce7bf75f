//! Two broad phases that see the same updates, and the books on what both report.

use super::both::{Both, Side};
use super::held_pairs::HeldPairs;
use super::journal::Journal;
use super::version::{self, BroadPhase, Installed, OwnBroadPhase};
use super::{Observed, Tee, Update};

/// Two broad phases that see the same updates, and the books on what both report.
pub(super) struct Ledger<C> {
    /// What takes the place of a broad phase in a step. Rapier hears of the default.
    pub(super) tee: Installed<Tee<Observed<OwnBroadPhase>, Observed<C>>>,
    /// What both hold, by their events.
    pub(super) held: HeldPairs,
    /// What both have reported since the last look at the contacts.
    pub(super) journals: Both<Journal>,
    /// How many events changed nothing.
    pub(super) redundant: Both<usize>,
    /// The first redundant event of the candidate.
    pub(super) first_redundant: Option<String>,
}

impl<C: BroadPhase + 'static> Ledger<C> {
    pub(super) fn new(candidate: C) -> Self {
        Self {
            tee: version::install(Tee::new(
                Observed::new(OwnBroadPhase::new()).clocked().with_events(),
                Observed::new(candidate).clocked().with_events(),
            )),
            held: HeldPairs::default(),
            journals: Both::default(),
            redundant: Both::default(),
            first_redundant: None,
        }
    }

    /// The broad phase that is compared with the default.
    pub(super) fn candidate(&self) -> &C {
        &self.tee.unheard.inner
    }

    /// Enters the updates of the step that was just made. Returns how many there were.
    pub(super) fn enter_step(&mut self) -> usize {
        let default = self.tee.heard.take_updates();
        let candidate = self.tee.unheard.take_updates();
        for (index, (default, candidate)) in default.iter().zip(&candidate).enumerate() {
            self.held.remove(&default.removed);
            self.enter(Side::Default, index + 1, default);
            self.enter(Side::Candidate, index + 1, candidate);
        }
        default.len()
    }

    fn enter(&mut self, side: Side, number: usize, update: &Update) {
        self.journals[side].record(update);
        for event in &update.events {
            let pair = event.pair().into();
            if !self.held.set(side, pair, event.is_add()) {
                self.redundant[side] += 1;
                if side == Side::Candidate && self.first_redundant.is_none() {
                    self.first_redundant = Some(format!(
                        "in update {number} the candidate reports the pair {pair} as {}",
                        if event.is_add() {
                            "new, which it holds already"
                        } else {
                            "ended, which it does not hold"
                        }
                    ));
                }
            }
        }
    }
}
