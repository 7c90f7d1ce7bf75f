//! The compute shaders, and what each of them reads and writes.

use wgpu::{BindGroup, Buffer, ComputePipeline, Device};

use crate::gpu::{bind, pipelines};

/// How many groups of threads a kernel needs: one, one for so many boxes, one for the cells that a group scans, or as many as the kernel
/// before it has found work for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Groups {
    One,
    Boxes(u32),
    Cells,
    Indirect,
}

use Groups::{Boxes, Cells, Indirect, One};

/// A compute shader: its entry point, the bindings that it uses, and its groups.
pub(crate) type Kernel = (&'static str, &'static [u32], Groups);

/// All kernels.
pub(crate) const KERNELS: [Kernel; 8] = [
    ("choose", &[0, 1, 2, 3, 7], One),
    ("assign", &[0, 1, 2, 3, 4, 6, 7], Boxes(256)),
    ("sum_counts", &[2, 3, 4, 8], Cells),
    ("scan_counts", &[2, 4, 8], Cells),
    ("scatter", &[0, 1, 5, 6, 9, 10], Boxes(256)),
    ("find", &[0, 3, 5, 11, 12, 13, 14, 15, 16], Boxes(128)),
    ("find_long", &[0, 3, 5, 11, 12, 14, 15, 16], Indirect),
    ("finish", &[0, 3, 17], One),
];

/// Size classes, as in the shaders.
pub(crate) const CLASSES: usize = 4;

/// The kernels of one frame, by their places above: the first two for each class.
pub(crate) const PASSES: [usize; 2 * CLASSES + 6] = [0, 1, 0, 1, 0, 1, 0, 1, 2, 3, 4, 5, 6, 7];

/// The pipelines of all kernels in `D` dimensions.
#[derive(Debug)]
pub(crate) struct Pipelines<const D: usize>(pub(crate) [ComputePipeline; KERNELS.len()]);

impl<const D: usize> Pipelines<D> {
    pub(crate) fn new(device: &Device) -> Self {
        let dimension = match D {
            2 => include_str!("shaders/dim2.wgsl"),
            _ => include_str!("shaders/dim3.wgsl"),
        };
        let source = format!("{dimension}\n{}", include_str!("shaders/sweep.wgsl"));
        Self(pipelines(device, &source, KERNELS.map(|(name, ..)| name)))
    }

    /// The bind groups of all kernels on these buffers, which `buffer` returns by their binding.
    pub(crate) fn bind<'a>(
        &self,
        device: &Device,
        buffer: impl Fn(u32) -> &'a Buffer,
    ) -> [BindGroup; KERNELS.len()] {
        std::array::from_fn(|i| {
            // In three dimensions entries hold the numbers of their boxes themselves.
            let used = |binding: &u32| D == 2 || ![10, 16].contains(binding);
            let bindings = KERNELS[i].1.iter().copied().filter(used);
            bind(device, &self.0[i], bindings.map(|b| (b, buffer(b))))
        })
    }
}
