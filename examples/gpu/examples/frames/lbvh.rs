//! What to compare with: a tree of boxes on the GPU, made and searched anew in every frame, by the shaders in `lbvh.wgsl`.

use unisize_gpu::{bind, pipelines};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    BindGroup, Buffer, BufferUsages, CommandEncoder, ComputePassDescriptor,
    ComputePassTimestampWrites, ComputePipeline, Device, QuerySet,
};

/// The kernels, with the bindings that they use.
const KERNELS: [(&str, &[u32]); 8] = [
    ("extent", &[0, 1, 2]),
    ("encode", &[0, 1, 2, 4]),
    ("count", &[0, 3, 5]),
    ("scan", &[0, 5]),
    ("scatter", &[0, 3, 4, 5]),
    ("link", &[0, 3, 6, 8]),
    ("bound", &[0, 1, 3, 6, 8]),
    ("find", &[0, 2, 3, 7, 8, 9]),
];

const NODE: &str = "
struct Node { left_mins: U, left_maxs: U, right_mins: U, right_maxs: U, links: vec4<u32> }
";
const IN_2D: &str = "
const D = 2u;
alias U = vec2<u32>;
fn node(i: u32) -> Node {
  let left = tree[3u * i];
  let right = tree[3u * i + 1u];
  return Node(left.xy, left.zw, right.xy, right.zw, tree[3u * i + 2u]);
}";
const IN_3D: &str = "
const D = 3u;
alias U = vec3<u32>;
fn node(i: u32) -> Node {
  let a = tree[4u * i];
  let b = tree[4u * i + 1u];
  let c = tree[4u * i + 2u];
  return Node(a.xyz, U(a.w, b.xy), U(b.zw, c.x), c.yzw, tree[4u * i + 3u]);
}";

/// Pairs as they lie in a buffer, in order.
pub(crate) fn sorted(words: &[u32]) -> Vec<[u32; 2]> {
    let mut pairs: Vec<_> = words
        .chunks_exact(2)
        .map(|pair| [pair[0], pair[1]])
        .collect();
    pairs.sort_unstable();
    pairs
}

/// Finds the pairs of the boxes in one buffer, at most 2²³, none of them invalid.
pub(crate) struct Lbvh {
    /// The number of pairs, and what else starts at zero.
    pub(crate) state: Buffer,
    /// The pairs, as far as they fit.
    pub(crate) pairs: Buffer,
    nodes: Buffer,
    steps: Vec<(ComputePipeline, BindGroup, u32)>,
}

impl Lbvh {
    pub(crate) fn pipelines<const D: usize>(device: &Device) -> [ComputePipeline; KERNELS.len()] {
        let dimension = if D == 2 { IN_2D } else { IN_3D };
        let source = [dimension, NODE, include_str!("lbvh.wgsl")].concat();
        pipelines(device, &source, KERNELS.map(|(name, _)| name))
    }

    pub(crate) fn new<const D: usize>(
        device: &Device,
        pipelines: &[ComputePipeline; KERNELS.len()],
        boxes: &Buffer,
        count: u32,
        pairs: u32,
    ) -> Self {
        let buffer = |words: u32| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size: 4 * u64::from(words),
                usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        };
        let blocks = count.div_ceil(2048);
        let (state, found, nodes) = (
            buffer(7),
            buffer(2 * pairs),
            buffer((4 * D as u32 + 4) * count),
        );
        let items = [buffer(2 * count), buffer(2 * count)];
        let (counts, parents) = (buffer(256 * (blocks + 1)), buffer(2 * count));
        let step = |kernel: usize, pass: usize, groups: u32| {
            let params = device.create_buffer_init(&BufferInitDescriptor {
                label: None,
                contents: bytemuck::cast_slice(&[count, pairs, 8 * pass as u32, blocks]),
                usage: BufferUsages::UNIFORM,
            });
            let [from, to] = [&items[pass % 2], &items[(pass + 1) % 2]];
            let all = [
                &params, boxes, &state, from, to, &counts, &nodes, &nodes, &parents, &found,
            ];
            let used = KERNELS[kernel].1.iter().map(|&i| (i, all[i as usize]));
            let group = bind(device, &pipelines[kernel], used);
            (pipelines[kernel].clone(), group, groups)
        };
        let each = count.div_ceil(256);
        let mut steps = vec![step(0, 0, each.min(1024)), step(1, 1, each)];
        for pass in 0..4 {
            steps.extend([
                step(2, pass, blocks),
                step(3, pass, 256),
                step(4, pass, blocks),
            ]);
        }
        steps.extend([5, 6, 7].map(|kernel| step(kernel, 0, each)));
        Self {
            pairs: found,
            state,
            nodes,
            steps,
        }
    }

    /// Records a frame: a pass that makes the tree, and one that finds the pairs. Four timestamps, before and after each, go to a set from
    /// this place on.
    pub(crate) fn record(&self, encoder: &mut CommandEncoder, times: Option<(&QuerySet, u32)>) {
        encoder.clear_buffer(&self.state, 0, None);
        encoder.clear_buffer(&self.nodes, 0, None);
        let (tree, search) = self.steps.split_at(self.steps.len() - 1);
        for (i, steps) in (0..).zip([tree, search]) {
            let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor {
                label: None,
                timestamp_writes: times.map(|(query_set, first)| ComputePassTimestampWrites {
                    query_set,
                    beginning_of_pass_write_index: Some(first + 2 * i),
                    end_of_pass_write_index: Some(first + 2 * i + 1),
                }),
            });
            for (pipeline, group, groups) in steps {
                pass.set_pipeline(pipeline);
                pass.set_bind_group(0, group, &[]);
                pass.dispatch_workgroups(*groups, 1, 1);
            }
        }
    }
}
