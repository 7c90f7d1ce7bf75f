//! Kernels that measure the times of their phases.

use unisize::{GridSweep, PairFinder, PhaseTimes, RankSweep};

use crate::boxes::uniform;

#[test]
fn only_timed_kernels_measure_times() {
    let boxes = uniform::<f32, 3>(1, 3000, 0.8);
    let pairs = &mut Vec::new();
    for is_timed in [false, true] {
        let (mut grid_sweep, mut rank_sweep) = (GridSweep::default(), RankSweep::default());
        if is_timed {
            (grid_sweep, rank_sweep) = (grid_sweep.timed(), rank_sweep.timed());
        }
        for _ in 0..2 {
            grid_sweep.find_pairs(&boxes, pairs).unwrap();
            rank_sweep.find_pairs(&boxes, pairs).unwrap();
            for times in [grid_sweep.phase_times(), rank_sweep.phase_times()] {
                let PhaseTimes { sort, sweep, .. } = times;
                assert!([sort, sweep].iter().all(|time| time.is_zero() != is_timed));
                // The phases of updates stay 0.
                assert_eq!(times.total(), times.read + sort + sweep);
            }
        }
    }
}
