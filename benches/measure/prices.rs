//! What the units of an update's work cost in whole worlds, and how the foresight that goes by speed fares beside fixed ones.
//!
//! Rapier's own broad phase drives each scene of `compare`; unisize gets the same updates, once with each fixed foresight and
//! once with the one that it chooses. All take turns within each step, so that the solver has emptied the caches for all.
//! The first rows have the time of the default broad phase over that of each foresight. The last ones have the prices of the units
//! that an update counts, fitted to the times of all updates by least squares of their relative errors, none below zero.

use crate::options::Options;
use crate::report::Report;
use crate::{dim2, dim3, fit};
use std::io;
use std::time::Duration;
use unisize_scenes::SceneKind;

/// The foresights; `None` is the one that goes by speed.
pub(crate) const FORESIGHTS: [Option<u16>; 7] =
    [None, Some(0), Some(2), Some(4), Some(8), Some(16), Some(32)];

/// Two simulated seconds.
const STEPS: usize = 120;

/// The bodies and the steps of a small run.
const SMALL: (usize, usize) = (100, 20);

/// The units of work.
pub(crate) const UNITS: [&str; 8] = [
    "update",
    "listed",
    "compared",
    "picked",
    "walked",
    "looked up",
    "searched",
    "found",
];

/// How many of each unit an update has taken.
pub(crate) type Work = [f64; UNITS.len()];

/// What one broad phase has taken: in all, in the longest update, and in each with its work.
#[derive(Default)]
pub(crate) struct Follower {
    all: Duration,
    longest: Duration,
    full_runs: u64,
    updates: Vec<(Work, Duration)>,
}

impl Follower {
    /// Another update.
    pub(crate) fn take(&mut self, time: Duration, work: Work, full_runs: u64) {
        self.all += time;
        self.longest = self.longest.max(time);
        self.full_runs = full_runs;
        self.updates.push((work, time));
    }
}

/// One scene.
pub(crate) struct Race {
    pub(crate) scene: &'static str,
    pub(crate) dim: usize,
    pub(crate) default: Duration,
    pub(crate) ours: Vec<Follower>,
}

impl Race {
    fn report(&self, report: &mut Report) -> io::Result<()> {
        let ratio = |follower: &Follower| self.default.div_duration_f64(follower.all);
        let ratios: Vec<_> = self.ours.iter().map(ratio).collect();
        let best = ratios[1..].iter().copied().fold(0.0, f64::max);
        let by_speed = &self.ours[0];
        let mut row = vec![
            ("table", "foresight".into()),
            ("scene", self.scene.into()),
            ("dim", self.dim.into()),
            ("by_speed", ratios[0].into()),
        ];
        let names = [
            "moves_0", "moves_2", "moves_4", "moves_8", "moves_16", "moves_32",
        ];
        let fixed = ratios[1..].iter().map(|&ratio| ratio.into());
        row.extend(names.into_iter().zip(fixed));
        row.extend([
            ("over_best", (ratios[0] / best).into()),
            ("full_runs", by_speed.full_runs.into()),
            ("updates", by_speed.updates.len().into()),
            ("longest_ms", (by_speed.longest.as_secs_f64() * 1e3).into()),
        ]);
        report.row(&row)
    }
}

/// Measures in each scene and dimension, then fits.
pub(crate) fn measure(options: &Options, report: &mut Report) -> io::Result<()> {
    let mut races = Vec::new();
    for kind in options.scenes() {
        let follow: [fn(SceneKind, usize, usize) -> Race; 2] =
            [dim2::fan::follow, dim3::fan::follow];
        let (bodies, steps) = options.least((kind.default_bodies(), STEPS), SMALL);
        for follow in follow {
            let race = follow(kind, bodies, steps);
            race.report(report)?;
            races.push(race);
        }
    }
    for dim in [2, 3] {
        let races = races.iter().filter(|race| race.dim == dim);
        let updates = races.flat_map(|race| race.ours.iter().flat_map(|ours| &ours.updates));
        let updates = updates.map(|(work, time)| (*work, time.as_secs_f64() * 1e9));
        for (unit, price) in UNITS.into_iter().zip(fit::prices(updates)) {
            report.row(&[
                ("table", "prices".into()),
                ("unit", unit.into()),
                ("dim", dim.into()),
                ("ns", price.into()),
            ])?;
        }
    }
    Ok(())
}
