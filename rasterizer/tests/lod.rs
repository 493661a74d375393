//! The level of detail of lookups in a draw: against the exact one, and the same however the pixels
//! are batched.

mod common;

use common::{bindings, bytes, device, fragment, image, pass, pipeline, vertex, viewport};
use rasterizer::driver::{Command, CommandBuffer, Device, Pipeline, Rect};
use rasterizer::ir::{Builder, Input, Lod, Op, TextureDecl, Ty, Value};
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;
use texunit::sampler::{Filter, Mipmap, Sampler};

const SIZE: u32 = 128;
const TEXELS: u32 = 1024;
/// What is far is so much farther than what is near.
const FAR: f32 = 12.0;
/// How often the texture repeats.
const REPEAT: f32 = 0.5;

/// Each level holds its own number, so that a trilinear sample is λ, where it is minified.
fn numbered() -> Texels {
    let mut image = Texels::new(Shape::D2);
    for number in 0..=TEXELS.ilog2() {
        let mut level =
            Level::new(Format::L32F, TEXELS >> number, TEXELS >> number).expect("small");
        level.fill(|_| [number as f32; 4]);
        image.set_level(0, number as usize, level).expect("a level of a 2D image");
    }
    image
}

/// A floor that fills the picture: position, then s, t, 0, q.
fn floor(q: f32) -> Vec<f32> {
    let corner = |x: f32, y: f32| {
        let w = if y > 0.0 { FAR } else { 1.0 };
        let (s, t) = ((x + 1.0) * 0.5 * w * REPEAT, (y + 1.0) * 0.5 * w * REPEAT);
        [x * w, y * w, 0.0, w, s * q, t * q, 0.0, q]
    };
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        .into_iter()
        .flat_map(|[x, y]| corner(x, y))
        .collect()
}

/// λ of pixel (x, y), from the derivatives of the floor's formula.
fn exact(x: u32, y: u32) -> f64 {
    let (far, n) = (f64::from(FAR), f64::from(SIZE));
    // On the screen 1/w, s/w and t/w are linear; u and v run from 0 to 1 over the picture.
    let (u, v) = ((f64::from(x) + 0.5) / n, (f64::from(y) + 0.5) / n);
    let scale = f64::from(REPEAT) * f64::from(TEXELS) / n;
    let inverse = 1.0 - v * (1.0 - 1.0 / far);
    let slope = -(1.0 - 1.0 / far);
    // s/w is u and t/w is v, but for the scale: s = u / inverse, t = v / inverse.
    let dx = [1.0 / inverse, 0.0];
    let dy = [-u * slope / (inverse * inverse), (inverse - v * slope) / (inverse * inverse)];
    let length = |d: [f64; 2]| (d[0] * d[0] + d[1] * d[1]).sqrt() * scale;
    length(dx).max(length(dy)).log2()
}

/// How the shader makes its coordinates of s, t, q.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Coords {
    /// As they come.
    Plain,
    /// Halved, moved and doubled again.
    Scaled,
    /// Divided by q.
    Projected,
    /// Through an operation whose derivative is not known.
    Computed,
}

/// Draws λ into red, a 16th of it, and green, what is left of its 16ths; pixels within `area` only.
fn draw(device: &Device, coords: Coords, area: Option<Rect>) -> Vec<u8> {
    let shader = fragment(4, |b: &mut Builder| {
        let slot = b.texture(TextureDecl { shape: Shape::D2, compare: false, texels: Ty::F32 });
        let [s, t, q] = [0, 1, 3].map(|slot| b.input(Input::Varying(slot)));
        let [zero, half, two, low] = [0.0, 0.5, 2.0, -1e30].map(|v| b.float(v));
        let mut make = |c: Value| match coords {
            Coords::Plain => c,
            Coords::Scaled => {
                let halved = b.op(Op::Mul, &[c, half]);
                let moved = b.op(Op::Add, &[halved, half]);
                b.op(Op::Mul, &[two, moved])
            }
            Coords::Projected => b.op(Op::Div, &[c, q]),
            Coords::Computed => b.op(Op::Max, &[c, low]),
        };
        let at = [make(s), make(t), zero];
        let [lambda, ..] = b.sample(slot, at, None, Lod::Implicit { bias: None });
        let [sixteenth, many] = [1.0 / 16.0, 16.0].map(|v| b.float(v));
        let red = b.op(Op::Mul, &[lambda, sixteenth]);
        let scaled = b.op(Op::Mul, &[lambda, many]);
        let whole = b.op(Op::Floor, &[scaled]);
        let green = b.op(Op::Sub, &[scaled, whole]);
        [red, green, zero, zero]
    });
    let sampler = Sampler { min: Filter::Linear, mipmap: Mipmap::Linear, ..Sampler::default() };
    let plan = Some(Arc::new(SamplePlan::new(&numbered(), &sampler)));
    let color = image(Format::Rgba8, SIZE, SIZE);
    let mut commands = CommandBuffer::new();
    commands.push(pass(&color, None, SIZE, SIZE));
    let desc = pipeline(vertex(4), shader);
    commands.push(Command::BindPipeline(Pipeline::new(desc).expect("valid")));
    let q = if coords == Coords::Projected { 2.5 } else { 1.0 };
    commands.push(Command::BindVertices(bindings(&floor(q), 2)));
    commands.push(Command::BindTextures { vertex: Arc::new([]), fragment: Arc::new([plan]) });
    commands.push(viewport(SIZE, SIZE));
    commands.push(Command::SetScissor(area));
    commands.push(Command::Draw { first: 0, count: 6, instances: 0..1 });
    commands.push(Command::EndPass);
    device.submit(&commands).expect("legal");
    bytes(&color)
}

/// The largest error of λ over the picture.
fn largest_error(picture: &[u8]) -> f64 {
    let mut largest = 0.0_f64;
    for (number, pixel) in picture.chunks_exact(4).enumerate() {
        let (x, y) = (number as u32 % SIZE, number as u32 / SIZE);
        let (red, green) = (f64::from(pixel[0]) / 255.0, f64::from(pixel[1]) / 255.0);
        let whole = (red * 16.0 * 16.0 - green).round();
        // A byte's rounding may have carried green over a whole.
        let error = [whole - 1.0, whole, whole + 1.0]
            .map(|whole| ((whole + green) / 16.0 - exact(x, y)).abs())
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        largest = largest.max(error);
    }
    largest
}

#[test]
fn a_varyings_level_of_detail_is_exact_at_each_pixel() {
    let device = device(Isa::best(), 2);
    // What two bytes hold.
    let bytes = 0.5 / (16.0 * 255.0);
    for coords in [Coords::Plain, Coords::Scaled, Coords::Projected] {
        let error = largest_error(&draw(&device, coords, None));
        assert!(error < 1.05 * bytes, "{coords:?}: {error}");
    }
    let of_quads = largest_error(&draw(&device, Coords::Computed, None));
    assert!(of_quads > 100.0 * bytes, "the differences of quads are as good: {of_quads}");
}

#[test]
fn the_level_of_detail_does_not_depend_on_how_pixels_are_batched() {
    let alone = device(Isa::BASELINE, 1);
    for coords in [Coords::Plain, Coords::Scaled, Coords::Projected, Coords::Computed] {
        let whole = draw(&alone, coords, None);
        for isa in Isa::available() {
            for threads in [1, 2, 8] {
                assert!(draw(&device(isa, threads), coords, None) == whole, "{coords:?}");
            }
        }
        // Few quads of each block share their batches with those of other blocks.
        let area = Rect { x: 3, y: 5, width: 101, height: 3 };
        let part = draw(&alone, coords, Some(area));
        for y in 5..8 {
            for x in 3..104 {
                let at = (y * SIZE as usize + x) * 4;
                assert_eq!(part[at..at + 4], whole[at..at + 4], "{coords:?} at {x}, {y}");
            }
        }
    }
}
