//! A lower bound on the time to find pairs on this machine, and whether it could be lower.

use crate::kernels::unit_box;
use crate::options::Options;
use crate::report::Report;
use crate::{median, ns_each};
use std::hint::black_box;
use std::io;
use std::time::{Duration, Instant};
use unisize::Aabb;
use unisize_scenes::DriftingBoxes;

/// The width of a strip, in boxes.
const WIDTH: f32 = 12.0;

/// A box and its index.
type Entry<const D: usize> = (Aabb<f32, D>, u32);

fn nothing<const D: usize>() -> Entry<D> {
    (Aabb::new([0.0; D], [0.0; D]), 0)
}

/// The strip of a box along the second axis.
#[inline(always)]
fn strip<const D: usize>(aabb: &Aabb<f32, D>) -> usize {
    (aabb.mins[1] * (1.0 / WIDTH)) as usize
}

/// How many strips there are.
fn strips<const D: usize>(boxes: &[Aabb<f32, D>]) -> usize {
    boxes.iter().map(strip).max().map_or(0, |last| last + 1)
}

/// Replaces counts by where the first of each kind goes.
fn add_up(counts: &mut [u32]) {
    let mut end = 0;
    for count in counts {
        end += std::mem::replace(count, end);
    }
}

/// Memory kept from call to call.
#[derive(Default)]
pub(crate) struct Floor<const D: usize> {
    /// Where the next box of each strip goes.
    cursors: Vec<u32>,
    sorted: Vec<Entry<D>>,
    pairs: Vec<[u32; 2]>,
}

impl<const D: usize> Floor<D> {
    /// How long it takes to read the boxes, to move them to their strips along the second axis, and to write the pairs. How many
    /// strips there are is known beforehand.
    pub(crate) fn measure(&mut self, boxes: &[Aabb<f32, D>], pairs: &[[u32; 2]]) -> Duration {
        let strips = strips(boxes);
        self.sorted.resize(boxes.len(), nothing());
        let start = Instant::now();
        self.sort(boxes, strips);
        self.pairs.clear();
        self.pairs.extend_from_slice(pairs);
        black_box((&self.sorted, &self.pairs));
        start.elapsed()
    }

    fn sort(&mut self, boxes: &[Aabb<f32, D>], strips: usize) {
        let Self {
            cursors, sorted, ..
        } = self;
        count(boxes, strips, cursors);
        add_up(cursors);
        for (aabb, index) in boxes.iter().zip(0..) {
            *next(sorted, &mut cursors[strip(aabb)]) = (*aabb, index);
        }
    }
}

fn count<const D: usize>(boxes: &[Aabb<f32, D>], strips: usize, counts: &mut Vec<u32>) {
    counts.clear();
    counts.resize(strips, 0);
    for aabb in boxes {
        counts[strip(aabb)] += 1;
    }
}

/// The place of a cursor, which goes on to the next.
#[inline(always)]
fn next<'a, T>(places: &'a mut [T], cursor: &mut u32) -> &'a mut T {
    let place = &mut places[*cursor as usize];
    *cursor += 1;
    place
}

/// A way to sort squares into strips, or a part of one.
struct Way {
    name: &'static str,
    run: fn(&mut Scratch, &[Aabb<f32, 2>], usize),
}

/// Memory of all ways.
#[derive(Default)]
struct Scratch {
    floor: Floor<2>,
    cursors: Vec<u32>,
    coarse: Vec<u32>,
    homes: Vec<u32>,
    indices: Vec<u32>,
    narrow: Vec<([u16; 4], u32)>,
    halfway: Vec<Entry<2>>,
    lines: Vec<[Entry<2>; LINE]>,
    filled: Vec<u8>,
}

/// Entries that are collected before they are written to their strip.
const LINE: usize = 16;

/// Strips that are told apart on the first of two levels.
const COARSE: usize = 16;

const WAYS: [Way; 8] = [
    Way {
        name: "counted only",
        run: |scratch, boxes, strips| count(boxes, strips, &mut scratch.cursors),
    },
    Way {
        name: "boxes and indices, 20 bytes: the floor",
        run: |scratch, boxes, strips| scratch.floor.sort(boxes, strips),
    },
    Way {
        name: "the same, strips remembered from counting",
        run: |scratch, boxes, strips| {
            let Scratch { homes, floor, .. } = scratch;
            homes.clear();
            homes.extend(boxes.iter().map(|aabb| strip(aabb) as u32));
            floor.cursors.clear();
            floor.cursors.resize(strips, 0);
            for &home in &*homes {
                floor.cursors[home as usize] += 1;
            }
            add_up(&mut floor.cursors);
            for ((aabb, index), &home) in boxes.iter().zip(0..).zip(&*homes) {
                *next(&mut floor.sorted, &mut floor.cursors[home as usize]) = (*aabb, index);
            }
        },
    },
    Way {
        name: "the same, lines of 16 collected",
        run: |scratch, boxes, strips| {
            let Scratch {
                floor,
                lines,
                filled,
                ..
            } = scratch;
            let (cursors, sorted) = (&mut floor.cursors, &mut floor.sorted);
            count(boxes, strips, cursors);
            add_up(cursors);
            lines.resize(strips, [nothing(); LINE]);
            filled.clear();
            filled.resize(strips, 0);
            for (aabb, index) in boxes.iter().zip(0..) {
                let strip = strip(aabb);
                let (line, filled) = (&mut lines[strip], &mut filled[strip]);
                line[usize::from(*filled) % LINE] = (*aabb, index);
                *filled += 1;
                if usize::from(*filled) == LINE {
                    let start = cursors[strip] as usize;
                    sorted[start..start + LINE].copy_from_slice(line);
                    cursors[strip] += LINE as u32;
                    *filled = 0;
                }
            }
            for ((line, &filled), &cursor) in lines.iter().zip(&*filled).zip(&*cursors) {
                let (start, rest) = (cursor as usize, usize::from(filled));
                sorted[start..start + rest].copy_from_slice(&line[..rest]);
            }
        },
    },
    Way {
        name: "on two levels, the first of 16 strips",
        run: |scratch, boxes, strips| {
            let Scratch {
                floor,
                coarse,
                halfway,
                ..
            } = scratch;
            let (cursors, sorted) = (&mut floor.cursors, &mut floor.sorted);
            let each = strips.div_ceil(COARSE);
            count(boxes, strips, cursors);
            coarse.clear();
            coarse.extend(
                cursors
                    .chunks(each)
                    .map(|counts| counts.iter().sum::<u32>()),
            );
            add_up(coarse);
            add_up(cursors);
            halfway.resize(boxes.len(), nothing());
            for (aabb, index) in boxes.iter().zip(0..) {
                *next(halfway, &mut coarse[strip(aabb) / each]) = (*aabb, index);
            }
            for entry in &*halfway {
                *next(sorted, &mut cursors[strip(&entry.0)]) = *entry;
            }
        },
    },
    Way {
        name: "16 bits a coordinate, 12 bytes",
        run: |scratch, boxes, strips| {
            let Scratch {
                cursors, narrow, ..
            } = scratch;
            count(boxes, strips, cursors);
            add_up(cursors);
            narrow.resize(boxes.len(), ([0; 4], 0));
            let scale = f32::from(u16::MAX) / (strips as f32 * WIDTH + 1.0);
            let narrowed = |x: f32| (x * scale) as i32 as u16;
            for (aabb, index) in boxes.iter().zip(0..) {
                let Aabb { mins, maxs } = *aabb;
                let numbers = [mins[0], mins[1], maxs[0], maxs[1]].map(narrowed);
                *next(narrow, &mut cursors[strip(aabb)]) = (numbers, index);
            }
        },
    },
    Way {
        name: "indices, 4 bytes",
        run: |scratch, boxes, strips| {
            let Scratch {
                cursors, indices, ..
            } = scratch;
            count(boxes, strips, cursors);
            add_up(cursors);
            indices.resize(boxes.len(), 0);
            for (aabb, index) in boxes.iter().zip(0..) {
                *next(indices, &mut cursors[strip(aabb)]) = index;
            }
        },
    },
    Way {
        name: "the same, and boxes read in that order",
        run: |scratch, boxes, strips| {
            (WAYS[6].run)(scratch, boxes, strips);
            let Scratch { floor, indices, .. } = scratch;
            for (entry, &index) in floor.sorted.iter_mut().zip(&*indices) {
                *entry = (boxes[index as usize], index);
            }
        },
    },
];

/// Measures the ways on squares of the lower density.
pub(crate) fn measure(options: &Options, report: &mut Report) -> io::Result<()> {
    for count in options.least(&[1 << 14, 1 << 17, 1 << 20][..], &[1 << 12]) {
        let drifting = DriftingBoxes::<2>::new(*count, 0.2, 7);
        let boxes: Vec<_> = drifting.mins().iter().map(unit_box).collect();
        let times = time_ways(&boxes, options.least(41, 2));
        for (way, time) in WAYS.iter().zip(times) {
            report.row(&[
                ("threads", rayon::current_num_threads().into()),
                ("way", way.name.into()),
                ("count", (*count).into()),
                ("ns_a_box", ns_each(time, *count).into()),
            ])?;
        }
    }
    Ok(())
}

/// The medians of the ways, which take turns.
fn time_ways(boxes: &[Aabb<f32, 2>], rounds: usize) -> impl Iterator<Item = Duration> {
    let strips = strips(boxes);
    let mut scratch = Scratch::default();
    scratch.floor.sorted.resize(boxes.len(), nothing());
    let mut times = vec![Vec::new(); WAYS.len()];
    for _ in 0..rounds {
        for (way, times) in WAYS.iter().zip(&mut times) {
            let start = Instant::now();
            (way.run)(&mut scratch, boxes, strips);
            black_box(&scratch.floor.sorted);
            times.push(start.elapsed());
        }
    }
    times.into_iter().map(median)
}
