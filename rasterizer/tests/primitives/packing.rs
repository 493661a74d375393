//! Fragments are the same however they are put into batches. In a tile with a watched pixel nothing is
//! packed by pixels and no window is looked for, so a picture of one tile can be drawn both ways.

use super::super::Random;
use super::super::common::{
    bindings, bytes, device, fragment, image, pass, pipeline, vertex, viewport,
};
use rasterizer::driver::{
    Blend, BlendEquation, BlendFactor, ClearValue, Command, CommandBuffer, DepthState, DepthWrite,
    Pipeline, PipelineDesc, Rect, VertexBinding, Watch,
};
use rasterizer::ir::{Builder, Input, Lod, Op, Stmt, TextureDecl, Value};
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;
use texunit::sampler::{Compare, Filter, Mipmap, Sampler};

/// One tile.
pub const SIZE: u32 = 64;

/// Triangles of all sizes from a subpixel to half the picture, some in perspective, some behind the
/// eye, many over one another: position, then four values.
pub fn triangles() -> Vec<f32> {
    let mut random = Random(5);
    let mut out = Vec::new();
    for n in 0..900 {
        let size = [0.02, 0.08, 0.15, 0.3, 0.6, 0.004][n % 6];
        let center = [random.float(-1.1, 1.1), random.float(-1.1, 1.1)];
        for _ in 0..3 {
            let w = match n % 5 {
                0 => random.float(0.1, 1.9),
                1 => random.float(-0.7, 1.3),
                _ => 1.0,
            };
            let [x, y] = center.map(|v| (v + random.float(-size, size)) * w);
            out.extend([x, y, random.float(-0.5, 0.5) * w, w]);
            out.extend([0; 4].map(|_| random.float(-0.2, 1.2)));
        }
    }
    out
}

/// A draw.
pub struct TestDraw<'a> {
    pub desc: &'a PipelineDesc,
    pub textures: &'a [Option<Arc<SamplePlan>>],
    pub vertices: &'a Arc<[VertexBinding]>,
    pub count: u32,
    /// The format of the attachment.
    pub target: Format,
}

/// The picture and the depths of a draw, and what is said of it.
pub fn picture(isa: Isa, draw: &TestDraw<'_>, watched: bool) -> (Vec<u8>, String) {
    let (color, depth) = (image(draw.target, SIZE, SIZE), image(Format::D24, SIZE, SIZE));
    let area = Rect { x: 0, y: 0, width: SIZE, height: SIZE };
    let mut commands = vec![pass(&color, Some(&depth), SIZE, SIZE), viewport(SIZE, SIZE)];
    if watched {
        commands.push(Command::Watch(Watch::new(20, 30)));
    }
    commands.extend([
        Command::Clear { value: ClearValue::Depth(1.0), area },
        Command::BindPipeline(Pipeline::new(draw.desc.clone()).expect("valid")),
        Command::BindVertices(draw.vertices.clone()),
        Command::BindTextures { vertex: Arc::new([]), fragment: draw.textures.into() },
        Command::SetScissor(Some(Rect { x: 3, y: 1, width: 58, height: 61 })),
        Command::Draw { first: 0, count: draw.count, instances: 0..1 },
        Command::EndPass,
    ]);
    let device = device(isa, 2);
    let report = device.submit(&CommandBuffer { commands }).expect("legal");
    assert!(report.over_budget.is_empty());
    ([bytes(&color), bytes(&depth)].concat(), device.take_explanations().concat())
}

/// A texture of noise with mipmaps.
fn noise() -> Texels {
    let mut level = Level::new(Format::Rgba8, 64, 64).expect("small");
    for (i, byte) in level.texels.iter_mut().enumerate() {
        *byte = (i as u32).wrapping_mul(2_654_435_761).to_le_bytes()[3];
    }
    let mut image = Texels::new(Shape::D2);
    image.set_level(0, 0, level).expect("face 0");
    image.generate_mipmaps(Isa::best(), 0, 1000).expect("small");
    image
}

pub fn varying(b: &mut Builder, slot: u16) -> Value {
    b.input(Input::Varying(slot))
}

/// What is interpolated, and where the fragment is.
pub fn inputs(b: &mut Builder) -> [Value; 4] {
    let front = b.input(Input::FrontFacing);
    let (x, y) = (b.input(Input::FragCoord(0)), b.input(Input::FragCoord(1)));
    let (z, w) = (b.input(Input::FragCoord(2)), b.input(Input::FragCoord(3)));
    let size = b.float(1.0 / SIZE as f32);
    let place = [x, y].map(|v| b.op(Op::Mul, &[v, size]));
    let red = varying(b, 0);
    let other = varying(b, 1);
    let red = b.op(Op::SelectF, &[front, red, other]);
    let green = b.op(Op::Add, &[place[0], z]);
    let blue = b.op(Op::Mul, &[place[1], w]);
    let alpha = varying(b, 3);
    [red, green, blue, alpha]
}

/// A lookup whose level of detail comes from the planes.
fn lookup(b: &mut Builder) -> [Value; 4] {
    let texture = b.texture(TextureDecl::color(Shape::D2));
    let (s, t, zero) = (varying(b, 0), varying(b, 1), b.float(0.0));
    b.sample(texture, [s, t, zero], None, Lod::Implicit { bias: None })
}

/// Some fragments are thrown away.
fn discards(b: &mut Builder) -> [Value; 4] {
    let (red, zero) = (varying(b, 0), b.float(0.0));
    let low = b.op(Op::Less, &[red, zero]);
    b.begin();
    b.push(Stmt::Discard);
    let accept = b.end();
    b.push(Stmt::If { condition: low, accept, reject: Vec::new() });
    inputs(b)
}

#[test]
fn packed_by_pixels_or_by_quads_is_the_same() {
    let sampler = Sampler {
        min: Filter::Linear,
        mag: Filter::Linear,
        mipmap: Mipmap::Linear,
        ..Sampler::default()
    };
    let texture = Arc::new(SamplePlan::new(&noise(), &sampler));
    let blend = Blend {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::SrcAlpha; 2],
        dst: [BlendFactor::OneMinusSrcAlpha; 2],
        constant: [0.0; 4],
    };
    let less = DepthState { test: Compare::Less, write: DepthWrite::On };
    for (name, color) in [
        ("inputs", inputs as fn(&mut Builder) -> [Value; 4]),
        ("lookup", lookup),
        ("discards", discards),
    ] {
        let unwritten = DepthState { test: Compare::Less, write: DepthWrite::Off };
        let all = [true; 4];
        for (blend, depth, mask) in [
            (None, None, all),
            (Some(blend), None, all),
            (Some(blend), Some(less), all),
            (Some(blend), Some(unwritten), all),
            // Nothing but depth.
            (None, Some(less), [false; 4]),
        ] {
            let mut desc = pipeline(vertex(4), fragment(4, color));
            desc.colors[0].blend = blend;
            desc.colors[0].mask = mask;
            desc.depth = depth;
            let draw = TestDraw {
                desc: &desc,
                textures: &[Some(texture.clone())],
                vertices: &bindings(&triangles(), 2),
                count: 2700,
                target: Format::Rgba8,
            };
            let (want, _) = picture(Isa::BASELINE, &draw, true);
            for isa in Isa::available() {
                let (got, _) = picture(isa, &draw, false);
                assert!(got == want, "{name}, {blend:?}, {depth:?}, {mask:?}, {}", isa.name());
            }
        }
    }
}
