//! A million boxes that a shader moves, and whose overlapping pairs are counted in every frame, without a copy to the processor:
//!
//! ```text
//! cargo run --release --manifest-path examples/gpu/Cargo.toml --example frames
//! ```
//!
//! Prints how long the GPU takes for each frame, and how long a tree on the GPU and `GridSweep` on all threads take for the same boxes.
//! Fails if they find other pairs. Where a processor does the work of a GPU, there are fewer boxes.
//!
//! With `-- --sizes LEAST MOST` it measures 2^LEAST to 2^MOST boxes; with `-- --adapter` it only names the adapter. Passes are measured by
//! timestamps; where the adapter has none, only the whole frame is. `RAYON_NUM_THREADS` limits the threads.

use std::error::Error;
use std::time::Instant;

use unisize::{Aabb, GridSweep, PairFinder};
use unisize_gpu::{Capacity, Gpu, GpuSweep, bind, pipelines, read, upload};
use unisize_scenes::DriftingBoxes;
use wgpu::{BindGroup, Buffer, BufferUsages, ComputePipeline, DeviceType, Features};

mod lbvh;

use lbvh::{Lbvh, sorted};

const FRAMES: usize = 9;

const COMPARED: &str = "tree of an LBVH, its search; upload, download, GridSweep";

/// Moves each side of each box, and turns around what would leave the square or cube.
const ADVANCE: &str = "
@group(0) @binding(0) var<storage, read_write> boxes: array<f32>;
@group(0) @binding(1) var<storage, read_write> velocities: array<f32>;

@compute @workgroup_size(256)
fn advance(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) t: u32) {
  let i = (group.y * 32768u + group.x) * 256u + t;
  if i >= BOXES { return; }
  for (var k = 0u; k < AXES; k++) {
    let x = boxes[2u * AXES * i + k] + velocities[AXES * i + k];
    if x < 0.0 || x > REACH {
      velocities[AXES * i + k] *= -1.0;
    } else {
      boxes[2u * AXES * i + k] = x;
      boxes[2u * AXES * i + AXES + k] = x + 1.0;
    }
  }
}";

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::new(None)?;
    let info = gpu.adapter.get_info();
    println!("{} ({:?})", info.name, info.backend);
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let arguments: Vec<_> = arguments.iter().map(String::as_str).collect();
    match arguments[..] {
        [] => {
            let is_software = info.device_type == DeviceType::Cpu;
            let power = if is_software { 17 } else { 20 };
            println!("{} boxes", 1 << power);
            frames::<3>(&gpu, power, 0.1, None)
        }
        ["--adapter"] => Ok(()),
        ["--sizes", least, most] => {
            let passes = GpuSweep::<2>::passes().join(", ");
            println!("medians, ms: all passes; {passes}; {COMPARED}");
            for power in least.parse()?..=most.parse::<u32>()?.min(23) {
                for keeps_grids in [false, true].map(Some) {
                    frames::<2>(&gpu, power, 0.2, keeps_grids)?;
                    frames::<2>(&gpu, power, 0.8, keeps_grids)?;
                    frames::<3>(&gpu, power, 0.1, keeps_grids)?;
                    frames::<3>(&gpu, power, 0.4, keeps_grids)?;
                }
            }
            Ok(())
        }
        _ => Err("usage: frames [--adapter | --sizes LEAST MOST]".into()),
    }
}

/// Moves 2^`power` boxes for some frames. Prints each of them; or one row of a table, with or without kept grids.
fn frames<const D: usize>(
    gpu: &Gpu,
    power: u32,
    density: f64,
    keeps_grids: Option<bool>,
) -> Result<(), Box<dyn Error>> {
    let Gpu { device, queue, .. } = gpu;
    let count = 1_u32 << power;
    let (advance, group, boxes) = boxes_that_move::<D>(gpu, count, density);
    let [most, words] = [3 * count, 2 * D as u32 * count];
    let capacity = Capacity {
        boxes: count,
        pairs: most,
    };
    let mut sweep = GpuSweep::<D>::new(device, capacity)?;
    sweep.keep_grids(keeps_grids == Some(true));
    let passes = GpuSweep::<D>::passes().len();
    let stamps = 2 * passes as u32 + 4;
    let has_times = device.features().contains(Features::TIMESTAMP_QUERY);
    let times = has_times.then(|| {
        device.create_query_set(&wgpu::QuerySetDescriptor {
            label: None,
            ty: wgpu::QueryType::Timestamp,
            count: stamps,
        })
    });
    sweep.set_times(times.clone());
    let resolved = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 8 * u64::from(stamps),
        usage: BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });
    let lbvh = Lbvh::new::<D>(device, &Lbvh::pipelines::<D>(device), &boxes, count, most);
    let mut on_processor = GridSweep::default();
    let mut pairs = Vec::new();
    let mut rows = Vec::new();
    for frame in 0..FRAMES {
        let clock = Instant::now();
        let mut encoder = device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&advance);
        pass.set_bind_group(0, &group, &[]);
        let groups = count.div_ceil(256);
        pass.dispatch_workgroups(groups.min(32_768), groups.div_ceil(32_768), 1);
        drop(pass);
        sweep.record(&mut encoder, &boxes, count)?;
        queue.submit([encoder.finish()]);
        // A simulation would go on with shaders that use `sweep.pairs()`. This program only looks how many there are.
        let found = read(device, queue, sweep.count(), 7)?[4];
        let mut row = vec![1e3 * clock.elapsed().as_secs_f64()];

        let mut encoder = device.create_command_encoder(&Default::default());
        lbvh.record(&mut encoder, times.as_ref().zip(Some(stamps - 4)));
        if let Some(times) = &times {
            encoder.resolve_query_set(times, 0..stamps, &resolved, 0);
        }
        queue.submit([encoder.finish()]);
        let in_tree = u64::from(read(device, queue, &lbvh.state, 1)?[0].min(most));
        let by_lbvh = sorted(&read(device, queue, &lbvh.pairs, 2 * in_tree)?);
        let halves = read(device, queue, &resolved, 2 * u64::from(stamps))?;
        let at = |i: usize| u64::from(halves[2 * i]) | u64::from(halves[2 * i + 1]) << 32;
        let tick = f64::from(queue.get_timestamp_period()) * 1e-6;
        let between = |from, to| at(to).saturating_sub(at(from)) as f64 * tick;
        if times.is_some() {
            row[0] = between(0, 2 * passes - 1);
        }
        row.extend((0..passes + 2).map(|i| between(2 * i, 2 * i + 1)));
        let sides = read(device, queue, &boxes, words.into())?;
        let clock = Instant::now();
        queue.write_buffer(&boxes, 0, bytemuck::cast_slice(&sides));
        queue.submit([]);
        read(device, queue, sweep.count(), 1)?;
        row.push(1e3 * clock.elapsed().as_secs_f64());
        let clock = Instant::now();
        let downloaded = read(device, queue, sweep.pairs(), 2 * u64::from(found.min(most)))?;
        row.push(1e3 * clock.elapsed().as_secs_f64());

        let at = |i: usize| std::array::from_fn(|k| f32::from_bits(sides[i + k]));
        let list = (0..sides.len()).step_by(2 * D);
        let list: Vec<Aabb<f32, D>> = list.map(|i| Aabb::new(at(i), at(i + D))).collect();
        let clock = Instant::now();
        on_processor.find_pairs(&list, &mut pairs)?;
        row.push(1e3 * clock.elapsed().as_secs_f64());
        pairs.sort_unstable();
        if [by_lbvh, sorted(&downloaded)]
            .iter()
            .any(|other| *other != pairs)
        {
            return Err(format!("{found} pairs are not the {} by GridSweep", pairs.len()).into());
        }
        if keeps_grids.is_none() {
            let [gpu, grid] = [row[0], row[row.len() - 1]];
            let tree = row[passes + 1] + row[passes + 2];
            println!(
                "{frame}: {found} pairs; GPU {gpu:.2} ms, LBVH {tree:.2}, GridSweep {grid:.2}"
            );
        }
        rows.push(row);
    }
    if let Some(keeps_grids) = keeps_grids {
        let grids = if keeps_grids { "kept" } else { "new" };
        print!(
            "{count} in {D}D at {density}, {grids} grids, {} pairs:",
            pairs.len()
        );
        for column in 0..rows[0].len() {
            rows.sort_by(|a, b| a[column].total_cmp(&b[column]));
            print!(" {:.3}", rows[FRAMES / 2][column]);
        }
        println!();
    }
    Ok(())
}

/// A shader that moves boxes, its buffers, and the boxes.
fn boxes_that_move<const D: usize>(
    gpu: &Gpu,
    count: u32,
    density: f64,
) -> (ComputePipeline, BindGroup, Buffer) {
    let device = &gpu.device;
    let mut drifting = DriftingBoxes::<D>::new(count as usize, density, 7);
    let start = drifting.mins().to_vec();
    drifting.advance();
    let velocities = drifting.mins().iter().flatten().zip(start.iter().flatten());
    let velocities: Vec<f32> = velocities.map(|(to, from)| to - from).collect();
    let sides = start.iter().flat_map(|&mins| [mins, mins.map(|x| x + 1.0)]);
    let boxes = upload(device, &sides.flatten().collect::<Vec<_>>());
    let velocities = upload(device, &velocities);
    let reach = (f64::from(count) / density).powf(1.0 / D as f64) - 1.0;
    let source = ADVANCE
        .replace("AXES", &format!("{D}u"))
        .replace("BOXES", &format!("{count}u"));
    let source = source.replace("REACH", &format!("{reach:.3}"));
    let [advance] = pipelines(device, &source, ["advance"]);
    let group = bind(device, &advance, [(0, &boxes), (1, &velocities)]);
    (advance, group, boxes)
}
