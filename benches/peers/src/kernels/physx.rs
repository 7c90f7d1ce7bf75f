//! PhysX's automatic box pruning, one of the broad phases of PhysX, on its own and in one thread.
//!
//! It is made to be kept, and reports only which pairs come and go, never all of them. So there are two: one
//! that is made anew for each frame, whose pairs are all new, as the other contenders' are; and one that is kept
//! and told that every box has moved. The second one's output is the changes alone; the set that they amount to
//! is put together outside of its time. Boxes in two dimensions are flat ones in three.

// The one file that calls PhysX.
#![allow(unsafe_code)]

use super::contender::{Family, Kernel, Setting};
use super::frame::Frame;
use anyhow::{Context, Result, ensure};
use physx_sys::{
    PxBounds3, PxBroadPhase, PxBroadPhase_release_mut, PxBroadPhase_update_mut_1,
    PxBroadPhaseDesc_new, PxBroadPhasePair, PxBroadPhaseResults_new, PxBroadPhaseType,
    PxBroadPhaseUpdateData_new, PxVec3, phys_PxCreateBroadPhase,
    phys_PxGetBroadPhaseDynamicFilterGroup, physx_create_foundation,
};
use std::borrow::Cow;
use std::collections::HashSet;
use std::ptr::NonNull;
use std::sync::OnceLock;

/// One made for each frame, and one that is kept.
pub(crate) fn families<const D: usize>() -> Vec<Family<D>> {
    let setting = |is_kept| Setting::new("", move || BoxPruning::new(is_kept));
    vec![
        Family::new("PhysX ABP, new", [setting(false)]),
        Family::new("PhysX ABP, changes only", [setting(true)]),
    ]
}

/// PhysX's allocator and the like, of which a program has one. It lives as long as the program.
fn is_founded() -> bool {
    static IS_FOUNDED: OnceLock<bool> = OnceLock::new();
    // SAFETY: takes nothing, and is called once, as it has to be.
    *IS_FOUNDED.get_or_init(|| !unsafe { physx_create_foundation() }.is_null())
}

struct BoxPruning {
    is_kept: bool,
    broad_phase: Option<NonNull<PxBroadPhase>>,
    bounds: Vec<PxBounds3>,
    groups: Vec<u32>,
    distances: Vec<f32>,
    indices: Vec<u32>,
    /// All pairs of the last frame, or all that have ever come and gone.
    created: Vec<[u32; 2]>,
    /// Those that have gone, with the number of those that had come by then.
    deleted: Vec<([u32; 2], usize)>,
}

impl BoxPruning {
    fn new(is_kept: bool) -> Result<Self> {
        ensure!(is_founded(), "PhysX's foundation could not be created");
        Ok(Self {
            is_kept,
            broad_phase: None,
            bounds: Vec::new(),
            groups: Vec::new(),
            distances: Vec::new(),
            indices: Vec::new(),
            created: Vec::new(),
            deleted: Vec::new(),
        })
    }

    fn release(&mut self) {
        if let Some(broad_phase) = self.broad_phase.take() {
            // SAFETY: created by `create`, and released once.
            unsafe { PxBroadPhase_release_mut(broad_phase.as_ptr()) }
        }
    }

    fn create() -> Result<NonNull<PxBroadPhase>> {
        // SAFETY: the foundation exists, and the description is read during the call.
        let broad_phase = unsafe {
            let description = PxBroadPhaseDesc_new(PxBroadPhaseType::Abp);
            phys_PxCreateBroadPhase(&description)
        };
        NonNull::new(broad_phase).context("PhysX's broad phase could not be created")
    }
}

impl<const D: usize> Kernel<D> for BoxPruning {
    fn find_pairs(&mut self, frame: &Frame<D>) -> Result<()> {
        let corner = |corner: &[f32; D]| PxVec3 {
            x: corner[0],
            y: corner[1],
            z: corner.get(2).copied().unwrap_or(0.0),
        };
        let bounds = |[mins, maxs]: &[[f32; D]; 2]| PxBounds3 {
            minimum: corner(mins),
            maximum: corner(maxs),
        };
        let count = frame.corners.len();
        self.bounds.clear();
        self.bounds.extend(frame.corners.iter().map(bounds));
        // PhysX may read four bytes beyond the last one.
        self.bounds.reserve(1);
        for index in self.indices.len() as u32..count as u32 {
            self.indices.push(index);
            // SAFETY: computes a number.
            self.groups
                .push(unsafe { phys_PxGetBroadPhaseDynamicFilterGroup(index) });
            self.distances.push(0.0);
        }

        if !self.is_kept {
            self.release();
            self.created.clear();
        }
        let (broad_phase, is_new) = match self.broad_phase {
            Some(broad_phase) => (broad_phase, false),
            None => (*self.broad_phase.insert(Self::create()?), true),
        };
        let (created, updated) = if is_new { (count, 0) } else { (0, count) };
        let indices = self.indices.as_ptr();
        // SAFETY: the broad phase lives; the arrays are as long as is said, and are read during the call, the
        // bounds not beyond their capacity.
        let results = unsafe {
            let data = PxBroadPhaseUpdateData_new(
                indices,
                created as u32,
                indices,
                updated as u32,
                indices,
                0,
                self.bounds.as_ptr(),
                self.groups.as_ptr(),
                self.distances.as_ptr(),
                count as u32,
            );
            let mut results = PxBroadPhaseResults_new();
            PxBroadPhase_update_mut_1(broad_phase.as_ptr(), &mut results, &data);
            results
        };
        // SAFETY: the lists are valid until the next call with this broad phase.
        let [found, lost] = unsafe {
            [
                pairs(results.mCreatedPairs, results.mNbCreatedPairs),
                pairs(results.mDeletedPairs, results.mNbDeletedPairs),
            ]
        };
        let before = self.created.len();
        self.deleted
            .extend(lost.iter().map(|pair| ([pair.mID0, pair.mID1], before)));
        self.created
            .extend(found.iter().map(|pair| [pair.mID0, pair.mID1]));
        Ok(())
    }

    fn pairs(&self) -> Cow<'_, [[u32; 2]]> {
        if !self.is_kept {
            return Cow::Borrowed(&self.created);
        }
        let ordered = |&[a, b]: &[u32; 2]| [a.min(b), a.max(b)];
        let mut held = HashSet::new();
        let mut created = self.created.iter();
        let mut taken = 0;
        for (pair, before) in &self.deleted {
            held.extend(created.by_ref().take(before - taken).map(ordered));
            taken = *before;
            held.remove(&ordered(pair));
        }
        held.extend(created.map(ordered));
        held.into_iter().collect()
    }
}

/// # Safety
/// There are that many pairs there, for as long as the slice is in use.
unsafe fn pairs<'a>(first: *const PxBroadPhasePair, count: u32) -> &'a [PxBroadPhasePair] {
    if count == 0 {
        // An empty list may be null.
        return &[];
    }
    // SAFETY: as the caller promises.
    unsafe { std::slice::from_raw_parts(first, count as usize) }
}

impl Drop for BoxPruning {
    fn drop(&mut self) {
        self.release();
    }
}
