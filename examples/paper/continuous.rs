//! Boxes that move during a frame.
//!
//! A *swept* box contains a box at the beginning of a frame and at its end. Boxes that meet during the frame have overlapping
//! swept boxes, so the kernels need no change, only other boxes. Rapier's soft CCD does the same.

use crate::race::{race, unit_boxes};
use crate::{Run, method};
use anyhow::Result;
use unisize::Aabb;
use unisize_scenes::DriftingBoxes;

/// The way of the fastest squares in a frame, in sizes.
const SPEEDS: [f32; 7] = [0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0];

/// The speed of the drifting squares as they are made.
const MADE_SPEED: f32 = 0.1;

const DENSITY: f64 = 0.4;

/// The number of squares that are timed, and of those whose pairs are followed through the frame.
const COUNT: usize = 1 << 17;
const FOLLOWED: usize = 1 << 12;
const FRAMES: usize = 5;

pub(crate) fn measure(run: &mut Run) -> Result<()> {
    let (n, followed) = run.choose((1 << 10, 1 << 9), (COUNT, FOLLOWED));
    for speed in SPEEDS {
        let mut drifting = DriftingBoxes::<2>::new(followed, DENSITY, 7);
        let meetings = Meetings::count(&Frame::next(&mut drifting, speed));
        let share = |part: usize, all: usize| 100.0 * part as f64 / all as f64;
        let row = format!("{speed} sizes a frame");
        let mut add = |column: String, value| run.table.add("continuous", &row, column, value);
        let found = share(meetings.at_the_end, meetings.all);
        add(
            "of all that meet, % found at the end of the frame".to_owned(),
            found,
        );
        let found = share(meetings.swept_and_meet, meetings.all);
        add("% found by swept boxes".to_owned(), found);
        let meet = share(meetings.swept_and_meet, meetings.swept);
        add("of the pairs of swept boxes, % meet".to_owned(), meet);

        let mut drifting = DriftingBoxes::<2>::new(n, DENSITY, 7);
        let mut methods = method::all().split_off(5);
        let next = |boxes: &mut Vec<_>| *boxes = Frame::next(&mut drifting, speed).swept();
        let outcome = race(&mut methods, run.choose(2, FRAMES), next)?;
        for (method, times) in methods.iter().zip(outcome.times) {
            let column = format!("{}, swept boxes, ms", method.name);
            run.table.add("continuous", &row, column, times.median());
        }
    }
    Ok(())
}

/// Squares at the beginning of a frame and at its end.
struct Frame {
    before: Vec<[f32; 2]>,
    after: Vec<[f32; 2]>,
}

impl Frame {
    /// The next frame. Squares go further than the generator moves them, straight through the borders.
    fn next(drifting: &mut DriftingBoxes<2>, speed: f32) -> Self {
        let before = drifting.mins().to_vec();
        drifting.advance();
        let factor = speed / MADE_SPEED;
        let ways = before.iter().zip(drifting.mins());
        let after = ways.map(|(before, after)| {
            std::array::from_fn(|axis| before[axis] + (after[axis] - before[axis]) * factor)
        });
        Self {
            after: after.collect(),
            before,
        }
    }

    fn swept(&self) -> Vec<Aabb<f32, 2>> {
        let ways = self.before.iter().zip(&self.after);
        let swept = ways.map(|(a, b)| {
            let mins = std::array::from_fn(|axis| a[axis].min(b[axis]));
            let maxs = std::array::from_fn(|axis| a[axis].max(b[axis]) + 1.0);
            Aabb::new(mins, maxs)
        });
        swept.collect()
    }
}

/// Counts of the pairs of squares in a frame.
#[derive(Debug, Default)]
struct Meetings {
    /// Overlap at some time of the frame.
    all: usize,
    /// Overlap at the end.
    at_the_end: usize,
    /// Have swept boxes that overlap.
    swept: usize,
    swept_and_meet: usize,
}

impl Meetings {
    /// Examines every pair of squares. **O(n²)**.
    fn count(frame: &Frame) -> Self {
        let (mut at_end, swept) = (Vec::new(), frame.swept());
        unit_boxes(&frame.after, &mut at_end);
        let mut meetings = Self::default();
        for i in 0..at_end.len() {
            for j in 0..i {
                let meet = meet(frame, i, j);
                let overlap = swept[i].overlaps(&swept[j]);
                meetings.all += usize::from(meet);
                meetings.at_the_end += usize::from(meet && at_end[i].overlaps(&at_end[j]));
                meetings.swept += usize::from(overlap);
                meetings.swept_and_meet += usize::from(overlap && meet);
            }
        }
        meetings
    }
}

/// Whether two squares that go straight overlap at some time of the frame, which lasts from 0 to 1.
fn meet(frame: &Frame, i: usize, j: usize) -> bool {
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let distance = |mins: &[[f32; 2]]| f64::from(mins[i][axis]) - f64::from(mins[j][axis]);
        let (start, end) = (distance(&frame.before), distance(&frame.after));
        let velocity = end - start;
        if velocity == 0.0 {
            if start.abs() > 1.0 {
                return false;
            }
            continue;
        }
        // When the distance is -1, and when it is 1.
        let times = [-1.0, 1.0].map(|limit| (limit - start) / velocity);
        first = first.max(times[0].min(times[1]));
        last = last.min(times[0].max(times[1]));
    }
    first <= last
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_meet_that_fly_through_each_other() {
        let frame = Frame {
            before: vec![[0.0, 0.0], [10.0, 0.0], [0.0, 1.5], [10.0, 5.0]],
            after: vec![[10.0, 0.0], [0.0, 0.0], [0.0, 1.5], [0.0, 5.0]],
        };
        let meets = |i, j| meet(&frame, i, j);
        assert!(meets(0, 1) && meets(1, 0));
        assert!(!meets(0, 2) && !meets(0, 3) && !meets(2, 3));
        let meetings = Meetings::count(&frame);
        assert_eq!([meetings.all, meetings.at_the_end], [1, 0]);
        // The swept boxes of the two reach along one line.
        assert_eq!([meetings.swept, meetings.swept_and_meet], [1, 1]);
    }

    #[test]
    fn what_meets_has_swept_boxes_that_overlap() {
        for speed in [0.0, 0.5, 3.0] {
            let mut drifting = DriftingBoxes::<2>::new(600, DENSITY, 7);
            let meetings = Meetings::count(&Frame::next(&mut drifting, speed));
            assert!(meetings.all > 50, "{meetings:?}");
            assert_eq!(meetings.swept_and_meet, meetings.all, "{meetings:?}");
        }
    }
}
