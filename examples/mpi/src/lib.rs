//! The overlapping pairs of boxes that are distributed over many processes, on MPI.
//!
//! Each process owns the bodies whose centres lie in its region. A recursive bisection of the centres makes the regions, so each process owns
//! about as many. In every frame [`Domains`] sends the bodies that have left their region to their new owners, copies those near a border to
//! the processes that need them, and finds the pairs of its own bodies and copies with a [`GridSweep`](unisize::GridSweep). One process
//! reports each pair, and knows so without asking the others.

mod bisection;
mod domains;
mod world;

pub use domains::{Body, Domains, Stats, sorted};
pub use world::{Sent, World};
