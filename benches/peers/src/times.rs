//! The times of many frames, turn by turn, and what is reported of them.

use std::time::Duration;

/// How long each of some frames took, turn by turn.
#[derive(Clone, Debug, Default)]
pub(crate) struct Times(Vec<Vec<Duration>>);

impl Times {
    /// Another turn begins.
    pub(crate) fn begin_turn(&mut self) {
        self.0.push(Vec::new());
    }

    /// A frame of this turn.
    pub(crate) fn push(&mut self, time: Duration) {
        if let Some(turn) = self.0.last_mut() {
            turn.push(time);
        }
    }

    pub(crate) fn count(&self) -> usize {
        self.0.iter().map(Vec::len).sum()
    }

    /// The median turn's mean, in milliseconds; 0 if there are no frames.
    ///
    /// A mean, because frames may differ and the slow ones count; of the median turn, because a frame that something
    /// else on the machine has held up says nothing, and can be a hundred times as long as the others.
    pub(crate) fn typical(&self) -> f64 {
        let mean = |turn: &Vec<Duration>| {
            let sum: Duration = turn.iter().sum();
            sum.as_secs_f64() * 1e3 / turn.len().max(1) as f64
        };
        let mut means: Vec<_> = self.0.iter().map(mean).collect();
        means.sort_unstable_by(f64::total_cmp);
        means.get(means.len() / 2).copied().unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Times;
    use std::time::Duration;

    #[test]
    fn one_turn_that_was_held_up_does_not_count() {
        let mut times = Times::default();
        assert_eq!(times.typical(), 0.0);
        for turn in [[1, 3], [2, 2], [1, 900]] {
            times.begin_turn();
            for ms in turn {
                times.push(Duration::from_millis(ms));
            }
        }
        assert_eq!(times.typical(), 2.0);
        assert_eq!(times.count(), 6);
    }
}
