//! Boxes that drift in three dimensions, and their pairs in each frame, on the processes that mpirun has started: see README.md.
//!
//! Prints a row of JSON with the cost of each frame on each process. Fails if the number of pairs in the last frame is not that of one process.

use anyhow::{Result, ensure};
use clap::Parser;
use serde_json::json;
use unisize::{Aabb, GridSweep, PairFinder};
use unisize_mpi::{Body, Domains, World};

/// The share of space that the boxes would fill if they did not overlap.
const DENSITY: f64 = 0.2;

/// Finds the pairs of drifting boxes on many processes.
#[derive(Parser)]
struct Options {
    #[arg(long, default_value_t = 1 << 20)]
    boxes: usize,
    #[arg(long, default_value_t = 11)]
    frames: usize,
}

/// Cubes of side 1, the same on every process.
struct Scene {
    mins: Vec<[f32; 3]>,
    velocities: Vec<[f32; 3]>,
    /// The greatest lower corner.
    limit: f32,
}

impl Scene {
    fn new(boxes: usize) -> Self {
        let limit = (boxes as f64 / DENSITY).cbrt() as f32 - 1.0;
        let mut random = oorandom::Rand32::new(7);
        let mut vectors = |from: f32, to: f32| {
            let mut vector = || [(); 3].map(|()| from + (to - from) * random.rand_float());
            Vec::from_iter((0..boxes).map(|_| vector()))
        };
        Self {
            mins: vectors(0.0, limit),
            velocities: vectors(-0.1, 0.1),
            limit,
        }
    }

    /// Moves all boxes, which bounce off the borders.
    fn advance(&mut self) {
        for (mins, velocity) in self.mins.iter_mut().zip(&mut self.velocities) {
            for (x, v) in mins.iter_mut().zip(velocity) {
                *x += *v;
                if *x < 0.0 || *x > self.limit {
                    *x = x.clamp(0.0, self.limit);
                    *v = -*v;
                }
            }
        }
    }

    fn aabb(&self, number: usize) -> Aabb<f32, 3> {
        let mins = self.mins[number];
        Aabb::new(mins, mins.map(|x| x + 1.0))
    }
}

fn main() -> Result<()> {
    let Options { boxes, frames } = Options::parse();
    ensure!(boxes > 0 && frames > 0, "nothing to do");
    World::run(|world| {
        let mut scene = Scene::new(boxes);
        // Any share will do at first: the first search assigns each box to the process of its region.
        let share = (world.rank()..boxes).step_by(world.size());
        let share = share.map(|i| Body {
            number: i as u64,
            aabb: scene.aabb(i),
            payload: (),
        });
        let mut domains = Domains::new(world, share.collect());
        let mut costs = Vec::new();
        for _ in 0..frames {
            scene.advance();
            for own in &mut domains.bodies[..domains.own] {
                own.aabb = scene.aabb(own.number as usize);
            }
            world.barrier();
            domains.find_pairs()?;
            costs.push(world.gather(vec![domains.stats])?);
        }
        let pairs = world.each(domains.reported().count());
        let pairs: usize = pairs.iter().sum();
        if world.rank() == 0 {
            let row = json!({
                "boxes": boxes, "density": DENSITY, "processes": world.size(), "threads": rayon::current_num_threads(),
                "pairs": pairs, "frames": costs,
            });
            println!("{row}");
            let mut expected = Vec::new();
            let all: Vec<_> = (0..boxes).map(|i| scene.aabb(i)).collect();
            GridSweep::default().find_pairs(&all, &mut expected)?;
            let expected = expected.len();
            ensure!(pairs == expected, "one process finds {expected} pairs");
        }
        Ok(())
    })
}
