//! Tests of the whole program: on projects with a small package in place of Rapier, which has the texts that the edits look for and nothing
//! else; and on Rapier itself.

mod fixture;
mod rapier;
mod refusals;
mod use_cases;

// The tables of edits, from which the tests make the small package.
#[allow(dead_code)]
#[path = "../../src/seam.rs"]
mod seam;
