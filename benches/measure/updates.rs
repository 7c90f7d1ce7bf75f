//! Updates of drifting cubes, of Rapier's own broad phases and of unisize: how long they take, which phase takes how much, and how
//! many bytes a collider both hold, which is what dropping them frees. Events do not count, since they go into the caller's list.
//!
//! The same colliders move in every frame, spread over the whole environment. Moving them and listing them is not timed.

use crate::case::{Case, Motion, Sizes};
use crate::kernels::Phases;
use crate::options::Options;
use crate::report::Report;
use crate::{clock_for, dim2, dim2_036, dim3, dim3_036, ns_each};
use serde_json::Value;
use std::path::Path;
use unisize_charts::{Axis, Chart, Panel, Series, color};

/// Gives 0.8 overlapping pairs per box.
const DENSITIES: [f64; 2] = [0.4, 0.2];

const MOTIONS: [Motion; 4] = [
    Motion::OneIn(1),
    Motion::OneIn(10),
    Motion::OneIn(100),
    Motion::InMargin,
];

/// Numbers of colliders.
const COUNTS: [usize; 5] = [100, 1_000, 10_000, 1 << 16, 1 << 17];

/// Numbers of bodies. The largest world takes some 10 GB.
const SCALE: [usize; 4] = [100_000, 300_000, 1_000_000, 4_000_000];

fn case(dim: usize, count: usize, motion: Motion, bodies: bool) -> Case {
    Case {
        count,
        density: DENSITIES[dim - 2],
        motion,
        sizes: Sizes::One,
        bodies,
        clock: clock_for(count),
    }
}

/// Measures every motion with every number of colliders, with bodies and without.
pub(crate) fn measure(options: &Options, report: &mut Report) -> anyhow::Result<()> {
    let frames = options.least(60, 3);
    for motion in MOTIONS {
        for bodies in [false, true] {
            for &count in options.counts(&COUNTS, 1_000) {
                let [flat, solid] = [2, 3].map(|dim| case(dim, count, motion, bodies));
                report.row(&dim2::follow::measure(&flat, frames))?;
                report.row(&dim3::follow::measure(&solid, frames))?;
                report.row(&dim2_036::follow::measure(&flat, frames))?;
                report.row(&dim3_036::follow::measure(&solid, frames))?;
            }
        }
    }
    Ok(())
}

/// Does the time a body stay level? All bodies move, and all are listed; the kernel gets bare boxes.
pub(crate) fn scale(options: &Options, report: &mut Report) -> anyhow::Result<()> {
    let frames = options.least(20, 2);
    let mut panels = Vec::new();
    for dim in [2, 3] {
        let mut rows = Vec::new();
        for &count in options.least(&SCALE[..], &[1_000]) {
            let case = case(dim, count, Motion::OneIn(1), true);
            let (kernel, mut row) = match dim {
                2 => (
                    Phases::of::<2>(count, case.density, frames),
                    dim2::follow::measure(&case, frames),
                ),
                _ => (
                    Phases::of::<3>(count, case.density, frames),
                    dim3::follow::measure(&case, frames),
                ),
            };
            row.push(("kernel_ns", ns_each(kernel.all, count).into()));
            report.row(&row)?;
            rows.push(row);
        }
        panels.push(panel(dim, &rows));
    }
    if options.is_small() {
        return Ok(());
    }
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures/scale.svg");
    Chart::new("Time a body, all moving", panels).write_svg(&file)
}

fn panel(dim: usize, rows: &[Vec<(&str, Value)>]) -> Panel {
    let series = |name, color, field: &str| {
        let figure = |row: &[(&str, Value)], field| {
            let found = row.iter().find(|(name, _)| *name == field);
            found
                .and_then(|(_, value)| value.as_f64())
                .unwrap_or(f64::NAN)
        };
        let points = rows
            .iter()
            .map(|row| (figure(row, "count"), figure(row, field)));
        Series::new(name, color, points)
    };
    let series = [
        series("unisize, update", color::RED, "ours_ns").bold(),
        series("unisize, kernel", color::SALMON, "kernel_ns"),
        series("Rapier 0.27, update", color::BLUE, "default_ns"),
    ];
    let (x, y) = (Axis::log("bodies"), Axis::log("nanoseconds a body"));
    Panel::new(format!("{dim}D"), x, y, series)
}
