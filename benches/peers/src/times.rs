//! The times of many frames, and what is reported of them.

use std::time::Duration;

/// How long each of some frames took, turn by turn.
#[derive(Clone, Debug, Default)]
pub(crate) struct Times {
    turns: Vec<Vec<Duration>>,
    /// The same frames in a second run, if there was one.
    again: Vec<Vec<Duration>>,
}

impl Times {
    /// Another turn begins.
    pub(crate) fn begin_turn(&mut self) {
        self.turns.push(Vec::new());
    }

    /// A frame of this turn.
    pub(crate) fn push(&mut self, time: Duration) {
        if let Some(turn) = self.turns.last_mut() {
            turn.push(time);
        }
    }

    pub(crate) fn count(&self) -> usize {
        self.turns.iter().map(Vec::len).sum()
    }

    /// The median turn's mean, in milliseconds; 0 if there are no frames.
    ///
    /// A mean, because frames may differ and the slow ones count; of the median turn, because a frame that something
    /// else on the machine has held up says nothing, and can be a hundred times as long as the others.
    pub(crate) fn typical(&self) -> f64 {
        let mut means: Vec<_> = self.turns.iter().map(|turn| mean(turn)).collect();
        means.sort_unstable_by(f64::total_cmp);
        means.get(means.len() / 2).copied().unwrap_or(0.0)
    }

    /// Of all frames, in milliseconds; 0 if there are none.
    pub(crate) fn mean(&self) -> f64 {
        mean(&self.turns.concat())
    }

    /// The same frames once more, from the beginning.
    pub(crate) fn repeated(&mut self, again: Self) {
        self.again = again.turns;
    }

    /// The longest frame, in milliseconds; 0 if there are none. If all were run twice, a frame took as long as in the
    /// quicker run: what holds a frame up by chance does not hold it up again.
    pub(crate) fn worst(&self) -> f64 {
        let mut again = self.again.iter().flatten();
        let of_frame = |&time: &Duration| again.next().map_or(time, |&again| again.min(time));
        let worst = self.turns.iter().flatten().map(of_frame).max();
        worst.map_or(0.0, milliseconds)
    }

    /// The same frames without a part of each.
    pub(crate) fn without(&self, parts: &Self) -> Self {
        let less = |turns: &[Vec<Duration>], parts: &[Vec<Duration>]| {
            let turns = turns.iter().zip(parts);
            let turns = turns.map(|(turn, parts)| {
                let frames = turn.iter().zip(parts);
                frames
                    .map(|(time, &part)| time.saturating_sub(part))
                    .collect()
            });
            turns.collect()
        };
        Self {
            turns: less(&self.turns, &parts.turns),
            again: less(&self.again, &parts.again),
        }
    }

    /// Whether no frame took any time.
    pub(crate) fn is_zero(&self) -> bool {
        self.turns.iter().flatten().all(Duration::is_zero)
    }
}

fn mean(times: &[Duration]) -> f64 {
    let sum: Duration = times.iter().sum();
    milliseconds(sum) / times.len().max(1) as f64
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
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
        assert_eq!(times.worst(), 900.0);
        assert_eq!(times.count(), 6);
    }

    fn of_one_turn<const N: usize>(frames: [u64; N]) -> Times {
        let mut times = Times::default();
        times.begin_turn();
        for ms in frames {
            times.push(Duration::from_millis(ms));
        }
        times
    }

    #[test]
    fn a_frame_that_is_held_up_once_is_not_the_longest() {
        let mut times = of_one_turn([1, 90, 5, 2]);
        times.repeated(of_one_turn([70, 2, 4, 2]));
        assert_eq!(times.worst(), 4.0);
        assert_eq!(times.mean(), 24.5);
    }

    #[test]
    fn parts_are_left_out_frame_by_frame() {
        let times = of_one_turn([5, 9, 3]);
        let parts = of_one_turn([1, 6, 4]);
        let rest = times.without(&parts);
        assert_eq!(rest.worst(), 4.0);
        assert_eq!(rest.count(), 3);
        assert!(of_one_turn([0, 0]).is_zero() && !rest.is_zero());
    }
}
