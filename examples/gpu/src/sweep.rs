//! The sweep on a GPU.

use unisize::{Aabb, InvalidInput, InvalidInputReason};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    BindGroup, Buffer, BufferUsages, CommandEncoder, ComputePassDescriptor,
    ComputePassTimestampWrites, Device, QuerySet, Queue,
};

use crate::buffers::{self, Capacity, SCANNED, STATE_WORDS, cell_capacity};
use crate::error::{GpuError, check};
use crate::gpu::{read, upload};
use crate::kernels::{Groups, KERNELS, PASSES, Pipelines};

/// Words of the parameters. The first state and the first size of the dispatch of long entries follow.
const PARAMS: usize = 8;

/// Groups along the first dimension of a dispatch that needs a second one, as in the shaders.
const WIDTH: u32 = 32_768;

/// Finds the overlapping pairs of boxes in a buffer, in `D` = 2 or 3 dimensions.
///
/// A box is `2 D` numbers of type `f32`: its `mins`, then its `maxs`, without padding. Boxes are closed on every side, and their sides may
/// be infinite.
///
/// ```no_run
/// # use unisize_gpu::{Capacity, Gpu, GpuError, GpuSweep};
/// # fn frame(boxes: &wgpu::Buffer, count: u32) -> Result<(), GpuError> {
/// let Gpu { device, queue, .. } = Gpu::new(None)?;
/// let mut sweep = GpuSweep::<3>::new(&device, Capacity { boxes: 1 << 20, pairs: 1 << 22 })?;
/// // In every frame, without waiting:
/// let mut encoder = device.create_command_encoder(&Default::default());
/// sweep.record(&mut encoder, boxes, count)?;
/// // ... and passes that use `sweep.pairs()` and `sweep.count()`.
/// queue.submit([encoder.finish()]);
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct GpuSweep<const D: usize> {
    device: Device,
    pipelines: Pipelines<D>,
    capacity: Capacity,
    buffers: Vec<Buffer>,
    bound: Option<Bound>,
    keeps_grids: bool,
    /// Whether there are grids to keep.
    has_grids: bool,
    times: Option<QuerySet>,
}

/// The bind groups for one buffer of boxes and one number of them.
#[derive(Debug)]
struct Bound {
    boxes: Buffer,
    count: u32,
    keeps_grids: bool,
    params: Buffer,
    groups: [BindGroup; KERNELS.len()],
}

impl<const D: usize> GpuSweep<D> {
    /// A sweep with memory for so many boxes and pairs.
    ///
    /// # Errors
    /// [`GpuError::TooMany`] if a buffer would be too large for the device, or for more than 2²³ boxes.
    pub fn new(device: &Device, capacity: Capacity) -> Result<Self, GpuError> {
        const { assert!(D == 2 || D == 3, "boxes have two or three axes") };
        let capacity = Capacity {
            boxes: capacity.boxes.max(1),
            pairs: capacity.pairs.max(1),
        };
        Ok(Self {
            device: device.clone(),
            capacity,
            buffers: buffers::allocate::<D>(device, capacity)?,
            pipelines: Pipelines::new(device),
            bound: None,
            keeps_grids: false,
            has_grids: false,
            times: None,
        })
    }

    /// How many boxes and pairs there is memory for.
    pub fn capacity(&self) -> Capacity {
        self.capacity
    }

    /// Whether to keep the grids that the last frame has chosen, which is faster. The pairs are exact on any grids; if boxes have become much
    /// larger or have left their places, finding them takes longer.
    pub fn keep_grids(&mut self, keeps: bool) {
        self.keeps_grids = keeps;
    }

    /// The names of the passes of a frame.
    pub fn passes() -> [&'static str; PASSES.len()] {
        PASSES.map(|kernel| KERNELS[kernel].0)
    }

    /// Writes a timestamp before and after each of the [`passes`](Self::passes) of the next frames, from the first of the set on.
    pub fn set_times(&mut self, times: Option<QuerySet>) {
        self.times = times;
    }

    /// Records the passes that find the pairs of the first `count` boxes of a buffer. It waits for nothing. The buffer needs the usage
    /// `STORAGE`.
    ///
    /// **O(n + pairs)** time where boxes lie no denser than so many deep, and have at most four ranges of sizes.
    ///
    /// # Errors
    /// [`GpuError::TooMany`] boxes.
    pub fn record(
        &mut self,
        encoder: &mut CommandEncoder,
        boxes: &Buffer,
        count: u32,
    ) -> Result<(), GpuError> {
        check("boxes", count.into(), self.capacity.boxes.into())?;
        let keeps_grids = self.keeps_grids && self.has_grids;
        let is_for = |bound: &Bound| {
            (&bound.boxes, bound.count, bound.keeps_grids) == (boxes, count, keeps_grids)
        };
        let bound = match self.bound.take().filter(is_for) {
            Some(bound) => bound,
            None => self.bind(boxes, count, keeps_grids),
        };
        encoder.clear_buffer(self.buffer(buffers::COUNTS), 0, None);
        let mut from = 4 * PARAMS as u64;
        for to in [buffers::STATE, buffers::LONG_GROUPS] {
            let to = self.buffer(to);
            encoder.copy_buffer_to_buffer(&bound.params, from, to, 0, to.size());
            from += to.size();
        }
        let cells = cell_capacity(self.capacity.boxes) + 1;
        for (i, kernel) in (0..).zip(PASSES) {
            let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor {
                label: Some(KERNELS[kernel].0),
                timestamp_writes: self
                    .times
                    .as_ref()
                    .map(|query_set| ComputePassTimestampWrites {
                        query_set,
                        beginning_of_pass_write_index: Some(2 * i),
                        end_of_pass_write_index: Some(2 * i + 1),
                    }),
            });
            pass.set_pipeline(&self.pipelines.0[kernel]);
            pass.set_bind_group(0, &bound.groups[kernel], &[]);
            let groups = match KERNELS[kernel].2 {
                Groups::One => 1,
                Groups::Boxes(each) => count.div_ceil(each),
                Groups::Cells => cells.div_ceil(SCANNED),
                Groups::Indirect => {
                    pass.dispatch_workgroups_indirect(self.buffer(buffers::LONG_GROUPS), 0);
                    continue;
                }
            };
            pass.dispatch_workgroups(groups.min(WIDTH), groups.div_ceil(WIDTH), 1);
        }
        self.bound = Some(bound);
        self.has_grids = true;
        Ok(())
    }

    fn bind(&self, boxes: &Buffer, count: u32, keeps_grids: bool) -> Bound {
        let (most, most_pairs) = (self.capacity.boxes, self.capacity.pairs);
        let shares = (most >> 18).max(1);
        let cells = cell_capacity(most);
        let mut words = vec![count, most, most_pairs, cells, keeps_grids.into(), shares];
        words.resize(PARAMS, 0);
        let mut state = [0; STATE_WORDS];
        // The words `INVALID` and `LEFT` of the shader.
        (state[1], state[8]) = (u32::MAX, count);
        words.extend(state);
        words.extend([0, 1, shares]);
        let params = self.device.create_buffer_init(&BufferInitDescriptor {
            label: Some("params"),
            contents: bytemuck::cast_slice(&words),
            usage: BufferUsages::UNIFORM | BufferUsages::COPY_SRC,
        });
        let groups = self.pipelines.bind(&self.device, |binding| match binding {
            0 => &params,
            1 => boxes,
            _ => self.buffer(binding as usize),
        });
        Bound {
            boxes: boxes.clone(),
            count,
            keeps_grids,
            params,
            groups,
        }
    }

    fn buffer(&self, binding: usize) -> &Buffer {
        &self.buffers[binding - buffers::FIRST]
    }

    /// The pairs of the last frame, two `u32` each, the smaller index first. Usages: `STORAGE`, `COPY_SRC` and `INDIRECT`.
    pub fn pairs(&self) -> &Buffer {
        self.buffer(buffers::PAIRS)
    }

    /// Seven `u32`: groups of 64 pairs for an indirect dispatch (three words; the first is at most 32,768), how many pairs
    /// [`pairs`](Self::pairs) holds, how many were found (low and high word), and the index of the first invalid box, or `u32::MAX`.
    ///
    /// **If more pairs were found than it holds, it holds only some of them.** If a box is invalid, it holds none.
    pub fn count(&self) -> &Buffer {
        self.buffer(buffers::COUNTED)
    }

    /// Replaces `pairs` by every overlapping pair of the boxes, each once, smaller index first, in no particular order. It uploads the boxes
    /// and waits for the answer. If there are more boxes or pairs than before, it takes more memory, and runs again.
    ///
    /// # Errors
    /// [`GpuError::Invalid`] names the first box with a NaN or `mins > maxs`; `pairs` is then empty, as after every error.
    pub fn find_pairs(
        &mut self,
        device: &Device,
        queue: &Queue,
        boxes: &[Aabb<f32, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), GpuError> {
        pairs.clear();
        let count = u32::try_from(boxes.len()).unwrap_or(u32::MAX);
        self.grow(count, 0)?;
        let sides = boxes.iter().flat_map(|b| [b.mins, b.maxs]).flatten();
        // A binding of no bytes is not allowed.
        let sides: Vec<f32> = sides.chain([0.0; 6]).collect();
        let uploaded = upload(device, &sides);
        loop {
            let mut encoder = device.create_command_encoder(&Default::default());
            self.record(&mut encoder, &uploaded, count)?;
            queue.submit([encoder.finish()]);
            let words = read(device, queue, self.count(), 7)?;
            let [_, _, _, held, low, high, invalid] = words[..] else {
                return Err(GpuError::Device("the counts are incomplete".to_owned()));
            };
            if let Some(bad) = boxes.get(invalid as usize) {
                return Err(why_invalid(invalid as usize, bad).into());
            }
            if high == 0 && held == low {
                let words = read(device, queue, self.pairs(), 2 * u64::from(held))?;
                pairs.extend(words.chunks_exact(2).map(|pair| [pair[0], pair[1]]));
                return Ok(());
            }
            self.grow(count, if high > 0 { u32::MAX } else { low })?;
        }
    }

    /// Takes memory for so many boxes and pairs at least.
    fn grow(&mut self, boxes: u32, pairs: u32) -> Result<(), GpuError> {
        let capacity = Capacity {
            boxes: self.capacity.boxes.max(boxes),
            pairs: self.capacity.pairs.max(pairs),
        };
        if capacity != self.capacity {
            self.buffers = buffers::allocate::<D>(&self.device, capacity)?;
            self.capacity = capacity;
            (self.bound, self.has_grids) = (None, false);
        }
        Ok(())
    }
}

/// What is wrong with a box that a shader has refused.
fn why_invalid<const D: usize>(index: usize, bad: &Aabb<f32, D>) -> InvalidInput {
    let is_fine = |axis: &usize| bad.mins[*axis] <= bad.maxs[*axis];
    let axis = (0..D).find(|axis| !is_fine(axis)).unwrap_or(0);
    let reason = match bad.mins[axis].partial_cmp(&bad.maxs[axis]) {
        Some(_) => InvalidInputReason::Inverted { axis },
        None => InvalidInputReason::NotANumber { axis },
    };
    InvalidInput::new(index, reason)
}
