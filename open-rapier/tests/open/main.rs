//! The program from outside: projects with a small package in Rapier's place, which has the texts that the edits look for, and
//! nothing else; and one with Rapier itself.

mod bad;
mod fixture;
mod good;
mod rapier;

// The tables, from which the small package is made.
#[allow(dead_code)]
#[path = "../../src/seam.rs"]
mod seam;
