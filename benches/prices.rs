//! What the units of an update's work cost in whole worlds, and how the foresight that goes by speed fares beside fixed ones.
//!
//! ```text
//! cargo bench --features rapier2d-027,rapier3d-027 --bench prices [-- SCENE ...]
//! ```
//!
//! Rapier's own broad phase drives each scene of `compare`; unisize gets the same updates, once with each fixed foresight and
//! once with the one that it chooses. All take turns within each step, so that the solver has emptied the caches for all.
//! Prints two Markdown tables. The first one has, by scene, the time of the default broad phase over that of each foresight. The
//! second one has the prices of the units that an update counts, fitted to the times of all updates by least
//! squares of their relative errors, none below zero. They are the prices of `src/tuning.rs`.

mod common;
mod prices {
    //! The fit.
    pub(crate) mod fit;
}

use std::time::Duration;
use unisize_scenes::SceneKind;

#[path = "prices"]
mod dim2 {
    use unisize::rapier2d_027 as ours;
    use unisize_scenes::dim2 as scenes;

    mod dimension;
    pub(crate) use dimension::follow;
}

#[path = "prices"]
mod dim3 {
    use unisize::rapier3d_027 as ours;
    use unisize_scenes::dim3 as scenes;

    mod dimension;
    pub(crate) use dimension::follow;
}

/// The foresights; `None` is the one that goes by speed.
const FORESIGHTS: [Option<u16>; 7] = [None, Some(0), Some(2), Some(4), Some(8), Some(16), Some(32)];

/// Two simulated seconds.
const STEPS: usize = 120;

/// The bodies and the steps of a smoke test.
const SMALL: (usize, usize) = (100, 20);

/// The units of work.
const UNITS: [&str; 8] = [
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
type Work = [f64; UNITS.len()];

/// One update.
struct Sample {
    time: Duration,
    work: Work,
}

/// What one broad phase has taken.
#[derive(Default)]
struct Follower {
    all: Duration,
    worst: Duration,
    full_runs: u64,
    samples: Vec<Sample>,
}

impl Follower {
    fn take(&mut self, time: Duration, work: Work, full_runs: u64) {
        self.all += time;
        self.worst = self.worst.max(time);
        self.full_runs = full_runs;
        self.samples.push(Sample { time, work });
    }
}

/// One scene.
struct Row {
    scene: &'static str,
    dim: usize,
    default: Duration,
    ours: Vec<Follower>,
}

impl Row {
    fn ratio(&self, i: usize) -> f64 {
        self.default.as_secs_f64() / self.ours[i].all.as_secs_f64()
    }

    fn print(&self) {
        let ratios = (0..FORESIGHTS.len()).map(|i| format!("{:.2}", self.ratio(i)));
        let best = (1..FORESIGHTS.len())
            .map(|i| self.ratio(i))
            .fold(0.0, f64::max);
        let by_speed = &self.ours[0];
        println!(
            "| {} | {}D | {} | {:.2} | {} of {} | {:.2} |",
            self.scene,
            self.dim,
            ratios.collect::<Vec<_>>().join(" | "),
            self.ratio(0) / best,
            by_speed.full_runs,
            by_speed.samples.len(),
            by_speed.worst.as_secs_f64() * 1e3,
        );
    }
}

fn main() {
    common::set_threads();
    let named: Vec<_> = std::env::args()
        .filter_map(|name| SceneKind::from_name(&name))
        .collect();
    let scenes = if named.is_empty() {
        SceneKind::ALL.to_vec()
    } else {
        named
    };
    let foresights = FORESIGHTS.map(|moves| match moves {
        None => "by speed".to_owned(),
        Some(moves) => moves.to_string(),
    });
    let foresights = foresights.join(" | ");
    println!("| scene | | {foresights} | over best | full runs | longest, ms |");
    println!("|---|---|{}", "---|".repeat(FORESIGHTS.len() + 3));
    let mut rows = Vec::new();
    for kind in scenes {
        let (bodies, steps) = if common::is_smoke_test() {
            SMALL
        } else {
            (kind.default_bodies(), STEPS)
        };
        for follow in [dim2::follow, dim3::follow] {
            let row = follow(kind, bodies, steps);
            row.print();
            rows.push(row);
        }
    }
    for dim in [2, 3] {
        let of_dim = || rows.iter().filter(|row| row.dim == dim);
        let logs = of_dim().map(|row| row.ratio(0).ln());
        let mean = (logs.sum::<f64>() / of_dim().count() as f64).exp();
        println!("\nGeometric mean in {dim}D: {mean:.2}");
    }
    println!("\n| unit | ns in 2D | ns in 3D |\n|---|---|---|");
    let prices = [2, 3].map(|dim| {
        let samples = rows.iter().filter(|row| row.dim == dim);
        let samples = samples.flat_map(|row| row.ours.iter().flat_map(|ours| &ours.samples));
        prices::fit::prices(samples.map(|sample| (sample.work, sample.time.as_secs_f64() * 1e9)))
    });
    for (unit, name) in UNITS.iter().enumerate() {
        println!(
            "| {name} | {:.2} | {:.2} |",
            prices[0][unit], prices[1][unit]
        );
    }
}
