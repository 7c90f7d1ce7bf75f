//! The times of turns of some frames each, and what is reported of them.

use std::time::Duration;

/// How long some turns took.
#[derive(Clone, Debug, Default)]
pub(crate) struct Times {
    /// The frames of all turns.
    pub(crate) frames: usize,
    /// The mean milliseconds of a frame, turn by turn.
    means: Vec<f64>,
}

impl Times {
    /// Another turn: what so many frames took.
    pub(crate) fn push(&mut self, frames: usize, time: Duration) {
        self.frames += frames;
        self.means
            .push(time.as_secs_f64() * 1e3 / frames.max(1) as f64);
    }

    /// The median turn's mean, in milliseconds; 0 if there are no turns.
    ///
    /// A mean, because frames may differ and the slow ones count; of the median turn, because a frame that something
    /// else on the machine has held up says nothing, and can be a hundred times as long as the others.
    pub(crate) fn typical(&self) -> f64 {
        let mut means = self.means.clone();
        means.sort_unstable_by(f64::total_cmp);
        means.get(means.len() / 2).copied().unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_turn_that_was_held_up_does_not_count() {
        let mut times = Times::default();
        assert_eq!(times.typical(), 0.0);
        for ms in [4, 4, 901] {
            times.push(2, Duration::from_millis(ms));
        }
        assert_eq!((times.typical(), times.frames), (2.0, 6));
    }
}
