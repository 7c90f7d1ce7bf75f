//! Pairs and herds on the processes that mpirun has started, and what they take: see the README.

use anyhow::Result;
use clap::{Args, Parser};
use serde_json::{Value, json};
use std::path::PathBuf;
use std::time::Instant;
use unisize::Aabb;
use unisize_mpi::{Body, Domains, Herd, World, state};
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
}

#[derive(Args)]
struct Run {
    #[arg(long, default_value_t = 1_000_000)]
    animals: usize,
    /// Steps since the start of the herd, after which the run ends.
    #[arg(long, default_value_t = 100)]
    steps: u64,
    /// A file for states, the latest only, on a disk that all processes share.
    #[arg(long)]
    state: Option<PathBuf>,
    /// Steps from one state to the next.
    #[arg(long, default_value = "50")]
    every: std::num::NonZero<u64>,
    /// Goes on from the state in the file.
    #[arg(long, requires = "state")]
    resume: bool,
}

fn main() -> Result<()> {
    let job = Job::parse();
    World::run(|world| {
        let row = match job {
            Job::Pairs { boxes, frames } => time_pairs(world, boxes, frames)?,
            Job::Herd(run) => run_herd(world, &run)?,
        };
        if world.rank() == 0 {
            println!("{row}");
        }
        Ok(())
    })
}

/// A row with what each frame costs each process.
fn time_pairs(world: &World, boxes: usize, frames: usize) -> Result<Value> {
    let density = 0.2;
    let mut scene = DriftingBoxes::<3>::new(boxes, density, 7);
    let cube = |&mins: &[f32; 3]| Aabb::new(mins, mins.map(|x| x + DriftingBoxes::<3>::SIZE));
    let bodies = (0..).zip(scene.mins()).map(|(number, mins)| {
        let (aabb, rest) = (cube(mins), ());
        Body { number, aabb, rest }
    });
    let share = bodies.skip(world.rank()).step_by(world.size());
    let mut domains = Domains::new(world, share.collect());
    let mut costs = Vec::new();
    for _ in 0..frames {
        world.barrier();
        domains.find_pairs()?;
        costs.push(world.gather(vec![domains.stats])?);
        scene.advance();
        for own in &mut domains.bodies {
            own.aabb = cube(&scene.mins()[own.number as usize]);
        }
    }
    Ok(json!({
        "boxes": boxes, "density": density, "processes": world.size(), "threads": rayon::current_num_threads(),
        "pairs": world.each(domains.reported().count()).iter().sum::<usize>(), "frames": costs,
    }))
}

/// A row with the hash of the herd at the end.
fn run_herd(world: &World, job: &Run) -> Result<Value> {
    let mut herd = match &job.state {
        Some(file) if job.resume => state::read(world, file)?,
        _ => Herd::at_start(world, job.animals),
    };
    let (began, mut migrated) = (Instant::now(), 0);
    while herd.step < job.steps {
        herd.advance()?;
        // Where regions are cut, most animals move house; what counts is how many run from one region into another.
        let stats = herd.domains.stats;
        migrated += if stats.bisected { 0 } else { stats.migrated };
        let is_due = herd.step == job.steps || herd.step % job.every == 0;
        if let Some(file) = job.state.as_ref().filter(|_| is_due) {
            state::write(&herd, file)?;
        }
    }
    Ok(json!({
        "what": "herd", "processes": world.size(), "animals": herd.count, "step": herd.step,
        "hash": format!("{:016x}", herd.hash()), "migrated": world.each(migrated).iter().sum::<usize>(),
        "seconds": began.elapsed().as_secs_f64(),
    }))
}
