//! A brick wall in running bond: every other course starts and ends with half a brick. In space it is one brick thick.

use super::rapier::prelude::*;
use super::{Random, Stage, UP, cuboid, vector};

/// Half the height of a brick, and half its depth in space.
const HALF_HEIGHT: Real = 0.25;
const HALF_DEPTH: Real = 0.5;

/// The length of half a brick with its joint.
const UNIT: Real = 0.51;

/// The width of a joint, which stays open.
const JOINT: Real = 0.02;

/// How far a brick may be off its place along the wall.
const OFFSET: Real = 0.004;

/// How many times as many bricks are in a course as there are courses.
const ASPECT: usize = 6;

pub(super) fn build(bodies: usize, random: &mut Random) -> Stage {
    let columns = ((bodies.max(1) * ASPECT) as f64).sqrt().ceil() as usize;
    let half_width = columns as Real * UNIT;
    let mut stage = Stage::on_floor(half_width + 10.0);
    for index in 0..bodies {
        let (course, place) = place(index, columns);
        // Where the brick begins and ends, in halves of bricks.
        let (start, end) = match course % 2 {
            0 => (2 * place, 2 * place + 2),
            _ => ((2 * place).max(1) - 1, (2 * place + 1).min(2 * columns)),
        };
        let center = vector(|axis| match axis {
            0 => (start + end) as Real * UNIT / 2.0 - half_width + random.range(-OFFSET, OFFSET),
            UP => (2.0 * course as Real + 1.0) * HALF_HEIGHT,
            _ => 0.0,
        });
        let half = vector(|axis| match axis {
            0 => ((end - start) as Real * UNIT - JOINT) / 2.0,
            UP => HALF_HEIGHT,
            _ => HALF_DEPTH,
        });
        stage.insert(center, cuboid(half));
    }
    stage
}

/// The course of a brick, and its place in it. Courses have `columns` bricks and one more by turns.
fn place(index: usize, columns: usize) -> (usize, usize) {
    let (two_courses, place) = (index / (2 * columns + 1), index % (2 * columns + 1));
    match place.checked_sub(columns) {
        None => (2 * two_courses, place),
        Some(place) => (2 * two_courses + 1, place),
    }
}
