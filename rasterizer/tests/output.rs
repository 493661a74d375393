//! What happens to fragments after the shader, against its definition: every pair of blend factors
//! in `f64`, every logical operation bit by bit, and the same bits on every instruction set and
//! number of threads for every format.

mod common;

use common::{bindings, bytes, device, fragment, image, pass, pipeline, vertex, viewport};
use rasterizer::driver::{
    Blend, BlendEquation, BlendFactor, ClearValue, ColorState, Command, CommandBuffer, Device,
    Image, LogicOp, Pipeline, PipelineDesc, Rect, ShaderModule, SrgbWrite, StencilFace, StencilOp,
    StencilState,
};
use rasterizer::ir::{Builder, Input, Output, Stage};
use texunit::format::{Encoding, Format};
use texunit::lanes::Isa;
use texunit::sampler::Compare;

const SIZE: u32 = 16;

/// Two triangles over the whole viewport.
fn square() -> Vec<f32> {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
        .into_iter()
        .flat_map(|[x, y]| [x, y, 0.0, 1.0])
        .collect()
}

/// Clears to a colour and draws another over it through `desc`.
fn run(device: &Device, target: &Image, cleared: [f32; 4], desc: &PipelineDesc) {
    let area = Rect { x: 0, y: 0, width: SIZE, height: SIZE };
    let value = ClearValue::Color { target: 0, value: cleared, mask: [true; 4] };
    let commands = vec![
        pass(target, None, SIZE, SIZE),
        Command::Clear { value, area },
        viewport(SIZE, SIZE),
        Command::BindPipeline(Pipeline::new(desc.clone()).expect("valid")),
        Command::BindVertices(bindings(&square(), 1)),
        Command::Draw { first: 0, count: 6, instances: 0..1 },
        Command::EndPass,
    ];
    device.submit(&CommandBuffer { commands }).expect("legal");
}

fn constant(color: [f32; 4]) -> PipelineDesc {
    pipeline(vertex(0), fragment(0, |b| color.map(|v| b.float(v))))
}

/// A fragment module of two constant colours.
fn two_colors(first: [f32; 4], second: [f32; 4]) -> ShaderModule {
    let mut b = Builder::new(Stage::Fragment);
    for component in 0..4 {
        let (first, second) = (b.float(first[component]), b.float(second[component]));
        let out = b.output(Output::Color { target: 0, component: component as u8 });
        b.store(out, first);
        let out = b.output(Output::SecondColor(component as u8));
        b.store(out, second);
    }
    ShaderModule::new(b.finish()).expect("valid")
}

const FACTORS: [BlendFactor; 19] = [
    BlendFactor::Zero,
    BlendFactor::One,
    BlendFactor::SrcColor,
    BlendFactor::OneMinusSrcColor,
    BlendFactor::DstColor,
    BlendFactor::OneMinusDstColor,
    BlendFactor::SrcAlpha,
    BlendFactor::OneMinusSrcAlpha,
    BlendFactor::DstAlpha,
    BlendFactor::OneMinusDstAlpha,
    BlendFactor::ConstantColor,
    BlendFactor::OneMinusConstantColor,
    BlendFactor::ConstantAlpha,
    BlendFactor::OneMinusConstantAlpha,
    BlendFactor::SrcAlphaSaturate,
    BlendFactor::Src1Color,
    BlendFactor::OneMinusSrc1Color,
    BlendFactor::Src1Alpha,
    BlendFactor::OneMinusSrc1Alpha,
];

/// GL 3.3, table 4.2.
fn factor(of: BlendFactor, i: usize, [s, s1, d, c]: [[f64; 4]; 4]) -> f64 {
    match of {
        BlendFactor::Zero => 0.0,
        BlendFactor::One => 1.0,
        BlendFactor::SrcColor => s[i],
        BlendFactor::OneMinusSrcColor => 1.0 - s[i],
        BlendFactor::DstColor => d[i],
        BlendFactor::OneMinusDstColor => 1.0 - d[i],
        BlendFactor::SrcAlpha => s[3],
        BlendFactor::OneMinusSrcAlpha => 1.0 - s[3],
        BlendFactor::DstAlpha => d[3],
        BlendFactor::OneMinusDstAlpha => 1.0 - d[3],
        BlendFactor::ConstantColor => c[i],
        BlendFactor::OneMinusConstantColor => 1.0 - c[i],
        BlendFactor::ConstantAlpha => c[3],
        BlendFactor::OneMinusConstantAlpha => 1.0 - c[3],
        BlendFactor::SrcAlphaSaturate if i == 3 => 1.0,
        BlendFactor::SrcAlphaSaturate => s[3].min(1.0 - d[3]),
        BlendFactor::Src1Color => s1[i],
        BlendFactor::OneMinusSrc1Color => 1.0 - s1[i],
        BlendFactor::Src1Alpha => s1[3],
        BlendFactor::OneMinusSrc1Alpha => 1.0 - s1[3],
    }
}

#[test]
fn every_pair_of_factors_is_what_the_table_says() {
    const SOURCE: [f32; 4] = [0.25, 0.75, 1.5, 0.625];
    const SECOND: [f32; 4] = [0.375, 1.25, -0.5, 0.8125];
    const STORED: [f32; 4] = [0.5, 0.125, 0.375, 0.25];
    const CONSTANT: [f32; 4] = [0.75, 0.0625, 0.5, 0.875];
    let device = device(Isa::best(), 1);
    for (format, largest) in
        [(Format::Rgba8, Some(255.0)), (Format::Rgba16, Some(65_535.0)), (Format::Rgba32F, None)]
    {
        let target = image(format, SIZE, SIZE);
        // What is stored is what the format can hold of the colour.
        let clamp = |c: f32| if largest.is_some() { c.clamp(0.0, 1.0) } else { c };
        let [s, s1] = [SOURCE, SECOND].map(|color| color.map(|c| f64::from(clamp(c))));
        let held = |c: f32| match largest {
            Some(largest) => (f64::from(c) * largest).round() / largest,
            None => c.into(),
        };
        let (d, c) = (STORED.map(held), CONSTANT.map(f64::from));
        for equation in
            [BlendEquation::Add, BlendEquation::Subtract, BlendEquation::ReverseSubtract]
        {
            for src in FACTORS {
                for dst in FACTORS {
                    let mut desc = pipeline(vertex(0), two_colors(SOURCE, SECOND));
                    // Alpha the other way round.
                    let blend = Blend {
                        equation: [equation; 2],
                        src: [src, dst],
                        dst: [dst, src],
                        constant: CONSTANT,
                    };
                    desc.colors = vec![ColorState { blend: Some(blend), mask: [true; 4] }];
                    run(&device, &target, STORED, &desc);
                    let texels = target.texels();
                    let level = texels.level(0, 0).expect("there");
                    let got = texunit::format::convert::decode(format, level.texel(9, 5));
                    for i in 0..4 {
                        let part = usize::from(i == 3);
                        let a = s[i] * factor(blend.src[part], i, [s, s1, d, c]);
                        let b = d[i] * factor(blend.dst[part], i, [s, s1, d, c]);
                        let want = match equation {
                            BlendEquation::Subtract => a - b,
                            BlendEquation::ReverseSubtract => b - a,
                            BlendEquation::Add | BlendEquation::Min | BlendEquation::Max => a + b,
                        };
                        let (want, tolerance) = match largest {
                            Some(largest) => (want.clamp(0.0, 1.0), 0.51 / largest),
                            None => (want, 1e-6),
                        };
                        let got = f64::from(got[i]);
                        assert!(
                            (got - want).abs() <= tolerance,
                            "{format:?} {equation:?} {src:?} {dst:?} {i}: {got}, not {want}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn every_logical_operation_works_on_every_pair_of_bits() {
    /// An operation and its results for (source, stored) = 00, 01, 10, 11.
    const TABLE: [(LogicOp, [u8; 4]); 16] = [
        (LogicOp::Clear, [0, 0, 0, 0]),
        (LogicOp::And, [0, 0, 0, 1]),
        (LogicOp::AndReverse, [0, 0, 1, 0]),
        (LogicOp::Copy, [0, 0, 1, 1]),
        (LogicOp::AndInverted, [0, 1, 0, 0]),
        (LogicOp::Noop, [0, 1, 0, 1]),
        (LogicOp::Xor, [0, 1, 1, 0]),
        (LogicOp::Or, [0, 1, 1, 1]),
        (LogicOp::Nor, [1, 0, 0, 0]),
        (LogicOp::Equivalent, [1, 0, 0, 1]),
        (LogicOp::Invert, [1, 0, 1, 0]),
        (LogicOp::OrReverse, [1, 0, 1, 1]),
        (LogicOp::CopyInverted, [1, 1, 0, 0]),
        (LogicOp::OrInverted, [1, 1, 0, 1]),
        (LogicOp::Nand, [1, 1, 1, 0]),
        (LogicOp::Set, [1, 1, 1, 1]),
    ];
    let device = device(Isa::best(), 1);
    let (source, stored) = ([0b1100_u8, 0xF0, 0x5A, 0xFF], [0b1010_u8, 0x3C, 0x99, 0x0F]);
    for format in [Format::Rgba8, Format::Rgba16, Format::Rgba4] {
        let target = image(format, SIZE, SIZE);
        for (op, results) in TABLE {
            let bits = format.channel_bits(0);
            let largest = ((1_u32 << bits) - 1) as f32;
            let limit = |v: u8| f32::from(v).min(largest) / largest;
            let mut desc = constant(source.map(limit));
            desc.output.logic_op = Some(op);
            run(&device, &target, stored.map(limit), &desc);
            let texels = target.texels();
            let texel = texels.level(0, 0).expect("there").texel(3, 3).to_vec();
            let got: Vec<u32> = match format {
                Format::Rgba8 => texel.iter().map(|&b| b.into()).collect(),
                Format::Rgba16 => {
                    texel.chunks(2).map(|b| u16::from_le_bytes([b[0], b[1]]).into()).collect()
                }
                _ => {
                    let word = u32::from(u16::from_le_bytes([texel[0], texel[1]]));
                    [12, 8, 4, 0].map(|shift| word >> shift & 0xF).to_vec()
                }
            };
            for (i, got) in got.into_iter().enumerate() {
                let [s, d] = [source[i], stored[i]].map(|v| u32::from(v).min(largest as u32));
                let want = (0..bits).fold(0, |word, bit| {
                    let pair = (s >> bit & 1) << 1 | d >> bit & 1;
                    word | u32::from(results[pair as usize]) << bit
                });
                assert_eq!(got, want, "{format:?} {op:?} {i}");
            }
        }
    }
}

/// Whether a pass can draw to a format.
fn is_attachable(format: Format) -> bool {
    !format.is_depth()
        && match format.info().encoding {
            Encoding::Unorm
            | Encoding::Snorm
            | Encoding::Srgb
            | Encoding::Float
            | Encoding::Uint
            | Encoding::Sint => true,
            Encoding::SharedExponent | Encoding::Block(_) | Encoding::SrgbBlock(_) => false,
        }
}

#[test]
fn every_format_gets_the_same_bits_on_every_instruction_set_and_thread_count() {
    let devices: Vec<Device> = Isa::available()
        .into_iter()
        .flat_map(|isa| [1, 3].map(|threads| device(isa, threads)))
        .collect();
    for format in Format::ALL.into_iter().filter(|&format| is_attachable(format)) {
        for srgb in [SrgbWrite::AsIs, SrgbWrite::Encode] {
            let mut first: Option<Vec<u8>> = None;
            for device in &devices {
                let target = image(format, SIZE, SIZE);
                let shader = fragment(0, |b| {
                    let scale = b.float(0.061);
                    let [x, y] = [0, 1].map(|axis| {
                        let at = b.input(Input::FragCoord(axis));
                        b.op(rasterizer::ir::Op::Mul, &[at, scale])
                    });
                    let sum = b.op(rasterizer::ir::Op::Add, &[x, y]);
                    [x, y, sum, y]
                });
                let mut desc = pipeline(vertex(0), shader);
                let blend = Blend {
                    equation: [BlendEquation::Add; 2],
                    src: [BlendFactor::SrcAlpha; 2],
                    dst: [BlendFactor::OneMinusSrcAlpha; 2],
                    constant: [0.0; 4],
                };
                desc.colors =
                    vec![ColorState { blend: Some(blend), mask: [true, true, false, true] }];
                desc.output.srgb = srgb;
                run(device, &target, [0.3, 0.6, 0.9, 0.4], &desc);
                let got = bytes(&target);
                match &first {
                    None => first = Some(got),
                    Some(first) => assert_eq!(&got, first, "{format:?}"),
                }
            }
        }
    }
}

#[test]
fn stencils_and_depths_of_one_image_do_not_disturb_each_other() {
    let device = device(Isa::best(), 2);
    let color = image(Format::Rgba8, SIZE, SIZE);
    let depth = image(Format::D24S8, SIZE, SIZE);
    let area = Rect { x: 0, y: 0, width: SIZE, height: SIZE };
    let mut desc = constant([1.0; 4]);
    let face = StencilFace {
        test: Compare::Always,
        reference: 0x33,
        read_mask: 0xFF,
        write_mask: 0x0F,
        fail: StencilOp::Keep,
        depth_fail: StencilOp::Keep,
        pass: StencilOp::Replace,
    };
    desc.output.stencil = Some(StencilState { front: face, back: face });
    let commands = vec![
        pass(&color, Some(&depth), SIZE, SIZE),
        Command::Clear { value: ClearValue::Depth(0.5), area },
        Command::Clear { value: ClearValue::Stencil { value: 0xA5, mask: 0xFF }, area },
        Command::Clear { value: ClearValue::Stencil { value: 0x00, mask: 0x80 }, area },
        viewport(SIZE, SIZE),
        Command::BindPipeline(Pipeline::new(desc).expect("valid")),
        Command::BindVertices(bindings(&square(), 1)),
        Command::Draw { first: 0, count: 6, instances: 0..1 },
        Command::EndPass,
    ];
    device.submit(&CommandBuffer { commands }).expect("legal");
    for texel in bytes(&depth).chunks(4) {
        let word = u32::from_le_bytes([texel[0], texel[1], texel[2], texel[3]]);
        assert_eq!((word & 0xFF, word >> 8), (0x23, 0x80_0000));
    }
}
