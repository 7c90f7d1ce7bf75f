//! box_intersect_ze: the algorithm of CGAL's function, in Rust.
//!
//! Its boxes are half-open, so they are given the number after their upper bound: up to and excluding that one
//! is up to and including the bound. Its one setting is the cutoff, as with CGAL.

use super::contender::{Family, Kernel, Setting};
use super::frame::Frame;
use anyhow::Result;
use box_intersect_ze::boxes::BoxND;
use box_intersect_ze::set::BBoxSet;
use box_intersect_ze::{Rng, intersect_ze_custom};
use std::borrow::Cow;

/// box_intersect_ze with the best of some cutoffs; 1000 is its default.
pub(crate) fn family<const D: usize>() -> Family<D> {
    let settings = [
        setting::<50, D>(),
        setting::<200, D>(),
        setting::<1000, D>(),
        setting::<5000, D>(),
    ];
    Family::new("box_intersect_ze", settings)
}

fn setting<const CUTOFF: usize, const D: usize>() -> Setting<D> {
    Setting::new(format!("cutoff {CUTOFF}"), || {
        Ok(Streamed::<CUTOFF, D> {
            boxes: BBoxSet::new(),
            pairs: Vec::new(),
        })
    })
}

/// A generator as quick as can be, for the medians that it estimates.
struct Xorshift(u64);

impl Rng for Xorshift {
    fn rand_usize(&mut self, high: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        // The upper half times the range, shifted back: no division.
        (((self.0 >> 32) * high as u64) >> 32) as usize
    }
}

struct Streamed<const CUTOFF: usize, const D: usize> {
    boxes: BBoxSet<BoxND<f32, D>, u32>,
    pairs: Vec<(u32, u32)>,
}

impl<const CUTOFF: usize, const D: usize> Kernel<D> for Streamed<CUTOFF, D> {
    fn find_pairs(&mut self, frame: &Frame<D>) -> Result<()> {
        self.boxes.clear();
        for (index, &[mins, maxs]) in frame.corners.iter().enumerate() {
            let half_open = BoxND::new(mins, maxs.map(f32::next_up));
            self.boxes.push(index as u32, half_open);
        }
        self.boxes.sort();
        self.pairs.clear();
        let mut random = Xorshift(0x9e37_79b9_7f4a_7c15);
        intersect_ze_custom::<_, _, _, CUTOFF>(
            &self.boxes,
            &self.boxes,
            &mut self.pairs,
            &mut random,
        );
        Ok(())
    }

    fn pairs(&self) -> Cow<'_, [[u32; 2]]> {
        self.pairs.iter().map(|&(a, b)| [a, b]).collect()
    }
}
