//! Time and memory a body from a hundred thousand to four million: does it stay level?
//!
//! ```text
//! cargo bench --features rapier2d-027,rapier3d-027,parallel --bench scale
//! ```
//!
//! Prints a Markdown table and writes a chart to `docs/figures/scale.svg`. Boxes drift, at the densities of the bench `update`.
//! The kernel gets bare boxes; for an update all bodies move and all are listed. Memory is what dropping the broad phase frees
//! after the updates. The largest world takes some 10 GB.

#[path = "common/allocator.rs"]
mod allocator;
mod common;
#[allow(dead_code, reason = "here everything moves")]
#[path = "update/motion.rs"]
mod motion;

use allocator::bytes_held;
use motion::Motion;
use std::path::Path;
use std::time::{Duration, Instant};
use unisize::{Aabb, GridSweep, PairFinder};
use unisize_charts::{Axis, Chart, Panel, Series, color};
use unisize_scenes::DriftingBoxes;

#[path = "scale"]
mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d_027 as ours;

    mod dimension;
    #[path = "../common/rapier_027.rs"]
    mod version;
    pub(crate) use dimension::{DENSITY, measure};
}

#[path = "scale"]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027 as ours;

    mod dimension;
    #[path = "../common/rapier_027.rs"]
    mod version;
    pub(crate) use dimension::{DENSITY, measure};
}

const COUNTS: [usize; 4] = [100_000, 300_000, 1_000_000, 4_000_000];

/// The number of bodies in a smoke test.
const SMALL_COUNT: usize = 1_000;

/// Frames of a run.
const FRAMES: usize = 20;

/// What a broad phase takes.
pub(crate) struct Cost {
    pub(crate) mean: Duration,
    pub(crate) longest: Duration,
    pub(crate) bytes: usize,
}

/// A line of the table, in nanoseconds and bytes a body.
struct Row {
    count: usize,
    kernel: f64,
    ours: [f64; 3],
    default: [f64; 3],
}

fn main() {
    common::set_threads();
    let counts = if common::is_smoke_test() {
        &[SMALL_COUNT][..]
    } else {
        &COUNTS
    };
    println!(
        "| dimension | bodies | kernel, ns a box | update, ns a body | longest | bytes a body | Rapier 0.27: update | longest | bytes |"
    );
    println!("|---|--:|--:|--:|--:|--:|--:|--:|--:|");
    let rows = [2, 3].map(|dim| {
        let rows = counts.iter().map(|&count| measure(dim, count));
        rows.collect::<Vec<_>>()
    });
    if !common::is_smoke_test() {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures/scale.svg");
        draw(&rows)
            .write_svg(&file)
            .expect("the chart can be written");
    }
}

fn measure(dim: usize, count: usize) -> Row {
    let per_body = |Cost {
                        mean,
                        longest,
                        bytes,
                    }: Cost| {
        let time = |time: Duration| time.as_secs_f64() * 1e9 / count as f64;
        [time(mean), time(longest), bytes as f64 / count as f64]
    };
    let (kernel, [ours, default]) = match dim {
        2 => (kernel::<2>(count, dim2::DENSITY), dim2::measure(count)),
        _ => (kernel::<3>(count, dim3::DENSITY), dim3::measure(count)),
    };
    let row = Row {
        count,
        kernel,
        ours: per_body(ours),
        default: per_body(default),
    };
    let figures = [row.kernel].into_iter().chain(row.ours).chain(row.default);
    let figures: Vec<_> = figures.map(|figure| format!("{figure:.0}")).collect();
    println!("| {dim}D | {count} | {} |", figures.join(" | "));
    row
}

/// Nanoseconds a box, the median of some frames.
fn kernel<const D: usize>(count: usize, density: f64) -> f64 {
    let mut drifting = DriftingBoxes::<D>::new(count, density, 7);
    let mut finder = GridSweep::<f32, D>::default();
    let (mut boxes, mut pairs) = (Vec::new(), Vec::new());
    let mut times: Vec<_> = (0..FRAMES)
        .map(|_| {
            drifting.advance();
            boxes.clear();
            boxes.extend(
                drifting
                    .mins()
                    .iter()
                    .map(|mins| Aabb::new(*mins, mins.map(|x| x + DriftingBoxes::<D>::SIZE))),
            );
            let start = Instant::now();
            let found = finder.find_pairs(&boxes, &mut pairs);
            let time = start.elapsed();
            assert_eq!(found, Ok(()));
            time
        })
        .collect();
    times.sort_unstable();
    times[FRAMES / 2].as_secs_f64() * 1e9 / count as f64
}

fn draw(rows: &[Vec<Row>; 2]) -> Chart {
    let series = |name: String, color, figure: &dyn Fn(&Row) -> f64, rows: &[Row]| {
        let points = rows.iter().map(|row| (row.count as f64, figure(row)));
        Series::new(name, color, points)
    };
    let panels = [("2D", &rows[0]), ("3D", &rows[1])].map(|(title, rows)| {
        Panel::new(
            title,
            Axis::log("bodies"),
            Axis::log("nanoseconds a body"),
            [
                series(
                    "unisize, update".into(),
                    color::RED,
                    &|row| row.ours[0],
                    rows,
                )
                .bold(),
                series(
                    "unisize, kernel".into(),
                    color::SALMON,
                    &|row| row.kernel,
                    rows,
                ),
                series(
                    "Rapier 0.27, update".into(),
                    color::BLUE,
                    &|row| row.default[0],
                    rows,
                ),
            ],
        )
    });
    Chart::new("Time a body, all moving", panels)
}
