//! Triangles drawn by the graphics card: uploaded once a scene, then moved by one small uniform a frame.
//!
//! Coordinates are uploaded relative to the middle of the scene, in single precision. Where the view is so near that
//! this would show, [`super::near`] draws the few triangles that are seen.

use std::collections::BTreeMap;
use std::sync::Arc;

use eframe::egui_wgpu::{Callback, CallbackResources, CallbackTrait, ScreenDescriptor};
use eframe::wgpu::util::DeviceExt as _;
use eframe::{egui, wgpu};
use trimalla::geometry::Point;

use super::switches::Switches;
use super::view::View;
use crate::scene::{Face, Scene};

/// A corner takes so many bytes on the card: two coordinates, the angle, the facts.
const CORNER_BYTES: usize = 16;

/// So many triangles are in one buffer: their bytes are gathered first, and browsers bound the size of a buffer.
const CHUNK: usize = 1 << 16;

/// A scene that a viewer shows, and how.
pub(crate) struct Drawn {
    /// Which viewer this is: each keeps buffers of its own.
    pub(crate) viewer: u64,
    pub(crate) scene: Arc<Scene>,
    pub(crate) format: wgpu::TextureFormat,
    pub(crate) uniform: Uniform,
}

/// What the shader is told of the view.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Uniform {
    scale: [f32; 2],
    offset: [f32; 2],
    threshold: f32,
    mode: u32,
    switches: u32,
    pixels_per_point: f32,
}

impl Uniform {
    const BYTES: usize = 32;

    /// For a view on a part of the screen.
    pub(crate) fn new(
        (view, rect): (View, egui::Rect),
        scene: &Scene,
        switches: &Switches,
        (is_dark, pixels_per_point): (bool, f32),
    ) -> Self {
        let origin = origin(scene);
        let up = if view.is_y_down { -1.0 } else { 1.0 };
        let [x, y] = [2.0 * view.scale / f64::from(rect.width()), 2.0 * up * view.scale / f64::from(rect.height())];
        let bits = [switches.edges, switches.constraints, switches.boundary, is_dark];
        Self {
            scale: [x as f32, y as f32],
            offset: [((origin.x - view.center.x) * x) as f32, ((origin.y - view.center.y) * y) as f32],
            threshold: switches.threshold_deg as f32,
            mode: switches.colours as u32,
            switches: bits.iter().rev().fold(0, |sum, &bit| sum << 1 | u32::from(bit)),
            pixels_per_point,
        }
    }

    fn bytes(&self, is_linear: bool) -> [u8; Self::BYTES] {
        let switches = self.switches | u32::from(is_linear) << 4;
        let words = [
            self.scale[0].to_bits(),
            self.scale[1].to_bits(),
            self.offset[0].to_bits(),
            self.offset[1].to_bits(),
            self.threshold.to_bits(),
            self.mode,
            switches,
            self.pixels_per_point.to_bits(),
        ];
        let mut bytes = [0; Self::BYTES];
        for (place, word) in bytes.chunks_exact_mut(4).zip(words) {
            place.copy_from_slice(&word.to_ne_bytes());
        }
        bytes
    }
}

/// What coordinates are uploaded relative to.
pub(crate) fn origin(scene: &Scene) -> Point {
    scene.bounds.unwrap_or_default().center()
}

/// Whether single precision would show: a last place of the farthest coordinate takes a quarter of a pixel or more.
pub(crate) fn is_too_near(view: View, scene: &Scene) -> bool {
    let Some(bounds) = scene.bounds else { return false };
    let extent = bounds.width().max(bounds.height());
    let last_place = extent * f64::from(f32::EPSILON) / 2.0;
    // What is neither a number in single precision could not be drawn either.
    !(last_place * view.scale < 0.25 && extent < 1e30 && (extent == 0.0 || extent > 1e-30))
}

impl Drawn {
    /// The shape that draws it.
    pub(crate) fn into_shape(self, rect: egui::Rect) -> egui::Shape {
        egui::Shape::Callback(Callback::new_paint_callback(rect, self))
    }
}

/// What all viewers have on the card.
struct Card {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    is_linear: bool,
    viewers: BTreeMap<u64, Uploaded>,
}

/// What one viewer has on the card.
struct Uploaded {
    scene: Arc<Scene>,
    chunks: Vec<(wgpu::Buffer, u32)>,
    uniform: wgpu::Buffer,
    group: wgpu::BindGroup,
}

impl CallbackTrait for Drawn {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        _: &ScreenDescriptor,
        _: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        let card = resources.entry::<Card>().or_insert_with(|| Card::new(device, self.format));
        let is_present = card.viewers.get(&self.viewer).is_some_and(|shown| Arc::ptr_eq(&shown.scene, &self.scene));
        if !is_present {
            // The old buffers are freed before there are new ones.
            card.viewers.remove(&self.viewer);
            let uploaded = card.upload(device, queue, &self.scene);
            card.viewers.insert(self.viewer, uploaded);
        }
        if let Some(shown) = card.viewers.get(&self.viewer) {
            queue.write_buffer(&shown.uniform, 0, &self.uniform.bytes(card.is_linear));
        }
        Vec::new()
    }

    fn paint(&self, _: egui::PaintCallbackInfo, pass: &mut wgpu::RenderPass<'static>, resources: &CallbackResources) {
        let Some(card) = resources.get::<Card>() else { return };
        let Some(shown) = card.viewers.get(&self.viewer) else { return };
        pass.set_pipeline(&card.pipeline);
        pass.set_bind_group(0, &shown.group, &[]);
        for (buffer, corners) in &shown.chunks {
            pass.set_vertex_buffer(0, buffer.slice(..));
            pass.draw(0..*corners, 0..1);
        }
    }
}

impl Card {
    fn new(device: &wgpu::Device, format: wgpu::TextureFormat) -> Self {
        let shader = device.create_shader_module(wgpu::include_wgsl!("shader.wgsl"));
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("view"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
                ty: wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Uniform,
                    has_dynamic_offset: false,
                    min_binding_size: wgpu::BufferSize::new(Uniform::BYTES as u64),
                },
                count: None,
            }],
        });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("triangles"),
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let attributes = wgpu::vertex_attr_array![0 => Float32x2, 1 => Float32, 2 => Uint32];
        let buffer = wgpu::VertexBufferLayout {
            array_stride: CORNER_BYTES as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &attributes,
        };
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("triangles"),
            layout: Some(&pipeline_layout),
            vertex: wgpu::VertexState {
                module: &shader,
                entry_point: Some("corner"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[Some(buffer)],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &shader,
                entry_point: Some("fill"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        Self { pipeline, layout, is_linear: format.is_srgb(), viewers: BTreeMap::new() }
    }

    fn upload(&self, device: &wgpu::Device, queue: &wgpu::Queue, scene: &Arc<Scene>) -> Uploaded {
        let chunk = |faces: &[Face]| {
            let buffer = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label: Some("corners"),
                contents: &corners(scene, faces),
                usage: wgpu::BufferUsages::VERTEX,
            });
            // Each is copied at once, so that what was lent for the copy is freed before the next one.
            queue.submit([]);
            let _ = device.poll(wgpu::PollType::Poll);
            (buffer, 3 * faces.len() as u32)
        };
        let uniform = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("view"),
            contents: &[0; Uniform::BYTES],
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        });
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("view"),
            layout: &self.layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() }],
        });
        Uploaded { scene: scene.clone(), chunks: scene.faces.chunks(CHUNK).map(chunk).collect(), uniform, group }
    }
}

/// The corners of triangles as the shader reads them.
fn corners(scene: &Scene, faces: &[Face]) -> Vec<u8> {
    let origin = origin(scene);
    let mut bytes = Vec::with_capacity(3 * CORNER_BYTES * faces.len());
    for face in faces {
        for p in scene.corners(face) {
            bytes.extend_from_slice(&((p.x - origin.x) as f32).to_ne_bytes());
            bytes.extend_from_slice(&((p.y - origin.y) as f32).to_ne_bytes());
            bytes.extend_from_slice(&face.min_angle_deg.to_ne_bytes());
            bytes.extend_from_slice(&face.facts.0.to_ne_bytes());
        }
    }
    bytes
}
