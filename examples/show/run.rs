//! The main loop of an example.

use super::difference::difference;
use super::film::Film;
use super::options::Options;
use super::ours::UnisizeBroadPhase;
use super::progress::progress_bar;
use super::rivals::Rivals;
use super::scenes::Observed;
use super::{HeldPairs, Show};
use anyhow::Result;
use std::process::ExitCode;

/// The milliseconds in a legend are the mean of this many steps.
const MEAN_OF: usize = 30;

/// Reads the command line, simulates, and prints the time in the broad phase, its pairs, and the line of code that chooses it.
/// Exits with 1 if pairs differ, and with 2 on any other error.
pub(crate) fn run<S: Show>() -> ExitCode {
    let options = Options::read::<S>();
    match simulate::<S>(&options) {
        Ok(None) => ExitCode::SUCCESS,
        Ok(Some(difference)) => {
            eprintln!("DIFFERENCE: {difference}");
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

/// Simulates until the end or until pairs differ, and returns the difference.
fn simulate<S: Show>(options: &Options) -> Result<Option<String>> {
    let mut film = Film::new::<S>(options)?;
    let steps = options.steps::<S>();
    let mut show = S::build(options.bodies::<S>());
    let unisize = Observed::new(UnisizeBroadPhase::new());
    let mut broad_phase = if options.verify_pairs {
        Rivals::new(unisize.with_held(), options.broad_phase, true, S::CONTACTS)
    } else {
        Rivals::new(unisize, options.broad_phase, false, S::CONTACTS)
    };
    let elapsed = |rivals: &Rivals| rivals.elapsed(rivals.choice).unwrap_or_default();
    let bar = progress_bar(steps as u64);
    bar.set_message(S::NAME);
    // The time in the broad phase up to each step.
    let mut clock = vec![elapsed(&broad_phase)];
    for step in 1..=steps {
        show.prepare(step, &broad_phase);
        show.world().step(&mut broad_phase, &(), &());
        clock.push(elapsed(&broad_phase));
        if let Some(difference) = difference(&broad_phase) {
            return Ok(Some(format!("{}, step {step}: {difference}", S::NAME)));
        }
        if film.wants(step) {
            let since = step.saturating_sub(MEAN_OF);
            let recent = clock[step] - clock[since];
            let milliseconds = recent.as_secs_f64() * 1e3 / (step - since) as f64;
            film.add(&show, &broad_phase, milliseconds)?;
        }
        bar.inc(1);
    }
    film.finish()?;
    bar.finish_and_clear();
    println!(
        "{}: {} bodies, {steps} steps: {:.3} ms a step in the broad phase, {} pairs at the end{}; \
         the line that chooses it: {}",
        S::NAME,
        show.bodies(),
        elapsed(&broad_phase).as_secs_f64() * 1e3 / steps as f64,
        broad_phase.pairs().len(),
        if options.verify_pairs {
            ", the same as Rapier's at every step"
        } else {
            ""
        },
        options.broad_phase.line(),
    );
    Ok(None)
}
