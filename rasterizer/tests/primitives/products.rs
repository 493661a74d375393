//! Programs that are a product of lookups: drawn without registers, they give what the interpreter gives, which a
//! tile with a watched pixel is left to.

use super::super::common::{bindings, fragment, pipeline, vertex};
use super::packing::{TestDraw, picture, varying};
use rasterizer::driver::{Blend, BlendEquation, BlendFactor, VertexBinding, VertexSource};
use rasterizer::ir::TextureDecl;
use rasterizer::ir::{Builder, Lod, Op, Value};
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;
use texunit::plan::SamplePlan;
use texunit::sampler::{Filter, Mipmap, Sampler, Swizzle, Wrap};

/// What `DETGL_EXPLAIN` says of such a draw.
const SAID: &str = "texels are multiplied as they come";

/// A texture of noise with mipmaps.
fn noise(format: Format, sampler: Sampler) -> Arc<SamplePlan> {
    of_noise(format, sampler, 2_654_435_761)
}

/// A texture of other noise.
fn other(format: Format, sampler: Sampler) -> Arc<SamplePlan> {
    of_noise(format, sampler, 2_246_822_519)
}

fn of_noise(format: Format, sampler: Sampler, by: u32) -> Arc<SamplePlan> {
    let mut level = Level::new(format, 64, 64).expect("small");
    for (i, byte) in level.texels.iter_mut().enumerate() {
        *byte = (i as u32).wrapping_mul(by).to_le_bytes()[3];
        if format == Format::Rgba32F {
            *byte &= 0x3F;
        }
    }
    let mut image = Texels::new(Shape::D2);
    image.set_level(0, 0, level).expect("face 0");
    image.generate_mipmaps(Isa::best(), 0, 1000).expect("small");
    Arc::new(SamplePlan::new(&image, &sampler))
}

/// Large triangles over one another, some in perspective: position, then s, t and others, then what `factor` makes
/// of the number of the triangle and the four values that the factors come from.
fn triangles(factor: impl Fn(usize, f32) -> f32) -> Vec<f32> {
    let corners = [
        [[-1.5, -1.2, 0.0, 1.0], [1.6, -1.1, 0.0, 1.0], [0.1, 1.9, 0.0, 1.0]],
        [[-1.0, -1.0, 0.0, 1.0], [2.5, -2.6, 0.0, 2.7], [0.2, 0.9, 0.0, 0.9]],
        [[0.9, -0.9, 0.0, 1.0], [-0.3, 1.4, 0.0, 1.5], [-0.8, -0.4, 0.0, 0.5]],
        [[-0.9, -0.7, 0.0, 1.0], [0.8, -0.9, 0.0, 1.0], [-0.2, 0.6, 0.0, 1.0]],
        [[-0.4, 0.9, 0.0, 1.0], [-0.9, 0.2, 0.0, 1.0], [0.9, -0.1, 0.0, 1.0]],
    ];
    let given = [[-0.3, 0.1, 0.2, 1.1], [1.9, 0.2, 0.9, -0.2], [0.7, 1.4, 0.5, 0.8]];
    let mut out = Vec::new();
    for (number, corners) in corners.into_iter().enumerate() {
        for (corner, given) in corners.into_iter().zip(given) {
            out.extend(corner);
            out.extend(given);
            out.extend(given.map(|v| factor(number, 1.2 - v)));
        }
    }
    out
}

/// Attribute 2, which the factors come from, is the same for all vertices.
fn constant(values: [f32; 4]) -> Arc<[VertexBinding]> {
    let mut all = bindings(&triangles(|_, v| v), 3).to_vec();
    all[2].source = VertexSource::Constant(values);
    all.into()
}

fn look_up(b: &mut Builder, s: u16, t: u16) -> [Value; 4] {
    let texture = b.texture(TextureDecl::color(Shape::D2));
    let (s, t, zero) = (varying(b, s), varying(b, t), b.float(0.0));
    b.sample(texture, [s, t, zero], None, Lod::Implicit { bias: None })
}

fn each(b: &mut Builder, f: impl Fn(&mut Builder, usize) -> Value) -> [Value; 4] {
    [0, 1, 2, 3].map(|component| f(b, component))
}

fn alone(b: &mut Builder) -> [Value; 4] {
    look_up(b, 0, 1)
}

fn times_varying(b: &mut Builder) -> [Value; 4] {
    let texel = look_up(b, 0, 1);
    each(b, |b, at| {
        let factor = varying(b, 4 + at as u16);
        b.op(Op::Mul, &[texel[at], factor])
    })
}

/// As the fixed function does.
fn times_clamped(b: &mut Builder) -> [Value; 4] {
    let texel = look_up(b, 0, 1);
    each(b, |b, at| {
        let (factor, zero, one) = (varying(b, 4 + at as u16), b.float(0.0), b.float(1.0));
        let low = b.op(Op::Max, &[factor, zero]);
        let held = b.op(Op::Min, &[low, one]);
        b.op(Op::Mul, &[held, texel[at]])
    })
}

fn times_number(b: &mut Builder) -> [Value; 4] {
    let texel = look_up(b, 0, 1);
    each(b, |b, at| {
        let factor = b.float([0.5, 1.0, 1.75, 0.3][at]);
        b.op(Op::Mul, &[texel[at], factor])
    })
}

/// What is factor of one lookup is coordinate of the other, and one coordinate is computed.
fn three_lookups(b: &mut Builder) -> [Value; 4] {
    let first = look_up(b, 0, 1);
    let second = look_up(b, 5, 2);
    let texture = b.texture(TextureDecl::color(Shape::D2));
    let (s, t, zero) = (varying(b, 0), varying(b, 4), b.float(0.0));
    let sum = b.op(Op::Add, &[s, t]);
    let third = b.sample(texture, [sum, t, zero], None, Lod::Implicit { bias: None });
    each(b, |b, at| {
        let factor = varying(b, 4 + at as u16);
        let product = b.op(Op::Mul, &[factor, second[at]]);
        let product = b.op(Op::Mul, &[first[at], product]);
        b.op(Op::Mul, &[product, third[at]])
    })
}

/// Both at one point.
fn twice(b: &mut Builder) -> [Value; 4] {
    let (first, second) = (look_up(b, 0, 1), look_up(b, 0, 1));
    each(b, |b, at| {
        let factor = varying(b, 4 + at as u16);
        let product = b.op(Op::Mul, &[factor, first[at]]);
        b.op(Op::Mul, &[product, second[at]])
    })
}

/// A colour of its own for one component: left to the interpreter.
fn mixed_up(b: &mut Builder) -> [Value; 4] {
    let [r, g, b, a] = look_up(b, 0, 1);
    [g, r, b, a]
}

fn samplers() -> Vec<(Format, Sampler)> {
    let with = |filter, mipmap| Sampler { min: filter, mag: filter, mipmap, ..Sampler::default() };
    let nearest = || with(Filter::Nearest, Mipmap::None);
    let linear = || with(Filter::Linear, Mipmap::None);
    let trilinear = || with(Filter::Linear, Mipmap::Linear);
    let turned = [Swizzle::Blue, Swizzle::Green, Swizzle::One, Swizzle::Red];
    vec![
        (Format::Rgba8, nearest()),
        (Format::Rgb8, nearest()),
        (Format::Rgba8, linear()),
        (Format::Rgb8, Sampler { wrap: [Wrap::ClampToEdge; 3], ..linear() }),
        (Format::Rgba8, Sampler { wrap: [Wrap::ClampToBorder; 3], ..linear() }),
        (Format::Rgba8, trilinear()),
        (Format::Rgba8, with(Filter::Nearest, Mipmap::Linear)),
        (Format::Rgb8, with(Filter::Nearest, Mipmap::Nearest)),
        (Format::Rgba8, Sampler { wrap: [Wrap::MirroredRepeat; 3], ..trilinear() }),
        (Format::Rgba8, Sampler { wrap: [Wrap::Clamp; 3], ..trilinear() }),
        (Format::Rgba8, Sampler { max_anisotropy: 8.0, ..trilinear() }),
        (Format::Rgba8, Sampler { swizzle: turned, ..linear() }),
        (Format::Srgb8A8, trilinear()),
        (Format::Rgba32F, linear()),
        (Format::L8, linear()),
    ]
}

#[test]
fn texels_multiplied_as_they_come_are_what_the_interpreter_multiplies() {
    let blend = Blend {
        equation: [BlendEquation::Add; 2],
        src: [BlendFactor::SrcAlpha; 2],
        dst: [BlendFactor::OneMinusSrcAlpha; 2],
        constant: [0.0; 4],
    };
    let vertices = [
        bindings(&triangles(|_, v| v), 3),
        bindings(&triangles(|_, _| 1.0), 3),
        bindings(&triangles(|number, _| [1.0, 0.6, 0.3, 0.3, 1.0][number]), 3),
        bindings(&triangles(|number, _| [0.6, -0.0, 0.0, 0.0, 0.9][number]), 3),
        constant([1.0; 4]),
        constant([0.25, 1.0, 1.5, 0.75]),
    ];
    let targets = [
        (Format::Rgba8, None, [true; 4]),
        (Format::Rgba8, None, [true, false, true, true]),
        (Format::Rgba8, Some(blend), [true; 4]),
        (Format::Rgba16F, None, [true; 4]),
    ];
    for (name, color, is_product) in [
        ("alone", alone as fn(&mut Builder) -> [Value; 4], true),
        ("varying", times_varying, true),
        ("clamped", times_clamped, true),
        ("number", times_number, true),
        ("three", three_lookups, true),
        ("twice", twice, true),
        ("mixed up", mixed_up, false),
    ] {
        for (at, (format, sampler)) in samplers().into_iter().enumerate() {
            let texture = noise(format, sampler.clone());
            let second = if at % 2 == 0 { texture.clone() } else { other(format, sampler) };
            let (target, blend, mask) = targets[at % targets.len()];
            let mut desc = pipeline(vertex(8), fragment(8, color));
            desc.colors[0].blend = blend;
            desc.colors[0].mask = mask;
            for vertices in &vertices {
                let textures =
                    vec![Some(texture.clone()), Some(second.clone()), Some(texture.clone())];
                let draw = |isa, watched| {
                    let drawn =
                        TestDraw { desc: &desc, textures: &textures, vertices, count: 15, target };
                    picture(isa, &drawn, watched)
                };
                let (want, _) = draw(Isa::BASELINE, true);
                for isa in Isa::available() {
                    let (got, said) = draw(isa, false);
                    let of = format!("{name}, {format:?}, {target:?}, {}", isa.name());
                    // What a mask leaves out is not computed, and no product of four colours is left.
                    let is_said = is_product && mask == [true; 4];
                    assert_eq!(said.contains(SAID), is_said, "{of}: {said}");
                    assert!(got == want, "{of}");
                }
            }
        }
    }
}

/// In perspective too: there a plane is divided by another, and rounded.
#[test]
fn what_is_one_at_all_vertices_is_one_in_between() {
    let desc = pipeline(vertex(8), fragment(8, |b| each(b, |b, at| varying(b, 4 + at as u16))));
    let vertices = &bindings(&triangles(|_, _| 1.0), 3);
    let target = Format::Rgba32F;
    let drawn = TestDraw { desc: &desc, textures: &[], vertices, count: 15, target };
    for isa in Isa::available() {
        for watched in [false, true] {
            let (bytes, _) = picture(isa, &drawn, watched);
            let pixels = bytes[..64 * 64 * 16].as_chunks::<4>().0.iter();
            let values: Vec<f32> = pixels.map(|bytes| f32::from_le_bytes(*bytes)).collect();
            assert!(values.iter().all(|&value| value == 1.0 || value == 0.0), "{}", isa.name());
            assert!(values.contains(&1.0) && values.contains(&0.0));
        }
    }
}
