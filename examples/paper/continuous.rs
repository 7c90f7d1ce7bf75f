//! The last open question: boxes that move during a frame.
//!
//! A *swept* box contains a box at the beginning of a frame and at its end. Boxes that meet during the frame have overlapping
//! swept boxes, so the kernels need no change, only other boxes. Rapier's soft CCD does the same.

mod bullets;

use crate::method;
use crate::page::Page;
use crate::progress::progress_bar;
use crate::race::{race, unit_boxes};
use crate::table::{Table, digits};
use anyhow::Result;
use unisize::Aabb;
use unisize_charts::{Axis, Chart, Panel, Series, color};
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

const QUICK_COUNT: usize = 1 << 10;

pub(crate) fn run(page: &Page, quick: bool) -> Result<()> {
    let (n, followed, frames) = if quick {
        (QUICK_COUNT, QUICK_COUNT, 2)
    } else {
        (COUNT, FOLLOWED, FRAMES)
    };
    let bar = progress_bar(SPEEDS.len() as u64 + 1);
    bar.set_message("continuous motion");
    let mut table = Table::new([
        "speed, sizes a frame",
        "of all that meet, found at the end of the frame",
        "found by swept boxes",
        "of the pairs of swept boxes, meet",
        "RankSweep, ms",
        "swept, ms",
        "GridSweep, ms",
        "swept, ms ",
    ]);
    let mut lines = [const { Vec::new() }; 2];
    for speed in SPEEDS {
        let meetings = Meetings::count(&Frame::new(followed, speed));
        let [rank, grid] = times(n, speed, frames, false)?;
        let [swept_rank, swept_grid] = times(n, speed, frames, true)?;
        let percent =
            |part: usize, all: usize| format!("{:.1} %", 100.0 * part as f64 / all as f64);
        let mut row = vec![
            speed.to_string(),
            percent(meetings.at_the_end, meetings.all),
            percent(meetings.swept_and_meet, meetings.all),
            percent(meetings.swept_and_meet, meetings.swept),
        ];
        row.extend([rank, swept_rank, grid, swept_grid].map(digits));
        table.push(row);
        for (points, ms) in lines.iter_mut().zip([swept_rank, swept_grid]) {
            points.push((f64::from(speed), ms));
        }
        bar.inc(1);
    }
    page.put("continuous", &table)?;
    page.put("continuous-rapier", &bullets::table(quick))?;
    bar.finish_and_clear();
    let [rank, grid] = lines;
    let panel = Panel::new(
        "",
        Axis::linear("speed of the fastest, in sizes per frame"),
        Axis::linear("milliseconds"),
        [
            Series::new("GridSweep, swept boxes", color::RED, grid),
            Series::new("RankSweep, swept boxes", color::SALMON, rank),
        ],
    );
    let title = format!("Swept boxes of {n} squares");
    Chart::new(title, [panel]).write_svg(&page.picture("continuous.svg"))
}

/// Squares at the beginning of a frame and at its end.
struct Frame {
    before: Vec<[f32; 2]>,
    after: Vec<[f32; 2]>,
}

impl Frame {
    fn new(count: usize, speed: f32) -> Self {
        let mut drifting = DriftingBoxes::<2>::new(count, DENSITY, 7);
        let mut frame = Self {
            before: Vec::new(),
            after: Vec::new(),
        };
        frame.advance(&mut drifting, speed);
        frame
    }

    /// On to the next frame. Squares go further than the generator moves them, straight through the borders.
    fn advance(&mut self, drifting: &mut DriftingBoxes<2>, speed: f32) {
        self.before.clear();
        self.before.extend(drifting.mins());
        drifting.advance();
        let factor = speed / MADE_SPEED;
        let ways = self.before.iter().zip(drifting.mins());
        self.after.clear();
        self.after.extend(ways.map(|(before, after)| {
            std::array::from_fn(|axis| before[axis] + (after[axis] - before[axis]) * factor)
        }));
    }

    fn swept(&self, boxes: &mut Vec<Aabb<f32, 2>>) {
        boxes.clear();
        let ways = self.before.iter().zip(&self.after);
        boxes.extend(ways.map(|(a, b)| {
            let mins = std::array::from_fn(|axis| a[axis].min(b[axis]));
            let maxs = std::array::from_fn(|axis| a[axis].max(b[axis]) + 1.0);
            Aabb::new(mins, maxs)
        }));
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
        let (mut at_end, mut swept) = (Vec::new(), Vec::new());
        unit_boxes(&frame.after, &mut at_end);
        frame.swept(&mut swept);
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

/// The milliseconds of RankSweep and of GridSweep.
fn times(n: usize, speed: f32, frames: usize, swept: bool) -> Result<[f64; 2]> {
    let mut drifting = DriftingBoxes::<2>::new(n, DENSITY, 7);
    let mut frame = Frame {
        before: Vec::new(),
        after: Vec::new(),
    };
    let mut methods = vec![method::rank_sweep(), method::grid_sweep()];
    let next = |boxes: &mut Vec<_>| {
        frame.advance(&mut drifting, speed);
        if swept {
            frame.swept(boxes);
        } else {
            unit_boxes(&frame.after, boxes);
        }
    };
    let outcome = race(&mut methods, frames, next, |_| {})?;
    Ok([0, 1].map(|i| outcome.times[i].median()))
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
            let meetings = Meetings::count(&Frame::new(600, speed));
            assert!(meetings.all > 50, "{meetings:?}");
            assert_eq!(meetings.swept_and_meet, meetings.all, "{meetings:?}");
        }
    }
}
