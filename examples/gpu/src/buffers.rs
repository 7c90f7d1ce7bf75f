//! The memory of a sweep.

use wgpu::{Buffer, BufferDescriptor, BufferUsages, Device};

use crate::error::{GpuError, check};
use crate::kernels::CLASSES;

/// How many boxes and pairs a sweep has memory for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacity {
    /// Boxes: 52 bytes each in 2D and 68 in 3D, besides the boxes themselves. At most 2²³.
    pub boxes: u32,
    /// Pairs: 8 bytes each.
    pub pairs: u32,
}

/// So many that no loop and no sum in a shader is too long.
const MAX_BOXES: u64 = 1 << 23;

/// Cells that a group scans.
pub(crate) const SCANNED: u32 = 2048;

/// Words of the shader's `state`.
pub(crate) const STATE_WORDS: usize = 16;

/// The binding of the first of them. Parameters and boxes are before it.
pub(crate) const FIRST: usize = 2;

/// The bindings of buffers that others use by name.
pub(crate) const STATE: usize = 3;
pub(crate) const COUNTS: usize = 4;
pub(crate) const PAIRS: usize = 11;
pub(crate) const LONG_GROUPS: usize = 13;
pub(crate) const COUNTED: usize = 17;

/// The cells of all classes together.
pub(crate) fn cell_capacity(boxes: u32) -> u32 {
    2 * boxes + SCANNED - 1
}

/// The buffers of all bindings from [`FIRST`] on.
pub(crate) fn allocate<const D: usize>(
    device: &Device,
    capacity: Capacity,
) -> Result<Vec<Buffer>, GpuError> {
    let limits = device.limits();
    let limit = limits.max_storage_buffer_binding_size;
    let limit = limit.min(limits.max_buffer_size);
    let (boxes, pairs) = (u64::from(capacity.boxes), u64::from(capacity.pairs));
    check("boxes", boxes, MAX_BOXES)?;
    check("bytes of boxes", 8 * D as u64 * boxes, limit)?;
    let cells = u64::from(cell_capacity(capacity.boxes)) + 1;
    let copied = BufferUsages::COPY_DST;
    let answer = BufferUsages::COPY_SRC | BufferUsages::INDIRECT;
    let none = BufferUsages::empty();
    let of_grids = (32 * CLASSES as u64 + 4, none);
    let of_entries = (if D == 2 { 4 } else { 8 } * boxes, none);
    // Words and usages by binding. A buffer of one word has two bindings, and becomes the other one below.
    let buffers = [
        of_grids,
        (STATE_WORDS as u64, copied),
        (cells, copied),
        (1, none),
        (2 * boxes, none),
        (2 * boxes, none),
        (cells.div_ceil(SCANNED.into()), none),
        of_entries,
        (boxes, none),
        (2 * pairs, answer),
        (boxes, none),
        (3, copied | BufferUsages::INDIRECT),
        (1, none),
        (1, none),
        (1, none),
        (7, answer),
    ];
    let mut all = Vec::new();
    for (words, usage) in buffers {
        check("bytes of a buffer", 4 * words, limit)?;
        all.push(device.create_buffer(&BufferDescriptor {
            label: Some("unisize"),
            size: 4 * words,
            usage: BufferUsages::STORAGE | usage,
            mapped_at_creation: false,
        }));
    }
    for (copy, of) in [(5, COUNTS), (14, 2), (15, 9), (16, 10)] {
        all[copy - FIRST] = all[of - FIRST].clone();
    }
    Ok(all)
}
