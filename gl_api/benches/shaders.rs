//! Nine shaders, full-screen at 1024×1024, per instruction set and thread count.
//!
//! `cargo bench -p gl_api --bench shaders [words…]` runs the shaders and instruction sets whose names
//! hold one of the words. A number is the fastest of many draws: the machine may do other things.
//! [RESULTS.md](RESULTS.md) keeps a run.

use gl_api::glsl::{Bindings, Options, Stage, compile, link};
use rasterizer::driver::{
    Attachment, Buffer, ColorState, Command, CommandBuffer, Cull, Device, DeviceDesc, FrontFace,
    Image, OutputState, PassDesc, Pipeline, PipelineDesc, Provoking, ShaderModule, Topology,
    VertexBinding, VertexFormat, VertexSource, VertexType, Viewport,
};
use std::sync::Arc;
use std::time::Instant;
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;
use texunit::sampler::{Filter, Mipmap, Sampler};

const SIZE: u32 = 1024;
/// Batches of 64 lanes in a picture.
const BATCHES: f64 = (SIZE * SIZE) as f64 / 64.0;
const DRAWS: usize = 24;
const THREADS: [usize; 2] = [1, 2];

const VERTEX: &str = "
attribute vec4 position; attribute vec2 coord;
varying vec2 uv;
void main() { uv = coord; gl_Position = position; }
";

/// Names and fragment shaders.
const SHADERS: [(&str, &str); 9] = [
    ("constant", "void main() { gl_FragColor = vec4(0.25, 0.5, 0.75, 1.0); }"),
    (
        "texture",
        "varying vec2 uv; uniform sampler2D image;
void main() { gl_FragColor = texture2D(image, uv * 2.0); }",
    ),
    (
        "two_at_once",
        "varying vec2 uv; uniform sampler2D image; uniform sampler2D light;
void main() { gl_FragColor = texture2D(image, uv * 2.0) * texture2D(light, uv * 2.0); }",
    ),
    (
        "two_apart",
        "varying vec2 uv; uniform sampler2D image; uniform sampler2D light;
void main() { gl_FragColor = texture2D(image, uv * 2.0) * texture2D(light, uv * 2.0 + 0.25); }",
    ),
    (
        "normal_map",
        "varying vec2 uv; uniform sampler2D bumps; uniform sampler2D image;
void main() {
    vec3 n = normalize(texture2D(bumps, uv * 2.0).xyz * 2.0 - 1.0);
    vec3 light = normalize(vec3(0.5, 0.5, 1.0) - vec3(uv, 0.0));
    vec3 eye = normalize(vec3(0.5, 0.5, 2.0) - vec3(uv, 0.0));
    float diffuse = max(dot(n, light), 0.0);
    float specular = pow(max(dot(n, normalize(light + eye)), 0.0), 32.0);
    gl_FragColor = vec4(texture2D(image, uv).rgb * (0.1 + diffuse) + vec3(specular), 1.0);
}",
    ),
    (
        "reflection",
        "varying vec2 uv; uniform samplerCube sky;
void main() {
    vec2 p = uv * 2.0 - 1.0;
    vec3 n = normalize(vec3(p, sqrt(max(2.0 - dot(p, p), 0.0))));
    vec3 eye = normalize(vec3(p, -3.0));
    vec3 r = reflect(eye, n);
    float fresnel = 0.1 + 0.9 * pow(1.0 - max(dot(-eye, n), 0.0), 5.0);
    gl_FragColor = vec4(textureCube(sky, r).rgb * fresnel, 1.0);
}",
    ),
    (
        "wood",
        "varying vec2 uv;
float hash(vec2 p) { return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453); }
float noise(vec2 p) {
    vec2 i = floor(p);
    vec2 f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash(i), hash(i + vec2(1.0, 0.0)), f.x),
               mix(hash(i + vec2(0.0, 1.0)), hash(i + vec2(1.0, 1.0)), f.x), f.y);
}
float fbm(vec2 p) {
    float sum = 0.0;
    float weight = 0.5;
    for (int i = 0; i < 5; i++) { sum += weight * noise(p); p *= 2.0; weight *= 0.5; }
    return sum;
}
void main() {
    vec2 p = uv * 4.0 - 2.0;
    float ring = fract(length(p) * 4.0 + fbm(p * 3.0));
    gl_FragColor = vec4(mix(vec3(0.4, 0.2, 0.07), vec3(0.75, 0.5, 0.25), ring), 1.0);
}",
    ),
    (
        "samples",
        "varying vec2 uv; uniform int count;
void main() {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; i++) {
        float angle = float(i) * 0.39269908;
        vec2 p = uv + vec2(cos(angle), sin(angle)) * 0.1;
        sum += vec3(p, dot(p, p));
    }
    gl_FragColor = vec4(sum / float(count), 1.0);
}",
    ),
    (
        "julia",
        "varying vec2 uv;
void main() {
    vec2 z = uv * 3.0 - 1.5;
    int turns = 0;
    for (int i = 0; i < 64; i++) {
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + vec2(-0.4, 0.6);
        if (dot(z, z) > 4.0) break;
        turns++;
    }
    gl_FragColor = vec4(vec3(float(turns) / 64.0), 1.0);
}",
    ),
];

/// Noise with mipmaps.
fn texels(shape: Shape) -> Texels {
    let mut image = Texels::new(shape);
    for face in 0..if shape == Shape::Cube { 6 } else { 1 } {
        let mut level = Level::new(Format::Rgba8, 256, 256).expect("small");
        for (i, byte) in level.texels.iter_mut().enumerate() {
            *byte = (i as u32).wrapping_mul(2_654_435_761).to_le_bytes()[3];
        }
        image.set_level(face, 0, level).expect("the face exists");
    }
    image.generate_mipmaps(Isa::best(), 0, 1000).expect("small");
    image
}

/// A binding of two triangles over the window: position, or coordinate.
fn binding(location: u8, buffer: &Buffer, offset: usize) -> VertexBinding {
    let source = VertexSource::Array {
        buffer: buffer.clone(),
        first: 0,
        offset,
        stride: 32,
        ty: VertexType::F32,
        components: 4,
        format: VertexFormat::Plain,
        divisor: 0,
    };
    VertexBinding { location, source }
}

fn commands(text: &str) -> CommandBuffer {
    let shader = |stage, text| {
        let compiled = compile(stage, text, &Options::default());
        compiled.shader.unwrap_or_else(|| panic!("{}", compiled.log))
    };
    let stages = [shader(Stage::Vertex, VERTEX), shader(Stage::Fragment, text)];
    let linked = link(&[&stages[0], &stages[1]], &Bindings::default());
    let program = linked.program.unwrap_or_else(|| panic!("{}", linked.log));
    let fragment = program.fragment.expect("linked");
    let sampler = Sampler {
        min: Filter::Linear,
        mag: Filter::Linear,
        mipmap: Mipmap::None,
        ..Sampler::default()
    };
    let textures = fragment
        .textures
        .iter()
        .map(|declared| Some(Arc::new(SamplePlan::new(&texels(declared.shape), &sampler))))
        .collect();
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let floats = corners
        .into_iter()
        .flat_map(|[x, y]: [f32; 2]| [x, y, 0.0, 1.0, (x + 1.0) * 0.5, (y + 1.0) * 0.5, 0.0, 1.0]);
    let buffer = Buffer::new(floats.flat_map(f32::to_le_bytes).collect());
    let vertices = program
        .attributes
        .iter()
        .map(|attribute| {
            let offset = if attribute.name == "coord" { 16 } else { 0 };
            binding(attribute.location, &buffer, offset)
        })
        .collect();
    let pipeline = Pipeline::new(PipelineDesc {
        vertex: ShaderModule::new(program.vertex.expect("linked")).expect("valid"),
        geometry: None,
        fragment: ShaderModule::new(fragment).expect("valid"),
        topology: Topology::Triangles,
        cull: Cull::None,
        front_face: FrontFace::Ccw,
        provoking: Provoking::Last,
        depth: None,
        colors: vec![ColorState { blend: None, mask: [true; 4] }],
        output: OutputState::default(),
    });
    let mut target = Texels::new(Shape::D2);
    target.set_level(0, 0, Level::new(Format::Rgba8, SIZE, SIZE).expect("small")).expect("face 0");
    let (width, height) = (SIZE as f32, SIZE as f32);
    CommandBuffer {
        commands: vec![
            Command::BeginPass(PassDesc {
                colors: vec![Some(Attachment::new(Image::new(target), 0, 0))],
                depth: None,
                width: SIZE,
                height: SIZE,
                layers: 1,
                samples: 1,
            }),
            Command::BindPipeline(pipeline.expect("valid")),
            // The one number that a shader asks for; textures are bound by slot.
            Command::SetUniforms(vec![16; program.words as usize].into()),
            Command::BindVertices(vertices),
            Command::BindTextures { vertex: Arc::new([]), fragment: textures },
            Command::SetViewport(Viewport {
                x: 0.0,
                y: 0.0,
                width,
                height,
                near: 0.0,
                far: 1.0,
                depth_clip: Default::default(),
                clip_control: Default::default(),
            }),
            Command::Draw { first: 0, count: 6, instances: 0..1 },
            Command::EndPass,
        ],
    }
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|arg| !arg.starts_with('-')).collect();
    let names = |names: &[&str]| {
        let mut wanted = words.iter().filter(|word| names.iter().any(|name| name.contains(*word)));
        wanted.next().is_some()
    };
    let isas = Isa::available();
    let isa_names: Vec<&str> = isas.iter().map(|isa| isa.name()).collect();
    let any_isa = names(&isa_names);
    let any_shader = names(&SHADERS.map(|(name, _)| name));
    println!("{:<12} {:<10} {:>7} {:>8} {:>12}", "shader", "isa", "threads", "ms", "µs per batch");
    for (name, text) in SHADERS {
        if any_shader && !names(&[name]) {
            continue;
        }
        let commands = commands(text);
        for isa in isas.iter().copied().filter(|isa| !any_isa || names(&[isa.name()])) {
            for threads in THREADS {
                let seconds = fastest(&commands, isa, threads);
                println!(
                    "{name:<12} {:<10} {threads:>7} {:>8.2} {:>12.3}",
                    isa.name(),
                    seconds * 1e3,
                    seconds * 1e6 / BATCHES
                );
            }
        }
    }
}

/// The seconds of the fastest of many draws.
fn fastest(commands: &CommandBuffer, isa: Isa, threads: usize) -> f64 {
    let desc = DeviceDesc::new(isa, threads);
    let device = Device::new(desc).expect("a thread starts");
    let draw = |_| {
        let start = Instant::now();
        device.submit(commands).expect("legal");
        start.elapsed()
    };
    (0..DRAWS).map(draw).min().unwrap_or_default().as_secs_f64()
}
