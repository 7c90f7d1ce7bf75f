//! The times of the last steps.

use std::collections::VecDeque;

/// The milliseconds of one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sample {
    /// In unisize's broad phase, if it took part.
    pub(crate) unisize: Option<f64>,
    /// In Rapier's own, if it took part.
    pub(crate) default: Option<f64>,
    /// In everything else.
    pub(crate) rest: f64,
}

/// The last steps, the oldest first.
pub(crate) struct History {
    samples: VecDeque<Sample>,
    capacity: usize,
    /// The number of all steps so far.
    steps: usize,
}

impl History {
    pub(crate) fn new(capacity: usize) -> Self {
        Self {
            samples: VecDeque::with_capacity(capacity),
            capacity,
            steps: 0,
        }
    }

    pub(crate) fn push(&mut self, sample: Sample) {
        if self.samples.len() == self.capacity {
            self.samples.pop_front();
        }
        self.samples.push_back(sample);
        self.steps += 1;
    }

    pub(crate) fn clear(&mut self) {
        self.samples.clear();
        self.steps = 0;
    }

    /// The numbers of the first and the last step of the chart; the very first step is 1.
    pub(crate) fn range(&self) -> [usize; 2] {
        let last = self.steps.max(self.capacity);
        [last - self.capacity + 1, last]
    }

    /// The numbers of steps and their values, without the steps that have none.
    pub(crate) fn points(&self, read: impl Fn(&Sample) -> Option<f64>) -> Vec<[f64; 2]> {
        let first = self.steps - self.samples.len() + 1;
        let numbered = (first..).zip(&self.samples);
        numbered
            .filter_map(|(step, sample)| Some([step as f64, read(sample)?]))
            .collect()
    }

    /// The value that only 2 % of the values exceed.
    pub(crate) fn usual_maximum(&self, reads: &[impl Fn(&Sample) -> Option<f64>]) -> Option<f64> {
        let values = |read| self.samples.iter().filter_map(read);
        let mut values: Vec<f64> = reads.iter().flat_map(values).collect();
        let index = (values.len().checked_sub(1)? as f64 * 0.98) as usize;
        Some(*values.select_nth_unstable_by(index, f64::total_cmp).1)
    }

    /// The mean over the last `count` steps that have a value.
    pub(crate) fn mean(&self, count: usize, read: impl Fn(&Sample) -> Option<f64>) -> Option<f64> {
        let values: Vec<f64> = self
            .samples
            .iter()
            .rev()
            .filter_map(read)
            .take(count)
            .collect();
        (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::{History, Sample};

    fn sample(unisize: Option<f64>) -> Sample {
        Sample {
            unisize,
            default: None,
            rest: 1.0,
        }
    }

    #[test]
    fn the_oldest_are_forgotten_and_steps_keep_their_numbers() {
        let mut history = History::new(3);
        assert_eq!(history.range(), [1, 3]);
        for step in 1..=5 {
            history.push(sample(Some(10.0 * f64::from(step))));
        }
        let points = history.points(|sample| sample.unisize);
        assert_eq!(points, [[3.0, 30.0], [4.0, 40.0], [5.0, 50.0]]);
        assert_eq!(history.range(), [3, 5]);
        history.clear();
        assert!(history.points(|sample| sample.unisize).is_empty());
        history.push(sample(Some(7.0)));
        assert_eq!(history.points(|sample| sample.unisize), [[1.0, 7.0]]);
    }

    #[test]
    fn what_was_not_measured_is_left_out() {
        let mut history = History::new(9);
        for unisize in [Some(100.0), Some(1.0), None, Some(3.0)] {
            history.push(sample(unisize));
        }
        let points = history.points(|sample| sample.unisize);
        assert_eq!(points, [[1.0, 100.0], [2.0, 1.0], [4.0, 3.0]]);
        assert_eq!(history.mean(2, |sample| sample.unisize), Some(2.0));
        assert_eq!(history.mean(2, |sample| sample.default), None);
    }

    #[test]
    fn a_rare_value_is_not_usual() {
        let mut history = History::new(100);
        assert_eq!(
            history.usual_maximum(&[|sample: &Sample| sample.unisize]),
            None
        );
        for step in 0..100 {
            let is_rare = step == 50;
            history.push(sample(Some(if is_rare {
                1e3
            } else {
                f64::from(step % 10)
            })));
        }
        let maximum = history.usual_maximum(&[|sample: &Sample| sample.unisize]);
        assert_eq!(maximum, Some(9.0));
    }
}
