//! The overlapping pairs of boxes that are dealt to many processes, on MPI.
//!
//! Each process owns the bodies whose centres lie in its region. Regions come from a recursive [`Bisection`] of the centres, so each
//! owns about as many. In every frame [`Domains`] hands over bodies that have left their region, copies those near a border to the
//! processes that need them, and lets a [`GridSweep`](unisize::GridSweep) find the pairs of own bodies and copies. Each pair is reported
//! by one process, which knows so without asking. [`Herd`] is a simulation on top, and [`state`] keeps it on disk.

mod bisection;
mod domains;
mod exchange;
mod herd;
pub mod state;

pub use bisection::Bisection;
pub use domains::{Body, Domains, Stats, sorted};
pub use exchange::{exchange, gather, greatest, sum};
pub use herd::{Animal, Herd, hash};

use anyhow::Context;
use mpi::environment::Universe;

/// Starts MPI. If this process panics, mpirun ends the others: it leaves without a word to MPI, which unwinding would say.
///
/// # Errors
/// If MPI runs already.
pub fn start() -> anyhow::Result<Universe> {
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        report(panic);
        std::process::exit(101);
    }));
    mpi::initialize().context("MPI does not start")
}
