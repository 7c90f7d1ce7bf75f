//! A device for programs that have none yet.

use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    Adapter, BindGroup, BindGroupDescriptor, BindGroupEntry, Buffer, BufferDescriptor,
    BufferUsages, ComputePipeline, ComputePipelineDescriptor, Device, DeviceDescriptor, Features,
    Instance, InstanceDescriptor, InstanceFlags, Limits, MapMode, PollType, Queue,
    RequestAdapterOptions, ShaderModuleDescriptor, ShaderSource,
};

use crate::error::GpuError;

/// A device with its queue, for tests, benches and examples.
#[derive(Debug)]
pub struct Gpu {
    /// Where it comes from.
    pub adapter: Adapter,
    /// The device.
    pub device: Device,
    /// Its queue.
    pub queue: Queue,
}

impl Gpu {
    /// The first adapter, with a device of these limits or of its own, and with timestamps if it has them.
    ///
    /// # Errors
    /// [`GpuError::NoDevice`].
    pub fn new(limits: Option<Limits>) -> Result<Self, GpuError> {
        let mut descriptor = InstanceDescriptor::new_without_display_handle_from_env();
        // Without this, wgpu hides the software adapter of Debian 12, which does not claim to conform to Vulkan.
        descriptor.flags |= InstanceFlags::ALLOW_UNDERLYING_NONCOMPLIANT_ADAPTER;
        let no_device = |error: &dyn std::fmt::Display| GpuError::NoDevice(error.to_string());
        let instance = Instance::new(descriptor);
        let adapter = instance.request_adapter(&RequestAdapterOptions::default());
        let adapter = pollster::block_on(adapter).map_err(|error| no_device(&error))?;
        let device = adapter.request_device(&DeviceDescriptor {
            required_features: Features::TIMESTAMP_QUERY & adapter.features(),
            required_limits: limits.unwrap_or_else(|| adapter.limits()),
            ..DeviceDescriptor::default()
        });
        let (device, queue) = pollster::block_on(device).map_err(|error| no_device(&error))?;
        Ok(Self {
            adapter,
            device,
            queue,
        })
    }
}

/// A buffer of these numbers, with the usages `STORAGE`, `COPY_SRC` and `COPY_DST`.
pub fn upload(device: &Device, numbers: &[f32]) -> Buffer {
    device.create_buffer_init(&BufferInitDescriptor {
        label: Some("uploaded"),
        contents: bytemuck::cast_slice(numbers),
        usage: BufferUsages::STORAGE | BufferUsages::COPY_SRC | BufferUsages::COPY_DST,
    })
}

/// A pipeline for each of these entry points of a shader in WGSL.
pub fn pipelines<const N: usize>(
    device: &Device,
    source: &str,
    names: [&str; N],
) -> [ComputePipeline; N] {
    let module = device.create_shader_module(ShaderModuleDescriptor {
        label: None,
        source: ShaderSource::Wgsl(source.into()),
    });
    names.map(|name| {
        device.create_compute_pipeline(&ComputePipelineDescriptor {
            label: Some(name),
            layout: None,
            module: &module,
            entry_point: Some(name),
            compilation_options: Default::default(),
            cache: None,
        })
    })
}

/// The only bind group of a pipeline: buffers by their bindings.
pub fn bind<'a>(
    device: &Device,
    pipeline: &ComputePipeline,
    buffers: impl IntoIterator<Item = (u32, &'a Buffer)>,
) -> BindGroup {
    let entries = buffers.into_iter().map(|(binding, buffer)| BindGroupEntry {
        binding,
        resource: buffer.as_entire_binding(),
    });
    device.create_bind_group(&BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &entries.collect::<Vec<_>>(),
    })
}

/// The first words of a buffer with the usage `COPY_SRC`, once the queue has done what was submitted before.
///
/// # Errors
/// [`GpuError::Device`].
pub fn read(
    device: &Device,
    queue: &Queue,
    from: &Buffer,
    words: u64,
) -> Result<Vec<u32>, GpuError> {
    if words == 0 {
        return Ok(Vec::new());
    }
    let size = 4 * words;
    let copy = device.create_buffer(&BufferDescriptor {
        label: Some("read back"),
        size,
        usage: BufferUsages::MAP_READ | BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    encoder.copy_buffer_to_buffer(from, 0, &copy, 0, size);
    queue.submit([encoder.finish()]);
    let failed = |error: &dyn std::fmt::Display| GpuError::Device(error.to_string());
    // A map that fails is an error of the range below.
    copy.map_async(MapMode::Read, .., |_| {});
    device
        .poll(PollType::wait_indefinitely())
        .map_err(|error| failed(&error))?;
    let range = copy.get_mapped_range(..).map_err(|error| failed(&error))?;
    Ok(bytemuck::cast_slice(&range).to_vec())
}
