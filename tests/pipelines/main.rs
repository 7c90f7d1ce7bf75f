//! Whole worlds stepped with ours and with Rapier's own broad phase, side by side.
//!
//! `Twins` steps two equal worlds and compares, after every step, what a user can
//! see: contacts, intersections, events, sleep and poses. In most worlds no body meets more than one other, so
//! that the order in which the solver gets the contacts cannot matter and everything must be the same to the
//! last bit. Where it does matter (`piles`) only the outcome is compared.

mod dim2;
mod dim2_f64;
mod dim3;
mod dim3_f64;
mod questions;
mod strategies;
