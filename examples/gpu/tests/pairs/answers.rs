//! A sweep on a device of default limits, and what it answers.

use unisize::Aabb;
use unisize_gpu::{Capacity, Gpu, GpuError, GpuSweep, read, upload};

/// A sweep with its device.
pub(crate) struct Tested<const D: usize> {
    pub(crate) gpu: Gpu,
    pub(crate) sweep: GpuSweep<D>,
}

impl<const D: usize> Tested<D> {
    pub(crate) fn new(boxes: u32, pairs: u32) -> Self {
        let gpu = Gpu::new(Some(wgpu::Limits::default()));
        let gpu = gpu.expect("an adapter (Debian: apt-get install mesa-vulkan-drivers)");
        let sweep = GpuSweep::new(&gpu.device, Capacity { boxes, pairs });
        let sweep = sweep.expect("there is memory for so little");
        Self { gpu, sweep }
    }

    /// The sorted pairs.
    pub(crate) fn pairs(&mut self, boxes: &[Aabb<f32, D>]) -> Vec<[u32; 2]> {
        self.try_pairs(boxes).expect("the boxes are valid")
    }

    pub(crate) fn try_pairs(&mut self, boxes: &[Aabb<f32, D>]) -> Result<Vec<[u32; 2]>, GpuError> {
        let Gpu { device, queue, .. } = &self.gpu;
        let mut pairs = vec![[7, 7]];
        let found = self.sweep.find_pairs(device, queue, boxes, &mut pairs);
        assert!(found.is_ok() || pairs.is_empty(), "pairs after an error");
        pairs.sort_unstable();
        found.map(|()| pairs)
    }

    /// The seven words of a frame of boxes in a buffer, and the pairs, sorted.
    pub(crate) fn record(&mut self, boxes: &[Aabb<f32, D>]) -> (Vec<u32>, Vec<[u32; 2]>) {
        let Gpu { device, queue, .. } = &self.gpu;
        let sides = boxes.iter().flat_map(|b| [b.mins, b.maxs]).flatten();
        let buffer = upload(device, &sides.collect::<Vec<f32>>());
        let mut encoder = device.create_command_encoder(&Default::default());
        let recorded = self.sweep.record(&mut encoder, &buffer, boxes.len() as u32);
        recorded.expect("so many boxes fit");
        queue.submit([encoder.finish()]);
        let read = |from, words| read(device, queue, from, words).expect("the device works");
        let words = read(self.sweep.count(), 7);
        let pairs = read(self.sweep.pairs(), 2 * u64::from(words[3]));
        let pairs = pairs.chunks_exact(2).map(|pair| [pair[0], pair[1]]);
        let mut pairs: Vec<_> = pairs.collect();
        pairs.sort_unstable();
        (words, pairs)
    }
}
