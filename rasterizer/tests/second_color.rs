//! The second colour of the fragment stage, which blending reads (GL 3.3, section 4.1.7): on every instruction set and
//! number of threads, of whole and partly covered blocks, with one and with several samples, before and after late
//! tests.

mod common;

use common::{bindings, bytes, device, image, pass, pipeline, vertex, viewport};
use rasterizer::driver::{
    Blend, BlendEquation, BlendFactor, ClearValue, ColorState, Command, CommandBuffer, DepthState,
    DepthWrite, Device, Image, MultisampleState, Pipeline, PipelineDesc, RasterState, Rect,
    SampleRule, ShaderModule,
};
use rasterizer::ir::{Builder, Input, Op, Output, Stage, Stmt, Ty, Value, Variable};
use std::sync::Arc;
use texunit::format::Format;
use texunit::image::{Image as Texels, Level, Shape};
use texunit::lanes::Isa;
use texunit::sampler::Compare;

const SIZE: u32 = 32;
const STORED: [f32; 4] = [0.5, 0.25, 0.75, 1.0];

/// As text with a coverage for each of red, green and blue.
const SUBPIXELS: Blend = Blend {
    equation: [BlendEquation::Add; 2],
    src: [BlendFactor::Src1Color; 2],
    dst: [BlendFactor::OneMinusSrc1Color; 2],
    constant: [0.0; 4],
};

/// Of a pixel at these whole window coordinates: the first colour, then the second.
fn colors(x: u32, y: u32) -> [[f64; 4]; 2] {
    let [x, y] = [x, y].map(|at| f64::from(at) + 0.5);
    [[x / 32.0, 0.75, y / 32.0, 1.0], [y / 32.0, x / 32.0, 0.5, x / 16.0]]
}

/// What the program does beside its colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Also {
    Nothing,
    /// It throws away the pixels left of this column, so that tests are late.
    Discards(u32),
}

fn shader(also: Also) -> ShaderModule {
    let mut b = Builder::new(Stage::Fragment);
    let scaled = |b: &mut Builder, axis: u8, by: f32| {
        let (at, by) = (b.input(Input::FragCoord(axis)), b.float(by));
        b.op(Op::Mul, &[at, by])
    };
    let [x, y] = [0, 1].map(|axis| scaled(&mut b, axis, 1.0 / 32.0));
    let steep = scaled(&mut b, 0, 1.0 / 16.0);
    let [half, most, one] = [0.5, 0.75, 1.0].map(|value| b.float(value));
    let write = |b: &mut Builder, output: Output, value: Value| {
        let var = b.output(output);
        b.store(var, value);
    };
    if let Also::Discards(column) = also {
        let (at, edge) = (b.input(Input::FragCoord(0)), b.float(column as f32));
        let condition = b.op(Op::Less, &[at, edge]);
        b.push(Stmt::If { condition, accept: vec![Stmt::Discard], reject: Vec::new() });
    }
    for (component, value) in (0..).zip([x, most, y, one]) {
        write(&mut b, Output::Color { target: 0, component }, value);
    }
    for (component, value) in (0..).zip([y, x, half, steep]) {
        write(&mut b, Output::SecondColor(component), value);
    }
    ShaderModule::new(b.finish()).expect("valid")
}

fn desc(fragment: ShaderModule, blend: Blend) -> PipelineDesc {
    let mut desc = pipeline(vertex(0), fragment);
    desc.colors = vec![ColorState { blend: Some(blend), mask: [true; 4] }];
    desc
}

fn target(format: Format, samples: u8) -> Image {
    let mut texels = Texels::new(Shape::D2);
    texels.set_level(0, 0, Level::new(format, SIZE, SIZE).expect("small")).expect("face 0");
    Image::with_samples(texels, samples)
}

/// Draws the triangle below the diagonal from the lower left to the upper right over the stored colour.
fn draw(device: &Device, color: &Image, depth: Option<&Image>, desc: &PipelineDesc) {
    let corners = [[-1.0, -1.0, 0.0, 1.0], [1.0, -1.0, 0.0, 1.0], [1.0, 1.0, 0.0, 1.0_f32]];
    let value = ClearValue::Color { target: 0, value: STORED, mask: [true; 4] };
    let multisample = MultisampleState { rule: SampleRule::Each, ..MultisampleState::default() };
    let commands = vec![
        pass(color, depth, SIZE, SIZE),
        Command::Clear { value, area: Rect { x: 0, y: 0, width: SIZE, height: SIZE } },
        viewport(SIZE, SIZE),
        Command::SetRaster(Arc::new(RasterState { multisample, ..RasterState::default() })),
        Command::BindPipeline(Pipeline::new(desc.clone()).expect("valid")),
        Command::BindVertices(bindings(corners.as_flattened(), 1)),
        Command::Draw { first: 0, count: 3, instances: 0..1 },
        Command::EndPass,
    ];
    device.submit(&CommandBuffer { commands }).expect("legal");
}

/// What a pixel that is covered whole holds: each colour clamped, where the format is fixed-point, and blended.
fn blended(format: Format, x: u32, y: u32) -> [f64; 4] {
    let clamp = |c: f64| if format == Format::Rgba32F { c } else { c.clamp(0.0, 1.0) };
    let [first, second] = colors(x, y).map(|color| color.map(clamp));
    std::array::from_fn(|i| clamp(first[i] * second[i] + f64::from(STORED[i]) * (1.0 - second[i])))
}

fn devices() -> Vec<Device> {
    let each = |isa| [1, 3].map(|threads| device(isa, threads));
    Isa::available().into_iter().flat_map(each).collect()
}

#[test]
fn every_pixel_is_blended_by_its_second_colour() {
    let devices = devices();
    for (format, error) in [
        (Format::Rgba8, 0.51 / 255.0 + 1e-6),
        (Format::Rgba16, 0.51 / 65_535.0 + 1e-6),
        (Format::Rgba32F, 1e-6),
    ] {
        // Stored values of 8 and 16 bits are off by up to half a step.
        let error = if format == Format::Rgba32F { error } else { 2.0 * error };
        for also in [Also::Nothing, Also::Discards(7)] {
            let desc = desc(shader(also), SUBPIXELS);
            let mut first = None;
            for device in &devices {
                let target = image(format, SIZE, SIZE);
                draw(device, &target, None, &desc);
                let texels = target.texels();
                let level = texels.level(0, 0).expect("made with one");
                for (x, y) in (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y))) {
                    let is_left = matches!(also, Also::Discards(column) if x < column);
                    // Pixels on the diagonal itself belong to one of two triangles.
                    if x == y {
                        continue;
                    }
                    let want = match x > y && !is_left {
                        true => blended(format, x, y),
                        false => STORED.map(f64::from),
                    };
                    let got = texunit::format::convert::decode(format, level.texel(x, y));
                    for i in 0..4 {
                        let difference = (f64::from(got[i]) - want[i]).abs();
                        assert!(
                            difference <= error,
                            "{format:?} {also:?} {x} {y} {i}: {got:?} {want:?}"
                        );
                    }
                }
                let got = bytes(&target);
                assert_eq!(first.get_or_insert_with(|| got.clone()), &got, "{format:?} {also:?}");
            }
        }
    }
}

#[test]
fn samples_and_late_tests_are_blended_as_single_pixels_are() {
    for device in &devices() {
        for also in [Also::Nothing, Also::Discards(7)] {
            let plain = target(Format::Rgba8, 1);
            draw(device, &plain, None, &desc(shader(also), SUBPIXELS));
            let (color, depth) = (target(Format::Rgba8, 4), target(Format::D32F, 4));
            let mut tested = desc(shader(also), SUBPIXELS);
            tested.depth = Some(DepthState { test: Compare::Always, write: DepthWrite::On });
            draw(device, &color, Some(&depth), &tested);
            let resolved = bytes(&color);
            for (x, y) in (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y))) {
                // All samples of a pixel off the diagonal are covered, or none.
                if x != y {
                    let at = 4 * (y * SIZE + x) as usize;
                    assert_eq!(resolved[at..at + 4], bytes(&plain)[at..at + 4], "{also:?} {x} {y}");
                }
            }
        }
    }
}

#[test]
fn a_program_without_a_second_colour_has_zeros() {
    let first = common::fragment(0, |b| [0.25, 0.5, 0.75, 1.0].map(|value| b.float(value)));
    for device in &devices() {
        for format in [Format::Rgba8, Format::Rgba32F] {
            for (factor, want) in [
                (BlendFactor::Src1Color, [0.0; 4]),
                (BlendFactor::OneMinusSrc1Alpha, [0.25, 0.5, 0.75, 1.0]),
            ] {
                let blend = Blend { src: [factor; 2], dst: [BlendFactor::Zero; 2], ..SUBPIXELS };
                let color = image(format, SIZE, SIZE);
                draw(device, &color, None, &desc(first.clone(), blend));
                let texels = color.texels();
                let texel = texels.level(0, 0).expect("made with one").texel(20, 10);
                let got = texunit::format::convert::decode(format, texel);
                let close =
                    got.iter().zip(want).all(|(got, want): (&f32, f32)| (got - want).abs() < 0.002);
                assert!(close, "{format:?} {factor:?} {got:?}");
            }
        }
    }
}

#[test]
fn a_second_colour_that_no_factor_reads_is_not_computed() {
    let device = device(Isa::best(), 1);
    let steps = |blend: Blend| {
        let color = image(Format::Rgba8, SIZE, SIZE);
        draw(&device, &color, None, &desc(shader(Also::Nothing), blend));
        let plan = device.take_explanations().concat();
        plan.lines().find(|line| line.contains("fragment")).expect("a line").to_owned()
    };
    let ordinary = Blend {
        src: [BlendFactor::SrcAlpha; 2],
        dst: [BlendFactor::OneMinusSrcAlpha; 2],
        ..SUBPIXELS
    };
    let unread = Blend { equation: [BlendEquation::Max; 2], ..SUBPIXELS };
    assert_ne!(steps(ordinary), steps(SUBPIXELS));
    assert_eq!(steps(ordinary), steps(unread));
}

#[test]
fn a_module_has_a_second_colour_of_four_floats_at_most() {
    let module = |stage: Stage, component: u8, ty: Ty| {
        let mut b = Builder::new(stage);
        b.module_mut().variables.push(Variable { ty, len: 1, name: "second".into() });
        let var = rasterizer::ir::Var(0);
        b.module_mut().outputs.push((Output::SecondColor(component), var));
        ShaderModule::new(b.finish())
    };
    assert!(module(Stage::Fragment, 3, Ty::F32).is_ok());
    assert!(module(Stage::Fragment, 4, Ty::F32).is_err());
    assert!(module(Stage::Fragment, 0, Ty::I32).is_err());
    assert!(module(Stage::Vertex, 0, Ty::F32).is_err());
}
