//! CGAL's `box_self_intersection_d`: Zomorodian and Edelsbrunner's streamed segment trees, in C++.
//!
//! The boxes are closed, CGAL's default. Its one setting is the cutoff, the number of boxes below which it
//! scans instead of recursing.

// The one file that calls C++; what it relies on is in cpp/cgal.cpp.
#![allow(unsafe_code)]

use super::contender::{Family, Frame, Kernel, Setting};
use anyhow::{Context, Result, ensure};
use std::ptr::NonNull;

const DEFAULT_CUTOFF: usize = 10;

const CUTOFFS: [usize; 9] = [10, 50, 100, 200, 500, 1000, 2000, 5000, 10_000];

/// CGAL as it comes, and with the best of some cutoffs.
pub(crate) fn families<const D: usize>() -> Vec<Family<D>> {
    let setting = |cutoff| Setting::new(format!("cutoff {cutoff}"), move || Cgal::new(cutoff));
    vec![
        Family::new("CGAL, default cutoff", [setting(DEFAULT_CUTOFF)]),
        Family::new("CGAL, best cutoff", CUTOFFS.map(setting)),
    ]
}

/// The memory of the C++ side.
#[repr(C)]
struct Finder {
    _opaque: [u8; 0],
}

unsafe extern "C" {
    fn peers_cgal_new() -> *mut Finder;
    fn peers_cgal_delete(finder: *mut Finder);
    fn peers_cgal_find_pairs(
        finder: *mut Finder,
        dimension: usize,
        corners: *const f32,
        count: usize,
        cutoff: isize,
        pairs: *mut *const [u32; 2],
        pair_count: *mut usize,
    ) -> bool;
}

struct Cgal {
    finder: NonNull<Finder>,
    cutoff: usize,
    /// The list of the last call, in the memory of `finder`.
    pairs: *const [u32; 2],
    pair_count: usize,
}

impl Cgal {
    fn new(cutoff: usize) -> Result<Self> {
        // SAFETY: takes nothing, and returns a new finder or null.
        let finder = NonNull::new(unsafe { peers_cgal_new() });
        Ok(Self {
            finder: finder.context("no memory left for CGAL")?,
            cutoff,
            pairs: std::ptr::null(),
            pair_count: 0,
        })
    }
}

impl<const D: usize> Kernel<D> for Cgal {
    fn find_pairs(&mut self, frame: &Frame<D>) -> Result<()> {
        (self.pairs, self.pair_count) = (std::ptr::null(), 0);
        // SAFETY: the finder is this one's own; `corners` are that many times twice D numbers without gaps, as
        // nested arrays are; the two results outlive the call.
        let done = unsafe {
            peers_cgal_find_pairs(
                self.finder.as_ptr(),
                D,
                frame.corners.as_ptr().cast(),
                frame.corners.len(),
                self.cutoff as isize,
                &mut self.pairs,
                &mut self.pair_count,
            )
        };
        ensure!(done, "CGAL failed");
        Ok(())
    }

    fn pairs(&self) -> &[[u32; 2]] {
        if self.pair_count == 0 {
            // An empty list may have no memory at all.
            return &[];
        }
        // SAFETY: the list of the last call, which is valid until the next one; that one takes `&mut self`.
        // A pair is two 32-bit numbers on both sides.
        unsafe { std::slice::from_raw_parts(self.pairs, self.pair_count) }
    }
}

impl Drop for Cgal {
    fn drop(&mut self) {
        // SAFETY: made by `peers_cgal_new`, and deleted once.
        unsafe { peers_cgal_delete(self.finder.as_ptr()) }
    }
}
