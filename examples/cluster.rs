//! Squares that all fly through the centre of a plane, without an engine: the last experiment of Capannini and Larsson (section 5).
//!
//! ```text
//! cargo run --release --example cluster -- --bodies 100000 --steps 500
//! ```

#[path = "show/options.rs"]
mod options;

use clap::Parser;
use std::process::ExitCode;
use std::time::{Duration, Instant};
use unisize::{Aabb, BruteForce, GridSweep, InvalidInput, PairFinder};
use unisize_scenes::ConvergingBoxes;

fn main() -> Result<ExitCode, InvalidInput> {
    let options = options::Options::parse();
    let count = options.bodies.unwrap_or(10_000);
    let mut squares = ConvergingBoxes::new(count, 5);
    let mut kernel = GridSweep::default();
    let (mut pairs, mut others) = (Vec::new(), Vec::new());
    let (mut total, mut most) = (Duration::ZERO, 0);
    for step in 1..=options.steps {
        let square = |&mins: &[f32; 2]| Aabb::new(mins, mins.map(|x| x + 1.0));
        let boxes: Vec<_> = squares.mins().iter().map(square).collect();
        let start = Instant::now();
        kernel.find_pairs(&boxes, &mut pairs)?;
        total += start.elapsed();
        most = most.max(pairs.len());
        if options.verify_pairs {
            BruteForce.find_pairs(&boxes, &mut others)?;
            pairs.sort_unstable();
            others.sort_unstable();
            if pairs != others {
                eprintln!("step {step}: the pairs differ");
                return Ok(ExitCode::FAILURE);
            }
        }
        squares.advance();
    }
    let ms = total.as_secs_f64() * 1e3 / options.steps.max(1) as f64;
    println!(
        "cluster: {count} squares, at most {most} pairs in {} steps; {ms:.3} ms a step",
        options.steps
    );
    Ok(ExitCode::SUCCESS)
}
