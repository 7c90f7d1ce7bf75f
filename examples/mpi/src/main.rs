//! Pairs and herds on the processes that mpirun has started, and what they take: see the README.

use anyhow::{Context, Result};
use clap::Parser;
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::time::Instant;
use unisize::Aabb;
use unisize_charts::{Axis, Chart, Panel, Series, color};
use unisize_mpi::{Body, Domains, Herd, greatest, state, sum};
use unisize_scenes::DriftingBoxes;

/// Pairs of boxes on many processes. Rows of JSON go to the standard output.
#[derive(Parser)]
enum Job {
    /// Finds the pairs of boxes that drift in three dimensions, and takes the time.
    Pairs {
        #[arg(long, default_value_t = 1 << 20)]
        boxes: usize,
        /// So many boxes for each process: weak scaling.
        #[arg(long)]
        each: bool,
        /// Frames that are measured, after two that are not.
        #[arg(long, default_value_t = 9)]
        frames: usize,
    },
    /// Runs a herd, and tells a hash of where it ends.
    Herd {
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
    },
    /// Draws the rows of a model that `measure` has made.
    Chart { rows: PathBuf, svg: PathBuf },
}

/// The share of space that the boxes would fill.
const DENSITY: f64 = 0.2;

fn main() -> Result<()> {
    match Job::parse() {
        Job::Chart { rows, svg } => draw(&rows, &svg),
        job => {
            let universe = mpi::initialize().context("MPI does not start")?;
            let report = std::panic::take_hook();
            std::panic::set_hook(Box::new(move |panic| {
                report(panic);
                // mpirun ends the others when one leaves without a word to MPI, which unwinding would say.
                std::process::exit(101);
            }));
            let world = universe.world();
            // The others may wait for the one that fails, and would for ever.
            run(&world, job).or_else(|error| {
                eprintln!("process {}: {error:#}", world.rank());
                world.abort(1)
            })
        }
    }
}

fn run(world: &SimpleCommunicator, job: Job) -> Result<()> {
    let row = match job {
        Job::Pairs {
            boxes,
            each: true,
            frames,
        } => time_pairs(world, boxes * world.size() as usize, frames, "weak")?,
        Job::Pairs { boxes, frames, .. } => time_pairs(world, boxes, frames, "strong")?,
        Job::Herd {
            animals,
            steps,
            state,
            every,
            resume,
        } => {
            let herd = match &state {
                Some(folder) if resume => state::read(world, folder)?,
                _ => Herd::at_start(world, animals),
            };
            run_herd(
                world,
                herd,
                steps,
                state.as_deref().map(|folder| (folder, every)),
            )?
        }
        Job::Chart { .. } => Value::Null,
    };
    if world.rank() == 0 {
        println!("{row}");
    }
    Ok(())
}

fn time_pairs(
    world: &SimpleCommunicator,
    count: usize,
    frames: usize,
    scaling: &str,
) -> Result<Value> {
    let processes = world.size() as usize;
    let mut scene = DriftingBoxes::<3>::new(count, DENSITY, 7);
    let body = |scene: &DriftingBoxes<3>, number: usize| {
        let mins = scene.mins()[number];
        let aabb = Aabb::new(mins, mins.map(|x| x + DriftingBoxes::<3>::SIZE));
        Body {
            number: number as u64,
            aabb,
            rest: (),
        }
    };
    let share = (world.rank() as usize..count).step_by(processes);
    let mut domains = Domains::new(world, share.map(|number| body(&scene, number)).collect());
    let (mut times, mut counts) = ([const { Vec::new() }; 3], [0; 3]);
    for frame in 0..frames + 2 {
        world.barrier();
        let began = Instant::now();
        domains.find_pairs()?;
        let (took, stats) = (began.elapsed(), domains.stats());
        if frame >= 2 {
            for (times, time) in times.iter_mut().zip([took, stats.exchange, stats.sweep]) {
                times.push(greatest(world, 1e3 * time.as_secs_f64()));
            }
            let sent = [stats.bytes, stats.copies as u64, stats.migrated as u64];
            counts = std::array::from_fn(|i| counts[i] + sum(world, sent[i]));
        }
        scene.advance();
        for own in domains.own_mut() {
            *own = body(&scene, own.number as usize);
        }
    }
    let [frame, exchange, sweep] = times.map(|mut times| {
        times.sort_unstable_by(f64::total_cmp);
        times.get(frames / 2).copied()
    });
    let [bytes, copies, migrated] = counts.map(|all| all as f64 / (frames * count) as f64);
    let most = greatest(world, domains.own().len());
    Ok(json!({
        "what": "pairs", "scaling": scaling, "processes": processes, "threads": rayon::current_num_threads(), "density": DENSITY,
        "boxes": count, "pairs": sum(world, domains.reported().count() as u64), "frame_ms": frame, "exchange_ms": exchange,
        "sweep_ms": sweep, "bytes_a_box": bytes, "copies_a_box": copies, "migrated_a_box": migrated,
        "most_over_mean": (most * processes) as f64 / count as f64,
    }))
}

fn run_herd(
    world: &SimpleCommunicator,
    mut herd: Herd,
    steps: u64,
    states: Option<(&Path, u64)>,
) -> Result<Value> {
    let (first, began) = (herd.step, Instant::now());
    let (mut migrated, mut bisections) = (0, 0);
    while herd.step < steps {
        herd.advance()?;
        let stats = herd.domains.stats();
        migrated += stats.migrated as u64;
        bisections += u64::from(stats.bisected);
        match states {
            Some((folder, every))
                if herd.step == steps || herd.step.checked_rem(every) == Some(0) =>
            {
                state::write(world, &herd, folder)?;
            }
            _ => {}
        }
    }
    Ok(json!({
        "what": "herd", "processes": world.size(), "animals": herd.count, "first": first, "step": herd.step,
        "hash": format!("{:016x}", herd.hash()), "migrated": sum(world, migrated), "bisections": bisections,
        "ms_a_step": 1e3 * began.elapsed().as_secs_f64() / (herd.step - first).max(1) as f64,
    }))
}

fn draw(rows: &Path, svg: &Path) -> Result<()> {
    let rows =
        std::fs::read_to_string(rows).with_context(|| format!("cannot read {}", rows.display()))?;
    let rows: Vec<Value> = rows
        .lines()
        .map(serde_json::from_str)
        .collect::<Result<_, _>>()?;
    let lines = [
        ("InfiniBand", "frame_ms", "frame", color::RED),
        ("Ethernet", "frame_ms", "frame", color::BLUE),
        (
            "InfiniBand",
            "network_ms",
            "of it the network",
            color::SALMON,
        ),
        ("Ethernet", "network_ms", "of it the network", color::SKY),
        ("InfiniBand", "compute_ms", "of it computing", color::BLACK),
    ];
    let series = lines.map(|(network, field, name, color)| {
        let of = rows
            .iter()
            .filter(|row| row["what"] == "model" && row["network"] == network);
        let point = |row: &Value| Some((row["processes"].as_f64()?, row[field].as_f64()?));
        Series::new(format!("{name}, {network}"), color, of.filter_map(point))
    });
    let panel = Panel::new(
        "",
        Axis::log("processes"),
        Axis::log("milliseconds"),
        series,
    );
    Chart::new("A frame of 10⁹ boxes in 3D, by the model", [panel]).write_svg(svg)
}
