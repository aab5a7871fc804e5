//! A device that runs shaders: any that Vulkan finds, the software rasteriser of Mesa included.

use std::env;
use std::io::{self, Write};

use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{
    Adapter, Backends, BindGroupDescriptor, BindGroupEntry, BufferDescriptor, BufferUsages,
    ComputePassDescriptor, ComputePipeline, ComputePipelineDescriptor, Device as Handle,
    DeviceDescriptor, Instance, InstanceDescriptor, MapMode, PollType, Queue,
    ShaderModuleDescriptor, ShaderSource,
};

/// What has to be in the environment where a missing device is no excuse.
pub const REQUIRED: &str = "BRDF_REQUIRE_DEVICE";

pub struct Device {
    device: Handle,
    queue: Queue,
    /// What the device is called.
    pub name: String,
}

/// What runs for each index `i`: statements that read `given[i * inputs + …]` and write
/// `answers[i * outputs + …]`.
pub struct Program<'a> {
    /// The module in front.
    pub text: &'a str,
    pub statements: &'a str,
    pub inputs: usize,
    pub outputs: usize,
}

impl Program<'_> {
    /// The whole shader, whose entry point is `main`.
    pub fn shader(&self) -> String {
        let Self { text, statements, inputs, outputs } = self;
        format!(
            "{text}
@group(0) @binding(0) var<storage, read> given: array<f32>;
@group(0) @binding(1) var<storage, read_write> answers: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {{
    if id.x >= arrayLength(&given) / {inputs}u {{
        return;
    }}
    let at = id.x * {inputs}u;
    let to = id.x * {outputs}u;
{statements}
}}
"
        )
    }
}

impl Device {
    /// A device, if there is one.
    ///
    /// # Panics
    /// If there is none although the environment requires one.
    pub fn find() -> Option<Self> {
        let found = pollster::block_on(find());
        if found.is_none() {
            assert!(
                env::var_os(REQUIRED).is_none(),
                "no Vulkan device, and {REQUIRED} is set: Debian has one in software in \
                 mesa-vulkan-drivers and libvulkan1"
            );
            // Not by a macro, whose output tests keep to themselves.
            let message = "\n*** NOT RUN: there is no Vulkan device for the shaders ***\n\n";
            io::stderr().write_all(message.as_bytes()).expect("standard error is open");
        }
        found
    }

    /// Makes a program ready to run.
    ///
    /// # Panics
    /// If the device does not take it.
    pub fn compile(&self, program: &Program<'_>) -> Compiled<'_> {
        let module = self.device.create_shader_module(ShaderModuleDescriptor {
            label: None,
            source: ShaderSource::Wgsl(program.shader().into()),
        });
        let pipeline = self.device.create_compute_pipeline(&ComputePipelineDescriptor {
            label: None,
            layout: None,
            module: &module,
            entry_point: Some("main"),
            compilation_options: Default::default(),
            cache: None,
        });
        Compiled { at: self, pipeline, inputs: program.inputs, outputs: program.outputs }
    }
}

/// A program on a device.
pub struct Compiled<'a> {
    at: &'a Device,
    pipeline: ComputePipeline,
    inputs: usize,
    outputs: usize,
}

impl Compiled<'_> {
    /// Runs on numbers, and on a uniform buffer if there is one (group 1, binding 0).
    ///
    /// # Panics
    /// If the device fails.
    pub fn run(&self, given: &[f32], uniforms: Option<&[u8]>) -> Vec<f32> {
        let Self { at: Device { device, queue, .. }, pipeline, .. } = self;
        let count = given.len() / self.inputs;
        let size = (count * self.outputs * 4) as u64;
        let filled = |contents: &[u8], usage| {
            device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage })
        };
        let empty = |usage| {
            let descriptor =
                BufferDescriptor { label: None, size, usage, mapped_at_creation: false };
            device.create_buffer(&descriptor)
        };
        let input = filled(bytemuck::cast_slice(given), BufferUsages::STORAGE);
        let output = empty(BufferUsages::STORAGE | BufferUsages::COPY_SRC);
        let back = empty(BufferUsages::MAP_READ | BufferUsages::COPY_DST);
        let bound = |group, buffers: &[&wgpu::Buffer]| {
            let entries: Vec<_> = (0..)
                .zip(buffers)
                .map(|(binding, buffer)| BindGroupEntry {
                    binding,
                    resource: buffer.as_entire_binding(),
                })
                .collect();
            device.create_bind_group(&BindGroupDescriptor {
                label: None,
                layout: &pipeline.get_bind_group_layout(group),
                entries: &entries,
            })
        };
        let groups = [
            Some(bound(0, &[&input, &output])),
            uniforms.map(|bytes| bound(1, &[&filled(bytes, BufferUsages::UNIFORM)])),
        ];
        let mut encoder = device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&ComputePassDescriptor::default());
            pass.set_pipeline(pipeline);
            for (index, group) in (0..).zip(groups.iter().flatten()) {
                pass.set_bind_group(index, group, &[]);
            }
            pass.dispatch_workgroups(count.div_ceil(64) as u32, 1, 1);
        }
        encoder.copy_buffer_to_buffer(&output, 0, &back, 0, size);
        queue.submit([encoder.finish()]);
        back.slice(..).map_async(MapMode::Read, |mapped| mapped.expect("the buffer is mapped"));
        device.poll(PollType::wait_indefinitely()).expect("the device answers");
        let bytes = back.slice(..).get_mapped_range().expect("the buffer is mapped");
        bytemuck::cast_slice(&bytes).to_vec()
    }
}

async fn find() -> Option<Device> {
    let mut descriptor = InstanceDescriptor::new_without_display_handle();
    descriptor.backends = Backends::VULKAN;
    let instance = Instance::new(descriptor);
    let adapter: Adapter = instance.request_adapter(&Default::default()).await.ok()?;
    let (device, queue) = adapter.request_device(&DeviceDescriptor::default()).await.ok()?;
    Some(Device { device, queue, name: adapter.get_info().name })
}
