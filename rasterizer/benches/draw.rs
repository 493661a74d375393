//! Full-screen draws at 1024×1024, per instruction set on one thread and the best one on two: what a
//! pixel costs from coverage to the attachment.
//!
//! All are measured in turn, round after round, and the least time of each is kept, so that what
//! disturbs the machine falls on all of them alike. Words after `--` pick those that hold them all.

use rasterizer::driver::{
    Attachment, Buffer, ColorState, Command, CommandBuffer, Cull, Device, DeviceDesc, FrontFace,
    Image, OutputState, PassDesc, Pipeline, PipelineDesc, Provoking, ShaderModule, Topology,
    VertexBinding, VertexFormat, VertexSource, VertexType, Viewport,
};
use rasterizer::ir::{Builder, Input, Interpolation, Lod, Op, Output, Stage, TextureDecl, Value};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;
use texunit::sampler::{Filter, Mipmap, Sampler};

const SIZE: u32 = 1024;
/// How often each is measured.
const ROUNDS: usize = 15;

fn module(b: Builder) -> ShaderModule {
    ShaderModule::new(b.finish()).expect("valid")
}

/// Position, s and t as slots 0 and 1, a white colour as slots 2 to 5.
fn vertex() -> ShaderModule {
    let mut b = Builder::new(Stage::Vertex);
    for component in 0..4 {
        let value = b.input(Input::Attribute { location: 0, component });
        let out = b.output(Output::Position(component));
        b.store(out, value);
    }
    for (slot, component) in (0..).zip([0, 1, 3, 3, 3, 3]) {
        let value = b.input(Input::Attribute { location: 1, component });
        let out = b.output(Output::Varying(slot));
        b.store(out, value);
    }
    module(b)
}

fn fragment(color: impl FnOnce(&mut Builder) -> [Value; 4]) -> ShaderModule {
    let mut b = Builder::new(Stage::Fragment);
    b.module_mut().varyings = vec![Interpolation::Smooth; 6];
    let rgba = color(&mut b);
    for (component, value) in rgba.into_iter().enumerate() {
        let out = b.output(Output::Color { target: 0, component: component as u8 });
        b.store(out, value);
    }
    module(b)
}

fn textured() -> ShaderModule {
    fragment(|b| {
        let texture = b.texture(TextureDecl::color(Shape::D2));
        let (s, t, zero) = (b.input(Input::Varying(0)), b.input(Input::Varying(1)), b.float(0.0));
        b.sample(texture, [s, t, zero], None, Lod::Implicit { bias: None })
    })
}

/// As the fixed function has it: the texel times the clamped colour.
fn modulated() -> ShaderModule {
    fragment(|b| {
        let texture = b.texture(TextureDecl::color(Shape::D2));
        let (s, t, zero) = (b.input(Input::Varying(0)), b.input(Input::Varying(1)), b.float(0.0));
        let one = b.float(1.0);
        let texel = b.sample(texture, [s, t, zero], None, Lod::Implicit { bias: None });
        let color = [2, 3, 4, 5].map(|slot| {
            let color = b.input(Input::Varying(slot));
            let high = b.op(Op::Max, &[color, zero]);
            b.op(Op::Min, &[high, one])
        });
        [0, 1, 2, 3].map(|i| b.op(Op::Mul, &[texel[i], color[i]]))
    })
}

/// A texture of noise with mipmaps.
fn texels() -> Texels {
    let mut level = Level::new(Format::Rgba8, 512, 512).expect("small");
    for (i, byte) in level.texels.iter_mut().enumerate() {
        *byte = (i as u32).wrapping_mul(2_654_435_761).to_le_bytes()[3];
    }
    let mut image = Texels::new(Shape::D2);
    image.set_level(0, 0, level).expect("face 0");
    image.generate_mipmaps(Isa::best(), 0, 1000).expect("small");
    image
}

/// A square in the plane, or a floor in perspective.
fn vertices(far_w: f32, repeat: f32) -> Arc<[VertexBinding]> {
    let corner = |x: f32, y: f32| {
        let w = if y > 0.0 { far_w } else { 1.0 };
        [x * w, y * w, 0.0, w, (x + 1.0) * repeat, (y + 1.0) * repeat, 0.0, 1.0]
    };
    let floats: Vec<f32> =
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .into_iter()
            .flat_map(|[x, y]| corner(x, y))
            .collect();
    bind(&floats)
}

/// Interleaved positions and texture coordinates.
fn bind(floats: &[f32]) -> Arc<[VertexBinding]> {
    let buffer = Buffer::new(floats.iter().flat_map(|v| v.to_le_bytes()).collect());
    (0..2)
        .map(|location| VertexBinding {
            location,
            source: VertexSource::Array {
                buffer: buffer.clone(),
                first: 0,
                offset: usize::from(location) * 16,
                stride: 32,
                ty: VertexType::F32,
                components: 4,
                format: VertexFormat::Plain,
                divisor: 0,
            },
        })
        .collect()
}

/// A grid of triangles of about five pixels each.
fn small_triangles(across: u32, up: u32) -> Vec<f32> {
    let mut floats = Vec::new();
    let place = |i: f32, n: u32| i / n as f32 * 2.0 - 1.0;
    for j in 0..up {
        for i in 0..across {
            for (dx, dy) in [(0.0, 0.0), (1.0, 0.1), (0.1, 1.0)] {
                let (x, y) = (i as f32 + dx, j as f32 + dy);
                floats.extend([place(x, across), place(y, up), 0.0, 1.0]);
                floats.extend([x / across as f32, y / up as f32, 0.0, 1.0]);
            }
        }
    }
    floats
}

struct Scene {
    name: &'static str,
    fragment: ShaderModule,
    sampler: Sampler,
    vertices: Arc<[VertexBinding]>,
    count: u32,
}

fn scenes() -> Vec<Scene> {
    let sampler =
        |filter, mipmap| Sampler { min: filter, mag: filter, mipmap, ..Sampler::default() };
    let flat = fragment(|b| [0.1, 0.2, 0.3, 1.0].map(|v| b.float(v)));
    let smooth = fragment(|b| {
        let (s, t, one) = (b.input(Input::Varying(0)), b.input(Input::Varying(1)), b.float(1.0));
        [s, t, one, one]
    });
    let nearest = sampler(Filter::Nearest, Mipmap::None);
    let linear = sampler(Filter::Linear, Mipmap::None);
    let trilinear = sampler(Filter::Linear, Mipmap::Linear);
    let anisotropic = Sampler { max_anisotropy: 16.0, ..trilinear.clone() };
    let scene = |name, fragment: &ShaderModule, sampler: &Sampler, far_w, repeat| Scene {
        name,
        fragment: fragment.clone(),
        sampler: sampler.clone(),
        vertices: vertices(far_w, repeat),
        count: 6,
    };
    let textured = textured();
    vec![
        scene("constant", &flat, &nearest, 1.0, 1.0),
        scene("interpolated", &smooth, &nearest, 4.0, 0.5),
        scene("nearest", &textured, &nearest, 1.0, 1.0),
        scene("nearest_modulated", &modulated(), &nearest, 1.0, 1.0),
        scene("bilinear", &textured, &linear, 1.0, 1.0),
        scene("trilinear_floor", &textured, &trilinear, 16.0, 4.0),
        scene("anisotropic_floor_16x", &textured, &anisotropic, 16.0, 4.0),
        Scene {
            name: "200000_small_triangles",
            fragment: textured.clone(),
            sampler: linear.clone(),
            vertices: bind(&small_triangles(500, 400)),
            count: 3 * 500 * 400,
        },
    ]
}

/// One scene on one device.
struct Cell {
    device: usize,
    name: &'static str,
    commands: CommandBuffer,
    least: f64,
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let texels = texels();
    let mut devices = Vec::new();
    let mut cells = Vec::new();
    let fastest = Isa::best();
    let kinds = Isa::available().into_iter().map(|isa| (isa, 1)).chain([(fastest, 2)]);
    for (isa, threads) in kinds {
        let desc = DeviceDesc::new(isa, threads);
        let name = format!("{} x{threads}", isa.name());
        for scene in scenes() {
            let full = format!("{name} {}", scene.name);
            if !words.is_empty() && !words.iter().all(|word| full.contains(word.as_str())) {
                continue;
            }
            let mut target = Texels::new(Shape::D2);
            let level = Level::new(Format::Rgba8, SIZE, SIZE).expect("small");
            target.set_level(0, 0, level).expect("face 0");
            let commands = commands(&scene, &texels, Image::new(target));
            let device = devices.len();
            cells.push(Cell { device, name: scene.name, commands, least: f64::INFINITY });
        }
        devices.push((name, Device::new(desc).expect("a thread starts")));
    }
    for _ in 0..ROUNDS {
        for cell in &mut cells {
            let start = Instant::now();
            black_box(devices[cell.device].1.submit(&cell.commands)).expect("legal");
            cell.least = cell.least.min(start.elapsed().as_secs_f64() * 1e3);
        }
    }
    for cell in cells {
        println!("{:<12} {:<24} {:6.1} ms", devices[cell.device].0, cell.name, cell.least);
    }
}

fn commands(scene: &Scene, texels: &Texels, target: Image) -> CommandBuffer {
    let plan = Arc::new(SamplePlan::new(texels, &scene.sampler));
    let pipeline = Pipeline::new(PipelineDesc {
        vertex: vertex(),
        geometry: None,
        fragment: scene.fragment.clone(),
        topology: Topology::Triangles,
        cull: Cull::None,
        front_face: FrontFace::Ccw,
        provoking: Provoking::Last,
        depth: None,
        colors: vec![ColorState { blend: None, mask: [true; 4] }],
        output: OutputState::default(),
    });
    let (x, y, width, height) = (0.0, 0.0, SIZE as f32, SIZE as f32);
    CommandBuffer {
        commands: vec![
            Command::BeginPass(PassDesc {
                colors: vec![Some(Attachment::new(target, 0, 0))],
                depth: None,
                width: SIZE,
                height: SIZE,
                layers: 1,
                samples: 1,
            }),
            Command::BindPipeline(pipeline.expect("valid")),
            Command::BindVertices(scene.vertices.clone()),
            Command::BindTextures { vertex: Arc::new([]), fragment: Arc::new([Some(plan)]) },
            Command::SetViewport(Viewport {
                x,
                y,
                width,
                height,
                near: 0.0,
                far: 1.0,
                depth_clip: Default::default(),
                clip_control: Default::default(),
            }),
            Command::Draw { first: 0, count: scene.count, instances: 0..1 },
            Command::EndPass,
        ],
    }
}
