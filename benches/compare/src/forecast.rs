//! A forecast of the time of an update on more threads than this machine has.
//!
//! On one thread, unisize measures the part of an update that several threads would split, and its number of sections. The rest of the
//! time stays as it is. The split part is divided by the number of threads. The costs of waking them were measured on a server with a core
//! for each thread.

use unisize_scenes::Sharing;

/// The numbers of threads for which there is a forecast.
pub(super) const THREADS: [usize; 4] = [2, 4, 8, 16];

/// Microseconds to enter a sleeping pool from outside.
const ENTERING: f64 = 40.0;

/// Microseconds for the first section in the pool, with each number of threads.
const FIRST_SECTION: [f64; 4] = [3.3, 6.5, 8.8, 25.0];

/// Microseconds for each further one.
const SECTION: [f64; 4] = [0.2, 1.3, 3.4, 6.3];

/// The number of entries into the pool in a step: when boxes are passed, and in the update.
const ENTRIES: f64 = 2.0;

/// Threads are woken if that saves at least this many milliseconds of a step.
const LEAST_GAIN: f64 = 0.25;

/// Milliseconds of an update on each number of threads, from the updates of this many steps on one.
pub(super) fn forecast(sharing: &Sharing, steps: usize) -> [f64; 4] {
    let [serial, shared, sections] = [
        sharing.ms - sharing.ms_shared,
        sharing.ms_shared,
        sharing.sections as f64,
    ]
    .map(|sum| sum / steps as f64);
    core::array::from_fn(|i| {
        let waking = ENTRIES * (ENTERING + FIRST_SECTION[i]) + sections * SECTION[i];
        let each = shared / THREADS[i] as f64;
        match shared - each < LEAST_GAIN {
            true => serial + shared,
            false => serial + each + waking / 1e3,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_serial_stays_and_what_is_shared_is_divided() {
        let sharing = |ms_shared, sections| Sharing {
            ms: 200.0,
            ms_shared,
            sections,
        };
        assert_eq!(forecast(&sharing(0.0, 0), 100), [2.0; 4]);
        // Too little to wake a second one, and enough for sixteen.
        let [two, .., sixteen] = forecast(&sharing(40.0, 100), 100);
        assert!(two == 2.0 && sixteen < 1.9, "{two}, {sixteen}");
        let [two, .., sixteen] = forecast(&sharing(160.0, 200), 100);
        assert!((1.2..1.3).contains(&two), "{two}");
        assert!((0.5..0.7).contains(&sixteen), "{sixteen}");
    }
}
