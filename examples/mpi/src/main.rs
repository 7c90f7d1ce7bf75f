//! Pairs and herds on the processes that mpirun has started, and what they take: see the README.

use anyhow::{Context, Result};
use clap::{Args, Parser};
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::time::Instant;
use unisize::Aabb;
use unisize_charts::{Axis, Chart, Panel, Series, color};
use unisize_mpi::{Body, Domains, Herd, gather, start, state, sum};
use unisize_scenes::DriftingBoxes;

/// Pairs of boxes on many processes. Rows of JSON go to the standard output.
#[derive(Parser)]
enum Job {
    /// Finds the pairs of boxes that drift in three dimensions, and takes the time of each frame on each process.
    Pairs {
        #[arg(long, default_value_t = 1 << 20)]
        boxes: usize,
        #[arg(long, default_value_t = 11)]
        frames: usize,
    },
    /// Runs a herd, and tells a hash of where it ends.
    Herd(Run),
    /// Draws the rows of a model that `measure` has made.
    Chart { rows: PathBuf, svg: PathBuf },
}

#[derive(Args)]
struct Run {
    #[arg(long, default_value_t = 1_000_000)]
    animals: usize,
    /// Steps since the start of the herd, after which the run ends.
    #[arg(long, default_value_t = 100)]
    steps: u64,
    /// A folder for states, on a disk that all processes share.
    #[arg(long)]
    state: Option<PathBuf>,
    /// Steps from one state to the next.
    #[arg(long, default_value_t = 50)]
    every: u64,
    /// Goes on from the latest state in the folder.
    #[arg(long, requires = "state")]
    resume: bool,
}

/// The share of space that the boxes would fill.
const DENSITY: f64 = 0.2;

fn main() -> Result<()> {
    let job = Job::parse();
    if let Job::Chart { rows, svg } = &job {
        return draw(rows, svg);
    }
    let universe = start()?;
    let world = universe.world();
    let row = match &job {
        Job::Pairs { boxes, frames } => time_pairs(&world, *boxes, *frames),
        Job::Herd(run) => run_herd(&world, run),
        Job::Chart { .. } => Ok(Value::Null),
    };
    let row = row.unwrap_or_else(|error| {
        eprintln!("process {}: {error:#}", world.rank());
        // The others may wait for the one that fails, and would for ever.
        world.abort(1)
    });
    if world.rank() == 0 {
        println!("{row}");
    }
    Ok(())
}

/// A row with what each frame costs each process.
fn time_pairs(world: &SimpleCommunicator, boxes: usize, frames: usize) -> Result<Value> {
    let mut scene = DriftingBoxes::<3>::new(boxes, DENSITY, 7);
    let body = |scene: &DriftingBoxes<3>, number: u64| {
        let mins = scene.mins()[number as usize];
        let aabb = Aabb::new(mins, mins.map(|x| x + DriftingBoxes::<3>::SIZE));
        let rest = ();
        Body { number, aabb, rest }
    };
    let share = (world.rank() as u64..boxes as u64).step_by(world.size() as usize);
    let mut domains = Domains::new(world, share.map(|number| body(&scene, number)).collect());
    let mut costs = Vec::new();
    for _ in 0..frames {
        world.barrier();
        domains.find_pairs()?;
        costs.push(gather(world, vec![domains.stats])?);
        scene.advance();
        for own in &mut domains.bodies {
            *own = body(&scene, own.number);
        }
    }
    Ok(json!({
        "boxes": boxes, "density": DENSITY, "processes": world.size(), "threads": rayon::current_num_threads(),
        "pairs": sum(world, domains.reported().count() as u64), "frames": costs,
    }))
}

fn run_herd(world: &SimpleCommunicator, job: &Run) -> Result<Value> {
    let mut herd = match &job.state {
        Some(folder) if job.resume => state::read(world, folder)?,
        _ => Herd::at_start(world, job.animals),
    };
    let (first, began) = (herd.step, Instant::now());
    let (mut migrated, mut bisections) = (0, 0);
    while herd.step < job.steps {
        herd.advance()?;
        // Where regions are cut, most animals move house; what counts is how many run from one region into another.
        match herd.domains.stats.bisected {
            true => bisections += 1,
            false => migrated += herd.domains.stats.migrated as u64,
        }
        let is_due = herd.step == job.steps || herd.step.checked_rem(job.every) == Some(0);
        if let Some(folder) = job.state.as_ref().filter(|_| is_due) {
            state::write(world, &herd, folder)?;
        }
    }
    Ok(json!({
        "what": "herd", "processes": world.size(), "animals": herd.count, "first": first, "step": herd.step,
        "hash": format!("{:016x}", herd.hash()), "migrated": sum(world, migrated), "bisections": bisections,
        "ms_a_step": 1e3 * began.elapsed().as_secs_f64() / (herd.step - first).max(1) as f64,
    }))
}

/// Draws a line for the frames on each network, and one for the part of them that the network takes.
fn draw(rows: &Path, svg: &Path) -> Result<()> {
    let text = std::fs::read_to_string(rows).context("cannot read the rows")?;
    let rows = serde_json::Deserializer::from_str(&text).into_iter();
    let rows: Vec<Value> = rows.collect::<Result<_, _>>()?;
    let model = || rows.iter().filter(|row| row["what"] == "model");
    let mut networks: Vec<_> = model().filter_map(|row| row["network"].as_str()).collect();
    networks.dedup();
    let colors = color::OURS.into_iter().chain(color::OTHERS).cycle();
    let lines = [("frame_ms", ""), ("network_ms", ": of it the network")];
    let lines = networks.iter().flat_map(|&of| lines.map(|line| (of, line)));
    let series = lines.zip(colors).map(|((network, (field, part)), color)| {
        let of = model().filter(|row| row["network"] == network);
        let point = |row: &Value| Some((row["processes"].as_f64()?, row[field].as_f64()?));
        Series::new(format!("{network}{part}"), color, of.filter_map(point))
    });
    let [x, y] = ["processes", "milliseconds"].map(Axis::log);
    let panel = Panel::new("", x, y, series);
    Chart::new("A frame of 10⁹ boxes in 3D, by the model", [panel]).write_svg(svg)
}
