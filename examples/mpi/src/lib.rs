//! The overlapping pairs of boxes that are dealt to many processes, on MPI.
//!
//! Each process owns the bodies whose centres lie in its region. Regions come from a recursive bisection of the centres, so each owns
//! about as many. In every frame [`Domains`] hands over bodies that have left their region, copies those near a border to the processes
//! that need them, and lets a [`GridSweep`](unisize::GridSweep) find the pairs of own bodies and copies. Each pair is reported by one
//! process, which knows so without asking. [`Herd`] is a simulation on top, and [`state`] keeps it on disk.

mod bisection;
mod domains;
mod herd;
pub mod state;
mod world;

pub use domains::{Body, Domains, Stats, sorted};
pub use herd::{Animal, Herd};
pub use world::{Sent, World};
